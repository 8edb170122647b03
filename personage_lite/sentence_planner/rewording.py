"""Rewording: operators that say a proposition in another way, without a word around it.

Source: Mairesse & Walker 2011, section 4.4 (negation insertion, subject implicitness).
"""

from __future__ import annotations

from typing import Final

from personage_lite.facts import entity_of
from personage_lite.lexicon import Lexicon
from personage_lite.operators import OperatorDraws
from personage_lite.plan import SentencePlan
from personage_lite.realizer.specification import AdjectivePhrase, NounPhrase
from personage_lite.sentence_planner.hedges import replaced

# The adjective is a word already, not a concept.
ANTONYM: Final = "antonym"


def negation(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
    """Say an attribute through its negated antonym: "isn't dull"; not where it is a reason."""
    if len(plan.clauses) > 1:
        return None
    for index, clause in enumerate(plan.clauses):
        said = clause.clause.complement
        if clause.clause.negated or clause.clause.mood == "exclamative":
            continue
        if not isinstance(said, AdjectivePhrase) or said.adverbs or clause.marks:
            continue
        if clause.role != "assertion" or clause.clause.adverbs or clause.clause.verb != "be":
            continue  # not "he isn't also rude", "he doesn't stay nervous"
        if clause.frame is not None:
            continue  # not "I love how she isn't dull"
        concept = lexicon.adjectives.get(said.adjective)
        if concept is None or not concept.antonyms:
            continue
        antonym = rng.choose("antonym", concept.antonyms, [1.0] * len(concept.antonyms))
        opposite = clause.clause._replace(complement=AdjectivePhrase(antonym), negated=True)
        marks = (*clause.marks, ANTONYM)
        changed = clause._replace(clause=opposite, gradable=False, marks=marks)
        return replaced(plan, index, changed, antonym)
    return None


def subject_implicitness(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Name the attribute, not its owner: "the hair is long", where the owner was the subject."""
    before = plan.subject_before
    for index, clause in enumerate(plan.clauses):
        subject = clause.clause.subject
        if not isinstance(subject, NounPhrase):
            continue
        owner = subject.possessor
        if owner is not None and entity_of(owner) == before and clause.frame is None:
            implicit = subject._replace(possessor=None, determiner="the")
            changed = clause._replace(clause=clause.clause._replace(subject=implicit))
            return replaced(plan, index, changed, "subject_implicitness")
        before = subject.entity
    return None
