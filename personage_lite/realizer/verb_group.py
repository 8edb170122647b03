"""The verb words of a clause: tense, aspect, voice, modals, agreement and do-support."""

from __future__ import annotations

from typing import Final

from personage_lite.errors import nearest, shown
from personage_lite.realizer.agreement import Agreement
from personage_lite.realizer.features import SpecificationError
from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.specification import Clause
from personage_lite.realizer.words import VerbForm, inflect_verb, spell

# A verb, the words after it, and the form it gives the next verb: be, going to, base.
_Link = tuple[str, tuple[str, ...], VerbForm]
# Looked up, so that a tense that is none is not taken for the present.
_PAST: Final = {"present": False, "past": True, "future": False}
_FORMS: Final[dict[str, VerbForm]] = {
    "finite": "base",  # of an imperative
    "infinitive": "base",
    "bare_infinitive": "base",
    "present_participle": "gerund",
    "past_participle": "participle",
}


class VerbGroup:
    """The verb words of one clause: the finite one, those after it, and whether it inverts.

    `linked` are words that a modal brings with it: (had) "better", (ought) "to".
    """

    __slots__ = ("auxiliary", "finite", "linked", "rest")

    def __init__(
        self, finite: str, rest: list[str], auxiliary: bool, linked: tuple[str, ...] = ()
    ) -> None:
        self.finite = finite
        self.rest = rest
        # An auxiliary (or be) takes "not" and inverts by itself; other verbs need "do".
        self.auxiliary = auxiliary
        self.linked = linked


def verb_group(
    clause: Clause, agrees: Agreement, grammar: Grammar, support: bool = False
) -> VerbGroup:
    """Return a finite clause's verb words; `support` asks for an auxiliary, "do" if need be.

    >>> from personage_lite import english
    >>> clause = Clause("sing", modal="have to", tense="past")
    >>> group = verb_group(clause, (3, False), english().grammar)
    >>> group.finite, group.rest
    ('had', ['to', 'sing'])
    """
    past = _PAST[clause.tense]
    words = grammar.words
    modal = clause.modal
    plain = not (modal or clause.perfect or clause.progressive or clause.passive)
    if plain and clause.tense != "future" and not clause.backshifted:
        # Most clauses: one verb.
        if clause.verb == words.copula:
            return VerbGroup(grammar.be[*agrees, past], [], True)
        verb = spell(clause.verb, grammar.inflection)
        if support:
            return VerbGroup(_finite(words.support, agrees, past, grammar), [verb], True)
        return VerbGroup(_finite(verb, agrees, past, grammar), [], False)
    if clause.tense == "future" and not is_modal(modal, grammar):
        modal = words.future
    perfect = clause.perfect
    if clause.backshifted and modal not in grammar.never_backshifted:
        # "She is" … "was", "she has been" and "she was" … "had been", "she will" … "would".
        perfect = perfect or (past and not is_modal(modal, grammar))
        past = True
    links = _links(clause, perfect, grammar)
    if is_modal(modal, grammar):
        said = modal
        if past:
            first, blank, rest_of_it = modal.partition(" ")
            said = grammar.modals.get(modal) or grammar.modals[first] + blank + rest_of_it
        finite, *linked = said.split(" ")
        return VerbGroup(finite, _chain(links, "base", grammar), True, tuple(linked))
    lemma, after, form = links.pop(0)
    auxiliary = (
        lemma == words.copula
        or (form == "participle" and lemma == words.perfect)
        or modal in grammar.auxiliary_semi_modals
    )
    if support and not auxiliary:
        rest = [lemma, *after, *_chain(links, form, grammar)]
        return VerbGroup(_finite(words.support, agrees, past, grammar), rest, True)
    rest = [*after, *_chain(links, form, grammar)]
    return VerbGroup(_finite(lemma, agrees, past, grammar), rest, auxiliary)


def is_modal(modal: str, grammar: Grammar) -> bool:
    """Whether this is an auxiliary, alone or with more words: "can", "ought to", "may as well".

    With "to" it is one only as a whole: "need to" is inflected, "ought to" is not.
    """
    if modal in grammar.modals:
        return True
    first, _, rest = modal.partition(" ")
    return first in grammar.modals and not f"{rest} ".startswith(f"{grammar.words.infinitive} ")


def non_finite(clause: Clause, grammar: Grammar) -> list[str]:
    """Return the verb words of an infinitive or a participle: "have been eaten", "eating"."""
    if clause.form == "past_participle":
        verb = spell(clause.verb, grammar.inflection)
        return [inflect_verb(verb, "participle", grammar.inflection)]
    return _chain(_links(clause, clause.perfect, grammar), _FORMS[clause.form], grammar)


def _links(clause: Clause, perfect: bool, grammar: Grammar) -> list[_Link]:
    """Return the verbs of a clause in their order, each with what it asks of the next.

    A modal that is inflected is one of them, after the perfect unless it looks ahead: "has had
    to leave", but "is going to have left".
    """
    words = grammar.words
    links: list[_Link] = []
    modal = clause.modal
    first, *linked = modal.split(" ")
    semi: _Link | None = (first, tuple(linked), "base") if linked else None
    if modal and is_modal(modal, grammar):
        semi = None
    elif modal and semi is None:
        remedy = nearest(modal, grammar.modals)
        raise SpecificationError(f"'{shown(modal)}' is no modal; {remedy}", clause)
    if semi and modal in grammar.prospective:
        links.append(semi)
    if perfect:
        links.append((words.perfect, (), "participle"))
    if semi and modal not in grammar.prospective:
        links.append(semi)
    if clause.progressive:
        links.append((words.progressive, (), "gerund"))
    if clause.passive:
        links.append((words.passive, (), "participle"))
    links.append((spell(clause.verb, grammar.inflection), (), "base"))
    return links


def _chain(links: list[_Link], form: VerbForm, grammar: Grammar) -> list[str]:
    """Inflect verbs in a row, the first in `form`, each other as the one before it asks."""
    said: list[str] = []
    for lemma, after, next_form in links:
        said.append(inflect_verb(lemma, form, grammar.inflection))
        said.extend(after)
        form = next_form
    return said


def _finite(lemma: str, agrees: Agreement, past: bool, grammar: Grammar) -> str:
    """Return a verb's finite form."""
    if lemma == grammar.words.copula:
        return grammar.be[*agrees, past]
    if past:
        return inflect_verb(lemma, "past", grammar.inflection)
    return inflect_verb(lemma, "third" if agrees == (3, False) else "base", grammar.inflection)
