"""The logs that sessions keep by themselves: one file each, in a folder of the user's own.

Files are called after the time when they were begun, never after a listener; whose they are stands
in their headers.
"""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable, Iterator
from itertools import count
from pathlib import Path
from typing import Any

from adaptation.memory.names import key
from adaptation.storyteller.session_log import SessionLog
from adaptation.user_folder import make_private, user_folder
from personage_lite.errors import PersonageError

_ENDING = ".jsonl"
_HEADER = b'{"line": "header"'


def log_folder() -> Path:
    """Return the folder of the user's logs, beside the memory's own file."""
    return user_folder() / "logs"


class KeptLog:
    """A log in a file of its own, made when its first line is written.

    Nobody asked for it: so what cannot be written is one line through `say`, and the session goes
    on without a log. `wall` returns epoch seconds.
    """

    def __init__(self, folder: Path, wall: Callable[[], float], say: Callable[[str], None]) -> None:
        self._folder = folder
        self._wall = wall
        self._say = say
        self._log: SessionLog | None = None
        self._lost = False
        self.path: Path | None = None

    def write(self, line: str, **fields: Any) -> None:
        """Append one line; see `SessionLog.write`."""
        if self._lost:
            return
        try:
            if self._log is None:
                self.path = claimed(self._folder, self._wall())
                self._log = SessionLog(str(self.path))
            self._log.write(line, **fields)
        except PersonageError as error:
            self._lost = True
            reason = str(error).partition("; ")[0]
            self._say(f"{reason}; the story goes on, but no more of it is logged")

    def close(self) -> None:
        """Close the file; may be called twice."""
        if self._log is not None:
            self._log.close()


def claimed(folder: Path, when: float) -> Path:
    """Make a new, empty log that is this session's alone; `when` in epoch seconds.

    Raises `PersonageError` where none can be made.
    """
    start = time.strftime("%Y-%m-%dT%H-%M-%SZ", time.gmtime(when))
    try:
        make_private(folder.parent)
        make_private(folder)
        for number in count(1):
            path = folder / f"{start}{f'.{number}' if number > 1 else ''}{_ENDING}"
            try:
                os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))
            except FileExistsError:
                continue
            return path
    except OSError as error:
        raise PersonageError(
            f"{folder}: no log can be made there ({error.strerror}); give --log FILE or --no-log"
        ) from None
    raise AssertionError("unreachable")


def last_log(folder: Path) -> str:
    """Return the path of the latest log; raises `PersonageError` if there is none."""
    logs = sorted(_logs(folder), key=lambda path: (path.stat().st_mtime_ns, path.name))
    if not logs:
        raise PersonageError(f"{folder}: holds no session log; give --replay one")
    return str(logs[-1])


def erase_logs(folder: Path, name: str) -> int:
    """Erase the logs of the sessions with a listener; returns how many.

    A session that is writing its log goes on, but nothing of it is left. Raises `PersonageError`
    for a log that cannot be read or erased.
    """
    erased = 0
    for path in _logs(folder):
        try:
            if key(name) in _listeners(path):
                path.unlink()
                erased += 1
        except FileNotFoundError:  # somebody else was faster
            continue
        except OSError as error:
            raise PersonageError(
                f"{path}: cannot be erased ({error.strerror}); remove it yourself"
            ) from None
    return erased


def _logs(folder: Path) -> list[Path]:
    return sorted(folder.glob(f"*{_ENDING}"))


def _listeners(path: Path) -> set[str]:
    """Return the keys of the names in a log's headers."""
    with path.open("rb") as file:
        return set(_keys(line for line in file if line.startswith(_HEADER)))


def _keys(headers: Iterator[bytes]) -> Iterator[str]:
    for line in headers:
        try:
            yield key(json.loads(line)["name"])
        except (ValueError, KeyError, TypeError, AttributeError, PersonageError):
            continue  # no header, or of nobody with a name
