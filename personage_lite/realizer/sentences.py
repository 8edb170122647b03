"""Sentences: openers, clauses joined, tags, vocatives and the end mark."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from personage_lite.realizer.clauses import content_clause, main_clause
from personage_lite.realizer.orthography import abbreviated
from personage_lite.realizer.phrases import coordination
from personage_lite.realizer.specification import (
    Case,
    Clause,
    Coordination,
    Embedded,
    NounPhrase,
    Phrase,
    Sentence,
)
from personage_lite.realizer.tags import raises_negation, tag_question, tagged_clause

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax

_ENDS: Final = frozenset(".!?…")
_TERMINALS: Final = {"interrogative": "?", "exclamative": "!"}


def sentence(syntax: Syntax, spec: Sentence) -> list[str]:
    """Return the words and marks of one sentence in order, before orthography."""
    body, following, openers, connective, vocative, afterthought, tag, terminal, *_ = spec
    out: list[str] = []
    for opener in openers:
        # A mark of its own counts as the mark after it.
        if opener.text[-1:] in _ENDS and not abbreviated(opener.text, syntax.grammar):
            out.extend((opener.text[:-1], opener.text[-1]))
        else:
            out.append(opener.text)
        if opener.mark:
            out.append(opener.mark)
    if connective:
        out.extend((connective, ","))
    if spec.false_start or spec.hesitation:
        body = _started(syntax, out, spec)
    _body(syntax, out, body)
    last: object = body
    for joined in following:
        if not joined.shared_subject or (isinstance(last, Clause) and last.quotation):
            out.append(",")
        out.append(joined.conjunction)
        last = joined.body
        inverted = joined.conjunction in syntax.grammar.inverting  # "nor does she"
        _body(syntax, out, joined.body, joined.shared_subject, inverted)
    if afterthought:
        out.extend((",", afterthought))
    if tag == "auto":
        clause_asked = tagged_clause(spec)
        tag = "" if clause_asked is None else tag
        if clause_asked is not None:
            negative = raises_negation(spec, syntax.grammar)
            tag_question(syntax, out, clause_asked, _subject(spec, clause_asked), negative)
    elif tag:
        out.extend((",", tag))
    if vocative:
        out.extend((",", vocative))
    out.append("?" if tag else terminal or _terminal(last))
    return out


def _started(syntax: Syntax, out: list[str], spec: Sentence) -> Embedded | Phrase:
    """Add what is said before one breaks off, or hesitates; return what one then says."""
    body, hesitation = spec.body, spec.hesitation
    broken = spec.false_start and isinstance(body, Clause | Embedded)
    if broken:
        clause = body.clause if isinstance(body, Embedded) else body
        assert isinstance(clause, Clause)
        main_clause(syntax, out, clause._replace(truncated=True, adverbs=(), subordinates=()))
    elif isinstance(body, Clause) and body.subject is not None and _named(body):
        syntax.phrase(out, body.subject, "subjective")
    elif hesitation:
        out.extend((hesitation, "…"))
        return body
    else:
        return body
    out.append("…")
    if hesitation:
        out.extend((hesitation, ","))
    return body._replace(subject=_taken_up(body.subject)) if isinstance(body, Clause) else body


def _named(clause: Clause) -> bool:
    """Whether a statement has a subject that one can name before one knows what to say of it."""
    pronoun = isinstance(clause.subject, NounPhrase) and clause.subject.pronoun
    whole = clause.form == "finite" and clause.mood == "declarative" and not clause.existential
    return whole and not (pronoun or clause.preposed)


def _taken_up(subject: Phrase | None) -> Phrase | None:
    """Return the pronoun for a subject that was just named, if it is sure to be the right one."""
    if not isinstance(subject, NounPhrase) or subject.relative or subject.possessor:
        return subject
    known = subject.entity or subject.gender != "neuter"
    return subject._replace(pronoun=True, stutter=0) if known else subject


def lone(syntax: Syntax, phrase: Phrase) -> list[str]:
    """Return the words of a clause or another phrase that is a sentence by itself."""
    out: list[str] = []
    _body(syntax, out, phrase)
    out.append(_terminal(phrase))
    return out


def embedded(syntax: Syntax, out: list[str], body: Embedded, case: Case = "objective") -> None:
    """Add fixed words and the clause that stands inside them."""
    syntax.phrase(out, body.lead)
    if body.complementizer:
        out.append(body.complementizer)
    content_clause(syntax, out, body.clause)


def _body(
    syntax: Syntax,
    out: list[str],
    body: Embedded | Phrase,
    shared_subject: bool = False,
    inverted: bool = False,
) -> None:
    """Add a clause, clauses, a main clause with the clause inside it, or a fragment."""
    if isinstance(body, Clause):
        main_clause(syntax, out, body, shared_subject, inverted)
    elif isinstance(body, Coordination):
        coordination(syntax, out, body, main=True)
    else:
        syntax.phrase(out, body)


def _subject(spec: Sentence, clause: Clause) -> Phrase | None:
    """Return the subject of a clause, or of the clause before it that it shares one with."""
    if clause.subject is not None:
        return clause.subject
    bodies: list[object] = [spec.body, *(joined.body for joined in spec.joined)]
    if isinstance(spec.body, Coordination):
        bodies = list(spec.body.items)
    for body in reversed(bodies):
        if isinstance(body, Clause) and body.subject is not None:
            return body.subject
    return None


def _whole(body: Phrase) -> bool:
    return isinstance(body, Clause) and body.form == "finite" and not body.ellipsis


def _terminal(body: object) -> str:
    """Return the mark that ends what has none of its own: by the mood of the last clause."""
    while isinstance(body, Coordination):
        # The last clause that is one by itself: "Will you sing and dance?"
        body = next(filter(_whole, reversed(body.items)), body.items[-1])
    return _TERMINALS.get(body.mood, ".") if isinstance(body, Clause) else "."
