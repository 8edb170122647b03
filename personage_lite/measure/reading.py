"""Reads what is to be measured: a corpus of records, or a plain text."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple, Protocol

from personage_lite.errors import DataError, PersonageError, shown

_BLANK_LINE = re.compile(r"\n[ \t\r]*\n")


class HasStyle(Protocol):
    """What the generator says, and all that has a text and an X."""

    @property
    def text(self) -> str:
        """What is said."""

    @property
    def x(self) -> float | None:
        """The extraversion that it is said with, if any."""


class Said(NamedTuple):
    """An utterance to measure, with its extraversion X, if it has one."""

    text: str
    x: float | None = None


def read_utterances(content: str, name: str) -> list[Said]:
    r"""Return the utterances of a file's content; `name` is how error messages call it.

    What begins with { is JSON lines, as `generate --format json` prints them. All else is text: one
    utterance a line, or one a paragraph where blank lines part paragraphs. Raises `PersonageError`
    if there is none.

    >>> [said.text for said in read_utterances("She is kind.\nHe is late.", "a.txt")]
    ['She is kind.', 'He is late.']
    """
    content = content.removeprefix("\ufeff")
    if content.lstrip().startswith("{"):
        return list(_records(content, name))
    parts = _BLANK_LINE.split(content) if _BLANK_LINE.search(content.strip()) else None
    found = [part.strip() for part in (content.splitlines() if parts is None else parts)]
    said = [Said(part) for part in found if part]
    if not said:
        raise PersonageError(f"{name} holds no text; give utterances, one a line, or records")
    return said


def _records(content: str, name: str) -> Iterator[Said]:
    """Yield the utterances of JSON lines; they all have an X, or none has."""
    has_x: bool | None = None
    # Not `splitlines`: JSON strings may hold the marks that it takes for line ends.
    for number, line in enumerate(content.split("\n"), 1):
        if not line.strip():
            continue
        said = _record(line, name, number)
        if has_x is None:
            has_x = said.x is not None
        elif has_x != (said.x is not None):
            what = "has an 'x' and the records before it have none"
            if has_x:
                what = "has no 'x' and the records before it have one"
            raise DataError(name, number, f"this record {what}", "measure the two apart")
        yield said


def _record(line: str, name: str, number: int) -> Said:
    try:
        record = json.loads(line)
    except (ValueError, RecursionError):
        raise DataError(
            name,
            number,
            f"this is no JSON record: {shown(line.strip())}",
            "give one record a line, as generate --format json prints them, or plain text",
        ) from None
    if not isinstance(record, dict) or not isinstance(record.get("text"), str):
        raise DataError(name, number, "this record has no 'text'", 'write {"text": "…"}')
    x = record.get("x")
    if x is None:
        return Said(record["text"])
    try:
        value = math.nan if isinstance(x, bool | str) else float(x)
    except (TypeError, OverflowError):
        value = math.nan
    if not math.isfinite(value):
        what = f"X is {shown(json.dumps(x, ensure_ascii=False))}"
        raise DataError(name, number, what, "give a number, or no 'x'")
    return Said(record["text"], value)


def said(utterances: Iterable[str | HasStyle]) -> list[Said]:
    """Return texts, or what has a text and an X, as utterances to measure."""
    found = [Said(one) if isinstance(one, str) else Said(one.text, one.x) for one in utterances]
    if len({one.x is None for one in found}) > 1:
        raise PersonageError("some utterances have an X and some have none; measure them apart")
    return found
