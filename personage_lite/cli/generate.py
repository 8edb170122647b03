"""`generate`: says something about a character."""

from __future__ import annotations

import argparse
import sys
from typing import TextIO

from personage_lite.errors import PersonageError, shown

HELP = "say something about a character, at extraversion X from -2 (introvert) to 2 (extravert)"
EXAMPLE = "personage-lite generate --character alice --x 2 --seed 7"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = command.add_argument
    add("--character", required=True, help="whom to talk about: an id or a name")
    add("--x", default="0", help="extraversion, a number from -2 to 2 (default 0)")
    add("--seed", help="same seed, same text; drawn and printed on stderr when not given")
    add("--count", default="1", help="how many successive turns (default 1)")
    add("--format", choices=("text", "json"), default="text", help="text, or JSON lines")
    add("--trace", action="store_true", help="explain every decision, after the text")
    add("--facts", metavar="PATH", help="your own facts: a file or a folder")
    add("--lexicons", metavar="PATH", help="your own lexicons: a copy of the folder, edited")
    add(
        "--set",
        action="append",
        default=[],
        metavar="PARAMETER=VALUE",
        help="fix a style parameter at 0 to 1; can be repeated",
    )
    add(
        "--rating",
        choices=("clean", "mild", "strong"),
        default="mild",
        help="which expletives are allowed (default mild: near-expletives only)",
    )


def whole_number(text: str, option: str, lowest: int) -> int:
    """Return an option's value as a whole number; raises `PersonageError` with the remedy."""
    try:
        number = int(text)
    except ValueError:
        number = lowest - 1
    if number < lowest or number >= 2**63:
        raise PersonageError(
            f"{option} is '{shown(text)}'; give a whole number from {lowest} to 2^63 - 1"
        )
    return number


def parse_overrides(settings: list[str]) -> dict[str, float]:
    """Return `--set` options as parameter values; raises `PersonageError` for what is none."""
    overrides: dict[str, float] = {}
    for setting in settings:
        name, _, value = setting.partition("=")
        try:
            overrides[name.strip()] = float(value)
        except ValueError:
            raise PersonageError(
                f"--set '{shown(setting)}' cannot be read; write PARAMETER=VALUE, as verbosity=0.8"
            ) from None
    return overrides


def run(arguments: argparse.Namespace) -> None:
    """Print the utterances."""
    from personage_lite.generator import Generator

    if arguments.seed is None:
        import secrets

        seed = secrets.randbelow(1_000_000)
    else:
        seed = whole_number(arguments.seed, "--seed", 0)
    count = whole_number(arguments.count, "--count", 1)
    overrides = parse_overrides(arguments.set)
    say = _say if count == 1 else say_whole
    generator = Generator(facts=arguments.facts, lexicons=arguments.lexicons)
    for utterance in generator.turns(
        arguments.character,
        arguments.x,
        seed,
        count=count,
        overrides=overrides,
        rating=arguments.rating,
        trace=arguments.trace,
    ):
        if arguments.seed is None and not utterance.turn:  # Only now: a fault stands alone.
            say(f"seed {seed}", sys.stderr)
        if arguments.format == "json":
            import json

            say(json.dumps(utterance.record(), ensure_ascii=False), sys.stdout)
        else:
            say(utterance.text, sys.stdout)
        if arguments.trace:
            from personage_lite.trace import explain

            out = sys.stderr if arguments.format == "json" else sys.stdout
            say(explain(utterance, generator), out)


def _say(text: str, out: TextIO) -> None:
    print(text, file=out)


def say_whole(text: str, out: TextIO) -> None:
    """Print with Ctrl-C held back: it must not leave half a line to a reader that is slow."""
    import signal  # Here, because a single turn does without.

    if sys.platform == "win32":
        _say(text, out)
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT,))
    try:
        _say(text, out)
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
