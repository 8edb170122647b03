"""The listener `near`: whatever is near enough pleases."""

from __future__ import annotations

import numpy as np

from adaptation.problem import Floats, Ints, within


class Near:
    """E rises by 1 where X is at most one level from the preference, and falls by 1 otherwise.

    After the paper, section III-A: engagement is expected to rise when extraversion is "close to
    the user's actual preferences", and to fall otherwise.

    >>> e, x, p = np.zeros(5), np.array([-2, -1, 0, 1, 2]), np.full(5, 1)
    >>> Near().respond(e, x, np.zeros(5, dtype=np.int64), p, np.empty((0, 5)))
    array([-1., -1.,  1.,  1.,  1.])
    """

    name = "near"
    draws = 0

    def start(self, trials: int) -> Floats:
        """Return E = 0 in each trial: neither engaged nor bored."""
        return np.zeros(trials)

    def respond(
        self, engagement: Floats, x: Ints, before: Ints, preference: Ints, draws: Floats
    ) -> Floats:
        """Return E after an utterance with `x`."""
        change = np.where(np.abs(x - preference) <= 1, 1.0, -1.0)
        return within(engagement + change)
