"""The problem: which extraversion X to speak with next, given how engaged the listener seems.

State (E, X), both from -2 to 2; actions decrease, keep and increase X; the reward is ΔE, the
change of engagement over one utterance. Source: the paper, section III-A.

All values are arrays with one entry for each trial: a live talk is one trial, an experiment runs
thousands side by side. No value is ever changed once it is made.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Ints: TypeAlias = NDArray[np.int64]
Floats: TypeAlias = NDArray[np.float64]

LOWEST, HIGHEST = -2, 2
# The levels of X, and of E where it is whole.
LEVELS: Ints = np.arange(LOWEST, HIGHEST + 1)
# What an action adds to X: decrease, keep, increase.
ACTIONS: Ints = np.array([-1, 0, 1])
# How far apart the values of a stream of sensed engagement are, in seconds (the paper, IV-B).
SAMPLE_SECONDS = 0.2


class Context(NamedTuple):
    """What a learner knows when it chooses: the step (from 0), X in force, the sensed E.

    `x` and `engagement` have shape (trials,). X in force is that of the last utterance, 0 before
    the first one. In real time the sensed E is not whole, and can lie beyond -2 and 2.
    """

    step: int
    x: Ints
    engagement: Floats


class Choice(NamedTuple):
    """A learner's action (-1, 0 or 1) in each trial, and the probability that it had; (trials,)."""

    action: Ints
    probability: Floats


class Outcome(NamedTuple):
    """What came of an action; shape (trials,).

    `reward` is the sensed ΔE, with the floor bonus where there is one; `x` is what was spoken
    with, `engagement` the sensed E afterwards. Where E is read while the utterance lasts,
    `stream` holds it, shape (trials, samples), NaN after the end and where nothing was sensed,
    and `duration` how long the utterance took, in seconds.
    """

    reward: Floats
    x: Ints
    engagement: Floats
    stream: Floats | None = None
    duration: Floats | None = None


def moved(x: Ints, action: Ints) -> Ints:
    """Return X after an action; at the ends of the scale it stays.

    >>> moved(np.array([-2, 0, 2]), np.array([-1, 1, 1]))
    array([-2,  1,  2])
    """
    after: Ints = np.maximum(np.minimum(x + action, HIGHEST), LOWEST)
    return after


def within(engagement: Floats) -> Floats:
    """Return E kept within -2 and 2.

    >>> within(np.array([-2.5, 0.5, 3.0]))
    array([-2. ,  0.5,  2. ])
    """
    # Not np.clip: with few trials that takes three times as long.
    kept = np.minimum(engagement, float(HIGHEST))
    return np.maximum(kept, float(LOWEST), out=kept)
