"""The command line: a thin adapter over the library (docs/commands.md).

Results go to stdout, everything else to stderr. A fault is one line and exit code 1 (2 where the
command line itself is wrong).
"""

from __future__ import annotations

import argparse
import gc
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING, NoReturn

from personage_lite import __version__
from personage_lite.errors import PersonageError

if TYPE_CHECKING:
    from _typeshed import SupportsWrite

# Loading makes many small objects and hardly any garbage: collecting as often as Python does by
# default took a third of the time to the first utterance (benchmarks/run.py).
gc.set_threshold(100_000, 50, 50)

# Each is a module of this package.
COMMANDS = (
    "generate",
    "characters",
    "realize",
    "measure",
    "corpus",
    "simulate",
    "network",
    "engage",
    "live",
    "forget",
    "check",
)


class _Formatter(argparse.HelpFormatter):
    """Help in lines of one width: argparse would import much to measure the terminal."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, max_help_position=30, width=92)


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one line, with the help a command away."""

    def error(self, message: str) -> NoReturn:
        message = " ".join(message.splitlines())
        if len(message) > 400:
            message = f"{message[:200]}…{message[-200:]}"
        print(f"{self.prog}: {message}; see {self.prog} --help", file=sys.stderr)
        raise SystemExit(2)

    def _print_message(self, message: str, file: SupportsWrite[str] | None = None) -> None:
        # argparse's own says nothing if the help cannot be written.
        (file or sys.stderr).write(message)


def parser(commands: Sequence[str] = COMMANDS) -> argparse.ArgumentParser:
    """Return the parser of these commands."""
    top = _Parser(
        prog="personage-lite",
        formatter_class=_Formatter,
        description="Turns facts into speech with a controllable personality.",
    )
    top.add_argument("--version", action="version", version=f"personage-lite {__version__}")
    # With a `prog` argparse need not format a usage line, nor import what measures terminals.
    added = top.add_subparsers(required=True, metavar="COMMAND", prog=top.prog)
    for name in commands:
        module = import_module(f"{__name__}.{name}")
        command = added.add_parser(
            name,
            help=module.HELP,
            description=module.HELP,
            epilog=f"example: {module.EXAMPLE}",
            formatter_class=_Formatter,
        )
        module.add_arguments(command)
        command.set_defaults(run=module.run)
    return top


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit code."""
    for stream in (sys.stdout, sys.stderr):
        # The text holds … and “ ”: say it in UTF-8 wherever the console allows any choice.
        if hasattr(stream, "reconfigure"):
            # A line at a time: what is printed of a long output is whole lines, and soon.
            stream.reconfigure(encoding="utf-8", errors="replace", line_buffering=True)
    if sys.stdout is None:
        return _fault("there is no output to write to; do not close it")
    given = sys.argv[1:] if argv is None else list(argv)
    # What comes after a command is the command's: to load all took a tenth of the start.
    named = given[:1] if given and given[0] in COMMANDS else COMMANDS
    try:
        arguments = parser(named).parse_args(given)
        arguments.run(arguments)
        sys.stdout.flush()
    except PersonageError as error:
        return _fault(str(error))
    except OSError as error:
        # Nothing more can be said, nor need Python try at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):
            return _fault("the reader of the output has gone; let it read on, or ask for less")
        return _fault(f"cannot write the output: {error.strerror}; choose another place")
    except KeyboardInterrupt:
        return _fault("interrupted; what is printed is whole, run it again for the rest", 130)
    return 0


def _fault(message: str, code: int = 1) -> int:
    """Print a fault's one line; returns the exit code."""
    print(f"personage-lite: {message}", file=sys.stderr)
    return code
