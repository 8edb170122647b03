"""Tokens to text: spaces, commas, capitals, a/an and quotation marks."""

from __future__ import annotations

from typing import Final

from personage_lite.realizer.article import indefinite_article
from personage_lite.realizer.features import SpecificationError, unprintable
from personage_lite.realizer.grammar import Grammar

# Stands for "a" or "an" until the next word is known; no word can look like it. What follows it
# in the same token is what the article goes by instead of that word.
INDEFINITE: Final = "\x00"
MARKS: Final = frozenset((",", ".", "!", "?", "…", ":", ";", ")"))
_ENDING: Final = frozenset(".!?")
_CLOSING: Final = frozenset(",.!?…")
# What no word begins with but with a mark: looked at first, for it is seldom there.
_UNUSUAL: Final = frozenset(",.!?…:;)(–—\x00")
_PARENTHETIC: Final = ("–", "—", "(")


def write(tokens: list[str], grammar: Grammar) -> str:
    """Join the tokens of one sentence into text.

    A comma is dropped beside any other mark, so that punctuation never doubles; an end mark after
    speech that has one of its own is dropped too, and after "…" a full stop. An abbreviation's
    full stop stays before any other mark.
    """
    written: list[str] = []
    capital = True
    glued = False
    last = len(tokens) - 1
    for index, token in enumerate(tokens):
        if not token:
            continue
        if token[0] in _UNUSUAL:
            if token in MARKS or _only_marks(token):
                if written:
                    after = tokens[index + 1] if index < last else ""
                    ends = token[0] in _ENDING
                    if not _swallowed(token, written[-1], after, grammar):
                        written[-1] = _attach(written, token, grammar)
                        capital = ends
                    elif ends:
                        capital = True
                continue
            if token[0] == INDEFINITE:
                following = token[1:] or next(
                    (word for word in tokens[index + 1 :] if word not in MARKS), ""
                )
                token = indefinite_article(following, grammar.sounds)
            elif token.startswith(_PARENTHETIC) and written and written[-1][-1] == ",":
                written[-1] = written[-1][:-1]
        if capital:
            token = _capitalize(token)
            capital = False
        if glued:
            written[-1] += token
        else:
            written.append(token)
        glued = token == "("
    if not written:
        raise SpecificationError("there is nothing to say; give it words")
    text = " ".join(written)
    if "  " in text or text[0] == " " or not text.isprintable():
        text = _cleaned(text)
    return text.replace("'", "’") if grammar.curly_apostrophes else text


def _cleaned(text: str) -> str:
    """Return a text in which blanks of any kind are single ones; refuse what cannot be printed."""
    text = " ".join(text.split())
    for mark in ",.!?…":
        text = text.replace(f" {mark}", mark)
    # Blanks that do not break a line are no harm.
    strange = unprintable(text)
    if strange:
        raise SpecificationError(f"{strange!a} cannot be printed; leave it out")
    if not text.strip(".!?…"):
        raise SpecificationError("there is nothing to say; give it words")
    return text


def abbreviated(words: str, grammar: Grammar) -> bool:
    """Whether words end in an abbreviation, whose full stop ends no sentence: etc., a.m., U.S."""
    word = words.rstrip("”’").rsplit(" ", 1)[-1]
    if word[-1:] != "." or ".." in word or word[:1].isdecimal():
        return False
    return (
        "." in word[:-1] or word in grammar.abbreviations or word.lower() in grammar.abbreviations
    )


def _only_marks(token: str) -> bool:
    """Whether a token is several marks in a row: "?!"."""
    return bool(token) and not token.strip(".!?…")


def _swallowed(mark: str, before: str, after: str, grammar: Grammar) -> bool:
    """Whether a mark falls away beside its neighbours."""
    quoted = before[-1] == "”"
    end = before.rstrip("”’")[-1:] if quoted else before[-1]
    if end == "." and mark != "." and abbreviated(before, grammar):
        return mark == "," and (not after or after in MARKS)
    if mark == ",":
        if not after or after in MARKS or _only_marks(after):
            return True
        return end in _CLOSING and not (quoted and _full_stop(before.rstrip("”’")))
    if quoted and mark == "?":
        return end in ("?", "…")
    return end in _ENDING or (end == "…" and (quoted or mark not in "!?"))


def _attach(written: list[str], mark: str, grammar: Grammar) -> str:
    """Return the last word with a mark after it.

    A full stop or comma goes inside quotation marks, a question mark outside, and an exclamation
    mark inside those of direct speech, which a comma announces. It takes the place of a comma, and
    of the full stop that ended the speech.
    """
    before = written[-1]
    if before[-1] != "”":
        return (before[:-1] if before[-1] == "," else before) + mark
    stem = before.rstrip("”’")
    close = before[len(stem) :]
    speech = len(written) < 2 or written[-2][-1] == ","
    outside = mark[0] == "?" or (mark[0] == "!" and not speech)
    if stem[-1:] == "," or (_full_stop(stem) and mark != "." and not abbreviated(stem, grammar)):
        stem = stem[:-1]
    return stem + close + mark if outside else stem + mark + close


def _full_stop(words: str) -> bool:
    """Whether words end in one full stop, not in the three of "well..."."""
    return words[-1:] == "." and words[-2:-1] != "."


def _capitalize(token: str) -> str:
    """Put the first letter in capitals; "10 children" has nothing to capitalize."""
    for index, letter in enumerate(token):
        if letter.isalpha():
            return token[:index] + letter.upper() + token[index + 1 :]
        if letter.isdigit():
            break
    return token
