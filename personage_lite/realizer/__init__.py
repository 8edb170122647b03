"""The surface realizer: typed deep syntax in, written English out. It can be used alone.

It plays the part that SimpleNLG plays in the paper (section IV-C). Realizing is pure: the
specification is never changed, the realizer keeps no state, threads may share it.
"""

from __future__ import annotations

from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.orthography import write
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Embedded,
    Joined,
    NounPhrase,
    Opener,
    Phrase,
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
    "Embedded",
    "Joined",
    "NounPhrase",
    "Opener",
    "Phrase",
    "Realizer",
    "Sentence",
    "Subordinate",
    "Text",
]


class Realizer:
    """Turns a `Sentence` (or a bare `Clause`) into text.

    >>> from personage_lite import english
    >>> alice = NounPhrase("Alice", gender="feminine", animate=True)
    >>> clause = Clause("be", alice, complement=AdjectivePhrase("curious"), contracted=True)
    >>> english().realize(Sentence(clause, tag="auto"))
    "Alice is curious, isn't she?"

    Source: Reiter & Dale 2000, chapter 6; the paper, section IV-C.
    """

    __slots__ = ("_grammar", "_syntax")

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar
        self._syntax = Syntax(grammar)

    def realize(self, sentence: Sentence | Clause) -> str:
        """Return the text of one sentence, with capital and end mark."""
        if isinstance(sentence, Clause):
            sentence = Sentence(sentence)
        return write(self.tokens(sentence), self._grammar)

    def tokens(self, sentence: Sentence) -> list[str]:
        """Return the words and marks of one sentence in order, before orthography."""
        out: list[str] = []
        syntax = self._syntax
        for opener in sentence.openers:
            out.append(opener.text)
            if opener.mark:
                out.append(opener.mark)
        if sentence.connective:
            out.extend((sentence.connective, ","))
        if sentence.false_start and not isinstance(sentence.body, Text):
            self._false_start(out, sentence.body)
        syntax.body(out, sentence.body)
        last = sentence.body
        for joined in sentence.joined:
            if not joined.shared_subject or (isinstance(last, Clause) and last.quotation):
                out.append(",")
            out.append(joined.conjunction)
            syntax.body(out, joined.body, joined.shared_subject)
            last = joined.body
        if sentence.afterthought:
            out.extend((",", sentence.afterthought))
        tag = sentence.tag
        if tag == "auto":
            tagged = _tagged(last)
            if tagged is None:
                tag = ""
            else:
                syntax.tag(out, tagged)
        elif tag:
            out.extend((",", tag))
        if sentence.vocative:
            out.extend((",", sentence.vocative))
        out.append("?" if tag else sentence.terminal)
        return out

    def _false_start(self, out: list[str], body: Clause | Embedded) -> None:
        clause = body.clause if isinstance(body, Embedded) else body
        self._syntax.clause(out, clause._replace(truncated=True, subordinates=()))
        out.append("…")


def _tagged(body: Clause | Embedded | Text) -> Clause | None:
    """Return the clause that a tag question agrees with; fixed words have none."""
    if isinstance(body, Embedded):
        return body.clause if body.inner_tag else None
    return body if isinstance(body, Clause) else None
