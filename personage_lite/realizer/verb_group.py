"""The verb words of a clause: tense, aspect, voice, modals, agreement and do-support."""

from __future__ import annotations

from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.morphology import VerbForm, inflect_verb
from personage_lite.realizer.specification import Clause, NounPhrase

# What agrees with a clause that has no subject of its own.
NOBODY = NounPhrase("")


class VerbGroup:
    """The verb words of one clause: the finite one, those after it, and whether it inverts."""

    __slots__ = ("auxiliary", "finite", "rest")

    def __init__(self, finite: str, rest: list[str], auxiliary: bool) -> None:
        self.finite = finite
        self.rest = rest
        # An auxiliary (or be) takes "not" and inverts by itself; other verbs need "do".
        self.auxiliary = auxiliary


def verb_group(clause: Clause, grammar: Grammar, emphatic: bool = False) -> VerbGroup:
    """Return a clause's verb words; `emphatic` asks for do-support."""
    subject = clause.subject or NOBODY
    past = clause.tense == "past"
    modal = clause.modal or ("will" if clause.tense == "future" else "")
    lemmas: list[tuple[str, VerbForm]] = []  # each with the form it gives the next one
    if clause.perfect:
        lemmas.append(("have", "participle"))
    if clause.progressive:
        lemmas.append(("be", "gerund"))
    if clause.passive:
        lemmas.append(("be", "participle"))
    if not modal and not lemmas:
        if clause.verb != "be" and emphatic:
            return VerbGroup(_finite("do", subject, past, grammar), [clause.verb], True)
        return VerbGroup(_finite(clause.verb, subject, past, grammar), [], clause.verb == "be")
    rest = []
    form: VerbForm = "base"
    if not modal:
        first, form = lemmas.pop(0)
        modal = _finite(first, subject, past, grammar)
    for lemma, next_form in lemmas:
        rest.append(inflect_verb(lemma, form, grammar))
        form = next_form
    rest.append(inflect_verb(clause.verb, form, grammar))
    return VerbGroup(modal, rest, True)


def _finite(lemma: str, subject: NounPhrase, past: bool, grammar: Grammar) -> str:
    """Return a verb's finite form, agreeing with its subject."""
    if lemma == "be":
        return _finite_be(subject, past, grammar)
    if past:
        return inflect_verb(lemma, "past", grammar)
    third = subject.person == 3 and subject.number == "singular"
    return inflect_verb(lemma, "third" if third else "base", grammar)


def _finite_be(subject: NounPhrase, past: bool, grammar: Grammar) -> str:
    """Return am, are, is, was or were."""
    forms = grammar.be
    plural = subject.number == "plural" or subject.person == 2
    if past:
        return forms["past_other" if plural else "past_singular"]
    if plural:
        return forms["present_other"]
    return forms["present_first" if subject.person == 1 else "present_third"]
