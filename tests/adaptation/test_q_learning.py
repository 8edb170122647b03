"""Q-learning as published: its updates, worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from adaptation.learners.q_learning import QLearning, state_of
from adaptation.problem import Choice, Context, Outcome
from personage_lite.errors import PersonageError


def learn(
    learner: QLearning,
    state: tuple[float, int],
    action: int,
    reward: float,
    after: tuple[float, int],
) -> None:
    context = Context(0, np.array([state[1]]), np.array([float(state[0])]))
    outcome = Outcome(np.array([reward]), np.array([after[1]]), np.array([float(after[0])]))
    learner.learn(context, Choice(np.array([action]), np.ones(1)), outcome)


def test_three_updates() -> None:
    learner = QLearning(1, gamma=0.9)
    table = learner.table.reshape(5, 5, 3)
    # From E = 0, X = 0: increase, E falls. 0 + .5 (-1 + .9 · 0 - 0)
    learn(learner, (0, 0), 1, -1, (-1, 1))
    assert table[2, 2].tolist() == [0, 0, -0.5]
    # From E = -1, X = 1: increase, E rises. 0 + .5 (1 + .9 · 0 - 0)
    learn(learner, (-1, 1), 1, 1, (0, 2))
    assert table[1, 3].tolist() == [0, 0, 0.5]
    # The first again: what follows is worth .5 now. -.5 + .5 (-1 + .9 · .5 + .5)
    learn(learner, (0, 0), 1, -1, (-1, 1))
    assert table[2, 2].tolist() == pytest.approx([0, 0, -0.525])
    # No other value has changed.
    assert np.count_nonzero(table) == 2


def test_a_real_engagement_is_rounded() -> None:
    states = state_of(np.array([-3.0, -1.6, -0.4, 0.6, 7.0]), np.zeros(5, dtype=np.int64))
    assert states.tolist() == [2, 2, 12, 17, 22]


def test_it_explores_in_a_fifth_of_the_steps() -> None:
    learner = QLearning(100_000)
    learner.table[:, 12, 2] = 1.0
    zero = np.zeros(100_000)
    draws = np.random.default_rng(0).random((2, 100_000))
    choice = learner.choose(Context(0, zero.astype(np.int64), zero), draws)
    share = [(choice.action == action).mean() for action in (-1, 0, 1)]
    assert share == pytest.approx([0.2 / 3, 0.2 / 3, 0.8 + 0.2 / 3], abs=0.004)
    assert set(choice.probability.round(6)) == {round(0.2 / 3, 6), round(0.8 + 0.2 / 3, 6)}


def test_an_empty_table_draws_evenly() -> None:
    learner = QLearning(60_000)
    zero = np.zeros(60_000)
    draws = np.random.default_rng(0).random((2, 60_000))
    choice = learner.choose(Context(0, zero.astype(np.int64), zero), draws)
    assert [(choice.action == action).mean() for action in (-1, 0, 1)] == pytest.approx(
        [1 / 3] * 3, abs=0.01
    )
    assert choice.probability == pytest.approx(1 / 3)


@pytest.mark.parametrize("setting", ["epsilon", "alpha", "gamma"])
@pytest.mark.parametrize("value", [-0.1, 1.1, float("nan"), "a", True])
def test_settings_out_of_range(setting: str, value: object) -> None:
    with pytest.raises(PersonageError, match=f"q-learning: {setting} is .*; give a number from 0"):
        QLearning(1, **{setting: value})  # type: ignore[arg-type]
