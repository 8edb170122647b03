"""Tokens to text: spaces, commas, capitals, a/an and quotation marks."""

from __future__ import annotations

from personage_lite.realizer.article import indefinite_article
from personage_lite.realizer.grammar import Grammar

# Stands for "a" or "an" until the next word is known; no word can look like it.
INDEFINITE = "\x00a"
MARKS = frozenset(",.!?…")
_ENDING = frozenset(".!?")


def write(tokens: list[str], grammar: Grammar) -> str:
    """Join the tokens of one sentence into text.

    A comma is dropped beside any other mark, so that punctuation never doubles; an end mark after
    speech that has one of its own is dropped too, and after "…" a full stop. An abbreviation's
    full stop stays before any other mark.
    """
    written: list[str] = []
    capital = True
    last = len(tokens) - 1
    for index, token in enumerate(tokens):
        if token in MARKS:
            before = written[-1] if written else ""
            after = tokens[index + 1] if index < last else ""
            if written and not _swallowed(token, before, after, grammar):
                written[-1] = _attach(before, token, grammar)
                capital = token in _ENDING
            elif written and token in _ENDING:
                capital = True
            continue
        if token == INDEFINITE:
            following = next((word for word in tokens[index + 1 :] if word not in MARKS), "")
            token = indefinite_article(following, grammar.sounds)
        if capital:
            token = _capitalize(token)
            capital = False
        written.append(token)
    text = " ".join(written)
    return text.replace("'", "’") if grammar.curly_apostrophes else text


def _swallowed(mark: str, before: str, after: str, grammar: Grammar) -> bool:
    """Whether a mark falls away beside its neighbours."""
    quoted = before[-1] == "”"
    end = before.rstrip("”’")[-1:] if quoted else before[-1]
    if end == "." and mark != "." and _abbreviated(before, grammar):
        return mark == "," and (not after or after in MARKS)
    if mark == ",":
        if not after or after in MARKS:
            return True
        return end in MARKS and not (quoted and _full_stop(before.rstrip("”’")))
    return end in _ENDING or (end == "…" and (quoted or mark not in "!?"))


def _attach(before: str, mark: str, grammar: Grammar) -> str:
    """Put a mark after a word; it goes inside the quotation marks of direct speech.

    It takes the place of a comma, and a comma that of the full stop that ended the speech.
    """
    stem = before.rstrip("”’") if before[-1] == "”" else before
    close = before[len(stem) :]
    if stem[-1:] == "," or (mark == "," and _full_stop(stem) and not _abbreviated(before, grammar)):
        stem = stem[:-1]
    return stem + mark + close


def _full_stop(words: str) -> bool:
    """Whether words end in one full stop, not in the three of "well..."."""
    return words[-1:] == "." and words[-2:-1] != "."


def _abbreviated(words: str, grammar: Grammar) -> bool:
    """Whether words end in an abbreviation, whose full stop ends no sentence."""
    return words.rstrip("”’").rsplit(" ", 1)[-1] in grammar.abbreviations


def _capitalize(token: str) -> str:
    """Put the first letter in capitals; "10 children" has nothing to capitalize."""
    for index, letter in enumerate(token):
        if letter.isalpha():
            return token[:index] + letter.upper() + token[index + 1 :]
        if letter.isdigit():
            break
    return token
