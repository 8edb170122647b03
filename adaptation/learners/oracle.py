"""Knows the listener's preference and walks to it: the best that any learner could do."""

from __future__ import annotations

import numpy as np

from adaptation.learners.base import BatchLearner
from adaptation.problem import Choice, Context, Floats, Ints, Outcome
from personage_lite.errors import PersonageError


class Oracle(BatchLearner):
    """Walks to the preference that it is told before each choice, and stays there.

    >>> oracle = Oracle(trials=3)
    >>> oracle.reveal(np.array([2, 0, -2]))
    >>> oracle.choose(Context(0, np.zeros(3, dtype=int), np.zeros(3)), np.empty((0, 3))).action
    array([ 1,  0, -1])
    """

    name = "oracle"
    memory = ("preference",)

    def __init__(self, trials: int) -> None:
        super().__init__(trials)
        self.preference: Ints = np.zeros(self.trials, dtype=np.int64)

    def reveal(self, preference: Ints) -> None:
        """Take note of the preference in each trial, shape (trials,), before the choice of X."""
        if preference.shape != (self.trials,):
            raise PersonageError(f"oracle: give {self.trials} preferences")
        self.preference = preference

    def _choose(self, context: Context, draws: Floats) -> Choice:
        return Choice(np.sign(self.preference - context.x), np.ones(self.trials))

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        pass
