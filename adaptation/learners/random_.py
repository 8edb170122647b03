"""Moves X at random: what a learner gets that learns nothing. For scale, beside the learners."""

from __future__ import annotations

import numpy as np

from adaptation.learners.base import BatchLearner
from adaptation.problem import ACTIONS, Choice, Context, Floats, Outcome


class Random(BatchLearner):
    """Draws each action evenly.

    >>> context = Context(0, np.zeros(3, dtype=np.int64), np.zeros(3))
    >>> Random(trials=3).choose(context, np.array([[0.1, 0.4, 0.9]])).action
    array([-1,  0,  1])
    """

    name = "random"
    draws = 1

    def __init__(self, trials: int) -> None:
        super().__init__(trials)

    def _choose(self, context: Context, draws: Floats) -> Choice:
        index = (draws[0] * len(ACTIONS)).astype(np.int64)
        return Choice(ACTIONS[index], np.full(self.trials, 1 / len(ACTIONS)))

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        pass
