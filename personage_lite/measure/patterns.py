"""Words that count only in some places: "like" between commas, "so" before an adjective.

A pattern is made from a marker of lexicons/markers.yaml, whose `place` says where generation puts
it, or from a list of lexicons/features.yaml. There is no tagger: a place is recognized by the marks
and the closed word classes around it, and what is in doubt does not count.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import NamedTuple

from personage_lite.measure.lists import Context, Lists
from personage_lite.measure.words import Word, words_of

# The places that a sentence must begin with, those of what is set off at the start of a clause, and
# those that ask for nothing.
_STARTS = ("sentence", "utterance", "question", "answer")
_OPENERS = ("opener", *_STARTS)
_ANYWHERE = ("", "middle", "alone", "connective")
PLACES = (
    *("degree", "quantity", "pause", "lead", "end", "news", "vocative", "joint", "asks"),
    *_OPENERS,
    *_ANYWHERE[1:],
)
_STOPS = frozenset(",!?.;:-–—")
_NO_CONTEXT = Context()


class Pattern(NamedTuple):
    """Words in a row, where they must stand, and the mark that must follow.

    `text` is how they are listed; a * at its end or beginning stands for any letters.
    """

    text: str
    words: tuple[str, ...]
    place: str = ""
    after: str = ""


class Names(NamedTuple):
    """Sentences that are but a name: "The Moon!", "Oh, Pluto, pal!".

    `ends` are the marks that one can have, `leads` and `addresses` the words that can be set off
    before and behind the name. One that only begins the sentence is in doubt ("Help!").
    """

    ends: frozenset[str]
    leads: frozenset[tuple[str, ...]]
    addresses: frozenset[tuple[str, ...]]

    def match(self, words: Sequence[Word], end: str, closed: frozenset[str]) -> bool:
        """Whether a sentence with its last mark is one."""
        if end not in self.ends:
            return False
        edges = [index for index, word in enumerate(words) if word.before.endswith(",")]
        parts = [words[start:last] for start, last in pairwise([0, *edges, len(words)])]
        if len(parts) > 1 and _texts(parts[-1]) in self.addresses:
            parts.pop()
        if len(parts) > 1 and _texts(parts[0]) in self.leads:
            parts.pop(0)
        return (
            len(parts) == 1
            and all(word.capital or word.stem in closed for word in parts[0])
            and any(word.capital and word.stem not in closed for word in words[1:])
        )


def _texts(words: Sequence[Word]) -> tuple[str, ...]:
    return tuple(word.text for word in words)


def pattern_of(text: str, place: str = "", after: str = "") -> Pattern:
    """Return the pattern of words as a list or a marker has them.

    >>> pattern_of("I think", "end").words
    ('i', 'think')
    """
    starred = text.startswith("*") or text.endswith("*")
    return Pattern(text.lower(), (text.lower(),) if starred else words_of(text), place, after)


class Finder:
    """Looks for patterns together: the longest first, and no word counts twice."""

    def __init__(
        self, patterns: Iterable[Pattern], lists: Lists, names: Names | None = None
    ) -> None:
        self._lists, self._names = lists, names
        self._by_word: dict[str, list[Pattern]] = {}
        starts, ends = [], []
        for pattern in sorted(patterns, key=lambda pattern: -len(pattern.words)):
            first = pattern.words[0]
            if first.endswith("*"):
                starts.append(first[:-1])
            elif first.startswith("*"):
                ends.append(first[1:])
            else:
                self._by_word.setdefault(first, []).append(pattern)
        self._starts, self._ends = tuple(starts), tuple(ends)

    def may_find(self, texts: set[str]) -> bool:
        """Whether any pattern can stand among such words (`text` and `stem` of each)."""
        always = self._starts or self._ends or self._names
        return bool(always) or not self._by_word.keys().isdisjoint(texts)

    def find(self, words: Sequence[Word], end: str) -> list[tuple[int, int]]:
        """Return where patterns stand in a sentence with its last mark, as (first, behind last).

        Words in quotations are passed over: they are not the speaker's own.
        """
        if self._names and self._names.match(words, end, self._lists.closed):
            return [(0, len(words))]
        found = []
        index = 0
        while index < len(words):
            length = 0 if words[index].quoted else self._length_at(words, index, end)
            if length:
                found.append((index, index + length))
            index += length or 1
        return found

    def _length_at(self, words: Sequence[Word], index: int, end: str) -> int:
        """Return how many words the pattern that stands here has; 0 if there is none."""
        text, stem = words[index].text, words[index].stem
        listed = self._by_word.get(text, [])
        if stem != text:
            listed = listed + self._by_word.get(stem, [])
        for pattern in listed:
            behind = index + len(pattern.words)
            if (
                behind <= len(words)
                and all(
                    sought in (word.text, word.stem)
                    for word, sought in zip(words[index:behind], pattern.words, strict=True)
                )
                and _in_place(pattern, words, index, end, self._lists)
                and _in_context(pattern, words, index, self._lists)
            ):
                return len(pattern.words)
        return int(text.startswith(self._starts) or text.endswith(self._ends))


def _in_place(pattern: Pattern, words: Sequence[Word], index: int, end: str, lists: Lists) -> bool:
    """Whether a pattern found at `index` stands in its place."""
    place, behind = pattern.place, index + len(pattern.words)
    if place in _ANYWHERE:
        return True
    before, after = words[index].before, words[behind - 1].after
    following = words[behind] if behind < len(words) else None
    starts, stops = index == 0 or bool(before), bool(after) or following is None
    if place in _OPENERS:
        # "Well… she" hesitates and "Well, she" does not: a mark of hesitation is asked for.
        hesitates = after.startswith("…")
        if hesitates or pattern.after == "…":
            marked = hesitates and pattern.after == "…"
        else:
            marked = after[:1] in _STOPS and after != ""
        return marked and starts and (index == 0 or place not in _STARTS)
    if place == "pause":
        # "She, um, runs", "Alice… um, she runs", "Um… she runs".
        inside = before.endswith((",", "…")) and after.startswith(",")
        return inside or (starts and after.startswith("…"))
    if place == "end":
        return before.endswith(",") and stops
    if place == "vocative":
        return starts and stops
    if place == "news":
        return pattern.after in after
    if place == "asks":
        return end == "?"
    if following is None or after:
        return False
    if place == "degree":
        return _can_be_graded(following, lists)
    if place == "quantity":
        return following.text[0].isdigit() or following.text in lists.numbers
    if place == "joint":
        return before.endswith(",") and not _can_be_graded(following, lists)
    # A lead: "I think that …", and without "that" if a clause begins.
    begins = starts or words[index - 1].text in lists.conjunctions
    return begins and (
        pattern.words[-1] == "that"
        or following.capital
        or following.stem in lists.determiners
        or following.stem in lists.pronouns
    )


def _in_context(pattern: Pattern, words: Sequence[Word], index: int, lists: Lists) -> bool:
    """Whether the words around are such that an ambiguous word is the hedge."""
    context = lists.contexts.get(pattern.text, _NO_CONTEXT)
    behind = index + len(pattern.words)
    before = words[index - 1] if index and not words[index].before else None
    following = words[behind] if behind < len(words) and not words[behind - 1].after else None
    if before is not None and context.not_after & {before.text, before.clitic}:
        return False
    if following is None:
        return not context.adjective
    return following.text not in context.not_before and (
        not context.adjective or _is_adjective(following.text, lists)
    )


def _is_adjective(word: str, lists: Lists) -> bool:
    """Whether a word is an adjective by the lexicon or by its ending."""
    return word in lists.adjectives or any(
        word.endswith(ending) and len(word) > len(ending) + 2 for ending in lists.adjective_endings
    )


def _can_be_graded(word: Word, lists: Lists) -> bool:
    """Whether a word can follow "so" or "quite": no name, and of no closed class."""
    return not word.capital and word.stem not in lists.closed
