"""Clauses: word order in every mood, content clauses and relative clauses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, get_args

from personage_lite.errors import shown
from personage_lite.realizer.agreement import THIRD_SINGULAR, agreement, existential_agreement
from personage_lite.realizer.features import SpecificationError
from personage_lite.realizer.non_finite import bare, imperative, non_finite_clause
from personage_lite.realizer.predicates import arguments, predicate, quoted, speech_before
from personage_lite.realizer.specification import (
    Case,
    Clause,
    Mood,
    NounPhrase,
    Phrase,
    Question,
    Quotation,
    Relative,
)
from personage_lite.realizer.subordination import add_subordinate, following, fronted, preposed
from personage_lite.realizer.verb_group import verb_group

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax

_MOODS: Final = frozenset(get_args(Mood))


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
        non_finite_clause(syntax, out, clause)
        return
    fronted(syntax, out, clause)
    quotation = speech_before(clause)
    if quotation is not None:
        out.extend((quoted(syntax, quotation), ","))
        if quotation.inverted and clause.subject is not None and _can_report(clause):
            _reporting(syntax, out, clause, clause.subject)
            _rest_of_speech(syntax, out, quotation)
            return
    if clause.preposed:
        inverted = preposed(syntax, out, clause) or inverted
    if clause.mood == "interrogative":
        asked = clause.question
        if asked is not None:
            syntax.phrase(out, asked.phrase)
        inverted = asked is None or asked.role != "subject" or clause.existential
    if clause.mood not in _MOODS:
        raise KeyError(clause.mood)
    if clause.mood == "imperative":
        imperative(syntax, out, clause)
    else:
        _subject_and_predicate(syntax, out, clause, inverted, shared_subject)
    following(syntax, out, clause)
    if quotation is not None:
        _rest_of_speech(syntax, out, quotation)


def content_clause(
    syntax: Syntax, out: list[str], clause: Clause, case: Case = "objective"
) -> None:
    """Add a clause inside another one: "that she is kind", "who came", "to go", "running"."""
    if clause.form != "finite":
        non_finite_clause(syntax, out, clause)
        return
    asked = clause.question
    if clause.complementizer:
        out.append(clause.complementizer)
    elif clause.mood == "interrogative" and asked is None:
        out.append(syntax.grammar.words.whether)
    fronted(syntax, out, clause)
    inverted = preposed(syntax, out, clause) if clause.preposed else False
    if clause.mood == "interrogative" and asked is not None:
        syntax.phrase(out, asked.phrase)
    _subject_and_predicate(syntax, out, clause, inverted)
    quotation = speech_before(clause)
    if quotation is not None:
        out.extend((",", quoted(syntax, quotation)))
    following(syntax, out, clause)


def relative_clause(
    syntax: Syntax, out: list[str], clause: Clause, relative: Relative, head: NounPhrase
) -> None:
    """Add what follows a relative pronoun; `head` is what the pronoun stands for."""
    stranded = relative.preposition if relative.stranded or relative.omitted else ""
    if clause.form != "finite":
        non_finite_clause(syntax, out, clause, stranded)
        return
    role, subject = relative.role, clause.subject
    owned = relative.possessed and role != "subject"
    if owned:
        clause = _with_owned(syntax, out, clause, relative)
    elif role not in ("subject", "adverbial"):
        _refuse_doubled(clause, role, relative)
    gap = role in ("complement", "adverbial") and clause.verb == syntax.grammar.words.copula
    if clause.existential:
        if role == "subject" and not relative.possessed:
            clause = clause._replace(subject=None)
            subject = head._replace(relative=None)
        out.append(syntax.grammar.words.existential)
        predicate(syntax, out, clause, existential_agreement(subject, syntax.grammar))
    elif role == "subject" and not relative.possessed:
        agrees = agreement(head, syntax.grammar)
        predicate(syntax, out, clause, agrees, subject=head, stranded=stranded)
    elif subject is None:
        raise _no_subject(clause)
    else:
        start = len(out)
        syntax.phrase(out, subject, "subjective")
        # "The girl that she is": nothing is shortened before what has left.
        pronoun = not gap and _is_pronoun(subject) and len(out) == start + 1
        agrees = agreement(subject, syntax.grammar)
        predicate(syntax, out, clause, agrees, after_pronoun=pronoun, stranded=stranded, gap=gap)
    # Nothing can stand before the pronoun, so all subordinate clauses follow.
    for subordinate in clause.subordinates:
        add_subordinate(syntax, out, clause, subordinate)


def _with_owned(syntax: Syntax, out: list[str], clause: Clause, relative: Relative) -> Clause:
    """Add what follows "whose" ("whose cat Alice likes"); return the clause without it."""
    role = relative.role
    if role == "adverbial":
        raise SpecificationError(
            "what has no place of its own cannot be possessed; "
            "give the relative another role, or 'word: whose …'",
            relative,
        )
    owned = getattr(clause, role)
    if owned is not None:
        syntax.phrase(out, owned)
    if role == "object":
        return clause._replace(object=None)
    if role == "indirect_object":
        return clause._replace(indirect_object=None)
    return clause._replace(complement=None)


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
    gap = False
    if asked is not None and clause.mood in ("interrogative", "exclamative"):
        stranded = asked.preposition
        if clause.mood == "exclamative":
            _exclaimed(syntax, out, asked.phrase)
        elif asked.role == "subject":
            _asked_subject(syntax, out, clause, asked, inverted)
            return
        if asked.role not in ("adverbial", "subject"):
            _refuse_doubled(clause, asked.role, clause)
        gap = asked.role in ("complement", "adverbial") and clause.verb == grammar.words.copula
    elif clause.mood == "exclamative":
        _exclaimed(syntax, out, clause.complement)
        gap = True
    left_out = shared_subject or "subject" in clause.ellipsis or "auxiliary" in clause.ellipsis
    if subject is None and not left_out:
        raise _no_subject(clause)
    said = subject
    if clause.existential:
        agrees = existential_agreement(subject, grammar)
        said = grammar.words.existential
    elif clause.mood == "subjunctive" and clause.tense == "past":
        agrees = (3, True)  # "if I were you"
    else:
        agrees = THIRD_SINGULAR if subject is None else agreement(subject, grammar, inverted)
    if inverted and said is not None and not left_out:
        predicate(syntax, out, clause, agrees, before=said, stranded=stranded, gap=gap)
        return
    start = len(out)
    if said is not None and not left_out:
        syntax.phrase(out, said, "subjective")
    if clause.mood == "subjunctive" and clause.tense == "present":
        bare(syntax, out, clause, clause.negated, stranded)
        return
    short = clause.contracted and len(out) == start + 1
    short = short and (_is_pronoun(subject) or out[-1].lower() in grammar.contracting)
    predicate(syntax, out, clause, agrees, after_pronoun=short, stranded=stranded, gap=gap)


def _asked_subject(
    syntax: Syntax, out: list[str], clause: Clause, asked: Question, inverted: bool
) -> None:
    """Add what follows a subject that is asked for: "who came", "how many doors there are"."""
    if clause.subject is not None:
        raise _doubled("subject", clause)
    grammar = syntax.grammar
    agrees = agreement(asked.phrase, grammar)
    there = grammar.words.existential
    if clause.existential and inverted:
        predicate(syntax, out, clause, agrees, before=there, stranded=asked.preposition)
        return
    if clause.existential:
        out.append(there)
    short = asked.phrase in grammar.contracting if isinstance(asked.phrase, str) else False
    predicate(syntax, out, clause, agrees, after_pronoun=short, stranded=asked.preposition)


def _exclaimed(syntax: Syntax, out: list[str], phrase: Phrase | None) -> None:
    """Add what an exclamative begins with: "how curious", "what a clever girl", "how"."""
    words = syntax.grammar.words
    degree = words.exclamative_degree
    if isinstance(phrase, NounPhrase):
        if not phrase.determiner.startswith(degree):  # "how many tarts"
            out.append(words.exclamative_noun)
    else:
        out.append(degree)
    if phrase is not None:
        syntax.phrase(out, phrase)


def _reporting(syntax: Syntax, out: list[str], clause: Clause, subject: Phrase) -> None:
    """Add a clause of reporting with its verb first: "says the White Rabbit"."""
    group = verb_group(clause, agreement(subject, syntax.grammar), syntax.grammar)
    out.append(group.finite)
    out.extend(group.rest)
    syntax.phrase(out, subject, "subjective")
    out.extend(clause.adverbs)
    arguments(syntax, out, clause, subject)
    following(syntax, out, clause)


def _rest_of_speech(syntax: Syntax, out: list[str], quotation: Quotation) -> None:
    """Add the speech that goes on after its clause: "(“Well,” says Alice,) “I am not.”"."""
    if quotation.rest:
        out.extend((",", quoted(syntax, quotation.rest)))


def _can_report(clause: Clause) -> bool:
    """Whether the verb can come before the subject: a single one, and no pronoun."""
    plain = not (clause.negated or clause.modal or clause.perfect or clause.progressive)
    return plain and clause.tense != "future" and not _is_pronoun(clause.subject)


def _is_pronoun(phrase: Phrase | None) -> bool:
    return isinstance(phrase, NounPhrase) and phrase.pronoun


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
        f"the clause with the verb '{shown(clause.verb)}' has no subject; add one", clause
    )
