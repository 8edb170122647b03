"""The listener `live`: engagement in real time, while the robot speaks."""

from __future__ import annotations

import math

import numpy as np

from adaptation.listeners.base import Course
from adaptation.problem import HIGHEST, LOWEST, SAMPLE_SECONDS, Floats, Ints
from personage_lite.errors import PersonageError

# How long an utterance takes at X = -2 and X = 2, in seconds; between them it grows evenly. The
# paper, section V: about 30 introvert or 10 extravert utterances in three minutes, with pauses.
SHORTEST_SECONDS, LONGEST_SECONDS = 4.0, 12.0


class Live:
    """E is a real number that relaxes towards 2 - |X - preference| while an utterance lasts.

    Its time constant is `tau` seconds: an utterance of d seconds shows 1 - exp(-d / tau) of the
    change that it would bring in the end, so with the default of 8 s a short one shows 39 %, a
    long one 78 %. An utterance takes 4 s at X = -2 to 12 s at X = 2. One follows the other: in
    the pauses E would rest, so they are left out. E starts at 0.

    >>> listener = Live()
    >>> x, preference = np.array([-2, 2]), np.array([2, 2])
    >>> course = listener.listen(listener.start(2), x, preference)
    >>> course.samples * 0.2  # seconds
    array([ 4., 12.])
    >>> [round(float(course.path[n - 1, i]), 2) for i, n in enumerate(course.samples)]
    [-0.79, 1.55]
    """

    name = "live"
    longest = round(LONGEST_SECONDS / SAMPLE_SECONDS)

    def __init__(self, tau: float = 8.0) -> None:
        if not (0 < tau < math.inf):
            raise PersonageError(f"live: tau is {tau}; give a time constant in seconds, above 0")
        self.tau = tau
        # How much of the way to go is left after so many samples; shape (longest, 1).
        steps = range(1, self.longest + 1)
        self._left = np.array([[math.exp(-SAMPLE_SECONDS * step / tau)] for step in steps])

    def start(self, trials: int) -> Floats:
        """Return E = 0 in each trial: neither engaged nor bored."""
        return np.zeros(trials)

    def listen(self, engagement: Floats, x: Ints, preference: Ints) -> Course:
        """Return how E runs during an utterance with `x`."""
        target = HIGHEST - np.abs(x - preference).astype(np.float64)
        return Course(target + (engagement - target) * self._left, samples_of(x))


def samples_of(x: Ints) -> Ints:
    """Return how many samples of 200 ms an utterance with `x` takes.

    >>> samples_of(np.array([-2, 0, 2]))
    array([20, 40, 60])
    """
    share = (x - LOWEST) / (HIGHEST - LOWEST)
    seconds = SHORTEST_SECONDS + (LONGEST_SECONDS - SHORTEST_SECONDS) * share
    samples: Ints = np.rint(seconds / SAMPLE_SECONDS).astype(np.int64)
    return samples
