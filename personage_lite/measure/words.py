"""Texts taken apart into sentences and words, as far as counting needs it.

A tokenizer of our own, without a model: what it must get right is what decides the counts. A
quotation inside a sentence ("He says, “Oh dear! I shall be late!”") ends no sentence, and its words
are marked, because pronouns and exclamations in it are not the speaker's own style.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator
from operator import itemgetter
from typing import NamedTuple

from personage_lite.measure.lists import Lists

_WORD = re.compile(
    r"\d+(?:[.,]\d+)+"  # 10,000 and 3.5 are one word each
    r"|[^\W_]+(?:'[^\W_]+)*(?:-[^\W_]+(?:'[^\W_]+)*)*"  # she's, tea-party, mother-in-law's
)
# Marks that can end a sentence, and what can close after them.
_END = re.compile(r"(?<![.!?…])[.!?…]++[”)\]]*+(?=\s|$)")
_QUOTATION = re.compile(r"“[^“”]*”")
_INSCRIPTION = re.compile(r"\b[A-Z]{2,}(?: [A-Z]{2,})+\b")  # DRINK ME
_SPACES = re.compile(r"\s+")
_PARAGRAPHS = re.compile(r"\n[ \t]*\n")
_STUTTER = re.compile(r"\b([^\W\d_]{1,3})-((?:\1-){0,8})(?=\1[^\W\d_])", re.IGNORECASE)
# A mark of hesitation after so few words holds a sentence up and does not end it: "Well… I see."
_SHORT = 3
# How much of what follows a mark is looked at.
_SEEN = 80


class Word(NamedTuple):
    """A word, and the punctuation that stands directly before and after it.

    `text` is in lower case, without stutter; `stem` is it without what is contracted to it: "she"
    of "she's" (but "isn't" is one word). `capital` is whether it began with a capital letter;
    `quoted` whether it stands in a quotation inside a sentence, or in an inscription (DRINK ME).
    """

    text: str
    stem: str
    before: str
    after: str
    capital: bool
    quoted: bool

    @property
    def clitic(self) -> str:
        """What is contracted to the word, with its apostrophe: "'s" of "she's"."""
        return self.text[len(self.stem) :]


class Sentence(NamedTuple):
    """A sentence of at least one word; `end` is its last mark: . ! ? … or nothing.

    A sentence that ends with a quotation has no mark of its own: the quotation has.
    """

    words: tuple[Word, ...]
    end: str


class Passage(NamedTuple):
    """An utterance, or a paragraph of a text: its sentences and how often a word was stuttered."""

    sentences: tuple[Sentence, ...]
    stutters: int


class _Spans:
    """Parts of a text, one after the other."""

    def __init__(self, found: Iterable[re.Match[str]]) -> None:
        self._spans = [one.span() for one in found]

    def hold(self, place: int) -> bool:
        """Whether the character at a place stands in one of the parts."""
        index = bisect_right(self._spans, place, key=itemgetter(0)) - 1
        return index >= 0 and place < self._spans[index][1]


def words_of(text: str) -> tuple[str, ...]:
    """Return the words of a text, in lower case.

    >>> words_of("Let's see… a tea-party")
    ("let's", 'see', 'a', 'tea-party')
    """
    return tuple(_WORD.findall(_plain(text).lower()))


def take_apart(text: str, lists: Lists) -> Passage:
    """Return the sentences of a text.

    >>> from personage_lite.measure.features import load_features
    >>> text = "He says, “Oh dear! I shall be late!” Well… he is."
    >>> taken = take_apart(text, load_features().lists)
    >>> [(len(sentence.words), sentence.end) for sentence in taken.sentences]
    [(8, ''), (3, '.')]
    """
    plain = _plain(text)
    steady, stutters = _steady(plain, lists)
    pieces = [
        piece
        for paragraph in _PARAGRAPHS.split(steady)
        for piece in _pieces(_quotes(paragraph), lists)
    ]
    sentences = tuple(sentence for piece in pieces if (sentence := _sentence(piece)).words)
    return Passage(sentences, stutters)


def _plain(text: str) -> str:
    """Return a text with one kind of apostrophe and of ellipsis."""
    return text.replace("’", "'").replace("‘", "'").replace("...", "…")


def _steady(text: str, lists: Lists) -> tuple[str, int]:
    """Return a text without its stutters, and how many there were.

    "Al-Al-Alice" and "W-what" are stutters, "re-read" and "tea-party" are not.
    """
    count = 0

    def said_once(found: re.Match[str]) -> str:
        nonlocal count
        start, more = found.group(1), found.group(2)
        # Once and before a small letter it may be a prefix: "re-read", "no-nonsense".
        follows_small = text[found.end()].islower()
        if not more and follows_small and start.lower() in lists.no_stutters:
            return found.group(0)
        count += 1
        return ""

    return _STUTTER.sub(said_once, text), count


def _quotes(text: str) -> str:
    """Return a paragraph with “ and ” for straight quotation marks, if they come in pairs."""
    if text.count('"') % 2 == 0:
        halves = text.split('"')
        text = "".join(
            half + ("" if index == len(halves) - 1 else "”" if index % 2 else "“")
            for index, half in enumerate(halves)
        )
    return _SPACES.sub(" ", text).strip()


def _pieces(text: str, lists: Lists) -> Iterator[str]:
    """Yield the sentences of a paragraph as texts."""
    quotations = _Spans(_QUOTATION.finditer(text))
    start = 0
    for found in _END.finditer(text):
        place = found.end()
        if quotations.hold(place - 1) and quotations.hold(place):
            continue
        if _ends(text, start, found, lists):
            yield from _freed(text[start:place], lists)
            start = place
    yield from _freed(text[start:], lists)


def _ends(text: str, start: int, found: re.Match[str], lists: Lists) -> bool:
    """Whether a mark ends the sentence that began at `start`."""
    marks, rest = found.group(), text[found.end() : found.end() + _SEEN].lstrip(" “(")
    if not rest:
        return True
    before = text[start : found.start()]
    if "”" in marks:
        following = [word.lower() for word in _WORD.findall(rest)[:2]]
        return not (rest[0].islower() or lists.reporting_verbs.intersection(following[1:]))
    if marks[0] == "…":
        return len(_WORD.findall(before)) > _SHORT and not rest[0].islower()
    if marks == ".":
        last = before[before.rfind(" ") + 1 :].lstrip("“(")
        return not (last.lower() in lists.abbreviations or (len(last) == 1 and last.isupper()))
    return True


def _freed(piece: str, lists: Lists) -> Iterator[str]:
    """Yield a sentence, or those of a quotation that stands for itself."""
    piece = piece.strip()
    alone = _QUOTATION.fullmatch(piece)
    if alone is None:
        yield piece
    else:
        yield from _pieces(piece[1:-1].strip(), lists)


def _sentence(piece: str) -> Sentence:
    """Return a sentence's words with the marks between them."""
    spans = [found.span() for found in _WORD.finditer(piece)]
    edges = [0, *(last for _, last in spans)]
    starts = [*(first for first, _ in spans), len(piece)]
    gaps = [piece[edge:first].replace(" ", "") for edge, first in zip(edges, starts, strict=True)]
    quotations, inscriptions = _Spans(_QUOTATION.finditer(piece)), _Spans(_inscriptions(piece))
    words = tuple(
        Word(
            text := piece[first:last].lower(),
            text if text.endswith("n't") else text.partition("'")[0],
            gaps[index],
            gaps[index + 1],
            piece[first].isupper(),
            quotations.hold(first) or inscriptions.hold(first),
        )
        for index, (first, last) in enumerate(spans)
    )
    return Sentence(words, _end_of(gaps[-1]))


def _inscriptions(piece: str) -> Iterator[re.Match[str]]:
    """Find words in capitals in a sentence that is not all in capitals."""
    return iter(()) if piece.isupper() else _INSCRIPTION.finditer(piece)


def _end_of(marks: str) -> str:
    """Return the mark that ends a sentence, of all that stands after its last word."""
    if "”" in marks:
        return ""
    return next((mark for mark in "?!.…" if mark in marks), "")
