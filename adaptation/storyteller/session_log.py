"""The session log: JSON lines, appended whole, from which a session can be said again.

The first line of a session is its header: settings, versions, what the learner began with. Then
follow, as they happen: `say` (a speech act), `heard` (an answer and what it meant), `turn` (one
utterance about a character, with all that the learner had and got), `state` (the dialog's phase)
and `end`. docs/live.md describes the fields.
"""

from __future__ import annotations

import json
import os
import stat
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from personage_lite.errors import PersonageError, shown

KIND, VERSION = "personage-lite live", 1
LINES = ("header", "say", "heard", "turn", "state", "end")


class SessionLog:
    """Appends lines to a file; a line is there whole or not at all, whenever the power fails.

    Another session's log is gone on with: what a killed session left of a last line is cut off.
    Raises `PersonageError` for a file that is no such log, that another session is writing, or
    that cannot be written.
    """

    def __init__(self, path: str) -> None:
        self.path = path
        try:
            self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o600)
        except OSError as error:
            raise self._unwritable(error) from None
        try:
            self._regular = stat.S_ISREG(os.fstat(self._file).st_mode)
            if self._regular:
                self._lock()
                self._mend()
        except BaseException:
            os.close(self._file)
            raise

    def _lock(self) -> None:
        try:
            import fcntl
        except ModuleNotFoundError:  # not on Windows
            return
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise PersonageError(
                f"{self.path}: another session is writing it; give another --log"
            ) from None

    def _mend(self) -> None:
        """Cut off what is left of a line that was never finished; refuse what is no log."""
        size = os.fstat(self._file).st_size
        if not size:
            return
        first = os.pread(self._file, 4096, 0).split(b"\n", 1)[0]
        if b'"log": "personage-lite live"' not in first and size > len(first):
            raise PersonageError(f"{self.path}: is no session log; give another name for --log")
        end = size
        while end:
            start = max(0, end - 65536)
            found = os.pread(self._file, end - start, start).rfind(b"\n")
            if found >= 0:
                end = start + found + 1
                break
            end = start
        if end == 0 and b'{"line": "header"' not in first[:20]:
            raise PersonageError(f"{self.path}: is no session log; give another name for --log")
        if end < size:
            os.ftruncate(self._file, end)

    def write(self, line: str, **fields: Any) -> None:
        """Append one line of a kind (one of `LINES`); it is on the disk when this returns.

        Raises `PersonageError` if there is no room for it; the log then ends with the line before.
        """
        record = json.dumps({"line": line, **fields}, ensure_ascii=False, allow_nan=False)
        data = f"{record}\n".encode("utf-8", "replace")
        try:
            written = os.write(self._file, data)
            if written < len(data) and self._regular:
                os.ftruncate(self._file, os.fstat(self._file).st_size - written)
            elif self._regular:
                os.fsync(self._file)
        except OSError as error:
            raise self._unwritable(error) from None
        if written < len(data):
            raise PersonageError(f"{self.path}: cannot be written in whole; make room")

    def close(self) -> None:
        """Close the file; may be called twice."""
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    def _unwritable(self, error: OSError) -> PersonageError:
        return PersonageError(
            f"{self.path}: cannot be written ({error.strerror}); give another --log, or --no-log"
        )


class NoLog:
    """Writes nothing."""

    path = None

    def write(self, line: str, **fields: Any) -> None:
        """Forget the line."""

    def close(self) -> None:
        """Nothing is held."""


class Line(NamedTuple):
    """A line of a log: its number in the file, its kind and its fields."""

    number: int
    kind: str
    fields: Mapping[str, Any]


class Session(NamedTuple):
    """One session of a log: its header and the lines after it."""

    header: Line
    lines: tuple[Line, ...]

    @property
    def turns(self) -> list[Mapping[str, Any]]:
        """The utterances about characters, in order."""
        return [line.fields for line in self.lines if line.kind == "turn"]


def read_sessions(path: str) -> list[Session]:
    """Return the sessions of a log, the oldest first.

    A last line that was never finished is left out. Raises `PersonageError`, with file and line,
    for what is no log.
    """
    sessions: list[tuple[Line, list[Line]]] = []
    for line in _lines(path):
        if line.kind == "header":
            if line.fields.get("log") != KIND or line.fields.get("version") != VERSION:
                raise _fault(path, line.number, f"no log of {KIND}, version {VERSION}")
            sessions.append((line, []))
        elif not sessions:
            raise _fault(path, line.number, "the header is missing")
        else:
            sessions[-1][1].append(line)
    if not sessions:
        raise PersonageError(f"{path}: holds no session; give a log that `live --log` has written")
    return [Session(header, tuple(lines)) for header, lines in sessions]


def _lines(path: str) -> Iterator[Line]:
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError as error:
        raise PersonageError(f"{path}: cannot be read ({error.strerror}); check the path") from None
    for number, raw in enumerate(content.split(b"\n"), 1):
        if not raw.strip():
            continue
        try:
            found = json.loads(raw.decode("utf-8"))
        except (ValueError, RecursionError):
            if number > content.count(b"\n"):  # the last one, unfinished
                return
            raise _fault(path, number, "not JSON") from None
        if not isinstance(found, dict) or found.get("line") not in LINES:
            kind = shown(str(found.get("line"))) if isinstance(found, dict) else "nothing"
            raise _fault(path, number, f"no line of a log ('{kind}')")
        yield Line(number, found["line"], found)


def _fault(path: str, number: int, what: str) -> PersonageError:
    return PersonageError(f"{path}:{number}: {what}; give a log that `live --log` has written")
