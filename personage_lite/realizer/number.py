"""Number and countability: what a noun asks of its determiner, and a determiner of its noun."""

from __future__ import annotations

from typing import Final

from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.inflection import Countability
from personage_lite.realizer.specification import NounPhrase
from personage_lite.realizer.words import countability

# Looked up, so that a number that is none is not taken for the singular.
_PLURAL: Final = {"singular": False, "plural": True}


def is_plural(phrase: NounPhrase, grammar: Grammar) -> bool:
    """Whether a noun phrase is plural, by its cardinal, its determiner and its noun."""
    if phrase.pronoun:
        return phrase.number == "plural"
    return number_and_kind(phrase, grammar)[0]


def number_and_kind(phrase: NounPhrase, grammar: Grammar) -> tuple[bool, Countability]:
    """Return whether a phrase that is no pronoun is plural, and the countability of its noun."""
    plural = _PLURAL[phrase.number]
    if phrase.determiner or phrase.predeterminer:
        before = grammar.determiners.get(phrase.predeterminer)
        forms = grammar.determiners.get(phrase.determiner)
        if forms is not None and (forms.number or forms.singly):
            before = forms  # "many a cat was", "both the cats were"
        if before is not None and before.number:
            plural = before.number == "plural"
    kind: Countability = "countable"
    if not phrase.entity:
        kind = countability(phrase.noun, grammar.inflection)
    if phrase.cardinal is not None:
        # What is counted can be counted: "two teas".
        plural = abs(phrase.cardinal) != 1
        return plural, "countable" if kind == "uncountable" else kind
    if kind == "uncountable":
        return False, kind
    if kind == "plural_only":
        return True, kind
    if kind == "pair":
        return plural or not takes_pair(phrase, grammar), kind
    return plural, kind


def takes_pair(phrase: NounPhrase, grammar: Grammar) -> bool:
    """Whether trousers and the like are counted in pairs: "a pair of trousers"."""
    if phrase.cardinal is not None:
        return True
    forms = grammar.determiners.get(phrase.determiner)
    return forms is not None and (forms.number == "singular" or forms.singly)


def determiner_form(phrase: NounPhrase, plural: bool, kind: Countability, grammar: Grammar) -> str:
    """Return the determiner as it agrees: "these cats", "much furniture"."""
    forms = grammar.determiners.get(phrase.determiner)
    if forms is None:
        return phrase.determiner
    if plural:
        counted = phrase.cardinal is not None and forms.singly and forms.plural
        if forms.plural is None or counted:
            return phrase.determiner  # "another two cups"
        return forms.plural
    if forms.uncountable is not None and kind == "uncountable":
        return forms.uncountable
    return phrase.determiner
