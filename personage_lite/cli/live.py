"""`live`: the adaptive storyteller, before a person or a simulated listener."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from contextlib import ExitStack
from os.path import join
from typing import TYPE_CHECKING

from personage_lite.cli.generate import whole_number
from personage_lite.errors import PersonageError, shown

if TYPE_CHECKING:
    from collections.abc import Callable

    from adaptation.storyteller.assembly import Options
    from adaptation.storyteller.kept_logs import KeptLog
    from adaptation.storyteller.parts import Summary
    from adaptation.storyteller.session_log import NoLog, SessionLog
    from personage_lite.generator import Generator

HELP = "the storyteller: tells you stories, and adapts its style to how engaged you seem"
EXAMPLE = "personage-lite live --name Anna"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options; without any it just works."""
    add = command.add_argument
    add(
        "--sensor",
        action="append",
        metavar="NAME",
        help="what watches you: camera, microphone, replay, stream, keyboard (default), or none; "
        "can be repeated",
    )
    add("--input", action="append", metavar="INPUT", help="a sensor's input, as for engage")
    add("--learner", default="bayes", metavar="NAME", help="what chooses X (default bayes)")
    add("--listener", metavar="NAME", help="a simulated listener sits there: match, live …")
    add("--changes", metavar="N,N", help="utterances before which its taste changes (15,26; none)")
    add("--tastes", metavar="X,X", help="what it likes, before and after changes (default: drawn)")
    add("--name", metavar="NAME", help="your name: you are known again next time")
    add("--memory", metavar="URL", help="where listeners are remembered: a file, a URL, or none")
    add("--speak", action="store_true", help="speak aloud")
    add("--voice", metavar="NAME", help="hibari or espeak (default: the first that is installed)")
    add("--ear", metavar="PATH", action="append", help="spoken answers from WAV files or folders")
    add("--microphone", nargs="?", const="", metavar="N", help="hear spoken answers")
    add("--wav", metavar="FILE", help="write what is spoken to a file")
    add("--log", metavar="FILE", help="the session log (default: a new one in your own folder)")
    add("--no-log", action="store_const", const="none", dest="log", help="keep no session log")
    add(
        "--replay",
        nargs="?",
        const="",
        metavar="LOG",
        help="say the words of a session log again, and verify them (default: your latest)",
    )
    add("--compare", action="store_true", help="with --replay: what other learners had chosen")
    add("--plain", action="store_true", help="text alone: no status, nothing drawn")
    add("--speed", default="1", metavar="N", help="how many times as fast (default 1; 0: at once)")
    add("--turns", metavar="N", help="take leave after so many utterances")
    add("--seed", help="same seed and answers, same words (drawn when not given)")
    add("--characters", metavar="NAMES", help="whom to tell about, with commas (default: all)")
    add("--facts", metavar="PATH", help="your own facts: a file or a folder (default: Wonderland)")


def run(arguments: argparse.Namespace) -> None:
    """Run a session, or replay one."""
    try:
        import numpy  # noqa: F401 - what all of it needs
    except ModuleNotFoundError:
        raise PersonageError("live needs numpy; pip install 'personage-lite[adaptation]'") from None
    if arguments.replay is not None:
        from personage_lite.cli.live_replay import replay

        replay(arguments)
        return
    if arguments.compare:
        raise PersonageError("--compare needs a session log; add --replay LOG")
    from personage_lite.cli.engage import own_stderr
    from personage_lite.cli.live_outside import outside_of

    with own_stderr() as say, ExitStack() as stack:
        options = options_of(arguments)
        generator = generator_for(arguments.facts)
        outside = outside_of(arguments, options, say, stack)
        from adaptation.storyteller.assembly import run_session

        summary = run_session(generator, options, outside)
        stack.close()
        _account(summary, outside.log, arguments.plain, say)


def generator_for(facts: str | None) -> Generator:
    """Return the generator; without facts of one's own it tells of Wonderland."""
    from personage_lite.data import data_folder
    from personage_lite.generator import Generator

    return Generator(facts=join(data_folder("facts"), "wonderland") if facts is None else facts)


def options_of(arguments: argparse.Namespace) -> Options:
    """Return what the command line asks for; raises `PersonageError` for what cannot be."""
    from adaptation.learners import LEARNERS
    from adaptation.storyteller.assembly import Options
    from personage_lite.names import checked_name

    if arguments.seed is None:
        import secrets

        seed = secrets.randbelow(1_000_000)
    else:
        seed = whole_number(arguments.seed, "--seed", 0)
    LEARNERS[arguments.learner]  # an unknown one is a fault before anything is said
    return Options(
        seed=seed,
        learner=arguments.learner,
        sensors=_sensors(arguments),
        listener=arguments.listener,
        changes=_changes(arguments),
        tastes=_tastes(arguments),
        name="" if arguments.name is None else checked_name(arguments.name),
        speed=speed_of(arguments.speed),
        turns=None if arguments.turns is None else whole_number(arguments.turns, "--turns", 1),
        characters=_listed(arguments.characters, "--characters"),
        settings={"facts": _whole_path(arguments.facts), "learner": arguments.learner},
    )


def _whole_path(facts: str | None) -> str | None:
    """Return a path that names the same facts wherever the log is replayed."""
    return None if facts is None else os.path.abspath(facts)


def _sensors(arguments: argparse.Namespace) -> list[tuple[str, str | None]]:
    """Return the sensors' names and inputs; at a terminal there is always the keyboard."""
    names = list(arguments.sensor or ())
    if arguments.listener is not None:
        if names:
            raise PersonageError("a simulated listener is its own sensor; drop --sensor")
        return []
    if names == ["none"]:
        return []
    if not names:
        terminal = sys.stdin is not None and sys.stdin.isatty()
        return [("keyboard", None)] if terminal else []
    inputs: list[str | None] = list(arguments.input or ())
    if len(inputs) > len(names):
        raise PersonageError(f"--input is given {len(inputs)} times; give one for each --sensor")
    from adaptation.sensing import SENSORS

    for name in names:
        SENSORS[name]
    return list(zip(names, inputs + [None] * (len(names) - len(inputs)), strict=True))


def _changes(arguments: argparse.Namespace) -> tuple[int, ...]:
    from adaptation.schedule import PUBLISHED_CHANGES

    given = arguments.changes
    if given is None:
        return PUBLISHED_CHANGES
    if given.strip() == "none":
        return ()
    changes = _numbers(given, "--changes")
    if list(changes) != sorted({change for change in changes if 1 < change <= 1000}):
        raise PersonageError(
            f"--changes is '{shown(given)}'; give rising numbers of utterances, 2 to 1000, or none"
        )
    return changes


def _tastes(arguments: argparse.Namespace) -> tuple[int, ...]:
    if arguments.tastes is None:
        return ()
    tastes = _numbers(arguments.tastes, "--tastes")
    if not tastes or any(abs(taste) > 2 for taste in tastes):
        raise PersonageError(
            f"--tastes is '{shown(arguments.tastes)}'; give whole numbers from -2 to 2, as 2,-2"
        )
    return tastes


def _numbers(text: str, option: str) -> tuple[int, ...]:
    try:
        return tuple(int(part) for part in text.split(","))
    except ValueError:
        raise PersonageError(
            f"{option} is '{shown(text)}'; give whole numbers with commas between them"
        ) from None


def _listed(text: str | None, option: str) -> list[str]:
    if text is None:
        return []
    names = [name.strip() for name in text.split(",") if name.strip()]
    if not names:
        raise PersonageError(f"{option} is empty; give names with commas between them")
    return names


def speed_of(text: str) -> float:
    """Return how many times as fast a session runs; 0 is at once."""
    try:
        speed = float(text)
    except ValueError:
        speed = -1.0
    if not 0 <= speed <= 1000:
        raise PersonageError(f"--speed is '{shown(text)}'; give a number from 0 (at once) to 1000")
    return speed


def _account(
    summary: Summary,
    log: SessionLog | KeptLog | NoLog,
    plain: bool,
    say: Callable[[str], None],
) -> None:
    """Say at the end what there was, and where it stands; not with --plain, unless asked to."""
    from adaptation.storyteller.session_log import SessionLog

    if plain and not isinstance(log, SessionLog):
        return
    if log.path and os.path.exists(log.path):
        again = shlex.join(("live", "--replay", str(log.path)))
        count = f"{summary.turns} utterance{'s' * (summary.turns != 1)}"
        say(f"{count}; say them again: {again}")
