"""The listener `closer`: it counts whether X came nearer to the preference."""

from __future__ import annotations

import numpy as np

from adaptation.problem import Floats, Ints, within


class Closer:
    """E rises by 1 where X came nearer to the preference or meets it, and falls by 1 otherwise.

    After the paper, section III-A: engagement is expected to rise when extraversion is "close to
    the user's actual preferences". Here a step towards them is what pleases.

    >>> e, x, p = np.zeros(5), np.array([-2, -1, 0, 1, 2]), np.full(5, 1)
    >>> Closer().respond(e, x, np.zeros(5, dtype=np.int64), p, np.empty((0, 5)))
    array([-1., -1., -1.,  1., -1.])
    """

    name = "closer"
    draws = 0

    def start(self, trials: int) -> Floats:
        """Return E = 0 in each trial: neither engaged nor bored."""
        return np.zeros(trials)

    def respond(
        self, engagement: Floats, x: Ints, before: Ints, preference: Ints, draws: Floats
    ) -> Floats:
        """Return E after an utterance with `x`."""
        distance = np.abs(x - preference)
        nearer = (distance < np.abs(before - preference)) | (distance == 0)
        change = np.where(nearer, 1.0, -1.0)
        return within(engagement + change)
