"""Hedges and emphasis: markers that weaken or stress a proposition without changing it.

Each is put where its place in English is: before a gradable adjective, in the middle of the
clause, around it or after it; one clause carries one of a kind. Source: Mairesse & Walker 2011,
section 4.4; the paper, section IV-C ("weakens positive content").
"""

from __future__ import annotations

from typing import Final

from personage_lite.lexicon import Lexicon, Marker
from personage_lite.operators import OperatorDraws
from personage_lite.plan import ClausePlan, Frame, SentencePlan
from personage_lite.realizer.specification import AdjectivePhrase, NounPhrase, Opener, Phrase, Text
from personage_lite.sentence_planner.fitting import suits

SOFTENED: Final = "softened"
EMPHASIZED: Final = "emphasized"
# Said with a doubt around it: no second doubt there, and nothing loud.
HEDGED: Final = "hedged"
_MOST_OPENERS: Final = 1
# "Actually" before a deed soon tires: how often it is said where it fits.
_DEEDS_STRESSED: Final = 0.4
# The smallest number that "around" goes before.
_GUESSED: Final = 10
# Operators look at the clauses in the order they are spoken and change the first that fits.
_SAID: Final = ("main", "coordinate", "subordinate", "fronted")


def replaced(plan: SentencePlan, index: int, clause: ClausePlan, word: str) -> SentencePlan:
    """Return a sentence with one clause changed and a marker word noted."""
    clauses = (*plan.clauses[:index], clause, *plan.clauses[index + 1 :])
    # Made anew: `_replace` takes several times as long, and nearly every operator ends here.
    return tuple.__new__(SentencePlan, (clauses, *plan[1:-1], (*plan.words, word)))


def opener_fits(plan: SentencePlan) -> bool:
    """Whether words can stand before a sentence: one opener is enough, none goes before "also"."""
    full = len(plan.openers) >= _MOST_OPENERS
    return not (full or plan.connective or plan.false_start)


def with_opener(plan: SentencePlan, marker: Marker) -> SentencePlan:
    """Return a sentence with words put before it and before the openers that it has."""
    opener = Opener(marker.text, marker.after)
    return plan._replace(openers=(opener, *plan.openers), words=(*plan.words, marker.text))


def unhedged(clause: ClausePlan) -> bool:
    """Whether a clause is neither weakened nor stressed yet."""
    return SOFTENED not in clause.marks and EMPHASIZED not in clause.marks


def doubtful(plan: SentencePlan) -> bool:
    """Whether any clause of a sentence is weakened or hesitant."""
    return any(SOFTENED in clause.marks or HEDGED in clause.marks for clause in plan.clauses)


def degree_fits(clause: ClausePlan) -> bool:
    """Whether a degree adverb can stand before the clause's adjective."""
    said = clause.clause.complement
    return (
        clause.gradable
        and isinstance(said, AdjectivePhrase)
        and not said.adverbs
        and not clause.clause.negated
        and clause.clause.mood != "exclamative"
        and clause.role == "assertion"
    )


def with_degree(clause: ClausePlan, word: str, mark: str) -> ClausePlan:
    """Return a clause with a degree adverb before its adjective."""
    said = clause.clause.complement
    assert isinstance(said, AdjectivePhrase)
    changed = clause.clause._replace(complement=said._replace(adverbs=(word,)))
    return clause._replace(clause=changed, marks=(*clause.marks, mark))


def _starts_with_number(clause: ClausePlan, lexicon: Lexicon) -> bool:
    said = clause.clause.complement or clause.clause.object
    first = said.parts[0] if isinstance(said, Text) else ""
    word = first.split(" ", 1)[0] if isinstance(first, str) else ""
    numerals = lexicon.grammar.numerals
    # Nobody says "around three": a small number is counted, not guessed.
    large = word.isdigit() and int(word) >= _GUESSED
    return large or word in numerals.units[_GUESSED:] or word in numerals.tens


def hedged(plan: SentencePlan) -> SentencePlan:
    """Return a sentence whose clauses are marked as said with a doubt."""
    clauses = tuple(clause._replace(marks=(*clause.marks, HEDGED)) for clause in plan.clauses)
    return plan._replace(clauses=clauses)


def softened(
    plan: SentencePlan, markers: tuple[Marker, ...], rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Weaken one clause with one of the markers that fit it."""
    for index, clause in enumerate(plan.clauses):
        if clause.link not in _SAID or not unhedged(clause):
            continue
        places = _soft_places(plan, index, lexicon)
        verb, said = clause.clause.verb, clause.clause.complement
        adjective = said.adjective if isinstance(said, AdjectivePhrase) else None
        marker = rng.marker(
            [
                m
                for m in markers
                if m.place in places
                and suits(m, clause)
                # Not "kind of kind", nor "I think she thinks".
                and adjective not in m.text.split(" ")
                and verb not in m.text.split(" ")
            ]
        )
        if marker is None:
            continue
        if marker.place == "end":
            changed = clause._replace(marks=(*clause.marks, SOFTENED))
            return replaced(plan, index, changed, marker.text)._replace(afterthought=marker.text)
        if marker.place == "degree":
            changed = with_degree(clause, marker.text, SOFTENED)
        elif marker.place == "quantity":
            changed = _around(clause, marker.text)
        elif marker.place == "pause":
            paused = clause.clause._replace(interruption=marker.text)
            changed = clause._replace(clause=paused, marks=(*clause.marks, SOFTENED))
        else:
            frame = Frame("clause", Text((marker.text,)), inner_tag=True)
            changed = clause._replace(frame=frame, marks=(*clause.marks, SOFTENED))
        return replaced(plan, index, changed, marker.text)
    return None


def _soft_places(plan: SentencePlan, index: int, lexicon: Lexicon) -> set[str]:
    """Return where in a clause a softener can stand."""
    clause = plan.clauses[index]
    places = set()
    if degree_fits(clause) and not _someone(clause) and clause.strength != "extremely":
        places.add("degree")
    if middle_free(clause):
        places.add("pause")
    if _starts_with_number(clause, lexicon):
        places.add("quantity")
    # Doubt belongs to judgements, not to plain neutral facts.
    free = clause.frame is None and HEDGED not in clause.marks and clause.polarity != "neutral"
    free = free and clause.strength != "extremely"
    # Nor to what is said with "even" or "always".
    free = free and not clause.clause.adverbs
    if free and not clause.clause.quotation and not plan.afterthought:
        fronted = any(other.link in ("fronted", "relative") for other in plan.clauses)
        set_in_place = bool(clause.clause.preposed)  # "at the trial" is not when I think so
        begun = bool(plan.connective or plan.openers)
        # One says "I don't think she is", which is no longer this fact.
        if clause.link == "main" and not (
            fronted or begun or set_in_place or clause.clause.negated
        ):
            places.add("lead")
        if len(plan.clauses) == 1 and not plan.tag:
            places.add("end")
    return places


def _someone(clause: ClausePlan) -> bool:
    return clause.frame is not None and clause.frame.form == "someone_who"


def start_fits(plan: SentencePlan) -> bool:
    """Whether one can name somebody, hesitate, and only then say what he does.

    "The Hatter… um, he never washes up"; who is something hesitates before that instead.
    """
    spec = plan.clauses[0].clause
    named = isinstance(spec.subject, NounPhrase) and _one_known(spec.subject)
    begun = plan.openers or plan.connective or plan.answers or spec.preposed or spec.quotation
    if any(clause.link in ("fronted", "relative") for clause in plan.clauses):
        return False
    return named and spec.verb != "be" and plan.clauses[0].frame is None and not begun


def _one_known(subject: NounPhrase) -> bool:
    """Whether a phrase names somebody, or the one there is: not "a plate… um, it flies"."""
    known = subject.determiner != "" or subject.noun[:1].isupper()
    return known and subject.animate and subject.entity != ""


def middle_free(clause: ClausePlan) -> bool:
    """Whether the middle of a clause is free for a word that softens or stresses it."""
    spec = clause.clause
    if clause.frame is not None and clause.frame.complementizer:
        return False
    full = spec.interruption or spec.emphasizers or spec.mood == "exclamative"
    # Not "she hasn't, um, slept a wink", nor "he even, um, talks".
    full = full or spec.negated or bool(spec.adverbs)
    return not (full or spec.passive or clause.shared_subject)


def _around(clause: ClausePlan, word: str) -> ClausePlan:
    spec = clause.clause
    if isinstance(spec.complement, Text):
        spec = spec._replace(complement=Text((word, *spec.complement.parts)))
    elif isinstance(spec.object, Text):
        spec = spec._replace(object=Text((word, *spec.object.parts)))
    return clause._replace(clause=spec, marks=(*clause.marks, SOFTENED))


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
        if _someone(clause) or clause.polarity != "good" or clause.strength == "extremely":
            continue
        if unhedged(clause) and degree_fits(clause):
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
        if clause.link not in _SAID or not unhedged(clause) or clause.strength == "somewhat":
            continue
        if HEDGED in clause.marks:
            continue
        places = _stress_places(plan, index)
        marker = rng.marker(
            [
                marker
                for marker in lexicon.markers["emphasizer_hedges"]
                if marker.place in places and suits(marker, clause)
            ]
        )
        if marker is None or (marker.place == "alone" and rng.uniform("alone") >= _DEEDS_STRESSED):
            continue
        if marker.place == "degree":
            return replaced(plan, index, with_degree(clause, marker.text, EMPHASIZED), marker.text)
        changed = clause._replace(marks=(*clause.marks, EMPHASIZED))
        if marker.place == "opener":
            return with_opener(replaced(plan, index, changed, marker.text), marker)
        stressed = clause.clause._replace(emphasizers=(marker.text,))
        return replaced(plan, index, changed._replace(clause=stressed), marker.text)
    return None


def _stress_places(plan: SentencePlan, index: int) -> set[str]:
    """Return where a clause can be stressed; after "be" it is the adjective that is."""
    clause = plan.clauses[index]
    spec = clause.clause
    places = set()
    if degree_fits(clause):
        places.add("degree")
    if index == 0 and not plan.first and opener_fits(plan) and clause.frame is None:
        places.add("opener")
    weak = spec.verb in ("be", "have") or spec.quotation
    if not weak and middle_free(clause) and not any(map(_is_adverb, spec.adverbials)):
        places.add("middle")
        if len(plan.clauses) == 1 and clause.polarity != "neutral":
            places.add("alone")
    return places


def _is_adverb(phrase: Phrase) -> bool:
    """Whether a phrase is one word: "deeply", after which "really" would be too much."""
    if not isinstance(phrase, Text) or len(phrase.parts) != 1:
        return False
    word = phrase.parts[0]
    return isinstance(word, str) and " " not in word
