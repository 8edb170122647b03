"""Never leaves X = 0: what a robot without any learning gets. For scale, beside the learners."""

from __future__ import annotations

import numpy as np

from adaptation.learners.base import BatchLearner
from adaptation.problem import Choice, Context, Floats, Outcome


class AlwaysZero(BatchLearner):
    """Walks back to X = 0 wherever it starts, and stays there.

    >>> context = Context(0, np.array([-2, 0, 1]), np.zeros(3))
    >>> AlwaysZero(trials=3).choose(context, np.empty((0, 3))).action
    array([ 1,  0, -1])
    """

    name = "always-zero"

    def __init__(self, trials: int) -> None:
        super().__init__(trials)

    def _choose(self, context: Context, draws: Floats) -> Choice:
        return Choice(-np.sign(context.x), np.ones(self.trials))

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        pass
