"""What a command is given to read: a file, or standard input."""

from __future__ import annotations

import sys

from personage_lite.errors import PersonageError


def content(file: str) -> tuple[str, str]:
    """Return the text of a file, `-` being standard input, and how errors name it.

    Raises `PersonageError` where it cannot be read.
    """
    from personage_lite.yaml_reader import decoded, read_text

    if file != "-":
        return read_text(file, file), file
    if sys.stdin is None or sys.stdin.closed:
        raise PersonageError("there is no standard input to read; name a file")
    return decoded(sys.stdin.buffer.read(), "standard input"), "standard input"
