"""Measures utterances: each feature at each X, its trend, and whether it is the published one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from typing import NamedTuple, TypeAlias

from personage_lite.errors import PersonageError
from personage_lite.measure.counting import Counted, FeatureCounter, value_of
from personage_lite.measure.features import Feature, load_features
from personage_lite.measure.reading import HasStyle, said
from personage_lite.measure.richness import Richness, richness
from personage_lite.measure.statistics import (
    is_certain,
    jackknife,
    moving_ratio,
    rank_correlation,
    separate_ratios,
    standard_error,
)

# More values of X than that are grouped by the nearest whole number.
MOST_GROUPS = 11
# Of so many words, at least, are the stretches that a rate is correlated over.
STRETCH = 100


# The counts of an utterance, or of several; a feature without any has none.
Totals: TypeAlias = Mapping[str, int]


class Group(NamedTuple):
    """The utterances of one X (None: they have none), and how much they hold."""

    x: float | None
    utterances: int
    words: int
    sentences: int


class Value(NamedTuple):
    """A feature's value at one X and its standard error; None where nothing can be said."""

    x: float | None
    value: float | None
    error: float | None


class Row(NamedTuple):
    """A feature at each X.

    `trend` is Spearman's correlation with X, over the utterances if the feature is one per
    utterance, else over stretches of utterances with 100 words or more (50 for type/token ratio).
    `verdict` is "agrees" or "disagrees" with the published direction, "no trend" if there is a
    published one but no certain trend (1 %), and "" if no direction is published or X is but one.
    """

    feature: Feature
    values: tuple[Value, ...]
    trend: float | None
    verdict: str


class Report(NamedTuple):
    """What `measure` found; `sources` are the full titles of those that the features name.

    `rounded` is whether there were so many X that the groups are those of the nearest whole number.
    """

    groups: tuple[Group, ...]
    rows: tuple[Row, ...]
    richness: tuple[Richness, ...]
    sources: Mapping[str, str]
    rounded: bool


def measure(
    utterances: Iterable[str | HasStyle], lexicons: str | PathLike[str] | None = None
) -> Report:
    """Measure the style of utterances, by X if they have one.

    An utterance is a text, or anything with a `text` and an `x`: what `Generator` says, a `Said`.
    `lexicons` is the folder of the words, the shipped one by default. Raises `PersonageError` if
    there is nothing to measure or a package of the extra `measure` is missing.

    >>> report = measure(["I love it!", "Alice isn't dull, is she?"])
    >>> next(row.values[0].value for row in report.rows if row.feature.name == "words")
    4.0
    """
    everything = said(utterances)
    if not everything:
        raise PersonageError("there is nothing to measure; give at least one utterance")
    features = load_features(lexicons)
    counter = FeatureCounter(features)
    counted = [counter.count(one.text) for one in everything]
    grouped = _grouped([one.x for one in everything], counted)
    samples = [_sample(x, parts) for x, parts in grouped]
    return Report(
        tuple(_group(x, parts) for x, parts in grouped),
        tuple(_row(feature, samples) for feature in features.features),
        richness(
            [(x, [part.sentences for part in parts]) for x, parts in grouped], features.lists.closed
        ),
        features.sources,
        not {one.x for one in everything} <= {x for x, _ in grouped},
    )


def _grouped(
    xs: Sequence[float | None], counted: Sequence[Counted]
) -> list[tuple[float | None, list[Counted]]]:
    """Return what was counted by X, in order; many values of X by the nearest whole number."""
    keys: list[float | None] = list(xs)
    if len(set(keys)) > MOST_GROUPS:
        keys = [None if x is None else float(round(x)) for x in xs]
    if len(set(keys)) > MOST_GROUPS:
        raise PersonageError(
            f"there are {len(set(keys))} whole numbers as X; give at most {MOST_GROUPS}"
        )
    groups: dict[float | None, list[Counted]] = {}
    for key in sorted(set(keys), key=lambda x: x or 0.0):
        groups[key] = []
    for key, part in zip(keys, counted, strict=True):
        groups[key].append(part)
    return list(groups.items())


def _group(x: float | None, parts: Sequence[Counted]) -> Group:
    words = sum(part.totals["words"] for part in parts)
    return Group(x, len(parts), int(words), int(sum(part.totals["sentences"] for part in parts)))


class _Sample(NamedTuple):
    """What is measured at one X: each utterance, stretches of several, and all words in a row."""

    x: float | None
    utterances: Sequence[Totals]
    stretches: Sequence[Totals]
    words: Sequence[str]


def _sample(x: float | None, parts: Sequence[Counted]) -> _Sample:
    totals = [part.totals for part in parts]
    words = [word.text for part in parts for one in part.sentences for word in one.words]
    return _Sample(x, totals, _stretches(totals), words)


def _row(feature: Feature, samples: Sequence[_Sample]) -> Row:
    values = []
    pairs: list[tuple[float, float]] = []
    for sample in samples:
        if feature.per == "window":
            found = separate_ratios(sample.words)
            values.append(Value(sample.x, moving_ratio(sample.words), standard_error(found)))
        else:
            values.append(_value(feature, sample))
            parts = sample.utterances if feature.per == "utterance" else sample.stretches
            known = [value_of(feature, part) for part in parts]
            found = [value for value in known if value is not None]
        if sample.x is not None:
            pairs += [(sample.x, value) for value in found]
    trend = rank_correlation([x for x, _ in pairs], [value for _, value in pairs])
    return Row(feature, tuple(values), trend, _verdict(feature, trend, len(pairs), len(samples)))


def _stretches(parts: Sequence[Totals]) -> list[Totals]:
    """Return the totals of successive utterances, of at least 100 words together.

    A rate over a single utterance says more of its length than of its style: a rare word is absent
    from most short ones, and frequent in the others.
    """
    found: list[Counter[str]] = [Counter()]
    for part in parts:
        if found[-1]["words"] >= STRETCH:
            found.append(Counter())
        for key, count in part.items():
            found[-1][key] += count
    if len(found) > 1 and found[-1]["words"] < STRETCH:
        last = found.pop()
        for key, count in last.items():
            found[-1][key] += count
    return [*found]


def _value(feature: Feature, sample: _Sample) -> Value:
    """Return a feature of all utterances together: of their summed counts, no mean of theirs."""
    parts = sample.utterances
    keys = ("utterances", "words", "sentences", "syllables", feature.quantity or feature.name)
    value = value_of(feature, {key: sum(part[key] for part in parts) for key in keys})
    if value is None:
        return Value(sample.x, None, None)
    error = jackknife(parts, keys, lambda totals: value_of(feature, totals))
    return Value(sample.x, value, error)


def _verdict(feature: Feature, trend: float | None, pairs: int, groups: int) -> str:
    if feature.direction == "none" or groups < 2:
        return ""
    if trend is None or not is_certain(trend, pairs):
        return "no trend"
    return "agrees" if (trend > 0) == (feature.direction == "rises") else "disagrees"
