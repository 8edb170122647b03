"""What an answer means: yes, no, a name in any form, pause, quit.

The words stand in `lexicons/dialog.yaml`, the names in the facts (the paper, section IV-A: "the
user accepts or declines the character by speech commands").
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from typing import Literal, NamedTuple, TypeAlias

from personage_lite.facts import Character

Sense: TypeAlias = Literal[
    "yes", "no", "quit", "pause", "resume", "who", "name", "unknown_name", "unclear"
]
# Longer answers are cut: nobody says that much at once, and what is pasted may be anything.
LONGEST_ANSWER = 200
# How alike a name and its misspelling are at least.
_ALIKE = 0.8
_LONGEST_NAME = 40
# What counts where an answer could mean two things.
_FIRST: tuple[Sense, ...] = ("quit", "pause", "no")
# What stands before a name: "tell me about the Hatter".
_ABOUT = re.compile(r"\b(?:about|of|with|want|like|prefer|hear|is|was)\b")
_ARTICLES = ("the ", "a ", "an ", "that ", "this ", "mr ", "mrs ")


class Meaning(NamedTuple):
    """What was meant: its sense, and for a name the character's id (or the words, if unknown)."""

    sense: Sense
    name: str = ""


def plain(text: str) -> str:
    """Return an answer in small letters, without marks and blanks that mean nothing.

    >>> plain("  Yes,  PLEASE! ")
    'yes please'
    """
    kept = "".join(
        sign if sign.isalnum() or sign in "'?" else " "
        for sign in text[:LONGEST_ANSWER].lower().replace("’", "'")
    )
    words = " ".join(kept.split())
    return words if words == "?" else words.replace("?", "").strip()


def names_of(characters: Iterable[Character]) -> dict[str, str]:
    """Return every form of a name that means but one character, with the character's id.

    >>> from personage_lite import Generator
    >>> names = names_of([Generator().character("white_rabbit")])
    >>> names["white rabbit"], names["rabbit"]
    ('white_rabbit', 'white_rabbit')
    """
    full: dict[str, str] = {}
    short: dict[str, set[str]] = {}
    for character in characters:
        entity = character.entity
        for form in (entity.id.replace("_", " "), entity.name):
            full[_bare(form)] = entity.id
        words = _bare(entity.name).split(" ")
        # Of what else they are called ("poor thing") only what is part of the name.
        forms = [entity.short_phrase.noun, words[-1], *(n for n in entity.nouns if n in words)]
        for form in forms:
            short.setdefault(_bare(form), set()).add(entity.id)
    for form, owners in short.items():
        if len(owners) == 1 and form not in full and len(form) > 2:
            full[form] = next(iter(owners))
    return full


def _bare(name: str) -> str:
    words = plain(name.replace("_", " "))
    for article in _ARTICLES:
        words = words.removeprefix(article)
    return words


class Understanding:
    """Turns answers into meanings, with the words of a language and the names of a story.

    >>> from personage_lite import Generator
    >>> generator = Generator()
    >>> one = Understanding(generator.dialog.heard, names_of([generator.character("hatter")]))
    >>> one.meaning("Yeah!"), one.meaning("no, tell me about the mad hatter").name
    (Meaning(sense='yes', name=''), 'hatter')
    """

    def __init__(self, heard: Mapping[str, Sequence[str]], names: Mapping[str, str]) -> None:
        self._names = dict(names)
        self._senses: dict[str, list[Sense]] = {}
        for sense, phrases in heard.items():
            for phrase in phrases:
                senses = self._senses.setdefault(plain(phrase), [])
                senses.append(sense)  # type: ignore[arg-type]
        self._longest = max((len(phrase.split()) for phrase in self._senses), default=1)

    @property
    def phrases(self) -> tuple[str, ...]:
        """All that can be understood: words and names, for a recogniser's grammar."""
        return tuple(dict.fromkeys([*self._senses, *self._names]))

    def meaning(self, text: str, prefer: Sequence[Sense] = ()) -> Meaning:
        """Return what an answer means; of a word's senses a preferred one counts first.

        A name counts first, then words: "no, the Hatter" is a name.
        """
        words = plain(text)
        if not words:
            return Meaning("unclear")
        exact = self._sense(words, prefer)
        if exact is not None:
            return Meaning(exact)
        name = self._name(words)
        if name:
            return Meaning("name", name)
        # "Tell me about Robin Hood" begins like a yes and is none.
        begun = None if " about " in words else self._begun(words, prefer)
        if begun is not None:
            return Meaning(begun)
        return self._unknown(words, text)

    def _sense(self, words: str, prefer: Sequence[Sense]) -> Sense | None:
        senses = self._senses.get(words, [])
        return next((sense for sense in prefer if sense in senses), senses[0] if senses else None)

    def _name(self, words: str) -> str:
        """Return the character whose name is in the words; the longest form counts."""
        found = [form for form in self._names if re.search(rf"\b{re.escape(form)}s?\b", words)]
        if found:
            return self._names[max(found, key=len)]
        asked = _bare(_ABOUT.split(words)[-1].strip())
        close = get_close_matches(asked, self._names, n=1, cutoff=_ALIKE)
        return self._names[close[0]] if close else ""

    def _begun(self, words: str, prefer: Sequence[Sense]) -> Sense | None:
        """Return what an answer begins or ends with means: "yes I would love that".

        Where that is two things, who wants to stop is not made to listen: "please stop".
        """
        parts = words.split()
        found: list[Sense] = []
        for count in range(min(self._longest, len(parts)), 0, -1):
            for piece in (parts[:count], parts[-count:]):
                sense = self._sense(" ".join(piece), prefer)
                # One letter is an answer only by itself.
                if sense is not None and len(" ".join(piece)) > 1:
                    found.append(sense)
        for first in _FIRST:
            if first in found:
                return first
        return found[0] if found else None

    def _unknown(self, words: str, text: str) -> Meaning:
        """Tell a name that nobody has, as it was written, from what is no answer at all."""
        *before, last = _ABOUT.split(words)
        last = _bare(last.strip())
        named = last and len(last) <= _LONGEST_NAME and (before or len(words.split()) <= 3)
        return Meaning("unknown_name", _as_written(last, text)) if named else Meaning("unclear")


def _as_written(words: str, text: str) -> str:
    """Return plain words as they stand in a text: with capitals, without marks around them."""
    parts = text[:LONGEST_ANSWER].split()
    count = len(words.split())
    for start in range(len(parts) - count, -1, -1):
        piece = " ".join(parts[start : start + count])
        if plain(piece) == words:
            return re.sub(r"^\W+|\W+$", "", piece) if piece.isprintable() else words
    return words
