"""The verb words of a clause: tense, aspect, voice, modals, agreement and do-support."""

from __future__ import annotations

from personage_lite.realizer.agreement import Agreement
from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.specification import Clause
from personage_lite.realizer.words import VerbForm, inflect_verb

# A verb, the words after it, and the form it gives the next verb: be, going to, base.
_Link = tuple[str, tuple[str, ...], VerbForm]
_FORMS: dict[str, VerbForm] = {
    "finite": "base",  # of an imperative
    "infinitive": "base",
    "bare_infinitive": "base",
    "present_participle": "gerund",
    "past_participle": "participle",
}


class VerbGroup:
    """The verb words of one clause: the finite one, those after it, and whether it inverts."""

    __slots__ = ("auxiliary", "finite", "rest")

    def __init__(self, finite: str, rest: list[str], auxiliary: bool) -> None:
        self.finite = finite
        self.rest = rest
        # An auxiliary (or be) takes "not" and inverts by itself; other verbs need "do".
        self.auxiliary = auxiliary


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
    past = clause.tense == "past"
    words = grammar.words
    if not (clause.modal or clause.perfect or clause.progressive or clause.passive):
        # Most clauses: one verb.
        if clause.tense != "future" and not clause.backshifted:
            if clause.verb == words.copula:
                return VerbGroup(grammar.be[*agrees, past], [], True)
            if support:
                return VerbGroup(_finite(words.support, agrees, past, grammar), [clause.verb], True)
            return VerbGroup(_finite(clause.verb, agrees, past, grammar), [], False)
    modal = clause.modal or (words.future if clause.tense == "future" else "")
    first, *linked = modal.split(" ")
    perfect = clause.perfect
    if clause.backshifted:
        # "She is" … "was", "she has been" and "she was" … "had been", "she will" … "would".
        perfect = perfect or (past and first not in grammar.modals)
        past = True
    links = _links(clause, perfect, grammar)
    if first in grammar.modals:
        rest = [*linked, *_chain(links, "base", grammar)]
        return VerbGroup(grammar.modals[first] if past else first, rest, True)
    if first:
        links.insert(0, (first, tuple(linked), "base"))
    lemma, after, form = links.pop(0)
    auxiliary = lemma == words.copula or bool(links and not after and lemma == words.perfect)
    if support and not auxiliary:
        rest = [lemma, *after, *_chain(links, form, grammar)]
        return VerbGroup(_finite(words.support, agrees, past, grammar), rest, True)
    rest = [*after, *_chain(links, form, grammar)]
    return VerbGroup(_finite(lemma, agrees, past, grammar), rest, auxiliary)


def non_finite(clause: Clause, grammar: Grammar) -> list[str]:
    """Return the verb words of an infinitive or a participle: "have been eaten", "eating"."""
    if clause.form == "past_participle":
        return [inflect_verb(clause.verb, "participle", grammar.inflection)]
    links = _links(clause, clause.perfect, grammar)
    first, *linked = clause.modal.split(" ")
    if linked and first not in grammar.modals:
        links.insert(0, (first, tuple(linked), "base"))
    return _chain(links, _FORMS[clause.form], grammar)


def _links(clause: Clause, perfect: bool, grammar: Grammar) -> list[_Link]:
    """Return the verbs of a clause in their order, each with what it asks of the next."""
    words = grammar.words
    links: list[_Link] = []
    if perfect:
        links.append((words.perfect, (), "participle"))
    if clause.progressive:
        links.append((words.progressive, (), "gerund"))
    if clause.passive:
        links.append((words.passive, (), "participle"))
    links.append((clause.verb, (), "base"))
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
