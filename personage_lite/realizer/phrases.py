"""Adjective and prepositional phrases, coordinations, numbers, dates and fixed words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from personage_lite.realizer.clauses import main_clause
from personage_lite.realizer.numerals import Date, cardinal, date_text, ordinal
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
    for part in phrase.parts:
        if isinstance(part, Cased):
            syntax.phrase(out, part.phrase, part.case)
        else:
            syntax.phrase(out, part)


def adjective_phrase(
    syntax: Syntax, out: list[str], phrase: AdjectivePhrase, case: Case = "objective"
) -> None:
    """Add an adjective with its adverbs, its degree and what follows it."""
    attribute(syntax, out, phrase)
    after_adjective(syntax, out, phrase)


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
    else:
        out.append(inflect_adjective(adjective, phrase.degree, inflection))


def after_adjective(syntax: Syntax, out: list[str], phrase: AdjectivePhrase) -> None:
    """Add what an adjective governs and what it is compared to."""
    if phrase.complement is not None:
        syntax.phrase(out, phrase.complement)
    if phrase.compared is not None:
        words = syntax.grammar.words
        out.append(words.equative if phrase.degree == "equative" else words.comparative)
        syntax.phrase(out, phrase.compared)


def prepositional_phrase(
    syntax: Syntax, out: list[str], phrase: PrepositionalPhrase, case: Case = "objective"
) -> None:
    """Add a preposition and its object."""
    out.append(phrase.preposition)
    syntax.phrase(out, phrase.object)


def numeral(syntax: Syntax, out: list[str], phrase: Numeral, case: Case = "objective") -> None:
    """Add a number by itself."""
    numerals = syntax.grammar.numerals
    if phrase.ordinal:
        out.append(ordinal(int(phrase.value), numerals, phrase.figures))
    else:
        out.append(cardinal(phrase.value, numerals, phrase.figures))


def date(syntax: Syntax, out: list[str], phrase: Date, case: Case = "objective") -> None:
    """Add a date."""
    numerals = syntax.grammar.numerals
    out.append(date_text(phrase, numerals))
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
    items, conjunction = phrase.items, phrase.conjunction
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
