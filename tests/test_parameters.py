"""Every parameter of the style does what its table says, as heard in the final sentences.

Each parameter is set to 0 and to 1 by override while all others stay as at X = 0, or as the
parameter needs in order to show; what is measured is the text or the realizer's input, never
the trace.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from statistics import fmean
from typing import NamedTuple, TypeAlias

import pytest

from personage_lite import Generator
from personage_lite.facts import Fact
from personage_lite.lexicon import Concept, Rating, Word
from personage_lite.plan import Utterance
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Embedded,
    NounPhrase,
    Phrase,
    Sentence,
    Text,
)

# Facts rich in qualities and relations, so that every parameter has something to show itself in.
GENERATOR = Generator(facts=Path(__file__).parent / "facts")
LEXICON = GENERATOR.lexicon
CHARACTERS = ("alice", "white_rabbit", "queen_of_hearts")
SEEDS = 100

_KINDS = (Sentence, Clause, Embedded, NounPhrase, AdjectivePhrase, Coordination, Text)
Node: TypeAlias = "Sentence | Clause | Embedded | Phrase"
# What one utterance shows, as numbers whose mean over all utterances is compared.
Measure: TypeAlias = Callable[[Utterance], list[float]]


# Reading the final sentences


def parts(node: object) -> Iterator[Node]:
    """Yield every clause and phrase of a sentence, the outer before the inner."""
    if isinstance(node, tuple):
        if isinstance(node, _KINDS):
            yield node
        for inner in node:
            yield from parts(inner)


def nodes(said: Utterance) -> tuple[Node, ...]:
    """Return all clauses and phrases of an utterance."""
    return tuple(part for sentence in said.sentences for part in parts(sentence))


def clauses(said: Utterance) -> list[Clause]:
    """Return all clauses of an utterance."""
    return [node for node in nodes(said) if isinstance(node, Clause)]


def adjectives(said: Utterance) -> list[AdjectivePhrase]:
    """Return all adjectives of an utterance."""
    return [node for node in nodes(said) if isinstance(node, AdjectivePhrase)]


def facts(said: Utterance) -> list[Fact]:
    """Return the facts that an utterance states, in the order in which they are heard."""
    about = GENERATOR.character(said.character)
    return [about.by_id[key] for key in said.facts]


def cues(said: Utterance) -> list[str]:
    """Return all words that join clauses or sentences."""
    found = [sentence.connective for sentence in said.sentences if sentence.connective]
    found += [joined.conjunction for sentence in said.sentences for joined in sentence.joined]
    found += [below.conjunction for clause in clauses(said) for below in clause.subordinates]
    return found


def leads(said: Utterance) -> list[str]:
    """Return the fixed main clauses around others: "I love how", "what can be said is"."""
    return [
        " ".join(part if isinstance(part, str) else "{topic}" for part in node.lead.parts)
        for node in nodes(said)
        if isinstance(node, Embedded)
    ]


def texts(kind: str) -> set[str]:
    """Return the words of a kind of marker."""
    return {marker.text for marker in LEXICON.markers[kind]}


def degrees(said: Utterance) -> list[str]:
    """Return the adverbs before adjectives."""
    return [adverb for adjective in adjectives(said) for adverb in adjective.adverbs]


def interruptions(said: Utterance) -> list[str]:
    """Return the hesitations inside clauses."""
    return [clause.interruption for clause in clauses(said) if clause.interruption]


def openers(said: Utterance) -> list[str]:
    """Return the words before sentences."""
    return [opener.text for sentence in said.sentences for opener in sentence.openers]


def chosen(said: Utterance, kind: str) -> list[tuple[Word, Concept]]:
    """Return the words that were chosen, with the choice; kind: adjectives or verbs."""
    concepts: dict[str, Concept] = getattr(LEXICON, kind)
    heard = {(node.adjective, "") for node in adjectives(said)}
    if kind == "verbs":
        heard = {(clause.verb, clause.particle) for clause in clauses(said)}
    found = []
    for fact in facts(said):
        clause = fact.clause
        name = clause.verb
        if kind == "adjectives":
            quality = clause.complement
            name = quality.adjective if isinstance(quality, AdjectivePhrase) else ""
        elif clause.particle:
            continue
        concept = concepts.get(name)
        if concept is not None and len(concept.words) > 1:
            words = [word for word in concept.words if (word.text, word.particle) in heard]
            found += [(word, concept) for word in words]
    return found


def choice(quality: Callable[[Word], float], *kinds: str) -> Measure:
    """Return for each word chosen where its quality lies, from 0, the least there was, to 1."""

    def measure(said: Utterance) -> list[float]:
        found = []
        for word, concept in (pair for kind in kinds for pair in chosen(said, kind)):
            values = [quality(other) for other in concept.words]
            least, most = min(values), max(values)
            if most > least:
                found.append((quality(word) - least) / (most - least))
        return found

    return measure


# Measures


def count(found: Callable[[Utterance], list[str]], *kinds: str) -> Measure:
    """Count how often an utterance holds words of some kinds of marker."""
    words = set().union(*(texts(kind) for kind in kinds))
    return lambda said: [float(sum(word in words for word in found(said)))]


def fragments(kind: str) -> Measure:
    """Count the sentences of a kind of marker."""
    words = {(marker.text,) for marker in LEXICON.markers[kind]}
    return lambda said: [
        float(sum(isinstance(one.body, Text) and one.body.parts in words for one in said.sentences))
    ]


def of_clauses(holds: Callable[[Clause], bool]) -> Measure:
    """Count the clauses for which something holds."""
    return lambda said: [float(sum(map(holds, clauses(said))))]


def of_sentences(holds: Callable[[Sentence], bool]) -> Measure:
    """Return for each sentence whether something holds."""
    return lambda said: [float(holds(sentence)) for sentence in said.sentences]


def said_again(said: Utterance) -> list[tuple[str, str]]:
    """Return the pairs of "curious, really curious"."""
    found = []
    for node in nodes(said):
        if isinstance(node, Coordination) and node.conjunction == ",":
            one, other = node.items
            assert isinstance(one, AdjectivePhrase)
            assert isinstance(other, AdjectivePhrase)
            found.append((one.adjective, other.adjective))
    return found


def said_again_good(said: Utterance) -> list[float]:
    """Return for each attribute said again whether it is good."""
    polarity: dict[str, str] = {}
    for fact in facts(said):
        if isinstance(fact.clause.complement, AdjectivePhrase):
            concept = fact.clause.complement.adjective
            entry = LEXICON.adjectives.get(concept)
            words = [word.text for word in entry.words] if entry is not None else [concept]
            polarity.update(dict.fromkeys(words, fact.polarity))
    return [float(polarity[one] == "good") for one, _ in said_again(said)]


def good_first(said: Utterance) -> list[float]:
    """Return whether good or bad news comes first, where both are told."""
    told = [fact.polarity for fact in facts(said) if fact.polarity != "neutral"]
    return [float(told[0] == "good")] if len(set(told)) > 1 else []


def related_by(said: Utterance, kind: str) -> list[tuple[Fact, Fact]]:
    """Return the neighbours in an utterance that one relation alone sets side by side."""
    about = GENERATOR.character(said.character)
    found = []
    for one, other in pairwise(facts(said)):
        kinds = {
            relation.kind
            for relation in about.related.get(one.id, ())
            if other.id in (relation.nucleus, relation.satellite)
        }
        if kinds == {kind}:
            found.append((one, other))
    return found


def good_nucleus(said: Utterance) -> list[float]:
    """Return whether the good side of a concession is the one that is stressed.

    "Although A, B" and "A, but B" stress B, "A although B" stresses A.
    """
    pairs = related_by(said, "concession")
    if len(pairs) != 1 or {fact.polarity for fact in pairs[0]} != {"good", "bad"}:
        return []
    if {fact.clause.verb for fact in pairs[0]} != {"be"}:
        return []  # deeds keep their order in time
    told = pairs[0]
    concessive = texts("concede_cue_word")
    if sum(cue in concessive for cue in cues(said)) != 1:
        return []
    last = not any(below.fronted is False for c in clauses(said) for below in c.subordinates)
    return [float(told[1 if last else 0].polarity == "good")]


def pronoun_subjects(said: Utterance) -> list[float]:
    """Return for the subjects after the first sentence whether they are pronouns."""
    found = []
    for sentence in said.sentences[1:]:
        for clause in (node for node in parts(sentence) if isinstance(node, Clause)):
            if isinstance(clause.subject, NounPhrase) and clause.subject.entity:
                found.append(float(clause.subject.pronoun))
    return found


def template_leads(said: Utterance, connotations: tuple[str, ...]) -> int:
    """Count the frames that have one of some connotations."""
    wanted = {
        template.lead
        for templates in LEXICON.templates.values()
        for template in templates
        if template.connotation in connotations
    }
    return sum(lead in wanted for lead in leads(said))


def template_polarity(said: Utterance) -> list[float]:
    """Return for each frame that judges whether it judges well."""
    good, bad = template_leads(said, ("good",)), template_leads(said, ("bad",))
    return [1.0] * good + [0.0] * bad


def of_parameter(parameter: str) -> Callable[[Utterance], list[str]]:
    """Return a function that gives the leads of a parameter's templates in an utterance."""
    wanted = {template.lead for template in LEXICON.templates.get(parameter, ()) if template.lead}
    return lambda said: [lead for lead in leads(said) if lead in wanted]


def nested(said: Utterance) -> list[float]:
    """Count "what can be said is that …" and "she is someone who …"."""
    someone = set(LEXICON.someone.values())
    holds = [node for node in nodes(said) if isinstance(node, NounPhrase) and node.noun in someone]
    return [float(len(of_parameter("syntactic_complexity")(said)) + len(holds))]


def extremes(said: Utterance) -> list[float]:
    """Return 1 for each extreme fact and 0 for each lukewarm one."""
    return [float(f.strength == "extremely") for f in facts(said) if f.strength != "plainly"]


def confirmations(said: Utterance) -> list[float]:
    """Whether an utterance begins by confirming the topic."""
    body = said.sentences[0].body
    asks = isinstance(body, Text) and any(isinstance(part, Cased) for part in body.parts)
    return [float(asks)]


def rejections(said: Utterance) -> list[float]:
    """Whether an utterance begins with a refusal."""
    if said.plan.messages[0].fact.polarity == "neutral":
        return []  # what is neither good nor bad is not disclaimed
    return [float(any(said.text.startswith(words) for words in texts("initial_rejection")))]


def mitigations(said: Utterance) -> list[float]:
    """Whether an utterance says that everybody knows it."""
    heard = said.text.lower()
    return [float(any(words in heard for words in texts("competence_mitigation")))]


def _antonyms() -> set[str]:
    return {word for concept in LEXICON.adjectives.values() for word in concept.antonyms}


def negated_antonyms(said: Utterance) -> list[float]:
    """Count "isn't dull"."""
    antonyms = _antonyms()
    return [
        float(
            sum(
                clause.negated
                and isinstance(clause.complement, AdjectivePhrase)
                and clause.complement.adjective in antonyms
                for clause in clauses(said)
            )
        )
    ]


def softened(kind: str) -> Measure:
    """Count the softeners of a kind in any of their places."""
    words = texts(kind)

    def measure(said: Utterance) -> list[float]:
        heard = degrees(said) + interruptions(said) + leads(said)
        heard += [sentence.afterthought for sentence in said.sentences]
        heard += [node.parts[0] for node in nodes(said) if _quantity(node)]  # type: ignore[union-attr,misc]
        return [float(sum(word in words for word in heard))]

    return measure


def _quantity(node: Node) -> bool:
    return isinstance(node, Text) and node.parts[0] == "around"


def emphasized(said: Utterance) -> list[float]:
    """Count what is stressed."""
    words = texts("emphasizer_hedges")
    heard = [word for clause in clauses(said) for word in clause.emphasizers]
    heard += degrees(said) + openers(said)
    return [float(sum(word in words for word in heard))]


def merged(said: Utterance) -> list[float]:
    """Count "kind, curious and brave"."""
    return [float(sum(isinstance(n, Coordination) and n.conjunction == "and" for n in nodes(said)))]


def relatives(said: Utterance) -> list[float]:
    """Count "…, who is seven, …"."""
    heard = [node for node in nodes(said) if isinstance(node, NounPhrase)]
    return [float(sum(n.relative is not None and not n.relative.restrictive for n in heard))]


def also(said: Utterance) -> list[float]:
    """Count "also", but in "oh, also", which leaves a topic."""
    return [float(len(re.findall(r"(?<!oh, )\balso\b", said.text.lower())))]


def stutters(said: Utterance) -> list[float]:
    """Count "Al-Alice" in the text."""
    return [float(len(re.findall(r"\b(\w{1,3})-(?:\1-)?\1\w", said.text)))]


def implicit_subjects(said: Utterance) -> list[float]:
    """Count "the hair is …" by the side of "Alice's hair is …"."""
    heard = [c.subject for c in clauses(said) if isinstance(c.subject, NounPhrase)]
    return [float(not noun.possessor) for noun in heard if not noun.entity]


def contractions(said: Utterance) -> list[float]:
    """Count "she's" and "isn't"."""
    return [float(len(re.findall(r"\b(?:he|she|it|they)'(?:s|re|ve)\b|n't\b", said.text.lower())))]


def oaths(said: Utterance) -> list[float]:
    """Count oaths, before adjectives and before sentences."""
    return count(lambda one: degrees(one) + openers(one), "expletives")(said)


def near_oaths(said: Utterance) -> list[float]:
    """Count what is almost an oath."""
    return count(lambda one: degrees(one) + openers(one), "near_expletives")(said)


def disclaimable(said: Utterance) -> bool:
    """Whether an utterance begins with news, good or bad, that one can be wrong about."""
    first = said.plan.messages[0]
    view = isinstance(first.fact.clause.complement, AdjectivePhrase)
    story = GENERATOR.character(said.character).topics[first.fact.topic].in_order
    return first.role == "assertion" and first.fact.polarity != "neutral" and not (view or story)


class Probe(NamedTuple):
    """How a parameter shows: what is measured, in which setting, and by how much it must rise.

    It is measured in that turn of a conversation.

    With `never`, it must be 0 throughout where the parameter is 0.
    """

    measure: Measure
    least: float
    never: bool = True
    setting: dict[str, float] = {}  # noqa: RUF012 - read only
    rating: Rating = "mild"
    seeds: int = SEEDS
    turn: int = 2


# So much verbosity makes just two facts, always.
PAIR = 1 / 6
SOME = {"verbosity": 0.5}
PLAIN = {
    "acknowledgments": 0.0,
    "self_references": 0.0,
    "template_polarity": 0.0,
    "syntactic_complexity": 0.0,
    "softener_hedges": 0.0,
    "informal_softeners": 0.0,
    "weakened_positive_content": 0.0,
    "emphasizer_hedges": 0.0,
    "filled_pauses": 0.0,
    "near_expletives": 0.0,
    "competence_mitigation": 0.0,
    "repetitions": 0.0,
    "restatements": 0.0,
    "negation": 0.0,
}
MANY = {"verbosity": 0.8}
INDIFFERENT = SOME | {
    "lexicon_frequency": 0.5,
    "lexicon_word_length": 0.5,
    "verb_strength": 0.5,
    "positive_emotion_words": 0.5,
}
# Of the joiners of facts on one subject, those that compete for the same facts are silent.
ALONE = PLAIN | MANY | {"conjunction": 0.0, "merge": 0.0, "relative_clause": 0.0}
AGAIN = PLAIN | {"verbosity": 0.3, "merge_with_comma": 1.0}

PROBES: dict[str, Probe] = {
    # Content planning
    "verbosity": Probe(lambda said: [len(said.facts)], 3.5, never=False),
    "restatements": Probe(
        lambda said: [float(sum(one != other for one, other in said_again(said)))],
        0.1,
        setting=AGAIN,
    ),
    "repetitions": Probe(
        lambda said: [float(sum(one == other for one, other in said_again(said)))],
        0.2,
        setting=AGAIN,
    ),
    "content_polarity": Probe(
        lambda said: [float(fact.polarity == "good") for fact in facts(said)], 0.3, never=False
    ),
    "repetition_polarity": Probe(
        said_again_good, 0.3, never=False, setting=AGAIN | {"repetitions": 1.0, "verbosity": 0.7}
    ),
    "concessions": Probe(
        count(cues, "concede_cue_word", "contrast_cue_word"), 0.08, never=False, setting=SOME
    ),
    "concession_polarity": Probe(
        good_nucleus,
        0.06,
        never=False,
        setting=PLAIN
        | {"verbosity": PAIR, "concessions": 1.0, "concede_cue_word": 1.0, "period": 0.0}
        | {"contrast_cue_word": 0.0, "justify_cue_word": 0.0},
        seeds=2400,
    ),
    "polarization": Probe(extremes, 0.04, never=False, setting=SOME, seeds=400),
    "positive_content_first": Probe(good_first, 0.1, never=False, setting=SOME, seeds=300),
    "request_confirmation": Probe(confirmations, 0.9, turn=1),
    "initial_rejection": Probe(
        # Nobody disclaims a plain neutral fact, nor what was told before.
        lambda said: rejections(said) if disclaimable(said) else [],
        0.5,
        setting={"request_confirmation": 0.0},
        turn=1,
    ),
    "competence_mitigation": Probe(
        mitigations, 0.3, setting={"initial_rejection": 0.0, "self_references": 0.0}
    ),
    # Syntactic template selection
    "self_references": Probe(
        lambda said: [len(of_parameter("self_references")(said))],
        0.7,
        setting={"softener_hedges": 0.0, "verbosity": PAIR},
    ),
    "syntactic_complexity": Probe(nested, 0.6, setting={"self_references": 0.0}),
    "template_polarity": Probe(
        template_polarity, 0.4, setting={"self_references": 1.0, "verbosity": 0.5}, seeds=400
    ),
    # Aggregation
    "period": Probe(
        lambda said: [len(said.sentences) / len(said.facts)], 0.03, never=False, setting=SOME
    ),
    "relative_clause": Probe(relatives, 0.015, setting=SOME | {"object_relative_clause": 0.0}),
    "object_relative_clause": Probe(
        relatives, 0.03, setting=ALONE | {"relative_clause": 0.0, "period": 0.1}
    ),
    "with_cue_word": Probe(
        lambda said: [float(sum(len(clause.asides) for clause in clauses(said)))],
        0.001,
        setting=ALONE,
        seeds=600,
    ),
    "conjunction": Probe(count(cues, "conjunction"), 0.1, setting=SOME),
    "merge": Probe(merged, 0.002, setting=PLAIN | MANY, seeds=900),
    "also_cue_word": Probe(also, 0.01, setting=SOME, seeds=300),
    "contrast_cue_word": Probe(
        count(cues, "contrast_cue_word"), 0.1, setting=MANY | {"concede_cue_word": 0.0}
    ),
    "justify_cue_word": Probe(count(cues, "justify_cue_word"), 0.08, setting=MANY),
    "concede_cue_word": Probe(
        count(cues, "concede_cue_word"), 0.08, setting=MANY | {"contrast_cue_word": 0.0}
    ),
    "sequence_cue_word": Probe(count(cues, "sequence_cue_word"), 0.02, setting=ALONE, seeds=200),
    "merge_with_comma": Probe(
        lambda said: [len(said_again(said))], 0.3, setting=AGAIN | {"repetitions": 1.0}
    ),
    "object_ellipsis": Probe(of_sentences(lambda sentence: sentence.false_start), 0.08),
    # Pragmatic markers
    "subject_implicitness": Probe(implicit_subjects, 0.1, setting={"verbosity": 0.8}),
    "stuttering": Probe(stutters, 0.7),
    "pronominalization": Probe(pronoun_subjects, 0.4, never=False, setting={"verbosity": 0.3}),
    "negation": Probe(negated_antonyms, 0.012, seeds=300),
    "softener_hedges": Probe(
        softened("softener_hedges"),
        0.7,
        setting={"weakened_positive_content": 0.0, "self_references": 0.0},
    ),
    "informal_softeners": Probe(
        softened("informal_softeners"), 0.1, setting={"filled_pauses": 0.0}
    ),
    "weakened_positive_content": Probe(
        count(degrees, "weakened_positive_content"), 0.04, setting={"softener_hedges": 0.0}
    ),
    "emphasizer_hedges": Probe(
        emphasized, 0.4, setting={"merge_with_comma": 0.0, "softener_hedges": 0.0}
    ),
    "acknowledgments": Probe(count(openers, "acknowledgments"), 0.8, setting={"filled_pauses": 0}),
    "filled_pauses": Probe(
        count(lambda said: interruptions(said) + openers(said), "filled_pauses"),
        0.6,
        setting={"informal_softeners": 0.0, "acknowledgments": 0.0},
    ),
    "exclamation": Probe(
        of_sentences(lambda sentence: sentence.terminal == "!"),
        0.5,
        setting={"request_confirmation": 0.0, "anticipation": 0.0, "reaction": 0.0},
    ),
    "expletives": Probe(oaths, 0.4, rating="strong"),
    "near_expletives": Probe(near_oaths, 0.4),
    "tag_question": Probe(lambda said: [float(any(s.tag for s in said.sentences))], 0.25),
    "in_group_marker": Probe(lambda said: [float(any(s.vocative for s in said.sentences))], 0.08),
    # Lexical choice
    "lexicon_frequency": Probe(
        choice(lambda word: word.frequency, "adjectives", "verbs"), 0.3, False, INDIFFERENT
    ),
    "lexicon_word_length": Probe(
        lambda said: [len(word.text) for word, _ in chosen(said, "adjectives")],
        1.0,
        False,
        INDIFFERENT,
    ),
    "verb_strength": Probe(
        choice(lambda word: word.strength, "verbs"), 0.04, False, INDIFFERENT, seeds=300
    ),
    "positive_emotion_words": Probe(
        choice(lambda word: word.emotion, "adjectives", "verbs"),
        0.06,
        False,
        INDIFFERENT,
        seeds=200,
    ),
    "contractions": Probe(contractions, 0.4, never=False, setting=SOME),
    # Discourse
    "setting": Probe(
        lambda said: [float(any(clause.preposed for clause in clauses(said)))],
        0.05,
        setting=SOME,
        turn=6,
    ),
    "topic_shift": Probe(count(openers, "topic_shift"), 0.1, setting=SOME, turn=3),
    "recall": Probe(
        lambda said: [float(len(said.recalled))], 0.1, setting={"verbosity": 0.3}, turn=12
    ),
    "anticipation": Probe(fragments("anticipation"), 0.1, setting=SOME, turn=3),
    "reaction": Probe(fragments("reaction"), 0.1, setting=SOME, turn=3),
}


def spoken(parameter: str, value: float, probe: Probe, rating: Rating = "mild") -> list[Utterance]:
    """Return a sample of utterances with one parameter at a value."""
    overrides = {**probe.setting, parameter: value}
    talks = (
        GENERATOR.turns(
            CHARACTERS[seed % 3], 0, seed, count=probe.turn, overrides=overrides, rating=rating
        )
        for seed in range(probe.seeds)
    )
    return [list(talk)[-1] for talk in talks]


def test_every_parameter_has_a_probe() -> None:
    """A parameter that is added to the style needs a measure here."""
    assert set(PROBES) == set(GENERATOR.style.parameters)


@pytest.mark.parametrize("parameter", GENERATOR.style.parameters)
def test_raising_it_does_what_the_table_says(parameter: str) -> None:
    """From 0 to 1, what the parameter is for becomes more frequent, by a clear margin."""
    probe = PROBES[parameter]
    low = [n for said in spoken(parameter, 0.0, probe, probe.rating) for n in probe.measure(said)]
    high = [n for said in spoken(parameter, 1.0, probe, probe.rating) for n in probe.measure(said)]
    assert low, "nothing to measure at 0"
    assert high, "nothing to measure at 1"
    assert fmean(high) - fmean(low) >= probe.least, (fmean(low), fmean(high))
    assert not (probe.never and any(low))


@pytest.mark.parametrize(
    ("parameter", "ratings", "measure"),
    [
        ("expletives", ("clean", "mild"), oaths),
        ("near_expletives", ("clean",), near_oaths),
    ],
)
def test_oaths_only_where_the_rating_allows(
    parameter: str, ratings: tuple[Rating, ...], measure: Measure
) -> None:
    """Even at 1 nobody swears where the host has not allowed it."""
    words = texts(parameter)
    for rating in ratings:
        for said in spoken(parameter, 1.0, PROBES[parameter], rating):
            assert measure(said) == [0.0], said.text
            heard = re.findall(r"[\w ]+", said.text.lower())
            assert not words & {piece.strip() for piece in heard}, said.text


def test_only_good_news_is_weakened() -> None:
    """`weakened_positive_content` makes no bad attribute small."""
    probe = PROBES["weakened_positive_content"]
    weak = texts("weakened_positive_content")
    for said in spoken("weakened_positive_content", 1.0, probe):
        words = {
            word.text: fact.polarity
            for fact in facts(said)
            if isinstance(fact.clause.complement, AdjectivePhrase)
            for word in LEXICON.adjectives[fact.clause.complement.adjective].words
        }
        for adjective in adjectives(said):
            if weak & set(adjective.adverbs):
                assert words[adjective.adjective] == "good", said.text


def test_a_parameter_at_one_half_lies_between() -> None:
    """Probability, not a switch: halfway the rate is between both ends."""
    for parameter in ("tag_question", "exclamation", "stuttering"):
        probe = PROBES[parameter]
        low, half, high = (
            fmean([n for said in spoken(parameter, value, probe) for n in probe.measure(said)])
            for value in (0.0, 0.5, 1.0)
        )
        assert low + 0.1 < half < high - 0.1, parameter
