"""`forget`: erases everything about a listener, or lists who is remembered."""

from __future__ import annotations

import argparse
import json
import sys
import time
from typing import TYPE_CHECKING

from personage_lite.errors import PersonageError, nearest, shown

if TYPE_CHECKING:
    from adaptation.memory.reading import Known
    from adaptation.memory.store import SqlMemory

HELP = "erase everything about a listener: memory and session logs; or list the listeners"
EXAMPLE = "personage-lite forget Anna"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = command.add_argument
    add("name", nargs="?", help="the listener's name, in any case")
    add("--list", action="store_true", help="list who is remembered, and erase nothing")
    add(
        "--memory",
        metavar="PLACE",
        help="an SQLite file, sqlite:///PATH or postgresql://USER@HOST/DATABASE (default: your "
        "own file, the one that `live` uses)",
    )
    add("--format", choices=("text", "json"), default="text", help="of the list")


def run(arguments: argparse.Namespace) -> None:
    """Erase a listener and say so; raise if nobody of that name is known."""
    from adaptation.memory import open_memory
    from personage_lite.names import checked_name

    if arguments.list == (arguments.name is not None):
        raise PersonageError("forget whom? give a name, or --list to see who is remembered")
    if arguments.list:
        memory = open_memory(arguments.memory, make=False)
        try:
            _list(memory.listeners(), arguments.format)
        finally:
            memory.close()
    else:
        _forget(arguments.memory, checked_name(arguments.name))


def _forget(where: str | None, name: str) -> None:
    """Erase the logs of this machine, then what the database holds; say what was there."""
    from adaptation.memory import NoMemoryError, open_memory
    from adaptation.storyteller.kept_logs import erase_logs, log_folder

    logs = erase_logs(log_folder(), name)
    if logs:
        what = _many(logs, "session log")
        print(f"{what} of {name} on this machine {'is' if logs == 1 else 'are'} erased.")
    try:
        memory = open_memory(where, make=False)
    except NoMemoryError:
        if logs and where is None:  # whoever was met without a memory has logs alone
            return
        raise
    try:
        _erase(memory, name, bool(logs))
    finally:
        memory.close()


def _erase(memory: SqlMemory, name: str, logged: bool) -> None:
    erased = memory.erase(name)
    if not erased.known:
        if logged:
            return
        others = [known.name for known in memory.listeners()]
        raise PersonageError(f"nobody called '{shown(name)}' is remembered; {_hint(name, others)}")
    print(f"Everything about {name} is erased from {memory.place}.")
    if erased.traces:
        print(
            f"personage-lite: {memory.place}: in use by a session; its files can keep traces until "
            "that ends: forget anybody once more then, or remove the file",
            file=sys.stderr,
        )


def _hint(name: str, others: list[str]) -> str:
    hint = nearest(name, others)
    return hint if hint.startswith("did you mean") else "forget --list shows who is"


def _list(listeners: list[Known], form: str) -> None:
    for known in listeners:
        if form == "json":
            print(json.dumps(known._asdict(), ensure_ascii=False))
        else:
            print(
                f"{known.name}: {_many(known.episodes, 'episode')}, {_many(known.turns, 'turn')}, "
                f"{_many(known.facts, 'fact')} told; last seen {_day(known.last_seen)}"
            )
    if not listeners and form == "text":
        print("personage-lite: nobody is remembered", file=sys.stderr)


def _many(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"


def _day(seconds: float | None) -> str:
    try:
        return time.strftime("%Y-%m-%d", time.gmtime(seconds)) if seconds is not None else "never"
    except (OverflowError, ValueError, OSError):
        return "at no known time"
