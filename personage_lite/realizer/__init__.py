"""The surface realizer: typed deep syntax in, written English out. It can be used alone.

It plays the part that SimpleNLG plays in the paper (section IV-C). Realizing is pure: the
specification is never changed, the realizer keeps no state, threads may share it.
"""

from __future__ import annotations

from personage_lite.errors import PersonageError
from personage_lite.realizer.features import SpecificationError
from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.numerals import Date
from personage_lite.realizer.orthography import write
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Embedded,
    Joined,
    NounPhrase,
    Numeral,
    Opener,
    Phrase,
    PrepositionalPhrase,
    Question,
    Quotation,
    Relative,
    Sentence,
    Subordinate,
    Text,
)
from personage_lite.realizer.syntax import Syntax

__all__ = [
    "AdjectivePhrase",
    "Cased",
    "Clause",
    "Coordination",
    "Date",
    "Embedded",
    "Joined",
    "NounPhrase",
    "Numeral",
    "Opener",
    "Phrase",
    "PrepositionalPhrase",
    "Question",
    "Quotation",
    "Realizer",
    "Relative",
    "Sentence",
    "SpecificationError",
    "Subordinate",
    "Text",
]

# What a specification can break when a value in it is of another type than it should be.
_BROKEN = (TypeError, AttributeError, KeyError, ValueError, IndexError, RecursionError)


class Realizer:
    """Turns a `Sentence` (or a bare `Clause` or phrase) into text.

    >>> from personage_lite import english
    >>> alice = NounPhrase("Alice", gender="feminine", animate=True)
    >>> clause = Clause("be", alice, complement=AdjectivePhrase("curious"), contracted=True)
    >>> english().realize(Sentence(clause, tag="auto"))
    "Alice is curious, isn't she?"

    Source: Reiter & Dale 2000, chapter 6; the paper, section IV-C.
    """

    __slots__ = ("_syntax", "grammar")

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar
        self._syntax = Syntax(grammar)

    def realize(self, sentence: Sentence | Phrase) -> str:
        """Return the text of one sentence, with capital and end mark.

        A phrase alone is a sentence of that phrase. Raises `SpecificationError`, which names the
        place inside the specification, for what cannot be said: a missing subject, a value of a
        wrong type, something nested too deep.
        """
        try:
            return write(self._syntax.tokens(sentence), self.grammar)
        except (PersonageError, *_BROKEN) as error:
            from personage_lite.realizer.diagnosis import diagnosed  # only a fault needs it

            raise diagnosed(sentence, error) from None
