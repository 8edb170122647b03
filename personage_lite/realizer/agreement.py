"""Person, number and countability: what a subject asks of its verb, a noun of its determiner."""

from __future__ import annotations

from typing import TypeAlias

from personage_lite.realizer.grammar import DeterminerForms, Grammar
from personage_lite.realizer.specification import Cased, Coordination, NounPhrase, Phrase, Text
from personage_lite.realizer.words import countability

# Person, and whether it is plural.
Agreement: TypeAlias = tuple[int, bool]
THIRD_SINGULAR: Agreement = (3, False)

_FREE = DeterminerForms()


def agreement(phrase: Phrase | None, grammar: Grammar) -> Agreement:
    """Return the person and number that a verb takes from its subject.

    Of phrases joined by "or" or "nor" the nearest counts, else they are plural, and the first
    person goes before the second, the second before the third.
    """
    if isinstance(phrase, NounPhrase):
        return phrase.person, is_plural(phrase, grammar)
    if isinstance(phrase, Coordination):
        if phrase.conjunction in grammar.disjunctive or len(phrase.items) == 1:
            return agreement(phrase.items[-1], grammar)
        if all(not isinstance(item, NounPhrase | Text | str) for item in phrase.items):
            return THIRD_SINGULAR  # "To see and to know is …"
        return min(agreement(item, grammar)[0] for item in phrase.items), True
    if isinstance(phrase, Text) and len(phrase.parts) == 1:
        part = phrase.parts[0]
        return agreement(part.phrase if isinstance(part, Cased) else part, grammar)
    return THIRD_SINGULAR


def is_plural(phrase: NounPhrase, grammar: Grammar) -> bool:
    """Whether a noun phrase is plural, by its cardinal, its determiner and its noun."""
    plural = phrase.number == "plural"
    if phrase.pronoun:
        return plural
    cardinal = phrase.cardinal
    if phrase.determiner:
        forced = grammar.determiners.get(phrase.determiner, _FREE).number
        if forced:
            plural = forced == "plural"
    if cardinal is not None:
        return abs(cardinal) > 1 or cardinal == 0
    if not phrase.entity:
        kind = countability(phrase.noun, grammar.inflection)
        if kind == "uncountable":
            return False
        if kind == "plural_only":
            return True
        if kind == "pair":
            return plural or not takes_pair(phrase, grammar)
    return plural


def takes_pair(phrase: NounPhrase, grammar: Grammar) -> bool:
    """Whether trousers and the like are counted in pairs: "a pair of trousers"."""
    if phrase.cardinal is not None:
        return True
    forms = grammar.determiners.get(phrase.determiner)
    # Determiners with no plural of their own count what they stand before.
    return forms is not None and (forms.number == "singular" or forms.plural == "")


def determiner_form(phrase: NounPhrase, plural: bool, grammar: Grammar) -> str:
    """Return the determiner as it agrees: "these cats", "much furniture"."""
    forms = grammar.determiners.get(phrase.determiner)
    if forms is None:
        return phrase.determiner
    if plural:
        return phrase.determiner if forms.plural is None else forms.plural
    if forms.uncountable is not None and _uncountable(phrase, grammar):
        return forms.uncountable
    return phrase.determiner


def _uncountable(phrase: NounPhrase, grammar: Grammar) -> bool:
    return (
        phrase.cardinal is None
        and not phrase.entity
        and countability(phrase.noun, grammar.inflection) == "uncountable"
    )
