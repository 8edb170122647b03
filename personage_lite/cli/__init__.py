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
from typing import NoReturn

from personage_lite import __version__
from personage_lite.cli import characters, check, generate
from personage_lite.errors import PersonageError

# Loading makes many small objects and hardly any garbage: collecting as often as Python does by
# default took a third of the time to the first utterance (benchmarks/run.py).
gc.set_threshold(100_000, 50, 50)

COMMANDS = (generate, characters, check)


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one line, with the help a command away."""

    def error(self, message: str) -> NoReturn:
        print(f"{self.prog}: {message}; see {self.prog} --help", file=sys.stderr)
        raise SystemExit(2)


def parser() -> argparse.ArgumentParser:
    """Return the parser of all commands."""
    top = _Parser(
        prog="personage-lite",
        description="Turns facts into speech with a controllable personality.",
    )
    top.add_argument("--version", action="version", version=f"personage-lite {__version__}")
    commands = top.add_subparsers(required=True, metavar="COMMAND")
    for module in COMMANDS:
        name = module.__name__.rpartition(".")[2]
        command = commands.add_parser(
            name,
            help=module.HELP,
            description=module.HELP,
            epilog=f"example: {module.EXAMPLE}",
        )
        module.add_arguments(command)
        command.set_defaults(run=module.run)
    return top


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit code."""
    for stream in (sys.stdout, sys.stderr):
        # The text holds … and “ ”: say it in UTF-8 wherever the console allows any choice.
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(encoding="utf-8", errors="replace")
    arguments = parser().parse_args(argv)
    try:
        arguments.run(arguments)
        sys.stdout.flush()
    except PersonageError as error:
        print(f"personage-lite: {error}", file=sys.stderr)
        return 1
    except BrokenPipeError:
        # The reader has gone; nothing more can be said, nor need Python try at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OSError as error:
        where = f" ({error.filename})" if error.filename else ""
        print(
            f"personage-lite: cannot write the output{where}: {error.strerror}; "
            "choose another place",
            file=sys.stderr,
        )
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except KeyboardInterrupt:
        return 130
    return 0
