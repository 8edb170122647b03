"""What may be said of which clause: words that judge or feel need something to judge or feel."""

from __future__ import annotations

from personage_lite.lexicon import Marker
from personage_lite.plan import ClausePlan
from personage_lite.realizer.specification import AdjectivePhrase
from personage_lite.sentence_planner.joining import describes


def suits(words: Marker, clause: ClausePlan) -> bool:
    """Whether a marker, or a template's, may be said of a clause, by what its entry asks for.

    That is its verb, its polarity, its feeling, and whether it is a quality, a state, a deed or
    a habit.
    """
    if words.verbs and clause.clause.verb not in words.verbs:
        return False
    if words.polarity and words.polarity != clause.polarity:
        return False
    if words.feelings and clause.feeling not in words.feelings:
        return False  # nobody gasps at what leaves everybody cold
    if words.only == "qualities":
        return isinstance(clause.clause.complement, AdjectivePhrase)
    if words.only == "states":
        return not clause.story and describes(clause)
    if words.only == "deeds":
        return not describes(clause)
    return words.only != "habits" or not clause.story
