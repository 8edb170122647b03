"""What a database can be at fault with, each as one line with a remedy."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from personage_lite.errors import PersonageError

if TYPE_CHECKING:
    from sqlalchemy.exc import DBAPIError

_ELSEWHERE = "or give --memory another place"
# By SQLite's result codes (https://www.sqlite.org/rescode.html): what is wrong, and the remedy.
_SQLITE = {
    sqlite3.SQLITE_BUSY: ("is locked by another process", f"wait until it is done, {_ELSEWHERE}"),
    sqlite3.SQLITE_LOCKED: ("is locked", f"wait until it is free, {_ELSEWHERE}"),
    sqlite3.SQLITE_READONLY: ("cannot be written to", f"change its permissions, {_ELSEWHERE}"),
    sqlite3.SQLITE_PERM: ("may not be used", f"change its permissions, {_ELSEWHERE}"),
    sqlite3.SQLITE_CORRUPT: ("is damaged", f"restore it from a copy, remove it, {_ELSEWHERE}"),
    sqlite3.SQLITE_NOTADB: ("is no SQLite database", "give --memory another place"),
    sqlite3.SQLITE_FULL: ("has no room left", f"free some space, {_ELSEWHERE}"),
    sqlite3.SQLITE_IOERR: (
        "cannot be read or written by the system (a full or broken disk?)",
        f"free some space, {_ELSEWHERE}",
    ),
    sqlite3.SQLITE_CANTOPEN: (
        "cannot be opened",
        f"check that its folder is there and may be written to, {_ELSEWHERE}",
    ),
}
# By the first characters of PostgreSQL's (its manual, appendix A); the longest that fits counts.
_POSTGRES = {
    "08": ("cannot be reached", f"check the server, {_ELSEWHERE}"),
    "25006": ("is read-only", f"use one that can be written to, {_ELSEWHERE}"),
    "28": ("refuses the user or the password", "check both in the URL"),
    "3D": ("has no database of this name", "create it with createdb, or check the URL"),
    "42501": ("does not permit this", "let the user create tables, or use another database"),
    "53": ("has no room or no connections left", "free some, or use another server"),
    "55P03": ("is locked by another session", f"wait until it is done, {_ELSEWHERE}"),
    "57": ("was shut down, or stopped this", f"check the server, {_ELSEWHERE}"),
}


class NoMemoryError(PersonageError):
    """There is no database at the place that was named."""


def fault_of(error: DBAPIError, place: str) -> PersonageError:
    """Return a fault of the database as one line; `place` is how it is named."""
    what, remedy = _reason(error.orig)
    return PersonageError(f"{place}: {what}; {remedy}")


def _reason(cause: object) -> tuple[str, str]:
    if isinstance(cause, sqlite3.Error):
        code = getattr(cause, "sqlite_errorcode", None)
        if code is not None and code & 0xFF in _SQLITE:
            return _SQLITE[code & 0xFF]
    state = getattr(cause, "sqlstate", None) or ""
    known = [start for start in _POSTGRES if state.startswith(start)]
    if known:
        return _POSTGRES[max(known, key=len)]
    said = " ".join(str(cause).split())
    if not state and type(cause).__module__.startswith("psycopg"):
        for hint, start in (("does not exist", "3D"), ("authentication", "28"), ("password", "28")):
            if hint in said and not (start == "3D" and "database" not in said):
                return _POSTGRES[start]
        said = said.removeprefix("connection failed: ")
        return f"cannot be reached ({said[:160]})", f"check the server and the URL, {_ELSEWHERE}"
    return f"failed ({said[:160]})", "give --memory another place"


@contextmanager
def needed_packages() -> Iterator[None]:
    """Say in one line how to install a package that is missing."""
    try:
        yield
    except ModuleNotFoundError as error:
        missing = (error.name or "").partition(".")[0]
        if missing not in ("sqlalchemy", "alembic", "psycopg"):
            raise
        extra = "postgresql" if missing == "psycopg" else "memory"
        raise PersonageError(
            f"the memory needs {missing}; pip install 'personage-lite[{extra}]'"
        ) from None
