"""What a simulated listener is: how engagement E answers to extraversion X.

Two kinds. A `Listener` answers once for each utterance; its E is usually a whole number. A
`LiveListener` answers while the utterance lasts. Both are batched: arrays have one entry a trial.
Noise and sensors are not theirs: see noise.py and sensor.py.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

from adaptation.problem import Floats, Ints


class Listener(Protocol):
    """A listener whose engagement changes once for each utterance.

    A listener of one's own is a class with these four members and needs no base class:

    >>> import numpy as np
    >>> from adaptation.contracts import check_listener
    >>> class Patient:
    ...     '''Pleased by what is near enough, and never falls below indifference.'''
    ...     name = "patient"
    ...     draws = 0
    ...     def start(self, trials: int) -> Floats:
    ...         return np.zeros(trials)
    ...     def respond(self, engagement, x, before, preference, draws):
    ...         return np.clip(engagement + np.where(abs(x - preference) <= 1, 1, -1), 0, 2)
    >>> check_listener(Patient())
    []
    >>> from adaptation.experiment import Experiment
    >>> from adaptation.learners import LEARNERS
    >>> result = Experiment(Patient(), trials=1000).run(LEARNERS["q-learning"])
    >>> 0 < result.mean("engagement").value < 2
    True
    """

    name: str
    # How many uniform numbers from [0, 1) `respond` needs for each step and trial.
    draws: int

    def start(self, trials: int) -> Floats:
        """Return the true E before the first utterance, from -2 to 2; shape (trials,)."""

    def respond(
        self, engagement: Floats, x: Ints, before: Ints, preference: Ints, draws: Floats
    ) -> Floats:
        """Return the true E, from -2 to 2, after an utterance with `x`.

        `engagement` is the true E until then, `before` the X of the utterance before (0 at the
        start), all of shape (trials,); `draws` has shape (`self.draws`, trials). Pure: the same
        arguments give the same E, and no argument is changed.
        """


class Course(NamedTuple):
    """How the true E runs during an utterance.

    `path` has shape (samples, trials), a row each 200 ms, the first one 200 ms after the start;
    after an utterance's own end its values mean nothing. `samples` (trials,) is how many of them
    each utterance has.
    """

    path: Floats
    samples: Ints


class LiveListener(Protocol):
    """A listener whose engagement changes while the utterance lasts."""

    name: str
    # How many samples the longest utterance has, 200 ms each.
    longest: int

    def start(self, trials: int) -> Floats:
        """Return the true E before the first utterance; shape (trials,)."""

    def listen(self, engagement: Floats, x: Ints, preference: Ints) -> Course:
        """Return how the true E runs during an utterance with `x`; all arguments (trials,)."""
