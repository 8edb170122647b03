"""The learners' contract: each fault is found, and ours have none."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest

from adaptation.contracts import check_learner
from adaptation.learners import LEARNERS
from adaptation.learners.base import Learner
from adaptation.learners.q_learning import QLearning
from adaptation.problem import Choice, Context, Floats, Outcome


@pytest.mark.parametrize("name", LEARNERS)
def test_each_learner_keeps_it(name: str) -> None:
    assert check_learner(LEARNERS[name]) == []


class _Restless(QLearning):
    """Does not choose the same for the same draws."""

    calls = itertools.count()

    def choose(self, context: Context, draws: Floats) -> Choice:
        choice = super().choose(context, draws)
        return choice._replace(action=(choice.action + next(self.calls) // 7) % 3 - 1)


class _Leaping(QLearning):
    def choose(self, context: Context, draws: Floats) -> Choice:
        choice = super().choose(context, draws)
        return choice._replace(action=choice.action * 2)


class _Unlikely(QLearning):
    def choose(self, context: Context, draws: Floats) -> Choice:
        choice = super().choose(context, draws)
        return choice._replace(probability=choice.probability * 0)


class _Forgetful(QLearning):
    def save(self) -> dict[str, Any]:
        return QLearning(self.trials).save()


class _Gossiping(QLearning):
    """Lets trials learn from each other."""

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        super()._learn(context, choice, outcome)
        self.table = np.broadcast_to(self.table.mean(axis=0), self.table.shape).copy()


class _Gullible(QLearning):
    """Learns from whatever it is told."""

    def learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        self._learn(context, choice, outcome)


class _Hasty(QLearning):
    """Refuses, but too late."""

    def learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        self.table = self.table + 1
        super().learn(context, choice, outcome)


class _Broken(QLearning):
    def choose(self, context: Context, draws: Floats) -> Choice:
        raise ZeroDivisionError("oh")


class _Unmakeable(QLearning):
    def __init__(self, trials: int) -> None:
        raise ValueError("no")


@pytest.mark.parametrize(
    ("faulty", "fault"),
    [
        (_Restless, "the same draws do not give the same choices"),
        (_Leaping, "an action is not -1, 0 or 1"),
        (_Unlikely, "a probability is not above 0"),
        (_Forgetful, "a restored learner does not go on"),
        (_Gossiping, "a trial goes otherwise in a batch than alone"),
        (_Gullible, "a reward of nan is learned from"),
        (_Hasty, "a reward of nan is refused, but changes what was learned"),
        (_Broken, "ZeroDivisionError: oh"),
        (_Unmakeable, "ValueError: no"),
    ],
)
def test_each_fault_is_found(faulty: type[Learner], fault: str) -> None:
    faults = check_learner(faulty)
    assert any(fault in line for line in faults), faults
