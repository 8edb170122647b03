"""Deep syntax to a row of words: says any phrase, each kind by the rules of its own module."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from personage_lite.realizer import clauses, noun_phrases, phrases, sentences
from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.numerals import Date
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Case,
    Clause,
    Coordination,
    Embedded,
    NounPhrase,
    Numeral,
    Phrase,
    PrepositionalPhrase,
    Sentence,
    Text,
)

_SAY: dict[type, Callable[[Any, list[str], Any, Case], None]] = {
    AdjectivePhrase: phrases.adjective_phrase,
    Clause: clauses.content_clause,
    Coordination: phrases.coordination,
    Date: phrases.date,
    Embedded: sentences.embedded,
    NounPhrase: noun_phrases.noun_phrase,
    Numeral: phrases.numeral,
    PrepositionalPhrase: phrases.prepositional_phrase,
    Text: phrases.text,
}


class Syntax:
    """Emits the words of phrases and clauses in order; holds nothing but the grammar's data."""

    __slots__ = ("grammar",)

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar

    def phrase(self, out: list[str], phrase: Phrase | Embedded, case: Case = "objective") -> None:
        """Add the words of any phrase."""
        if phrase.__class__ is str:
            owner = case in ("possessive", "independent")
            out.append(f"{phrase}'s" if owner else phrase)
        else:
            _SAY[phrase.__class__](self, out, phrase, case)

    def inverted(self, out: list[str], clause: Clause) -> None:
        """Add a clause with its auxiliary first: "had she known"."""
        clauses.main_clause(self, out, clause, inverted=True)

    def relative(self, out: list[str], joined: Coordination) -> None:
        """Add the relative clause about all that is joined."""
        noun_phrases.relative_to_all(self, out, joined)

    def clauses(self, out: list[str], joined: Coordination) -> None:
        """Add clauses joined as those of a sentence are."""
        phrases.coordination(self, out, joined, main=True)

    def tokens(self, sentence: Sentence | Phrase) -> list[str]:
        """Return the words and marks of one sentence in order, before orthography."""
        if isinstance(sentence, Sentence):
            return sentences.sentence(self, sentence)
        return sentences.lone(self, sentence)
