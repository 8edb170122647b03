"""Stuttering: the first letters of a name, said more than once."""

from __future__ import annotations

from typing import Final

_VOWELS: Final = "aeiou"


def stutter(name: str, times: int) -> str:
    """Repeat the first letters of a name: Al-Al-Alice, Qu-Queen, Wh-White Rabbit, M-Mr Fox.

    >>> stutter("Alice", 2)
    'Al-Al-Alice'

    Source: the paper, figure 7; PERSONAGE's stuttering operator.
    """
    word = name.split(" ", 1)[0].split("-", 1)[0].lower()
    length = 1
    if word[:1] in _VOWELS:
        while length < len(word) - 1 and word[length] in _VOWELS:
            length += 1
        length += 1
    else:
        while length < len(word) - 1 and word[length] not in "aeiouy":
            length += 1
        if length == len(word) - 1 and word[length] not in "aeiouy":
            length = 1
        elif word[:length].endswith("q"):
            length += 1
    return f"{name[: min(length, len(word))]}-" * times + name
