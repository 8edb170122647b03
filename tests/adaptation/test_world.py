"""The paper's noise and reward, worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from adaptation.listeners.match import Match
from adaptation.problem import Floats
from adaptation.world import Coins, Noise, StepWorld, misread, rewarded


def world(
    listener_coin: tuple[float, float] | None,
    sensor_coin: tuple[float, float] | None,
    floor_bonus: bool = True,
) -> StepWorld:
    """A single trial whose coins fall alike in each of ten steps; both noises are 0.5."""

    def ten(coin: tuple[float, float] | None) -> Floats | None:
        return None if coin is None else np.tile(np.array(coin).reshape(1, 2, 1), (10, 1, 1))

    coins = Coins(ten(listener_coin), ten(sensor_coin))
    return StepWorld(Match(), 1, Noise(0.5, 0.5), coins, np.empty((10, 0, 1)), floor_bonus)


def hear(subject: StepWorld, xs: list[int], preference: int = 1) -> list[tuple[float, float]]:
    """Return true E and reward after each utterance."""
    found = []
    for step, x in enumerate(xs):
        outcome = subject.hear(step, np.array([x]), np.array([preference]))
        assert outcome.x.tolist() == [x]
        assert outcome.engagement is subject.sensed
        found.append((float(subject.engagement[0]), float(outcome.reward[0])))
    return found


def test_without_noise() -> None:
    assert hear(world(None, None), [1, 1, 1, 0, 0]) == [
        (1, 1),
        (2, 1),
        (2, 0.5),
        (1, -1),
        (0, -1),
    ]


def test_the_floor_bonus() -> None:
    assert hear(world(None, None), [0, 0, 0]) == [(-1, -1), (-2, -1), (-2, 0.5)]
    assert hear(world(None, None, floor_bonus=False), [0, 0, 0]) == [(-1, -1), (-2, -1), (-2, 0)]


@pytest.mark.parametrize(("which", "change"), [(0.1, -1), (0.5, 0), (0.9, 1)])
def test_the_listeners_coin_replaces_the_change(which: float, change: int) -> None:
    for x in (0, 1):
        assert hear(world((0.4, which), None), [x])[0][0] == change
        assert hear(world((0.5, which), None), [x])[0][0] == (1 if x == 1 else -1)


def test_the_sensors_coin_shifts_what_is_sensed_only() -> None:
    subject = world(None, (0.4, 0.9))
    # True E: 1, 2, 2; sensed: 2, 2 (the scale's end), 2.
    assert hear(subject, [1, 1, 1]) == [(1, 2), (2, 0.5), (2, 0.5)]
    subject = world(None, (0.4, 0.1))
    # True E: 1, 2, 2; sensed: 0, 1, 1.
    assert hear(subject, [1, 1, 1]) == [(1, 0.5), (2, 1), (2, 0.5)]


def test_without_floor_bonus_the_sensed_floor_counts() -> None:
    # True E falls to -1, then -2; sensed one lower: -2, then -2.
    assert hear(world(None, (0.4, 0.1), floor_bonus=False), [0, 0]) == [(-1, -2), (-2, 0)]


def test_the_coins_fall_as_often_as_they_should() -> None:
    draws = np.random.default_rng(0).random((2, 200_000))
    sensed = misread(np.zeros(200_000), draws, 0.3)
    assert abs((sensed == 1).mean() - 0.15) < 0.005
    assert abs((sensed == -1).mean() - 0.15) < 0.005


def test_the_reward_table() -> None:
    sensed, before = np.array([2.0, -2, -2, 0, 2, 0.25]), np.array([2.0, -2, -1, -2, 1, 0])
    assert rewarded(sensed, before, True).tolist() == [0.5, 0.5, -1, 2, 1, 0.25]
    assert rewarded(sensed, before, False).tolist() == [0.5, 0, -1, 2, 1, 0.25]
