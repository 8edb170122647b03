"""As X rises, speech becomes more extravert, step by step: measured over 2,000 seeds for each X.

All figures are means over utterances, read from the text and the realizer's input.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import pairwise
from statistics import fmean
from typing import TypeAlias

import pytest

from personage_lite import Generator
from personage_lite.data import data_folder
from personage_lite.facts_reader import character_files
from personage_lite.plan import Utterance
from personage_lite.realizer.specification import AdjectivePhrase, Clause, Embedded, Text

XS = (-2, -1, 0, 1, 2)
SEEDS = 2_000
CHARACTERS = tuple(character_files(data_folder("facts")))
GENERATOR = Generator()
LEXICON = GENERATOR.lexicon

Sample: TypeAlias = dict[int, list[Utterance]]
Measure: TypeAlias = Callable[[Utterance], float]


@pytest.fixture(scope="module")
def sample() -> Sample:
    """All utterances, by X, of all characters in turn.

    A third of them are the first of their talk, a third the second and a third the third.
    """
    return {x: [_said(x, seed) for seed in range(SEEDS)] for x in XS}


def _said(x: float, seed: int) -> Utterance:
    turns = GENERATOR.turns(
        CHARACTERS[seed % len(CHARACTERS)], x, seed, count=1 + seed // len(CHARACTERS) % 3
    )
    return list(turns)[-1]


# Positive words: those of the lexicon, with their endings, and what markers and templates add.

GLAD = {
    "love",
    "loves",
    "lovely",
    "wonderful",
    "great",
    "adore",
    "like",
    "best",
    "wow",
    "beautiful",
}


def _positive() -> set[str]:
    found = set(GLAD)
    for concept in LEXICON.adjectives.values():
        found |= {word.text for word in concept.words if word.emotion >= 0.4}
    for concept in LEXICON.verbs.values():
        for word in concept.words:
            if word.emotion >= 0.4 and not word.particle:
                stem = word.text.removesuffix("e")
                found |= {word.text, f"{word.text}s", f"{word.text}es", f"{stem}ed", f"{stem}ing"}
    # "like" is more often a filled pause than a feeling.
    return found - {"like"}


POSITIVE = _positive()


# Measures


def words(said: Utterance) -> list[str]:
    """Return the words of an utterance, without case."""
    return re.findall(r"[^\W\d_]+(?:['-][^\W\d_]+)*", said.text.lower())


def positive_words(said: Utterance) -> float:
    """Count positive words."""
    return sum(word in POSITIVE for word in words(said))


def clauses(node: object) -> Iterator[Clause]:
    """Yield all clauses inside anything."""
    if isinstance(node, Clause):
        yield node
    if isinstance(node, tuple):
        for inner in node:
            yield from clauses(inner)


def adjectives(node: object) -> Iterator[AdjectivePhrase]:
    """Yield all adjectives inside anything."""
    if isinstance(node, AdjectivePhrase):
        yield node
    elif isinstance(node, tuple):
        for inner in node:
            yield from adjectives(inner)


def frames(said: Utterance) -> list[str]:
    """Return the fixed main clauses around others."""
    bodies = [
        body
        for sentence in said.sentences
        for body in (sentence.body, *(joined.body for joined in sentence.joined))
    ]
    leads = [body.lead.parts[0] for body in bodies if isinstance(body, Embedded)]
    return [lead for lead in leads if isinstance(lead, str)]


def texts(kind: str) -> frozenset[str]:
    """Return the words of a kind of marker."""
    return frozenset(marker.text for marker in LEXICON.markers[kind])


SOFTENERS = texts("softener_hedges") | texts("weakened_positive_content")
INFORMAL = texts("informal_softeners")
EMPHASIZERS = texts("emphasizer_hedges")
ACKNOWLEDGMENTS = texts("acknowledgments")
PAUSES = texts("filled_pauses")
OATHS = texts("near_expletives") | texts("expletives")
HESITANT = ("um", "err", "mmhm")


def degrees(said: Utterance) -> list[str]:
    """Return the adverbs before adjectives."""
    return [adverb for phrase in adjectives(said.sentences) for adverb in phrase.adverbs]


def openers(said: Utterance) -> list[str]:
    """Return the words before sentences."""
    return [opener.text for sentence in said.sentences for opener in sentence.openers]


def interruptions(said: Utterance) -> list[str]:
    """Return the hesitations inside clauses."""
    return [c.interruption for c in clauses(said.sentences) if c.interruption]


def softeners(said: Utterance) -> float:
    """Count "somewhat", "I think that" and "…, it seems"."""
    heard = degrees(said) + frames(said) + [s.afterthought for s in said.sentences]
    return sum(word in SOFTENERS for word in heard)


def informal(said: Utterance) -> float:
    """Count "kind of" and "pretty"."""
    return sum(word in INFORMAL for word in degrees(said))


def emphasizers(said: Utterance) -> float:
    """Count what is stressed, except where an attribute is said again."""
    heard = openers(said) + degrees(said)
    heard += [word for clause in clauses(said.sentences) for word in clause.emphasizers]
    return sum(word in EMPHASIZERS for word in heard)


def acknowledgments(said: Utterance) -> float:
    """Count "yeah"."""
    return sum(word in ACKNOWLEDGMENTS for word in openers(said))


def pauses(said: Utterance) -> float:
    """Count filled pauses of all kinds."""
    return sum(word in PAUSES for word in openers(said) + interruptions(said))


def hesitations(said: Utterance) -> float:
    """Return the share of words that are "um", "err" or "mmhm".

    A share, for from X = 0 on they are so rare that longer speech would hide the fall.
    """
    return fmean(word in HESITANT for word in words(said))


def stutters(said: Utterance) -> float:
    """Count "Al-Alice"."""
    return len(re.findall(r"\b(\w{1,3})-(?:\1-)?\1\w", said.text))


def tags(said: Utterance) -> float:
    """Count tag questions."""
    return sum(bool(sentence.tag) for sentence in said.sentences)


def vocatives(said: Utterance) -> float:
    """Count in-group markers."""
    words = {marker.text for marker in GENERATOR.lexicon.markers["in_group_marker"]}
    spoken = [*(sentence.vocative for sentence in said.sentences)]
    spoken += [opener.text for sentence in said.sentences for opener in sentence.openers]
    return sum(word in words for word in spoken)


def exclamations(said: Utterance) -> float:
    """Count exclamation marks that are not inside quotations."""
    return re.sub("“[^”]*”", "", said.text).count("!")


def oaths(said: Utterance) -> float:
    """Count oaths, real and almost."""
    return sum(word in OATHS for word in openers(said) + degrees(said))


def confirmations(said: Utterance) -> float:
    """Whether the topic is confirmed."""
    body = said.sentences[0].body
    return (isinstance(body, Text) and len(body.parts) > 1) or said.text.startswith("Let's see")


def rejections(said: Utterance) -> float:
    """Whether it begins with a refusal."""
    return any(said.text.startswith(text) for text in texts("initial_rejection"))


def mitigations(said: Utterance) -> float:
    """Whether everybody knows it."""
    return any(text in said.text.lower() for text in texts("competence_mitigation"))


def first_person(said: Utterance) -> float:
    """Count self-references: "I love how"."""
    applied = [decision for decision in said.decisions if decision.status == "applied"]
    return sum(decision.operator == "self_references" for decision in applied)


def false_starts(said: Utterance) -> float:
    """Count broken-off sentences."""
    return sum(sentence.false_start for sentence in said.sentences)


def word_count(said: Utterance) -> float:
    """Count words."""
    return len(words(said))


def fact_count(said: Utterance) -> float:
    """Count facts."""
    return len(said.facts)


# What each measure must at least add (or take off) from X = -2 to X = 2.
RISING: list[tuple[Measure, float]] = [
    (word_count, 8.0),
    (fact_count, 1.1),
    (positive_words, 0.35),
    (tags, 0.012),
    (vocatives, 0.007),
    (exclamations, 0.8),
    (emphasizers, 0.1),
    (first_person, 0.08),
    (oaths, 0.05),
    (confirmations, 0.1),
]
FALLING: list[tuple[Measure, float]] = [
    (softeners, 0.08),
    (stutters, 0.004),
    (hesitations, 0.015),
    (rejections, 0.002),
]
# What is rare on one side, where chance, or what else stands there, may hide a small step.
ROUGHLY: list[tuple[Measure, float]] = [(acknowledgments, 0.08), (false_starts, -0.004)]
_A_STEP = 0.01
MARKERS: list[Measure] = [
    softeners,
    informal,
    emphasizers,
    acknowledgments,
    pauses,
    hesitations,
    stutters,
    tags,
    vocatives,
    exclamations,
    oaths,
    confirmations,
    rejections,
    mitigations,
    first_person,
    false_starts,
]


def means(sample: Sample, measure: Measure) -> list[float]:
    """Return a measure's mean at each X."""
    return [fmean(map(measure, sample[x])) for x in XS]


@pytest.mark.parametrize(("measure", "least"), RISING)
def test_rises_with_x(sample: Sample, measure: Measure, least: float) -> None:
    """It never falls from X to X + 1, and from -2 to 2 it rises clearly."""
    found = means(sample, measure)
    assert found == sorted(found)
    assert found[-1] - found[0] >= least, found


@pytest.mark.parametrize(("measure", "least"), FALLING)
def test_falls_with_x(sample: Sample, measure: Measure, least: float) -> None:
    """It never rises from X to X + 1, and from -2 to 2 it falls clearly."""
    found = means(sample, measure)
    assert found == sorted(found, reverse=True)
    assert found[0] - found[-1] >= least, found


@pytest.mark.parametrize(("measure", "least"), ROUGHLY)
def test_goes_roughly_with_x(sample: Sample, measure: Measure, least: float) -> None:
    """No step goes the wrong way by more than one in a hundred utterances; the whole goes right."""
    sign = 1 if least > 0 else -1
    found = [sign * mean for mean in means(sample, measure)]
    assert all(other - one >= -_A_STEP for one, other in pairwise(found)), found
    assert found[-1] - found[0] >= abs(least), found


@pytest.mark.parametrize("measure", [word_count, fact_count, positive_words, exclamations])
def test_rises_at_every_step(sample: Sample, measure: Measure) -> None:
    """How much is said, and how gladly, rises strictly."""
    found = means(sample, measure)
    assert all(one < other for one, other in pairwise(found)), found


@pytest.mark.parametrize("measure", MARKERS)
def test_plain_speech_in_the_middle(sample: Sample, measure: Measure) -> None:
    """At X = 0 fewer than a tenth of the utterances carry a marker of any one kind."""
    share = fmean(measure(said) > 0 for said in sample[0])
    assert share < 0.1, share


def test_few_positive_words_of_introverts(sample: Sample) -> None:
    """At X = -2 few utterances hold a positive word, and no more than one in thirty words is."""
    introvert = sample[-2]
    assert fmean(positive_words(said) > 0 for said in introvert) < 0.3
    per_word = sum(map(positive_words, introvert)) / sum(map(word_count, introvert))
    assert per_word < 1 / 30
    extravert = sample[2]
    assert sum(map(positive_words, extravert)) / sum(map(word_count, extravert)) > 2 * per_word


@pytest.mark.parametrize("x", XS)
def test_two_seeds_differ(sample: Sample, x: int) -> None:
    """The same request with another seed says something else, nearly always."""
    said = [utterance.text for utterance in sample[x]]
    # Three seeds on, it is the same character's turn again.
    assert fmean(one != other for one, other in zip(said, said[3:], strict=False)) > 0.97
    assert len(set(said)) > 0.15 * len(said)


@pytest.mark.parametrize("x", XS[:-1])
def test_x_in_between_speaks_in_between(sample: Sample, x: int) -> None:
    """X + 0.5 tells no fewer facts than X and no more than X + 1."""
    half = [_said(x + 0.5, seed) for seed in range(600)]
    here, there = (fmean(map(fact_count, sample[near][:600])) for near in (x, x + 1))
    assert here <= fmean(map(fact_count, half)) <= there
