"""Adverbial clauses before and after their host, and what else stands before a subject."""

from __future__ import annotations

from typing import TYPE_CHECKING

from personage_lite.realizer.predicates import speech_before
from personage_lite.realizer.specification import Clause, NounPhrase, Phrase, Subordinate

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax


def fronted(syntax: Syntax, out: list[str], clause: Clause) -> None:
    """Add the adverbial clauses that come before the subject."""
    for subordinate in clause.subordinates:
        if subordinate.fronted:
            _add(syntax, out, subordinate)
            out.append(",")


def following(syntax: Syntax, out: list[str], clause: Clause) -> None:
    """Add the adverbial clauses that come at the end."""
    for subordinate in clause.subordinates:
        if not subordinate.fronted:
            add_subordinate(syntax, out, clause, subordinate)


def add_subordinate(syntax: Syntax, out: list[str], host: Clause, subordinate: Subordinate) -> None:
    """Add an adverbial clause that follows its host; a comma parts it from speech."""
    if host.quotation and speech_before(host) is None:
        out.append(",")
    _add(syntax, out, subordinate)


def _add(syntax: Syntax, out: list[str], subordinate: Subordinate) -> None:
    if subordinate.conjunction:
        out.append(subordinate.conjunction)
    if subordinate.inverted:
        syntax.inverted(out, subordinate.clause)
    else:
        syntax.phrase(out, subordinate.clause)


def preposed(syntax: Syntax, out: list[str], clause: Clause) -> bool:
    """Add the phrases before the subject; return whether they put the auxiliary before it too."""
    inverted = False
    for phrase in clause.preposed:
        start = len(out)
        syntax.phrase(out, phrase)
        if _inverts(phrase, " ".join(out[start:]), clause, syntax):
            inverted = True
        else:
            out.append(",")
    return inverted


def _inverts(phrase: Phrase, said: str, clause: Clause, syntax: Syntax) -> bool:
    """Whether a phrase inverts what follows: "never had she run", "so do we"."""
    grammar = syntax.grammar
    if isinstance(phrase, Clause):
        return False
    if said in grammar.inverting:
        return True
    if "predicate" in clause.ellipsis and said in grammar.inverting_with_ellipsis:
        return True
    if isinstance(phrase, NounPhrase) and phrase.determiner in grammar.inverting:
        return True  # "neither of them did she like"
    return f"{said} ".startswith(grammar.inverting_beginnings)
