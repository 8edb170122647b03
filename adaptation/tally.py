"""Means over trials with their 95 % confidence intervals, added up block by block."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from adaptation.problem import Floats

Values: TypeAlias = NDArray[Any]


class Estimate(NamedTuple):
    """A mean, and how far the ends of its 95 % confidence interval lie from it.

    Of a single trial there is no interval: `ci95` is NaN.
    """

    value: float
    ci95: float

    def __repr__(self) -> str:
        return f"Estimate(value={self.value:.3f}, ci95={self.ci95:.3f})"


class Curve(NamedTuple):
    """The means over trials in each step, with their intervals; both of shape (steps,)."""

    value: Floats
    ci95: Floats


class Result:
    """What came of an experiment: of each measure its mean, and its mean in each step.

    The measures are `reward`; `match`, the share of trials in which X equals the preference; and
    `engagement`, the true E. The interval of an overall mean comes from the spread of the trials'
    own means, as the steps of one trial hang together.
    """

    def __init__(self, trials: int, means: dict[str, Estimate], curves: dict[str, Curve]) -> None:
        self.trials = trials
        self._means = means
        self._curves = curves

    def mean(self, measure: str) -> Estimate:
        """Return the mean over all steps and trials."""
        return self._means[measure]

    def curve(self, measure: str) -> Curve:
        """Return the means in each step."""
        return self._curves[measure]


class Tally:
    """Adds up trials, and forgets them.

    >>> tally = Tally(steps=2)
    >>> tally.add(reward=np.array([[0.0, 1.0], [1.0, 2.0]]))
    >>> tally.result().mean("reward").value
    1.0
    """

    def __init__(self, steps: int) -> None:
        self._steps = steps
        self._trials = 0
        # Of each measure: sum and sum of squares, in each step and, last, of the trials' means.
        self._sums: dict[str, Floats] = {}

    def add(self, **measures: Values) -> None:
        """Add trials; each measure has shape (steps, trials)."""
        self._trials += next(iter(measures.values())).shape[1]
        for name, values in measures.items():
            if name not in self._sums:
                self._sums[name] = np.zeros((2, self._steps + 1))
            numbers = values.astype(np.float64, copy=False)
            own = numbers.mean(axis=0)
            sums = self._sums[name]
            sums[:, :-1] += [numbers.sum(axis=1), np.einsum("st,st->s", numbers, numbers)]
            sums[:, -1] += [own.sum(), (own * own).sum()]

    def result(self) -> Result:
        """Return the means of all trials added."""
        means, curves = {}, {}
        for name, (total, squares) in self._sums.items():
            mean = total / self._trials
            half = np.full(len(mean), math.nan)
            if self._trials > 1:
                spread = np.maximum(squares / self._trials - mean * mean, 0)
                half = student95(self._trials - 1) * np.sqrt(spread / (self._trials - 1))
            means[name] = Estimate(float(mean[-1]), float(half[-1]))
            curves[name] = Curve(mean[:-1], half[:-1])
        return Result(self._trials, means, curves)


def student95(freedom: int) -> float:
    """Return Student's t that 95 % of the distribution lie within, for so many degrees of freedom.

    Source: Abramowitz & Stegun, Handbook of Mathematical Functions, 26.7.5; for one and two
    degrees, where that expansion is too coarse, the exact values.

    >>> [round(student95(freedom), 3) for freedom in (1, 2, 4, 29, 9999)]
    [12.706, 4.303, 2.776, 2.045, 1.96]
    """
    exact = {1: 12.706204736, 2: 4.302652730, 3: 3.182446305}
    if freedom in exact:
        return exact[freedom]
    z = 1.959963984540054
    terms: tuple[float, ...] = (
        z,
        (z**3 + z) / 4,
        (5 * z**5 + 16 * z**3 + 3 * z) / 96,
        (3 * z**7 + 19 * z**5 + 17 * z**3 - 15 * z) / 384,
        (79 * z**9 + 776 * z**7 + 1482 * z**5 - 1920 * z**3 - 945 * z) / 92160,
    )
    return sum((term / freedom**power for power, term in enumerate(terms)), 0.0)
