"""Clauses: word order in every mood, negation, contraction, content and relative clauses."""

from __future__ import annotations

from typing import TYPE_CHECKING

from personage_lite.realizer.agreement import THIRD_SINGULAR, Agreement, agreement
from personage_lite.realizer.features import SpecificationError
from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.predicates import arguments, predicate, quoted
from personage_lite.realizer.specification import (
    Case,
    Clause,
    Coordination,
    NounPhrase,
    Phrase,
    Quotation,
    Relative,
    Subordinate,
)
from personage_lite.realizer.verb_group import non_finite, verb_group

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax


def main_clause(
    syntax: Syntax,
    out: list[str],
    clause: Clause,
    shared_subject: bool = False,
    inverted: bool = False,
) -> None:
    """Add a clause that is a sentence, or a part of one, of its own.

    `shared_subject` leaves its subject unsaid, `inverted` puts the auxiliary before it.
    """
    if clause.form != "finite":
        _non_finite_clause(syntax, out, clause)
        return
    _fronted(syntax, out, clause)
    quotation = clause.quotation
    if isinstance(quotation, Quotation) and quotation.first:
        out.extend((quoted(syntax, quotation), ","))
        if quotation.inverted and clause.subject is not None:
            _reporting(syntax, out, clause, clause.subject)
            return
    for phrase in clause.preposed:
        start = len(out)
        syntax.phrase(out, phrase)
        if " ".join(out[start:]).startswith(syntax.grammar.inverting):
            inverted = True
        else:
            out.append(",")
    if clause.mood == "interrogative":
        asked = clause.question
        if asked is not None:
            syntax.phrase(out, asked.phrase)
        inverted = asked is None or asked.role != "subject" or clause.existential
    if clause.mood == "imperative":
        _imperative(syntax, out, clause)
    else:
        _subject_and_predicate(syntax, out, clause, inverted, shared_subject)
    _following(syntax, out, clause)


def content_clause(
    syntax: Syntax, out: list[str], clause: Clause, case: Case = "objective"
) -> None:
    """Add a clause inside another one: "that she is kind", "who came", "to go", "running"."""
    if clause.form != "finite":
        _non_finite_clause(syntax, out, clause)
        return
    asked = clause.question
    if clause.complementizer:
        out.append(clause.complementizer)
    elif clause.mood == "interrogative" and asked is None:
        out.append(syntax.grammar.words.whether)
    _fronted(syntax, out, clause)
    if clause.mood == "interrogative" and asked is not None:
        syntax.phrase(out, asked.phrase)
    for phrase in clause.preposed:
        syntax.phrase(out, phrase)
        out.append(",")
    _subject_and_predicate(syntax, out, clause)
    if isinstance(clause.quotation, Quotation) and clause.quotation.first:
        out.extend((",", quoted(syntax, clause.quotation)))
    _following(syntax, out, clause)


def relative_clause(
    syntax: Syntax, out: list[str], relative: Relative, head: Agreement
) -> None:
    """Add what follows a relative pronoun; `head` is what the pronoun stands for."""
    clause = relative.clause
    stranded = relative.preposition if relative.stranded else ""
    if clause.form != "finite":
        _non_finite_clause(syntax, out, clause)
        return
    subject = clause.subject
    if relative.possessed and relative.role != "subject":
        # "whose cat Alice likes": what is owned follows "whose".
        owned = getattr(clause, relative.role)
        if owned is not None:
            syntax.phrase(out, owned)
            clause = _without(clause, relative.role)
    if relative.role == "subject" and not relative.possessed:
        predicate(syntax, out, clause, head, stranded=stranded)
    else:
        if subject is None:
            raise _no_subject(clause)
        if relative.role not in ("adverbial", "subject"):
            _refuse_doubled(clause, relative.role, relative)
        start = len(out)
        syntax.phrase(out, subject, "subjective")
        pronoun = isinstance(subject, NounPhrase) and subject.pronoun and len(out) == start + 1
        agrees = agreement(subject, syntax.grammar)
        predicate(syntax, out, clause, agrees, after_pronoun=pronoun, stranded=stranded)
    # Nothing can stand before the pronoun, so all subordinate clauses follow.
    for subordinate in clause.subordinates:
        _subordinate(syntax, out, clause, subordinate)


def _without(clause: Clause, role: str) -> Clause:
    """Return a clause without what has this role in it."""
    if role == "object":
        return clause._replace(object=None)
    if role == "indirect_object":
        return clause._replace(indirect_object=None)
    return clause._replace(complement=None)


def _fronted(syntax: Syntax, out: list[str], clause: Clause) -> None:
    """Add the subordinate clauses that come before the subject."""
    for subordinate in clause.subordinates:
        if subordinate.fronted:
            out.append(subordinate.conjunction)
            content_clause(syntax, out, subordinate.clause)
            out.append(",")


def _following(syntax: Syntax, out: list[str], clause: Clause) -> None:
    """Add the subordinate clauses that come at the end."""
    for subordinate in clause.subordinates:
        if not subordinate.fronted:
            _subordinate(syntax, out, clause, subordinate)


def _subordinate(
    syntax: Syntax, out: list[str], host: Clause, subordinate: Subordinate
) -> None:
    """Add a subordinate clause that follows its host; a comma parts it from speech."""
    if host.quotation:
        out.append(",")
    out.append(subordinate.conjunction)
    content_clause(syntax, out, subordinate.clause)


def _subject_and_predicate(
    syntax: Syntax,
    out: list[str],
    clause: Clause,
    inverted: bool = False,
    shared_subject: bool = False,
) -> None:
    """Add what comes from the subject on, or from the auxiliary on that comes before it."""
    grammar = syntax.grammar
    subject, asked = clause.subject, clause.question
    stranded = ""
    if asked is not None and clause.mood == "interrogative":
        stranded = asked.preposition
        if asked.role == "subject":
            if subject is not None:
                raise _doubled("subject", clause)
            agrees = agreement(asked.phrase, grammar)
            if inverted:  # existential: "how many cats are there"
                predicate(syntax, out, clause, agrees, before=grammar.words.existential)
            else:
                short = asked.phrase in grammar.contracting if isinstance(asked.phrase, str) else False
                predicate(syntax, out, clause, agrees, after_pronoun=short, stranded=stranded)
            return
        if asked.role != "adverbial":
            _refuse_doubled(clause, asked.role, clause)
    elif clause.mood == "exclamative":
        _exclaimed(syntax, out, clause)
    left_out = shared_subject or "subject" in clause.ellipsis or "auxiliary" in clause.ellipsis
    if subject is None and not left_out:
        raise _no_subject(clause)
    if clause.existential:
        agrees = _existential_agreement(subject, grammar)
        there = grammar.words.existential
        if inverted:
            predicate(syntax, out, clause, agrees, before=there, stranded=stranded)
        else:
            if not left_out:
                out.append(there)
            predicate(syntax, out, clause, agrees, after_pronoun=not left_out, stranded=stranded)
        return
    agrees = THIRD_SINGULAR if subject is None else agreement(subject, grammar)
    if inverted and subject is not None and not left_out:
        predicate(syntax, out, clause, agrees, before=subject, stranded=stranded)
        return
    pronoun = False
    if subject is not None and not left_out:
        syntax.phrase(out, subject, "subjective")
        pronoun = isinstance(subject, NounPhrase) and subject.pronoun
    predicate(syntax, out, clause, agrees, after_pronoun=pronoun, stranded=stranded)



def _existential_agreement(subject: Phrase | None, grammar: Grammar) -> Agreement:
    """Return what agrees with the verb after "there": the first of what there is."""
    while isinstance(subject, Coordination):
        subject = subject.items[0]
    return agreement(subject, grammar)


# Moods and forms of their own


def _imperative(syntax: Syntax, out: list[str], clause: Clause) -> None:
    """Add an imperative: "go", "don't go", "let's go", "nobody move"."""
    grammar, subject = syntax.grammar, clause.subject
    negated = clause.negated and clause.negator == grammar.words.negator
    pronoun = isinstance(subject, NounPhrase) and subject.pronoun
    if pronoun and agreement(subject, grammar) == (1, True):
        out.append(grammar.let_contracted if clause.contracted else grammar.let_full)
        if negated:
            out.append(clause.negator)
    else:
        if subject is not None and not (pronoun and agreement(subject, grammar)[0] == 2):
            syntax.phrase(out, subject, "subjective")
        support = grammar.words.support
        if negated and clause.contracted:
            out.append(grammar.negative_contractions[support])
        elif negated:
            out.extend((support, clause.negator))
    _bare(syntax, out, clause, clause.negated and not negated)


def _non_finite_clause(syntax: Syntax, out: list[str], clause: Clause) -> None:
    """Add an infinitive or a participle with all that belongs to it: "not to be eaten"."""
    words = syntax.grammar.words
    if clause.complementizer:
        out.append(clause.complementizer)
    if clause.existential:
        out.append(words.existential)
    elif clause.subject is not None and "subject" not in clause.ellipsis:
        syntax.phrase(out, clause.subject)
    if clause.negated and clause.form == "infinitive":
        out.extend((clause.negator, words.infinitive))
        _bare(syntax, out, clause, False)
    else:
        if clause.form == "infinitive":
            out.append(words.infinitive)
        _bare(syntax, out, clause, clause.negated)
    for subordinate in clause.subordinates:
        _subordinate(syntax, out, clause, subordinate)


def _bare(syntax: Syntax, out: list[str], clause: Clause, negated: bool) -> None:
    """Add adverbs, verbs without a finite one, and arguments."""
    if negated:
        out.append(clause.negator)
    out.extend(clause.emphasizers)
    out.extend(clause.adverbs)
    if clause.interruption:
        out.extend((",", clause.interruption, ","))
    out.extend(non_finite(clause, syntax.grammar))
    if not clause.truncated and "predicate" not in clause.ellipsis:
        arguments(syntax, out, clause)


def _exclaimed(syntax: Syntax, out: list[str], clause: Clause) -> None:
    """Add what an exclamative begins with: "how curious", "what a clever girl", "how"."""
    words = syntax.grammar.words
    noun = isinstance(clause.complement, NounPhrase)
    out.append(words.exclamative_noun if noun else words.exclamative_degree)
    if clause.complement is not None:
        syntax.phrase(out, clause.complement)


def _reporting(syntax: Syntax, out: list[str], clause: Clause, subject: Phrase) -> None:
    """Add a clause of reporting with its verb first: "says the White Rabbit"."""
    group = verb_group(clause, agreement(subject, syntax.grammar), syntax.grammar)
    out.append(group.finite)
    out.extend(group.rest)
    syntax.phrase(out, subject, "subjective")
    out.extend(clause.adverbs)
    arguments(syntax, out, clause)
    _following(syntax, out, clause)


# Faults


def _refuse_doubled(clause: Clause, role: str, culprit: object) -> None:
    """Refuse a clause that fills the place which a question or relative pronoun has taken."""
    if getattr(clause, role) is not None:
        raise _doubled(role, culprit)


def _doubled(role: str, culprit: object) -> SpecificationError:
    return SpecificationError(
        f"the {role} stands twice, in the clause and before it; leave it out of the clause", culprit
    )


def _no_subject(clause: Clause) -> SpecificationError:
    return SpecificationError(
        f"the clause with the verb '{clause.verb}' has no subject; add one", clause
    )
