"""Where the memory is: the user's own file, another one, or a PostgreSQL server."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from pathlib import Path

from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import ArgumentError

from adaptation.user_folder import make_private, user_folder
from personage_lite.errors import PersonageError, shown

FILE = "listeners.sqlite"
_HOW = "give a file, sqlite:///PATH or postgresql://USER@HOST/DATABASE"


def usual_place(environment: Mapping[str, str] = os.environ, platform: str = sys.platform) -> Path:
    """Return the user's own file; see `adaptation.user_folder`.

    >>> usual_place({"XDG_DATA_HOME": "/data"}, "linux").as_posix()
    '/data/personage-lite/listeners.sqlite'
    """
    return user_folder(environment, platform) / FILE


def found_place(where: str | None) -> URL:
    """Return the URL of a database; `where` is as in `open_memory`.

    Raises `PersonageError` for what is no place, and for other kinds of databases.

    >>> str(found_place("mine.sqlite"))
    'sqlite:///mine.sqlite'
    >>> found_place("mysql://somewhere/db")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    personage_lite.errors.PersonageError: memory: no database of the kind 'mysql' can be...
    """
    if where is None:
        return URL.create("sqlite", database=str(usual_place()))
    if not where.strip() or "\0" in where:
        raise PersonageError(f"memory: no place is named; {_HOW}")
    if "://" not in where:
        return URL.create("sqlite", database=where)
    try:
        url = make_url(where)
    except (ArgumentError, ValueError):
        # The text itself is not shown: it may hold a password.
        raise PersonageError(f"memory: this is no URL of a database; {_HOW}") from None
    kind = url.drivername.partition("+")[0]
    if kind == "sqlite":
        return url.set(drivername="sqlite")
    if kind in ("postgresql", "postgres"):
        return url.set(drivername="postgresql+psycopg")
    raise PersonageError(f"memory: no database of the kind '{shown(kind)}' can be used; {_HOW}")


def shown_place(url: URL) -> str:
    """Return a place as messages name it: a file's path, or a URL without its password.

    >>> shown_place(found_place("postgresql://anna:secret@host/db"))
    'postgresql://anna:***@host/db'
    """
    if url.get_backend_name() == "sqlite":
        return url.database or "sqlite://"
    return url.set(drivername="postgresql").render_as_string(hide_password=True)


def is_missing(url: URL) -> bool:
    """Whether a database is a file that is not there."""
    return url.get_backend_name() == "sqlite" and not os.path.exists(url.database or "")


def make_folder(url: URL) -> None:
    """Make the folder of the user's own file: for the user alone, as what is kept is private."""
    if url.database == str(usual_place()):
        folder = usual_place().parent
        try:
            make_private(folder)
        except OSError as error:
            raise PersonageError(
                f"{folder}: cannot be made ({error.strerror}); give --memory another place"
            ) from None
