"""Assembly: a sentence plan's clauses become one deep-syntax tree for the realizer."""

from __future__ import annotations

from personage_lite.plan import ClausePlan, SentencePlan
from personage_lite.realizer.specification import (
    Cased,
    Clause,
    Embedded,
    Joined,
    NounPhrase,
    Phrase,
    Relative,
    Sentence,
    Subordinate,
    Text,
)
from personage_lite.sentence_planner.hedges import middle_free


def assemble(plan: SentencePlan, clauses: tuple[ClausePlan, ...]) -> Sentence:
    """Return the realizer's specification of a sentence plan with these clauses."""
    if plan.fragment is not None:
        return Sentence(
            plan.fragment,
            openers=plan.openers,
            vocative=plan.vocative,
            afterthought=plan.afterthought,
            terminal=plan.terminal,
        )
    bodies: list[tuple[ClausePlan, Clause]] = []
    fronted: tuple[Subordinate, ...] = ()
    for part in clauses:
        clause = part.clause
        if part.link == "fronted":
            fronted = (*fronted, Subordinate(part.cue, clause, fronted=True))
        elif part.link in ("main", "coordinate"):
            if fronted:
                clause = clause._replace(subordinates=(*fronted, *clause.subordinates))
                fronted = ()
            bodies.append((part, clause))
        else:
            host, said = bodies[-1]
            bodies[-1] = (host, _attached(said, part))
    joined: tuple[Joined, ...] = ()
    if len(bodies) > 1:
        joined = tuple(
            tuple.__new__(Joined, (part.cue, _framed(part, clause), part.shared_subject))
            for part, clause in bodies[1:]
        )
    # Unchecked, for the plan's parts are: that takes half the time.
    around = (plan.openers, plan.connective, plan.vocative, plan.afterthought, plan.tag)
    hesitation = plan.hesitation
    if hesitation:
        bodies[0], hesitation = _hesitant(*bodies[0], hesitation)
    started = (plan.terminal, plan.false_start, hesitation)
    fields = (_framed(*bodies[0]), joined, *around, *started)
    return tuple.__new__(Sentence, fields)


def _hesitant(
    part: ClausePlan, clause: Clause, hesitation: str
) -> tuple[tuple[ClausePlan, Clause], str]:
    """Put a hesitation after a subject that is a pronoun, if the clause's middle is free.

    "He, um, talks" is said, but neither "he even, um, talks" nor "the Dodo, um, talks".
    """
    pronoun = isinstance(clause.subject, NounPhrase) and clause.subject.pronoun
    if not (pronoun and middle_free(part)):
        return (part, clause), hesitation
    return (part, clause._replace(interruption=hesitation)), ""


def _attached(host: Clause, part: ClausePlan) -> Clause:
    """Put a subordinate or relative clause into its host."""
    if part.link == "subordinate":
        return host._replace(subordinates=(*host.subordinates, Subordinate(part.cue, part.clause)))
    inner = part.clause._replace(subject=None)
    if part.link == "relative" and isinstance(host.subject, NounPhrase):
        return host._replace(subject=host.subject._replace(relative=Relative(inner)))
    for name in ("adverbials", "complement", "object"):
        said = getattr(host, name)
        if name == "adverbials" and said:
            return host._replace(adverbials=(*said[:-1], _with_relative(said[-1], inner)))
        if name == "complement" and said is not None:
            return host._replace(complement=_with_relative(said, inner))
        if name == "object" and said is not None:
            return host._replace(object=_with_relative(said, inner))
    raise AssertionError("a relative clause without a host")


def _with_relative(phrase: Phrase, inner: Clause) -> Phrase:
    """Attach a relative clause to the mention that ends a phrase."""
    assert isinstance(phrase, Text)
    last = phrase.parts[-1]
    assert isinstance(last, Cased)
    noun = last.phrase._replace(relative=Relative(inner))
    return Text((*phrase.parts[:-1], Cased(noun, last.case)))


def _framed(part: ClausePlan, clause: Clause) -> Clause | Embedded:
    """Put a clause into its template's frame."""
    frame = part.frame
    if frame is None or frame.lead is None:
        return clause
    if frame.form == "someone_who":
        word = frame.lead.parts[0]
        assert isinstance(word, str)
        someone = NounPhrase(
            word,
            animate=isinstance(clause.subject, NounPhrase) and clause.subject.animate,
            relative=Relative(
                clause._replace(subject=None, subordinates=(), contracted=False), restrictive=True
            ),
        )
        return Clause(
            "be",
            clause.subject,
            complement=someone,
            subordinates=clause.subordinates,
            contracted=clause.contracted,
        )
    return Embedded(frame.lead, clause, frame.complementizer, frame.inner_tag)
