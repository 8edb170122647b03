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

    A comma is dropped beside any other mark, so that punctuation never doubles; a terminal mark
    after speech that has one of its own is dropped too.
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
    if before[-1] == "”":
        return before[-2] in _CLOSING
    if mark == ",":
        return before[-1] in _CLOSING or not after or after[0] in _CLOSING
    return before[-1] in _ENDING


def _attach(before: str, mark: str) -> str:
    """Put a mark after a word; an end mark goes inside the quotation marks of direct speech."""
    if before[-1] == "”":
        return before[:-1] + mark + "”"
    return before + mark


def _capitalize(token: str) -> str:
    for index, letter in enumerate(token):
        if letter.isalpha():
            return token[:index] + letter.upper() + token[index + 1 :]
    return token
