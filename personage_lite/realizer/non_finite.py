"""Clauses without a finite verb of their own: infinitives, participles, imperatives."""

from __future__ import annotations

from typing import TYPE_CHECKING

from personage_lite.realizer.agreement import agreement
from personage_lite.realizer.predicates import arguments
from personage_lite.realizer.specification import Clause, NounPhrase
from personage_lite.realizer.subordination import add_subordinate
from personage_lite.realizer.verb_group import non_finite

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax


def non_finite_clause(syntax: Syntax, out: list[str], clause: Clause, stranded: str = "") -> None:
    """Add an infinitive or a participle with all that belongs to it: "not to be eaten"."""
    words = syntax.grammar.words
    if clause.mood == "interrogative":
        asked = clause.question
        if asked is None:
            out.append(words.whether)
        else:
            syntax.phrase(out, asked.phrase)
            stranded = asked.preposition
    if clause.complementizer:
        out.append(clause.complementizer)
    if clause.existential:
        out.append(words.existential)
    elif clause.subject is not None and "subject" not in clause.ellipsis:
        # "(He asks) that they not shout", but "(he wants) them not to shout".
        governed = clause.form == "bare_infinitive" and clause.complementizer
        syntax.phrase(out, clause.subject, "subjective" if governed else "objective")
    negated = clause.negated
    if negated and clause.form == "infinitive":
        out.append(clause.negator)
        negated = False
    if clause.form == "infinitive":
        out.append(words.infinitive)
    bare(syntax, out, clause, negated, stranded)
    for subordinate in clause.subordinates:
        add_subordinate(syntax, out, clause, subordinate)


def imperative(syntax: Syntax, out: list[str], clause: Clause) -> None:
    """Add an imperative: "go", "don't go", "let's go", "do go", "nobody move"."""
    grammar, subject = syntax.grammar, clause.subject
    negated = clause.negated and clause.negator == grammar.words.negator
    pronoun = isinstance(subject, NounPhrase) and subject.pronoun
    support = grammar.words.support
    if pronoun and agreement(subject, grammar) == (1, True):
        out.append(grammar.let_contracted if clause.contracted else grammar.let_full)
        if negated:
            out.append(clause.negator)
    else:
        said = subject is not None and not (pronoun and agreement(subject, grammar)[0] == 2)
        if negated and (clause.contracted or said):
            # "Don't anybody move": before a subject it is never "do not".
            out.append(grammar.negative_contractions[support])
        elif negated:
            out.extend((support, clause.negator))
        elif clause.emphatic:
            out.append(support)
        if said and subject is not None:
            syntax.phrase(out, subject, "subjective")
    bare(syntax, out, clause, clause.negated and not negated)


def bare(syntax: Syntax, out: list[str], clause: Clause, negated: bool, stranded: str = "") -> None:
    """Add adverbs, verbs without a finite one, and arguments."""
    if negated:
        out.append(clause.negator)
    out.extend(clause.emphasizers)
    out.extend(clause.adverbs)
    if clause.interruption:
        out.extend((",", clause.interruption, ","))
    if "predicate" in clause.ellipsis:
        return  # "(I don't want) to"
    out.extend(non_finite(clause, syntax.grammar))
    if not clause.truncated:
        arguments(syntax, out, clause, clause.subject, stranded)
