"""The listener `match`: only X = preference will do."""

from __future__ import annotations

import numpy as np

from adaptation.problem import Floats, Ints, within


class Match:
    """E rises by 1 where X equals the preference, and falls by 1 otherwise.

    This reading fits the paper's figure 2 (section III-B: engagement "increases when the robot's
    personality matches the actual preferences and decreases otherwise").

    >>> e, x, p = np.zeros(5), np.array([-2, -1, 0, 1, 2]), np.full(5, 1)
    >>> Match().respond(e, x, np.zeros(5, dtype=np.int64), p, np.empty((0, 5)))
    array([-1., -1., -1.,  1., -1.])
    """

    name = "match"
    draws = 0

    def start(self, trials: int) -> Floats:
        """Return E = 0 in each trial: neither engaged nor bored."""
        return np.zeros(trials)

    def respond(
        self, engagement: Floats, x: Ints, before: Ints, preference: Ints, draws: Floats
    ) -> Floats:
        """Return E after an utterance with `x`."""
        change = np.where(x == preference, 1.0, -1.0)
        return within(engagement + change)
