"""The Gymnasium environment."""

from __future__ import annotations

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

from adaptation.environment import ID, ListenerEnv
from adaptation.listeners import LISTENERS
from adaptation.listeners.near import Near
from personage_lite.errors import PersonageError


@pytest.mark.parametrize("name", LISTENERS)
def test_gymnasium_finds_no_fault(name: str) -> None:
    check_env(gymnasium.make(ID, listener=name, noise=0.3).unwrapped)


def test_an_episode() -> None:
    env = ListenerEnv("match", steps=5, changes=())
    observation, info = env.reset(seed=3)
    assert observation.tolist() == [0, 0]
    assert set(info) == {"preference", "engagement", "match"}
    preference, x, engagement = info["preference"], 0, 0.0
    for step in range(5):
        action = int(np.sign(preference - x)) + 1
        x += action - 1
        before, engagement = engagement, min(2, engagement + (1 if x == preference else -1))
        observation, reward, terminated, truncated, info = env.step(np.int64(action))
        assert observation.tolist() == [engagement, x]
        assert reward == (engagement - before or 0.5)
        assert (terminated, truncated) == (False, step == 4)
        assert info == {
            "preference": preference,
            "engagement": engagement,
            "match": x == preference,
        }
    with pytest.raises(PersonageError, match="the talk is over"):
        env.step(np.int64(1))


def test_x_stays_on_the_scale() -> None:
    env = ListenerEnv()
    env.reset(seed=0)
    assert [env.step(np.int64(2))[0][1] for _ in range(4)] == [1, 2, 2, 2]


def _preferences(env: ListenerEnv, seed: int) -> list[int]:
    first = env.reset(seed=seed)[1]["preference"]
    return [first, *(env.reset()[1]["preference"] for _ in range(30))]


def test_the_seed_decides_which_listeners_come() -> None:
    assert _preferences(ListenerEnv(), 1) == _preferences(ListenerEnv(), 1)
    assert _preferences(ListenerEnv(), 1) != _preferences(ListenerEnv(), 2)
    assert set(_preferences(ListenerEnv(), 1)) == {-2, -1, 0, 1, 2}


def test_the_coins_can_be_set_apart() -> None:
    env = ListenerEnv("match", noise=1.0, sensor_noise=0.0)
    observation, info = env.reset(seed=0)
    for _ in range(30):
        observation, _, _, _, info = env.step(np.int64(1))
        assert observation[0] == info["engagement"]


def test_a_listener_of_ones_own() -> None:
    check_env(gymnasium.make(ID, listener=Near()).unwrapped)


def test_impossible_environments() -> None:
    with pytest.raises(PersonageError, match="no listener 'mach'"):
        ListenerEnv("mach")
    with pytest.raises(PersonageError, match="listener noise: 2; give"):
        ListenerEnv(noise=2)
    env = ListenerEnv()
    with pytest.raises(PersonageError, match="call reset first"):
        env.step(np.int64(1))
    env.reset(seed=1)
    with pytest.raises(PersonageError, match="action 3; give 0, 1 or 2"):
        env.step(3)  # type: ignore[arg-type]
