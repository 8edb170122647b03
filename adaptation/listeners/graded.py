"""The listener `graded`: the next best X at least does no harm."""

from __future__ import annotations

import numpy as np

from adaptation.problem import Floats, Ints, within


class Graded:
    """E rises by 1 at the preference, stays one level beside it, and falls by 1 further away.

    A listener of ours, as a kinder `match`: the paper says nothing of distance.

    >>> e, x, p = np.zeros(5), np.array([-2, -1, 0, 1, 2]), np.full(5, 1)
    >>> Graded().respond(e, x, np.zeros(5, dtype=np.int64), p, np.empty((0, 5)))
    array([-1., -1.,  0.,  1.,  0.])
    """

    name = "graded"
    draws = 0

    def start(self, trials: int) -> Floats:
        """Return E = 0 in each trial: neither engaged nor bored."""
        return np.zeros(trials)

    def respond(
        self, engagement: Floats, x: Ints, before: Ints, preference: Ints, draws: Floats
    ) -> Floats:
        """Return E after an utterance with `x`."""
        change = np.sign(1 - np.abs(x - preference))
        return within(engagement + change)
