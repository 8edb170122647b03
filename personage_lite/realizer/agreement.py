"""Person, number and countability: what a subject asks of its verb, a noun of its determiner."""

from __future__ import annotations

from typing import TypeAlias

from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.inflection import Countability
from personage_lite.realizer.specification import (
    Cased,
    Clause,
    Coordination,
    NounPhrase,
    Phrase,
    Text,
)
from personage_lite.realizer.words import countability

# Person, and whether it is plural.
Agreement: TypeAlias = tuple[int, bool]
THIRD_SINGULAR: Agreement = (3, False)
# Looked up, so that a number that is none is not taken for the singular.
_PLURAL = {"singular": False, "plural": True}


def agreement(phrase: Phrase | None, grammar: Grammar, inverted: bool = False) -> Agreement:
    """Return the person and number that a verb takes from its subject.

    Of phrases joined by "or" or "nor" the nearest counts, which is the first if the verb comes
    before them; else they are plural, and the first person goes before the second, the second
    before the third.
    """
    if isinstance(phrase, NounPhrase):
        return phrase.person, is_plural(phrase, grammar)
    if isinstance(phrase, Coordination):
        if phrase.conjunction in grammar.additive:
            return agreement(phrase.items[0], grammar)
        if phrase.conjunction in grammar.disjunctive or len(phrase.items) == 1:
            return agreement(phrase.items[0 if inverted else -1], grammar, inverted)
        if not any(_many(item, grammar) for item in phrase.items):
            return THIRD_SINGULAR  # "To see and to know is …", "every card and every king is …"
        return min(agreement(item, grammar)[0] for item in phrase.items), True
    if isinstance(phrase, Text) and len(phrase.parts) == 1:
        part = phrase.parts[0]
        return agreement(part.phrase if isinstance(part, Cased) else part, grammar)
    return THIRD_SINGULAR


def existential_agreement(subject: Phrase | None, grammar: Grammar) -> Agreement:
    """Return what agrees with the verb after "there": the first of what there is."""
    while isinstance(subject, Coordination):
        subject = subject.items[0]
    return agreement(subject, grammar)


def _many(phrase: Phrase, grammar: Grammar) -> bool:
    """Whether a phrase makes those that it is joined to plural."""
    if isinstance(phrase, NounPhrase):
        forms = grammar.determiners.get(phrase.determiner)
        return forms is None or forms.number != "singular"
    if isinstance(phrase, Clause):
        return phrase.form == "present_participle"  # "Reading and writing are …"
    return isinstance(phrase, Text | str)


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
