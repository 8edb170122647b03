"""The statistics of a report, without packages: everything is exact and the same at every run."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from itertools import groupby, pairwise
from math import sqrt

# Of so many words is the type/token ratio taken: over a whole text it falls with the length
# (M. Covington and J. McFall, "Cutting the Gordian knot: the moving-average type-token ratio",
# Journal of Quantitative Linguistics 17(2), 2010).
WINDOW = 50
# A correlation so many standard errors from 0 is a trend: one in a hundred is by chance.
_CERTAIN = 2.576
# With fewer pairs nothing is said about a trend.
_FEWEST = 10


def ranks(values: Sequence[float]) -> list[float]:
    """Return the rank of each value, from 1; equal values share the mean of theirs.

    >>> ranks([3, 1, 3])
    [2.5, 1.0, 2.5]
    """
    order = sorted(range(len(values)), key=values.__getitem__)
    found = [0.0] * len(values)
    behind = 0
    for _, same in groupby(order, key=values.__getitem__):
        indices = list(same)
        for index in indices:
            found[index] = behind + (len(indices) + 1) / 2
        behind += len(indices)
    return found


def correlation(first: Sequence[float], second: Sequence[float]) -> float | None:
    """Return Pearson's correlation; None if one of the two does not vary."""
    mean1, mean2 = sum(first) / len(first), sum(second) / len(second)
    apart1, apart2 = [one - mean1 for one in first], [two - mean2 for two in second]
    spread = sqrt(sum(one * one for one in apart1) * sum(two * two for two in apart2))
    if spread < 1e-12:
        return None
    return sum(one * two for one, two in zip(apart1, apart2, strict=True)) / spread


def rank_correlation(first: Sequence[float], second: Sequence[float]) -> float | None:
    """Return Spearman's correlation; None for fewer than ten pairs, or if one does not vary.

    C. Spearman, "The proof and measurement of association between two things", American Journal
    of Psychology 15, 1904.
    """
    if len(first) < _FEWEST:
        return None
    return correlation(ranks(first), ranks(second))


def is_certain(trend: float, pairs: int) -> bool:
    """Whether a rank correlation over so many pairs differs from 0 at the level of 1 %."""
    return abs(trend) * sqrt((pairs - 2) / max(1 - trend * trend, 1e-12)) > _CERTAIN


def jackknife(
    parts: Sequence[Mapping[str, int]],
    keys: Sequence[str],
    value: Callable[[Mapping[str, int]], float | None],
) -> float | None:
    """Return the standard error of a value of summed parts; None if there are too few parts.

    Each part is left out once (B. Efron and R. Tibshirani, "An introduction to the bootstrap",
    1993, chapter 11). `keys` are those that the value asks for.
    """
    sums = {key: sum(part[key] for part in parts) for key in keys}
    without = [value({key: sums[key] - part[key] for key in keys}) for part in parts]
    found = [one for one in without if one is not None]
    if len(found) < 2:
        return None
    mean = sum(found) / len(found)
    return sqrt((len(found) - 1) / len(found) * sum((one - mean) ** 2 for one in found))


def standard_error(values: Sequence[float]) -> float | None:
    """Return the standard error of a mean; None for fewer than two values."""
    count = len(values)
    if count < 2:
        return None
    mean = sum(values) / count
    return sqrt(sum((value - mean) ** 2 for value in values) / (count - 1) / count)


def moving_ratio(words: Sequence[str]) -> float | None:
    """Return the mean share of different words in each window of 50; None for fewer words.

    >>> moving_ratio(["a", "b"] * 50)
    0.04
    """
    if len(words) < WINDOW:
        return None
    counts = Counter(words[:WINDOW])
    different = len(counts)
    total = different
    for left, joined in zip(words, words[WINDOW:], strict=False):
        counts[left] -= 1
        different -= not counts[left]
        different += not counts[joined]
        counts[joined] += 1
        total += different
    return total / (len(words) - WINDOW + 1) / WINDOW


def separate_ratios(words: Sequence[str]) -> list[float]:
    """Return the share of different words in each stretch of 50 words, side by side."""
    edges = range(0, len(words) + 1, WINDOW)
    return [len(set(words[start:end])) / WINDOW for start, end in pairwise(edges)]
