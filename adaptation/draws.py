"""Random numbers: all are drawn up front, a stream of its own for each thing that needs chance.

So the same seed gives each learner the same listeners, whatever the noise and whoever else is
compared; and the numbers of a trial do not depend on how many trials there are. The generator is
Philox (Salmon et al., Parallel random numbers: as easy as 1, 2, 3, SC 2011), counter-based and
the same on every machine.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from adaptation.problem import Floats

# The streams and their numbers. Whoever changes a number changes every result.
STREAMS: Mapping[str, int] = MappingProxyType(
    {"preference": 0, "listener": 1, "response": 2, "sensor": 3, "stream": 4, "learner": 5}
)


class Draws:
    """The random numbers of an experiment, block after block of trials.

    >>> whole = Draws(seed=7).uniform("learner", trials=3, steps=2, count=1)
    >>> draws = Draws(seed=7)
    >>> blocks = [draws.uniform("learner", trials=n, steps=2, count=1) for n in (2, 1)]
    >>> (np.concatenate(blocks, axis=2) == whole).all()
    np.True_
    """

    def __init__(self, seed: int) -> None:
        self._generators = {
            name: np.random.Generator(np.random.Philox(np.random.SeedSequence((seed, number))))
            for name, number in STREAMS.items()
        }

    def uniform(self, stream: str, trials: int, steps: int, count: int) -> Floats:
        """Return the next trials' uniform numbers from [0, 1), shape (steps, count, trials)."""
        numbers = self._generators[stream].random((trials, steps, count))
        return np.ascontiguousarray(numbers.transpose(1, 2, 0))

    def normal(self, stream: str, trials: int, count: int) -> Floats:
        """Return the next trials' numbers of mean 0 and deviation 1, shape (count, trials)."""
        return np.ascontiguousarray(self._generators[stream].standard_normal((trials, count)).T)
