"""Predicates: the verb group with negation and contraction, and the arguments in their order."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from personage_lite.realizer.agreement import Agreement
from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.orthography import write
from personage_lite.realizer.specification import (
    Cased,
    Clause,
    Coordination,
    NounPhrase,
    Phrase,
    Quotation,
    Sentence,
    Text,
)
from personage_lite.realizer.verb_group import VerbGroup, verb_group

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax

_SWAPPED: Final = {"“": "‘", "”": "’", "‘": "“", "’": "”"}


def predicate(
    syntax: Syntax,
    out: list[str],
    clause: Clause,
    agrees: Agreement,
    after_pronoun: bool = False,
    before: Phrase | None = None,
    subject: Phrase | None = None,
    stranded: str = "",
    gap: bool = False,
) -> None:
    """Add the verb group and all that follows it, but for subordinate clauses.

    `before` is the subject of an inverted clause, said after the auxiliary; `after_pronoun` says
    that the auxiliary can be shortened; `subject` is whom a relative clause is about; `stranded`
    is a preposition left at the end; `gap` says that what follows the verb "be" stands elsewhere.
    """
    grammar = syntax.grammar
    negator = clause.negator if clause.negated else ""
    plain_not = negator == grammar.words.negator
    ellipsis = clause.ellipsis
    whole = clause.modal in grammar.negated_as_a_whole and before is None
    alone = "predicate" in ellipsis
    subject = clause.subject if subject is None else subject
    support = plain_not or before is not None or alone or clause.emphatic
    group = verb_group(clause, agrees, grammar, support)
    outside = clause.negated and before is None
    if outside and clause.emphasizers:
        out.extend(clause.emphasizers)
        after_pronoun = False
    middle: list[str] = []
    if clause.negated or clause.emphasizers or clause.adverbs or clause.interruption:
        if negator and (whole or not plain_not):
            middle.append(negator)
        if not outside:
            middle.extend(clause.emphasizers)
        middle.extend(clause.adverbs)
        if clause.interruption:
            middle.extend((",", clause.interruption, ","))
    if before is not None:
        _inverted_finite(syntax, out, clause, group, before)
        out.extend(middle)
    elif "auxiliary" in ellipsis and group.auxiliary and group.rest:
        out.extend(middle)
    elif "verb" in ellipsis:
        group = VerbGroup("", [], True)
    else:
        start = len(out)
        _finite_words(out, clause, group, after_pronoun, plain_not and not whole, grammar)
        if whole:
            out.extend(group.linked)
        last = alone or (gap and not group.rest)
        if group.auxiliary and not (last and not plain_not):
            out.extend(middle)
        else:
            # Before the finite verb: "she often runs", and at the end: "she never does".
            out[start:start] = middle
    if not whole:
        out.extend(group.linked)
    if alone:
        for adverbial in clause.adverbials:
            syntax.phrase(out, adverbial)
        return
    if "main_verb" in ellipsis:
        out.extend(group.rest[:-1])
        return
    out.extend(group.rest)
    if not clause.truncated:
        arguments(syntax, out, clause, subject, stranded)


def _inverted_finite(
    syntax: Syntax, out: list[str], clause: Clause, group: VerbGroup, subject: Phrase
) -> None:
    """Add the auxiliary, the subject and "not", which a contraction takes before the subject."""
    grammar = syntax.grammar
    finite = group.finite
    negated = clause.negated and clause.negator == grammar.words.negator
    if negated and clause.contracted:
        short = grammar.negative_contractions.get(finite) or grammar.question_negatives.get(finite)
        if short:
            finite, negated = short, False
    elif (
        clause.contracted
        and finite in grammar.contracted_after
        and clause.question is not None
        and isinstance(clause.question.phrase, str)
        and clause.question.phrase in grammar.contracting
        and (group.rest or not (isinstance(subject, NounPhrase) and subject.pronoun))
    ):
        out[-1] += grammar.contractions[finite]
        finite = ""
    if finite:
        out.append(finite)
    syntax.phrase(out, subject, "subjective")
    if negated:
        out.append(clause.negator)


def _finite_words(
    out: list[str],
    clause: Clause,
    group: VerbGroup,
    after_pronoun: bool,
    negated: bool,
    grammar: Grammar,
) -> None:
    """Add the finite verb and "not", shortened where the clause and its place allow it."""
    finite = group.finite
    short: str | None = None
    able = clause.contracted and after_pronoun and group.auxiliary
    if able and (negated or _can_shorten(clause, group)):
        # "There's" and "who's", but not "there're".
        odd = finite not in grammar.contracted_after and out[-1].lower() in grammar.contracting
        short = None if odd else grammar.contractions.get(finite)
    if not negated:
        if short:
            out[-1] += short
        else:
            out.append(finite)
    elif clause.contracted and finite in grammar.negative_contractions:
        out.append(grammar.negative_contractions[finite])
    elif short:
        out[-1] += short
        out.append(clause.negator)
    elif finite in grammar.fused_negatives:
        out.append(grammar.fused_negatives[finite])
    else:
        out.extend((finite, clause.negator))


def _can_shorten(clause: Clause, group: VerbGroup) -> bool:
    """Whether enough follows an auxiliary: nothing is shortened at the end, "Yes, she is"."""
    if clause.truncated or clause.mood == "exclamative" or clause.ellipsis:
        return False
    if group.rest:
        return True
    if clause.question is not None and clause.question.role != "subject":
        return False  # what it asks for has left: "(tell me) where he is today"
    return bool(clause.complement is not None or clause.adverbials or clause.existential)


# Arguments


def arguments(
    syntax: Syntax, out: list[str], clause: Clause, subject: Phrase | None, stranded: str = ""
) -> None:
    """Add all that follows the verbs of a clause, but for subordinate clauses."""
    if clause.existential and clause.subject is not None:
        syntax.phrase(out, clause.subject)
    particle_last = (
        clause.particle
        and _is_pronoun(clause.object, syntax.grammar)
        and clause.particle not in syntax.grammar.inflection.prepositions
    )
    if clause.particle and not particle_last:
        out.append(clause.particle)
    if clause.indirect_object is not None:
        _object(syntax, out, subject, clause.indirect_object)
    if clause.object is not None:
        _object(syntax, out, subject, clause.object)
    if particle_last:
        out.append(clause.particle)
    exclaimed = clause.mood == "exclamative" and clause.question is None
    if clause.complement is not None and not exclaimed:
        syntax.phrase(out, clause.complement)
    if clause.agent is not None:
        out.append(syntax.grammar.words.agent)
        syntax.phrase(out, clause.agent)
    if stranded:
        out.append(stranded)
    for adverbial in clause.adverbials:
        syntax.phrase(out, adverbial)
    for aside in clause.asides:
        out.append(",")
        syntax.phrase(out, aside)
        out.append(",")
    if clause.quotation and speech_before(clause) is None:
        out.extend((",", quoted(syntax, clause.quotation)))


def speech_before(clause: Clause) -> Quotation | None:
    """Return the direct speech that a clause follows, if it does."""
    quotation = clause.quotation
    return quotation if isinstance(quotation, Quotation) and quotation.first else None


def quoted(syntax: Syntax, quotation: str | Sentence | Quotation) -> str:
    """Return direct speech in quotation marks; those inside it become single ones."""
    speech = quotation.speech if isinstance(quotation, Quotation) else quotation
    if isinstance(speech, Sentence):
        speech = write(syntax.tokens(speech), syntax.grammar)
    if not isinstance(speech, str):
        raise TypeError("speech that is no text")
    return f"“{_inner(speech)}”"


def _inner(speech: str) -> str:
    """Return speech as it stands inside quotation marks: “ ” become ‘ ’, and those “ ” again."""
    if "“" not in speech and "‘" not in speech:
        return speech
    swapped = ""
    for index, letter in enumerate(speech):
        apostrophe = letter == "’" and speech[index + 1 : index + 2].isalpha()
        swapped += letter if apostrophe else _SWAPPED.get(letter, letter)
    return swapped


def _object(syntax: Syntax, out: list[str], subject: Phrase | None, said: Phrase) -> None:
    """Add an object; the pronoun for whom the subject denotes too is reflexive."""
    if isinstance(subject, NounPhrase) and subject.entity:
        if isinstance(said, Coordination):
            items = tuple(_reflexive(item, subject.entity) for item in said.items)
            said = said._replace(items=items)
        else:
            said = _reflexive(said, subject.entity)
    syntax.phrase(out, said)


def _reflexive(said: Phrase, entity: str) -> Phrase:
    """Return a pronoun as the reflexive one, if it denotes an entity."""
    if isinstance(said, NounPhrase) and said.pronoun and said.entity == entity:
        return said._replace(reflexive=True)
    return said


def _is_pronoun(phrase: Phrase | None, grammar: Grammar) -> bool:
    while isinstance(phrase, Text) and len(phrase.parts) == 1:
        part = phrase.parts[0]
        if isinstance(part, Cased):
            return part.case == "reflexive" or part.phrase.pronoun
        phrase = part
    if isinstance(phrase, str):
        return phrase in grammar.object_pronouns
    return isinstance(phrase, NounPhrase) and (phrase.pronoun or phrase.reflexive)
