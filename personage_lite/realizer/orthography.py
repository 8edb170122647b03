"""Tokens to text: spaces, commas, capitals, a/an and quotation marks."""

from __future__ import annotations

from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.morphology import indefinite_article

# Stands for "a" or "an" until the next word is known; no word can look like it.
INDEFINITE = "\x00a"
_CLOSING = frozenset(",.!?…")
_ENDING = frozenset(".!?")


def write(tokens: list[str], grammar: Grammar) -> str:
    """Join the tokens of one sentence into text.

    A comma is dropped beside any other mark, so that punctuation never doubles; an end mark after
    speech that has one of its own is dropped too, and after "…" a full stop.
    """
    written: list[str] = []
    capital = True
    last = len(tokens) - 1
    for index, token in enumerate(tokens):
        if token in _CLOSING:
            if written and not _swallowed(token, written[-1], tokens[index + 1 : index + 2]):
                written[-1] = _attach(written[-1], token)
                capital = token in _ENDING
            elif written and token in _ENDING:
                capital = True
            continue
        if token == INDEFINITE:
            token = indefinite_article(tokens[index + 1] if index < last else "", grammar)
        if capital:
            token = _capitalize(token)
            capital = False
        written.append(token)
    return " ".join(written)


def _swallowed(mark: str, before: str, after: list[str]) -> bool:
    """Whether a mark falls away beside its neighbours."""
    quoted = before[-1] == "”"
    end = before[-2:-1] if quoted else before[-1]
    if mark == ",":
        if not after or after[0] in _CLOSING:
            return True
        return end in _CLOSING and not (quoted and _full_stop(before[:-1]))
    return end in _ENDING or (end == "…" and (quoted or mark not in "!?"))


def _attach(before: str, mark: str) -> str:
    """Put a mark after a word; it goes inside the quotation marks of direct speech.

    It takes the place of a comma, and a comma that of the full stop that ended the speech.
    """
    close = "”" if before[-1] == "”" else ""
    stem = before[:-1] if close else before
    if stem[-1:] == "," or (mark == "," and _full_stop(stem)):
        stem = stem[:-1]
    return stem + mark + close


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
