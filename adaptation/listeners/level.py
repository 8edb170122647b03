"""The listener `level`: each distance has its own level of engagement."""

from __future__ import annotations

import numpy as np

from adaptation.problem import HIGHEST, Floats, Ints, within


class Level:
    """E goes one step towards 2 - |X - preference|, and stays once it is there.

    A listener of ours: there E itself, not its change, tells how well X fits. `live` is the same
    in real time.

    >>> e, x, p = np.zeros(5), np.array([-2, -1, 0, 1, 2]), np.full(5, 1)
    >>> Level().respond(e, x, np.zeros(5, dtype=np.int64), p, np.empty((0, 5)))
    array([-1.,  0.,  1.,  1.,  1.])
    """

    name = "level"
    draws = 0

    def start(self, trials: int) -> Floats:
        """Return E = 0 in each trial: neither engaged nor bored."""
        return np.zeros(trials)

    def respond(
        self, engagement: Floats, x: Ints, before: Ints, preference: Ints, draws: Floats
    ) -> Floats:
        """Return E after an utterance with `x`."""
        target = HIGHEST - np.abs(x - preference)
        return within(engagement + np.sign(target - engagement))
