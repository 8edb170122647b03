"""Adjective and prepositional phrases, coordinations, numbers, dates and fixed words."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from personage_lite.errors import PersonageError
from personage_lite.realizer.clauses import main_clause
from personage_lite.realizer.features import SpecificationError
from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.numerals import Date, NumberWords, cardinal, date_text, ordinal
from personage_lite.realizer.orthography import MARKS
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Case,
    Cased,
    Clause,
    Coordination,
    NounPhrase,
    Numeral,
    Phrase,
    PrepositionalPhrase,
    Text,
)
from personage_lite.realizer.words import inflect_adjective, spell

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax


def text(syntax: Syntax, out: list[str], phrase: Text, case: Case = "objective") -> None:
    """Add fixed words and the phrases between them."""
    for index, part in enumerate(phrase.parts):
        if isinstance(part, Cased):
            syntax.phrase(out, part.phrase, part.case)
        elif phrase.contracted and isinstance(part, str) and index:
            _after_mention(syntax, out, phrase.parts[index - 1], part)
        else:
            syntax.phrase(out, part)
    last = phrase.parts[-1] if phrase.parts else ""
    if case in ("possessive", "independent") and not isinstance(last, Cased):
        possess(out, plural=False)


def _after_mention(syntax: Syntax, out: list[str], before: Cased | Phrase, words: str) -> None:
    """Add words after a mention; after a subject pronoun the first is shortened: "she", "'s late".

    Not where something has moved to the front: "who she is now".
    """
    grammar = syntax.grammar
    first, _, rest = words.partition(" ")
    pronoun = isinstance(before, Cased) and before.case == "subjective" and before.phrase.pronoun
    moved = len(out) > 1 and out[-2].rpartition(" ")[2] in grammar.full_after
    if pronoun and rest and not moved and first in grammar.contracted_in_text:
        out[-1] += grammar.contractions[first]
        words = rest
    syntax.phrase(out, words)


def possess(out: list[str], plural: bool) -> None:
    """Make the last word said an owner: Alice's, the gardeners'."""
    last = len(out) - 1
    while last and out[last] in MARKS:
        last -= 1
    out[last] += "'" if plural and out[last].endswith("s") else "'s"


def adjective_phrase(
    syntax: Syntax, out: list[str], phrase: AdjectivePhrase, case: Case = "objective"
) -> None:
    """Add an adjective with its adverbs, its degree, what it governs and is compared to."""
    attribute(syntax, out, phrase)
    if phrase.complement is not None:
        syntax.phrase(out, phrase.complement)
    if phrase.compared is not None:
        words = syntax.grammar.words
        out.append(words.equative if phrase.degree == "equative" else words.comparative)
        syntax.phrase(out, phrase.compared)


def attribute(syntax: Syntax, out: list[str], phrase: AdjectivePhrase) -> None:
    """Add the part of an adjective phrase that can stand before a noun."""
    out.extend(phrase.adverbs)
    inflection = syntax.grammar.inflection
    adjective = spell(phrase.adjective, inflection)
    if phrase.degree == "positive":
        out.append(adjective)
    elif phrase.degree == "equative":
        out.append(syntax.grammar.words.equative)
        out.append(adjective)
    elif phrase.degree in ("comparative", "superlative"):
        out.append(inflect_adjective(adjective, phrase.degree, inflection))
    else:
        raise KeyError(phrase.degree)


def prepositional_phrase(
    syntax: Syntax, out: list[str], phrase: PrepositionalPhrase, case: Case = "objective"
) -> None:
    """Add a preposition and its object."""
    out.append(phrase.preposition)
    syntax.phrase(out, phrase.object)


def numeral(syntax: Syntax, out: list[str], phrase: Numeral, case: Case = "objective") -> None:
    """Add a number by itself."""
    form = ordinal if phrase.ordinal else cardinal
    out.append(number_said(form, phrase.value, phrase, phrase.figures, syntax.grammar))


def number_said(
    form: Callable[[Any, NumberWords, bool], str],
    number: int | float,  # spelt out: a compiled build makes floats of all else
    phrase: Phrase,
    figures: bool,
    grammar: Grammar,
) -> str:
    """Return a number as a cardinal or an ordinal; `phrase` is where errors say that it stands."""
    try:
        return form(number, grammar.numerals, figures)
    except PersonageError as error:
        raise SpecificationError(str(error), phrase) from None


def date(syntax: Syntax, out: list[str], phrase: Date, case: Case = "objective") -> None:
    """Add a date."""
    numerals = syntax.grammar.numerals
    try:
        out.append(date_text(phrase, numerals))
    except PersonageError as error:
        raise SpecificationError(str(error), phrase) from None
    if phrase.style == "figures" and phrase.day and "," in numerals.patterns["figures_year"]:
        out.append(",")  # "July 4, 1862, was warm"


def coordination(
    syntax: Syntax,
    out: list[str],
    phrase: Coordination,
    case: Case = "objective",
    main: bool = False,
) -> None:
    """Add phrases or clauses with commas and the conjunction between them."""
    grammar = syntax.grammar
    items, conjunction = joined_items(phrase), phrase.conjunction
    last = len(items) - 1
    inverted = False
    pair = grammar.correlatives.get(conjunction, "") if phrase.correlative and last else ""
    if pair and (last == 1 or conjunction in grammar.disjunctive):
        if main and isinstance(items[0], Clause) and not _said_whole(items[1]):
            # What is shared comes first: "she neither sings nor dances".
            items = (items[0]._replace(adverbs=(pair, *items[0].adverbs)), *items[1:])
        else:
            out.append(pair)
            # "Not only is she kind", "neither does she run"
            inverted = main and (pair in grammar.inverting or pair in grammar.inverting_beginnings)
    owners = case in ("possessive", "independent")
    joint = owners and not phrase.separate and not _any_pronoun(phrase)
    for index, item in enumerate(items):
        if index:
            if index < last or conjunction == ",":
                out.append(",")
            else:
                if (main and _said_whole(item)) or (grammar.oxford_comma and last > 1):
                    out.append(",")
                # "Not only is she kind, but she is also brave": "also" goes into the clause.
                first, _, second = conjunction.partition(" ")
                out.append(first if inverted else conjunction)
                if inverted and second and isinstance(item, Clause):
                    item = item._replace(adverbs=(second, *item.adverbs))
        if main and isinstance(item, Clause):
            also = conjunction in grammar.inverting and _said_whole(item)
            main_clause(syntax, out, item, inverted=also if index else inverted)
        elif main and isinstance(item, Coordination):
            syntax.clauses(out, item)
        elif owners and index < last:
            syntax.phrase(out, item, "objective" if joint else "possessive")
        else:
            syntax.phrase(out, item, case)
    if phrase.relative is not None:
        syntax.relative(out, phrase)


def joined_items(phrase: Coordination) -> tuple[Phrase, ...]:
    """Return what is joined; nothing is an error."""
    if not phrase.items:
        raise SpecificationError("this joins nothing; give it items", phrase)
    return phrase.items


def _said_whole(clause: Phrase) -> bool:
    """Whether a clause says its own subject and verb, so that a comma parts it from another."""
    while isinstance(clause, Coordination):
        clause = clause.items[0]
    return (
        isinstance(clause, Clause)
        and clause.form == "finite"
        and not {"subject", "auxiliary", "verb"} & set(clause.ellipsis)
    )


def _any_pronoun(phrase: Coordination) -> bool:
    """Whether a pronoun owns too, which has no 's to share: "his and Alice's house"."""
    return any(isinstance(item, NounPhrase) and item.pronoun for item in phrase.items)
