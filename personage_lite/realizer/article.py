"""The indefinite article, by the sound of what follows: an hour, a unicorn, an FBI agent, an 8."""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from typing import NamedTuple

from personage_lite.realizer.inflection import Dialect
from personage_lite.yaml_reader import Node

# What stands before a word and is not said there: blanks, quotation marks, brackets, emphasis and
# currencies, which are said after their number (an $8 book).
_UNSPOKEN = " \t\r\n\u00a0\u202f\"'“”‘’‚„«»‹›`([{¿¡*_…$€£¥₹"
# What ends a word; in the table of beginnings its end is written as a full stop.
_END, _ENDS = ".", " \t\r\n\u00a0-‐‑–—/'’\".,;:!?…)]}”»&+"
_FIGURES = "0123456789"
_APOSTROPHES = "'’"
# So many capitals are a word if a vowel stands among them after the first (UMBRELLA, not HTTPS).
_LONG = 5


class ArticleSounds(NamedTuple):
    """What sounds like a vowel and what only looks so; never changed after loading."""

    vowels: frozenset[str]
    vowel_names: frozenset[str]
    # A beginning of two letters or more: its article. Each beginning of a beginning is here too, so
    # that a word can be followed letter by letter until nothing knows it better.
    beginnings: dict[str, str]
    longest: int
    capitals: dict[str, str]
    eight: str
    teens: frozenset[str]
    ends: dict[int, int]


def read_article_sounds(node: Node, dialect: Dialect = "british") -> ArticleSounds:
    """Read the articles file for one dialect; every fault names its line.

    Raises `DataError` for a missing table, an unknown one, or a word that stands twice.
    """
    beginnings: dict[str, str] = {}
    capitals: dict[str, str] = {}
    for article in ("an", "a"):
        for capital, table in ((False, beginnings), (True, capitals)):
            block = node.need("capitals_" + article if capital else article)
            for word in block.text().split():
                if word in table:
                    raise block.fault(f"'{word}' stands twice", "remove one of the two")
                if len(word) < 2 or word != (word.upper() if capital else word.lower()):
                    wanted = "capitals" if capital else "small letters"
                    raise block.fault(
                        f"'{word}' does not belong here", f"write two or more {wanted}"
                    )
                table[word] = article
    american = node.need("american_an").text().split()
    if dialect == "american":
        beginnings.update(dict.fromkeys(american, "an"))
    vowels = frozenset(node.need("vowels").text())
    sounds = ArticleSounds(
        vowels=vowels,
        vowel_names=frozenset(node.need("vowel_names").text()),
        beginnings=_all_beginnings(beginnings, vowels),
        longest=max(map(len, beginnings)),
        capitals=capitals,
        eight=node.need("eight").text(),
        teens=frozenset(node.need("teens").text().split()),
        ends=str.maketrans(_ENDS, _END * len(_ENDS)),
    )
    node.done()
    return sounds


def _all_beginnings(beginnings: dict[str, str], vowels: frozenset[str]) -> dict[str, str]:
    """Return the beginnings with all of their own beginnings, which shorter ones decide."""
    every: dict[str, str] = {}
    for word in beginnings:
        article = "an" if word[0] in vowels else "a"
        for size in range(2, len(word) + 1):
            article = beginnings.get(word[:size], article)
            every[word[:size]] = article
    return every


def indefinite_article(following: str, sounds: ArticleSounds) -> str:
    """Return "a" or "an" for the text that follows; "a" if nothing does.

    >>> from personage_lite.data import data_folder
    >>> from personage_lite.yaml_reader import read_yaml
    >>> sounds = read_article_sounds(read_yaml(data_folder("lexicons") + "/articles.yaml"))
    >>> [indefinite_article(text, sounds) for text in ("hour", "unicorn", "FBI agent", "1865")]
    ['an', 'a', 'an', 'an']
    """
    text = following.lstrip(_UNSPOKEN)
    # A word has a small letter second: anything else is a figure, a letter or an abbreviation.
    if text[1:2].islower():
        return _word(text, sounds)
    if not text:
        return "a"
    if text[0] in _FIGURES:
        return _number(text, sounds)
    if not text.isascii():
        # Imported here: an accent apart from its letter is rare.
        from unicodedata import normalize

        whole = normalize("NFC", text)
        if whole != text:
            return indefinite_article(whole, sounds)
    return _letters(text, sounds)


def _word(text: str, sounds: ArticleSounds) -> str:
    """Return the article before a word that is read as such."""
    start = text[: sounds.longest].lower() + " "
    article = "an" if start[0] in sounds.vowels else "a"
    for size in range(2, len(start) + 1):
        longer = sounds.beginnings.get(start[:size])
        if longer is None:
            if start[size - 1].isalpha():
                return article
            return sounds.beginnings.get(start[: size - 1] + _END, article)
        article = longer
    return article


def _letters(text: str, sounds: ArticleSounds) -> str:
    """Return the article before a letter, an abbreviation, a word in capitals, or a sign."""
    first = text[0].lower()
    by_sound = "an" if first in sounds.vowels else "a"
    if not first.isalpha():
        return by_sound
    words = text[:40].translate(sounds.ends).split(_END)
    # L'Oréal and O'Brien are words; two F's are letters.
    if text[1:2] in _APOSTROPHES and len(words) > 1 and words[1] not in ("s", ""):
        return by_sound
    word = words[0]
    article = sounds.capitals.get(word) or sounds.capitals.get(word.removesuffix("s"))
    if article is not None:
        return article
    if (
        len(word) >= _LONG
        and word.isupper()
        and any(x in sounds.vowels for x in word[1:_LONG].lower())
    ):
        return _word(word, sounds)
    return "an" if first in sounds.vowel_names else "a"


def _number(text: str, sounds: ArticleSounds) -> str:
    """Return the article before a number in figures, as it is said."""
    figures = len(text) - len(text.lstrip(_FIGURES))
    # Four figures without a comma are said in twos, as years are; more of them in threes.
    first = text[: 2 if figures == 4 else (figures - 1) % 3 + 1]
    return "an" if first in sounds.teens or first.startswith(sounds.eight) else "a"
