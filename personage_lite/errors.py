"""The errors a user can meet: each is one line that says what, where and how to mend it."""

from __future__ import annotations

from collections.abc import Iterable


class PersonageError(Exception):
    r"""A fault in what the user gave us; its message is one clear line with a remedy.

    >>> str(PersonageError("no character 'al\nice'; did you mean alice?"))
    "no character 'al ice'; did you mean alice?"
    """

    def __init__(self, message: str) -> None:
        super().__init__(" ".join(message.splitlines()))


class DataError(PersonageError):
    """A fault in a facts or lexicon file, with its place.

    >>> str(DataError("alice.yaml", 12, "no fact 'cat'", "name a fact of this file"))
    "alice.yaml:12: no fact 'cat'; name a fact of this file"
    """

    def __init__(self, file: str, line: int, what: str, remedy: str) -> None:
        super().__init__(f"{file}:{line}: {what}; {remedy}")
        self.file = file
        self.line = line
        self._parts = (file, line, what, remedy)

    def __reduce__(self) -> tuple[object, ...]:
        return DataError, self._parts


def shown(text: str) -> str:
    """Return the user's text as a message quotes it: at most 40 characters of it.

    >>> shown("x" * 1000) == "x" * 40 + "…"
    True
    """
    return text if len(text) <= 40 else text[:40] + "…"


def nearest(name: str, known: Iterable[str]) -> str:
    """Return a remedy that offers the known names most like `name`, or all of them.

    >>> nearest("alcie", ["alice", "white_rabbit"])
    'did you mean alice?'
    """
    from difflib import get_close_matches  # imported here: only a fault needs it

    names = sorted(known)
    close = get_close_matches(name, names, n=3, cutoff=0.5)
    if close:
        return f"did you mean {' or '.join(close)}?"
    return f"choose from: {', '.join(names)}" if names else "there is none to choose from"
