"""Agreement: what a subject asks of its verb, person and number."""

from __future__ import annotations

from typing import TypeAlias

from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.number import is_plural
from personage_lite.realizer.specification import (
    Cased,
    Clause,
    Coordination,
    NounPhrase,
    Phrase,
    Text,
)

# Person, and whether it is plural.
Agreement: TypeAlias = tuple[int, bool]
THIRD_SINGULAR: Agreement = (3, False)


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
