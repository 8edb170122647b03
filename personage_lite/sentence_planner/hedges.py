"""Hedges and emphasis: markers that weaken or stress a proposition without changing it.

Each is put where its place in English is: before a gradable adjective, in the middle of the
clause, around it or after it; one clause carries one of a kind. Source: Mairesse & Walker 2011,
section 4.4; the paper, section IV-C ("weakens positive content").
"""

from __future__ import annotations

from dataclasses import replace

from personage_lite.lexicon import Lexicon, Marker
from personage_lite.operators import OperatorDraws
from personage_lite.plan import ClausePlan, Frame, SentencePlan
from personage_lite.realizer.specification import AdjectivePhrase, Opener, Phrase, Text

SOFTENED, EMPHASIZED = "softened", "emphasized"
# The adjective is a word already, not a concept.
ANTONYM = "antonym"
_MOST_OPENERS = 2
# Operators look at the clauses in the order they are spoken and change the first that fits.
_SAID = ("main", "coordinate", "subordinate", "fronted")


def replaced(plan: SentencePlan, index: int, clause: ClausePlan, word: str) -> SentencePlan:
    """Return a sentence with one clause changed and a marker word noted."""
    clauses = (*plan.clauses[:index], clause, *plan.clauses[index + 1 :])
    return replace(plan, clauses=clauses, words=(*plan.words, word))


def opener_fits(plan: SentencePlan) -> bool:
    """Whether more words can stand before a sentence: two at most, none after "but"."""
    full = len(plan.openers) >= _MOST_OPENERS or any(not item.mark for item in plan.openers)
    return not (full or plan.connective or plan.false_start)


def with_opener(plan: SentencePlan, marker: Marker) -> SentencePlan:
    """Return a sentence with words put before it and before the openers that it has."""
    opener = Opener(marker.text, marker.after)
    return replace(plan, openers=(opener, *plan.openers), words=(*plan.words, marker.text))


def _unhedged(clause: ClausePlan) -> bool:
    return SOFTENED not in clause.marks and EMPHASIZED not in clause.marks


def _degree_fits(clause: ClausePlan) -> bool:
    """Whether a degree adverb can stand before the clause's adjective."""
    said = clause.clause.complement
    return (
        clause.gradable
        and isinstance(said, AdjectivePhrase)
        and not said.adverbs
        and not clause.clause.negated
        and not clause.clause.degree
        and clause.role == "assertion"
    )


def _echoes(clause: ClausePlan, words: str) -> bool:
    """Whether the adjective repeats a word of its adverb: "kind of kind"."""
    said = clause.clause.complement
    return isinstance(said, AdjectivePhrase) and said.adjective in words.split(" ")


def with_degree(clause: ClausePlan, word: str, mark: str) -> ClausePlan:
    """Return a clause with a degree adverb before its adjective."""
    said = clause.clause.complement
    assert isinstance(said, AdjectivePhrase)
    changed = replace(clause.clause, complement=replace(said, adverbs=(word,)))
    return replace(clause, clause=changed, marks=(*clause.marks, mark))


def _starts_with_number(clause: ClausePlan, lexicon: Lexicon) -> bool:
    said = clause.clause.complement or clause.clause.object
    first = said.parts[0] if isinstance(said, Text) else ""
    word = first.split(" ", 1)[0] if isinstance(first, str) else ""
    return word.isdigit() or word in lexicon.grammar.numerals


def softened(
    plan: SentencePlan, markers: tuple[Marker, ...], rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Weaken one clause with one of the markers that fit it."""
    for index, clause in enumerate(plan.clauses):
        if clause.link not in _SAID or not _unhedged(clause):
            continue
        able = tuple(m for m in markers if _soft_fits(plan, index, m, lexicon))
        marker = rng.marker(able)
        if marker is None:
            continue
        if marker.place == "end":
            changed = replace(clause, marks=(*clause.marks, SOFTENED))
            return replace(replaced(plan, index, changed, marker.text), afterthought=marker.text)
        if marker.place == "degree":
            changed = with_degree(clause, marker.text, SOFTENED)
        elif marker.place == "quantity":
            changed = _around(clause, marker.text)
        elif marker.place == "pause":
            paused = replace(clause.clause, interruption=marker.text)
            changed = replace(clause, clause=paused, marks=(*clause.marks, SOFTENED))
        else:
            frame = Frame(marker.text, "clause", Text((marker.text,)), "", inner_tag=True)
            changed = replace(clause, frame=frame, marks=(*clause.marks, SOFTENED))
        return replaced(plan, index, changed, marker.text)
    return None


def _soft_fits(plan: SentencePlan, index: int, marker: Marker, lexicon: Lexicon) -> bool:
    clause, place = plan.clauses[index], marker.place
    alone = not clause.clause.quotation and clause.frame is None
    if place == "degree":
        return _degree_fits(clause) and not _echoes(clause, marker.text)
    if place == "lead":
        fronted = any(other.link in ("fronted", "relative") for other in plan.clauses)
        main = clause.link == "main" and not fronted
        return alone and main and not plan.connective and not plan.afterthought
    if place == "end":
        last = index == len(plan.clauses) - 1 and len(plan.clauses) == 1
        return alone and last and not plan.tag and not plan.afterthought
    if place == "quantity":
        return _starts_with_number(clause, lexicon)
    return pause_fits(clause)


def pause_fits(clause: ClausePlan) -> bool:
    """Whether a hesitation can stand in the middle of a clause."""
    spec = clause.clause
    bare = not (spec.interruption or spec.adverbs or spec.emphasizers or spec.degree)
    return bare and not spec.negated and not spec.passive and not clause.shared_subject


def _around(clause: ClausePlan, word: str) -> ClausePlan:
    spec = clause.clause
    if isinstance(spec.complement, Text):
        spec = replace(spec, complement=Text((word, *spec.complement.parts)))
    elif isinstance(spec.object, Text):
        spec = replace(spec, object=Text((word, *spec.object.parts)))
    return replace(clause, clause=spec, marks=(*clause.marks, SOFTENED))


def softener_hedges(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Weaken a proposition: "somewhat curious", "I think that …", "…, it seems"."""
    return softened(plan, lexicon.markers["softener_hedges"], rng, lexicon)


def informal_softeners(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Weaken a proposition as friends do: "kind of curious"."""
    return softened(plan, lexicon.markers["informal_softeners"], rng, lexicon)


def weakened_positive_content(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Make good news small: "somewhat imaginative" (the paper, section IV-C)."""
    for index, clause in enumerate(plan.clauses):
        if clause.polarity == "good" and _unhedged(clause) and _degree_fits(clause):
            marker = rng.marker(lexicon.markers["weakened_positive_content"])
            if marker is None:
                return None
            return replaced(plan, index, with_degree(clause, marker.text, SOFTENED), marker.text)
    return None


def emphasizer_hedges(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Stress a proposition: "really", "just", "so curious"; never a lukewarm one."""
    for index, clause in enumerate(plan.clauses):
        if clause.link not in _SAID or not _unhedged(clause) or clause.strength == "somewhat":
            continue
        able = tuple(
            marker
            for marker in lexicon.markers["emphasizer_hedges"]
            if _stress_fits(plan, index, marker)
        )
        marker = rng.marker(able)
        if marker is None:
            continue
        if marker.place == "opener":
            marked = replace(clause, marks=(*clause.marks, EMPHASIZED))
            return with_opener(replaced(plan, index, marked, marker.text), marker)
        if marker.place == "degree":
            return replaced(plan, index, with_degree(clause, marker.text, EMPHASIZED), marker.text)
        stressed = replace(clause.clause, emphasizers=(marker.text,))
        changed = replace(clause, clause=stressed, marks=(*clause.marks, EMPHASIZED))
        return replaced(plan, index, changed, marker.text)
    return None


def _stress_fits(plan: SentencePlan, index: int, marker: Marker) -> bool:
    clause = plan.clauses[index]
    if marker.place == "degree":
        return _degree_fits(clause)
    if marker.place == "opener":
        return index == 0 and not plan.first and opener_fits(plan)
    # After "be" a stress goes to the adjective; in the middle it would stress the wrong thing.
    verb = clause.clause.verb
    suits = verb in marker.verbs if marker.verbs else verb not in ("be", "have")
    if any(_is_adverb(phrase) for phrase in clause.clause.adverbials):
        return False
    return suits and pause_fits(clause) and not clause.clause.quotation


def _is_adverb(phrase: Phrase) -> bool:
    """Whether a phrase is one word: "deeply", after which "really" would be too much."""
    if not isinstance(phrase, Text) or len(phrase.parts) != 1:
        return False
    word = phrase.parts[0]
    return isinstance(word, str) and " " not in word


def negation(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
    """Say an attribute through its negated antonym: "isn't dull"."""
    for index, clause in enumerate(plan.clauses):
        said = clause.clause.complement
        if clause.clause.negated or clause.clause.degree or clause.role != "assertion":
            continue
        if not isinstance(said, AdjectivePhrase) or said.adverbs or clause.marks:
            continue
        concept = lexicon.adjectives.get(said.adjective)
        if concept is None or not concept.antonyms:
            continue
        antonym = rng.choose("antonym", concept.antonyms, [1.0] * len(concept.antonyms))
        opposite = replace(
            clause.clause, complement=AdjectivePhrase(antonym), negated=True
        )
        marks = (*clause.marks, ANTONYM)
        changed = replace(clause, clause=opposite, gradable=False, marks=marks)
        return replaced(plan, index, changed, antonym)
    return None


def subject_implicitness(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Name the attribute, not its owner: "the hair is long", where the owner was the subject."""
    before = plan.subject_before
    for index, clause in enumerate(plan.clauses):
        subject = clause.clause.subject
        if subject is None:
            continue
        owner = subject.possessor
        if owner is not None and owner.entity == before and clause.frame is None:
            implicit = replace(subject, possessor=None, determiner="the")
            changed = replace(clause, clause=replace(clause.clause, subject=implicit))
            return replaced(plan, index, changed, "subject_implicitness")
        before = subject.entity
    return None
