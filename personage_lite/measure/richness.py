"""Lexical richness: how often a style says the same in the same words."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from typing import NamedTuple, TypeAlias

from personage_lite.measure.words import Sentence

# An utterance as its sentences.
Utterance: TypeAlias = Sequence[Sentence]
Phrase: TypeAlias = tuple[str, ...]
_OPENING = 3
_SHORTEST, _LONGEST = 3, 5
_MOST_WORN = 10
_NEARLY_ALWAYS = 0.75


class Worn(NamedTuple):
    """A phrase and how many utterances hold it."""

    phrase: str
    utterances: int


class Richness(NamedTuple):
    """How rich the language at one X is.

    `distinct_1` and `distinct_2` are the shares of different words and of different pairs of
    neighbouring words (J. Li and others, "A diversity-promoting objective function for neural
    conversation models", NAACL 2016, section 5), over the first `words` words: as many as the X
    with the fewest has, because the shares fall with length. `repeated_openings` is the share of
    utterances whose first three words begin another one of this X, too. `worn` are the phrases of
    three to five words that most utterances hold, without names, none much like another.
    """

    x: float | None
    words: int
    distinct_1: float | None
    distinct_2: float | None
    repeated_openings: float | None
    worn: tuple[Worn, ...]


def richness(
    groups: Sequence[tuple[float | None, Sequence[Utterance]]], closed: frozenset[str]
) -> tuple[Richness, ...]:
    """Return the richness of each group of utterances, given with its X.

    `closed` are the words of the closed classes (pronouns, prepositions …).
    """
    everything = [
        (index, word)
        for _, utterances in groups
        for utterance in utterances
        for sentence in utterance
        for index, word in enumerate(sentence.words)
    ]
    # What has a capital letter inside a sentence is a name wherever it stands.
    names = {word.text for index, word in everything if index and word.capital} - closed
    fewest = min((_length(utterances) for _, utterances in groups), default=0)
    return tuple(
        _richness(x, [_texts(one) for one in utterances], fewest, names, closed)
        for x, utterances in groups
    )


def _length(utterances: Sequence[Utterance]) -> int:
    return sum(len(sentence.words) for utterance in utterances for sentence in utterance)


def _texts(utterance: Utterance) -> list[Phrase]:
    return [tuple(word.text for word in sentence.words) for sentence in utterance]


def _richness(
    x: float | None,
    utterances: Sequence[Sequence[Phrase]],
    most: int,
    names: set[str],
    closed: frozenset[str],
) -> Richness:
    words: list[Phrase] = []
    pairs: list[Phrase] = []
    for utterance in utterances:
        for sentence in utterance:
            taken = sentence[: most - len(words)]
            words += _phrases(taken, 1)
            pairs += _phrases(taken, 2)
    return Richness(
        x,
        len(words),
        _distinct(words),
        _distinct(pairs),
        _repeated_openings(utterances),
        _worn(utterances, names, closed),
    )


def _phrases(words: Phrase, length: int) -> Iterator[Phrase]:
    for start in range(len(words) - length + 1):
        yield words[start : start + length]


def _distinct(phrases: Sequence[Phrase]) -> float | None:
    return len(set(phrases)) / len(phrases) if phrases else None


def _repeated_openings(utterances: Sequence[Sequence[Phrase]]) -> float | None:
    starts = [tuple(chain.from_iterable(utterance))[:_OPENING] for utterance in utterances]
    openings = [start for start in starts if start]
    counts = Counter(openings)
    return sum(counts[one] > 1 for one in openings) / len(openings) if openings else None


def _worn(
    utterances: Sequence[Sequence[Phrase]], names: set[str], closed: frozenset[str]
) -> tuple[Worn, ...]:
    counts: Counter[Phrase] = Counter()
    for utterance in utterances:
        counts.update(
            {
                phrase
                for sentence in utterance
                for length in range(_SHORTEST, _LONGEST + 1)
                for phrase in _phrases(sentence, length)
                if names.isdisjoint(phrase)
            }
        )
    shared = {phrase: count for phrase, count in counts.items() if count > 1}
    worn: list[Worn] = []
    taken: set[Phrase] = set()
    for phrase in sorted(shared, key=lambda phrase: (-shared[phrase], -len(phrase), phrase)):
        if not taken.isdisjoint(_telling_pairs(phrase, closed)):
            continue
        whole = _whole(phrase, shared)
        # What is much like a phrase that is listed has two neighbouring words of it.
        pairs = _telling_pairs(whole, closed)
        if pairs and taken.isdisjoint(pairs):
            worn.append(Worn(" ".join(whole), shared[whole]))
            if len(worn) == _MOST_WORN:
                break
        taken.update(pairs)
    return tuple(sorted(worn, key=lambda one: (-one.utterances, one.phrase)))


def _telling_pairs(phrase: Phrase, closed: frozenset[str]) -> list[Phrase]:
    """Return a phrase's neighbouring words, but for "of the" and the like."""
    return [pair for pair in _phrases(phrase, 2) if not closed.issuperset(pair)]


def _whole(phrase: Phrase, counts: Mapping[Phrase, int]) -> Phrase:
    """Return the longest phrase that a phrase is nearly always part of, or itself."""
    wider = [
        one
        for one, count in counts.items()
        if len(one) > len(phrase)
        and count >= _NEARLY_ALWAYS * counts[phrase]
        and phrase in _phrases(one, len(phrase))
    ]
    return max(wider, key=lambda one: (len(one), counts[one], one), default=phrase)
