"""Noun phrases: determiners, counts, order of adjectives, owners, pronouns, relative clauses."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, cast

from personage_lite.realizer.agreement import agreement
from personage_lite.realizer.clauses import relative_clause
from personage_lite.realizer.features import SpecificationError
from personage_lite.realizer.grammar import LIMITING, OPINION, UNLISTED, Grammar
from personage_lite.realizer.inflection import Countability
from personage_lite.realizer.number import determiner_form, number_and_kind, takes_pair
from personage_lite.realizer.numerals import cardinal, ordinal
from personage_lite.realizer.orthography import INDEFINITE
from personage_lite.realizer.phrases import attribute, joined_items, number_said, possess
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Case,
    Clause,
    Coordination,
    NounPhrase,
    Person,
    Phrase,
    PrepositionalPhrase,
    Relative,
)
from personage_lite.realizer.stutter import stutter
from personage_lite.realizer.words import pluralize, spell

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax

# More is a mistake, and could fill the memory.
_MOST_STUTTERS: Final = 20


def noun_phrase(
    syntax: Syntax, out: list[str], phrase: NounPhrase, case: Case = "objective"
) -> None:
    """Add a noun phrase or its pronoun."""
    grammar = syntax.grammar
    if phrase.pronoun or phrase.reflexive or case == "reflexive":
        pronoun(out, phrase, "reflexive" if phrase.reflexive else case, grammar)
        if phrase.pronoun and case in ("subjective", "objective"):
            _after_noun(syntax, out, phrase)
        return
    start = len(out)
    plural, kind = number_and_kind(phrase, grammar)
    noun, owner, adjectives = phrase.noun, phrase.possessor, phrase.adjectives
    owner_after = owner is not None and (phrase.determiner != "" or _heavy(owner))
    if phrase.determiner or owner is not None or phrase.predeterminer:
        _before_adjectives(syntax, out, phrase, plural, kind, owner_after)
    if len(adjectives) > 1 or (adjectives and phrase.cardinal is not None):
        adjectives = _in_order(syntax, out, adjectives)
    if phrase.ordinal is not None:
        out.append(number_said(ordinal, phrase.ordinal, phrase, phrase.figures, grammar))
    if phrase.cardinal is not None:
        out.append(number_said(cardinal, phrase.cardinal, phrase, phrase.figures, grammar))
    if kind == "pair" and takes_pair(phrase, grammar):
        pair = grammar.words.pair
        out.append(pluralize(pair, grammar.inflection) if plural else pair)
        out.append(grammar.words.possession)
    following: Sequence[Phrase] = ()
    if adjectives:
        # "Something strange"
        after = noun in grammar.indefinite_pronouns
        following = adjectives if after else _adjectives(syntax, out, adjectives)
    if noun:
        if phrase.stutter > _MOST_STUTTERS:
            what = f"stutter: {phrase.stutter} times is too often; write {_MOST_STUTTERS} at most"
            raise SpecificationError(what, phrase)
        if phrase.stutter and len(out) > start and out[-1] == INDEFINITE:
            out[-1] = INDEFINITE + noun  # "a f-fox"
        out.append(_noun(phrase, plural, kind, grammar))
    elif len(out) == start:
        raise SpecificationError("a noun phrase says nothing; give it a noun", phrase)
    for adjective in following:
        syntax.phrase(out, adjective)
    if owner is not None and owner_after:
        _owner_after(syntax, out, owner, double=phrase.determiner != "" and not _heavy(owner))
    if case in ("possessive", "independent"):
        for modifier in phrase.modifiers:
            syntax.phrase(out, modifier)
        possess(out, plural)
        if phrase.modifiers:
            phrase = phrase._replace(modifiers=())  # said before the 's
    _after_noun(syntax, out, phrase)


def _before_adjectives(
    syntax: Syntax,
    out: list[str],
    phrase: NounPhrase,
    plural: bool,
    kind: Countability,
    owner_after: bool,
) -> None:
    """Add the determiner, or the owner in its place."""
    grammar, owner = syntax.grammar, phrase.possessor
    if phrase.predeterminer:
        out.append(phrase.predeterminer)
    if owner is not None and not owner_after:
        syntax.phrase(out, owner, "independent" if _stands_alone(phrase) else "possessive")
    elif owner is not None and not phrase.determiner:
        out.append(grammar.words.definite)
    elif phrase.determiner:
        determiner = determiner_form(phrase, plural, kind, grammar)
        if determiner:
            article = determiner in grammar.indefinite_articles
            out.append(INDEFINITE if article else determiner)


def _after_noun(syntax: Syntax, out: list[str], phrase: NounPhrase) -> None:
    """Add what follows a noun or its pronoun: "we, the jury,", "he who hesitates"."""
    for modifier in phrase.modifiers:
        syntax.phrase(out, modifier)
    if phrase.apposition is not None:
        out.append(",")
        syntax.phrase(out, phrase.apposition)
        out.append(",")
    if phrase.relative is not None:
        _relative(syntax, out, phrase, phrase.relative)
    if phrase.interruption:
        out.extend((",", phrase.interruption, ","))


def pronoun(out: list[str], phrase: NounPhrase, case: Case, grammar: Grammar) -> None:
    """Add the pronoun that stands for a noun phrase."""
    out.append(grammar.pronouns[phrase.person, phrase.number, phrase.gender][case])


def _noun(phrase: NounPhrase, plural: bool, kind: Countability, grammar: Grammar) -> str:
    """Return the noun in its number and its spelling; names of entities stay as they are."""
    noun = phrase.noun
    if phrase.entity:
        return stutter(noun, phrase.stutter) if phrase.stutter else noun
    inflection = grammar.inflection
    noun = spell(noun, inflection)
    if plural and kind not in ("pair", "plural_only"):
        noun = pluralize(noun, inflection)
    return stutter(noun, phrase.stutter) if phrase.stutter else noun


# Adjectives


def _in_order(syntax: Syntax, out: list[str], adjectives: tuple[Phrase, ...]) -> tuple[Phrase, ...]:
    """Add the adjectives that come before a number ("the next two"); return the rest in order."""
    order = syntax.grammar.adjective_order
    # Sorting keeps the order of those of one rank.
    ranked = sorted(adjectives, key=lambda each: _rank(each, order))
    limiting = [each for each in ranked if _rank(each, order) == LIMITING]
    for adjective in limiting:
        syntax.phrase(out, adjective)
    return tuple(ranked[len(limiting) :])


def _adjectives(syntax: Syntax, out: list[str], adjectives: tuple[Phrase, ...]) -> list[Phrase]:
    """Add adjectives; return what has to follow the noun.

    That is the whole phrase if it governs something ("a girl proud of her cat") or compares by
    "as", and only the comparison of a comparative: "a braver girl than Dinah".
    """
    order = syntax.grammar.adjective_order
    following: list[Phrase] = []
    before = -1
    for adjective in adjectives:
        if _governs(adjective):
            following.append(adjective)
            continue
        rank = _rank(adjective, order)
        # Opinions are weighed one by one: "a kind, brave girl", but "a big old house".
        if OPINION <= before <= UNLISTED and OPINION <= rank <= UNLISTED:
            out.append(",")
        before = rank
        if isinstance(adjective, AdjectivePhrase):
            attribute(syntax, out, adjective)
            if adjective.compared is not None:
                following.append(_comparison(syntax, adjective.compared))
        elif isinstance(adjective, Coordination):
            last = adjective.items[-1]
            compared = last if isinstance(last, AdjectivePhrase) and last.compared else None
            if compared is not None and compared.compared is not None:
                bare = (*adjective.items[:-1], compared._replace(compared=None))
                adjective = adjective._replace(items=bare)
                following.append(_comparison(syntax, compared.compared))
            syntax.phrase(out, adjective)
        else:
            syntax.phrase(out, adjective)
    return following


def _comparison(syntax: Syntax, compared: Phrase) -> Phrase:
    """Return what a comparative before a noun leaves behind it: "than Dinah"."""
    return PrepositionalPhrase(syntax.grammar.words.comparative, compared)


def _governs(adjective: Phrase) -> bool:
    """Whether an adjective has to follow its noun: "a girl proud of her cat", "as brave as"."""
    if isinstance(adjective, Coordination):
        return any(map(_governs, adjective.items))
    return isinstance(adjective, AdjectivePhrase) and (
        adjective.complement is not None or adjective.degree == "equative"
    )


def _rank(adjective: Phrase, order: dict[str, int]) -> int:
    while isinstance(adjective, Coordination):
        adjective = adjective.items[0]
    if isinstance(adjective, AdjectivePhrase):
        return order.get(adjective.adjective, UNLISTED)
    return order.get(adjective, UNLISTED) if isinstance(adjective, str) else UNLISTED


# Owners


def _heavy(owner: Phrase) -> bool:
    """Whether an owner has too much after its noun to bear an 's."""
    if isinstance(owner, Coordination):
        return any(map(_heavy, owner.items))
    return (
        isinstance(owner, NounPhrase)
        and not owner.pronoun
        and (
            owner.relative is not None
            or owner.apposition is not None
            or any(isinstance(modifier, Clause) for modifier in owner.modifiers)
        )
    )


def _owner_after(syntax: Syntax, out: list[str], owner: Phrase, double: bool) -> None:
    """Add "of" and the owner: "of Alice, who is kind"; double: "(a friend) of hers"."""
    out.append(syntax.grammar.words.possession)
    # Things own less than people do: "a leg of the table".
    thing = isinstance(owner, NounPhrase) and not (owner.animate or owner.entity or owner.pronoun)
    syntax.phrase(out, owner, "independent" if double and not thing else "objective")


def _stands_alone(phrase: NounPhrase) -> bool:
    """Whether nothing but the owner is said: "hers", but "her two", "her own"."""
    return not (phrase.noun or phrase.adjectives) and phrase.cardinal is phrase.ordinal is None


# Relative clauses


def _relative(syntax: Syntax, out: list[str], phrase: NounPhrase, relative: Relative) -> None:
    """Add "who …"; between commas unless it is restrictive."""
    grammar = syntax.grammar
    mark = [] if relative.restrictive else [","]
    out.extend(mark)
    # Only a restrictive pronoun that is no subject can be left out; its preposition stays behind.
    omitted = relative.omitted and relative.restrictive and relative.role != "subject"
    finite = not isinstance(relative.clause, Clause) or relative.clause.form == "finite"
    if relative.preposition and not (relative.stranded or omitted):
        out.append(relative.preposition)
    if relative.possessed:
        out.append(relative.word or grammar.relative_possessive)
    elif not omitted and (finite or (relative.preposition and not relative.stranded)):
        out.append(relative.word or _relative_pronoun(phrase, relative, grammar))
    said = relative.clause
    clauses = joined_items(said) if isinstance(said, Coordination) else (said,)
    for index, clause in enumerate(clauses):
        if index and isinstance(said, Coordination):
            out.append("," if index < len(clauses) - 1 else said.conjunction)
        relative_clause(syntax, out, _as_clause(clause, said), relative, phrase)
    out.extend(mark)


def relative_to_all(syntax: Syntax, out: list[str], joined: Coordination) -> None:
    """Add a relative clause about all that is joined: "the King and the Queen, who are late"."""
    person, plural = agreement(joined, syntax.grammar)
    animate = any(isinstance(item, NounPhrase) and item.animate for item in joined.items)
    all_of_them = NounPhrase(
        "",
        pronoun=True,
        number="plural" if plural else "singular",
        person=cast(Person, person),
        animate=animate,
    )
    if joined.relative is not None:
        _relative(syntax, out, all_of_them, joined.relative)


def _as_clause(phrase: Phrase, joined: Phrase) -> Clause:
    if isinstance(phrase, Clause):
        return phrase
    raise SpecificationError("only clauses can be joined in a relative clause; add verbs", joined)


def _relative_pronoun(phrase: NounPhrase, relative: Relative, grammar: Grammar) -> str:
    """Return who, whom, which or that, by the noun and the role."""
    table = grammar.relative_pronouns["animate" if phrase.animate else "inanimate"]
    if relative.preposition and not relative.stranded:
        return table["after_preposition"]
    if relative.role == "complement":
        # What somebody is, is no person: "the child that she was".
        table = grammar.relative_pronouns["inanimate"]
    role = "subject" if relative.role == "subject" else "object"
    return table[f"restrictive_{role}" if relative.restrictive else role]
