"""`corpus`: writes a corpus of styled utterances."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable

from personage_lite.cli.generate import parse_overrides, whole_number

HELP = "write a corpus of styled utterances, even over X and characters, as JSON lines"
EXAMPLE = "personage-lite corpus --count 1000 --out corpus.jsonl"
# Fewer are generated sooner than more processes start.
_FEW = 2000


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = command.add_argument
    add("--count", required=True, help="how many utterances")
    add("--out", required=True, metavar="FILE", help="the file: .jsonl (or .json)")
    add("--x", action="append", help="an X from -2 to 2; can be repeated (default -2 -1 0 1 2)")
    add(
        "--character",
        action="append",
        default=[],
        help="whom to talk about; can be repeated (default all)",
    )
    add("--facts", metavar="PATH", help="your own facts: a file or a folder")
    add("--seed", default="0", help="same seed, same corpus (default 0)")
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
    add("--workers", help="how many processes generate (default: one a core if that is faster)")


def run(arguments: argparse.Namespace) -> None:
    """Write the corpus and say what is in it."""
    count = whole_number(arguments.count, "--count", 1)
    seed = whole_number(arguments.seed, "--seed", 0)
    overrides = parse_overrides(arguments.set)
    if arguments.workers is None:
        workers = 1 if count < _FEW else os.cpu_count() or 1
    else:
        workers = whole_number(arguments.workers, "--workers", 1)
    from personage_lite.corpus import DEFAULT_X, write_corpus

    written = write_corpus(
        arguments.out,
        count,
        xs=arguments.x or DEFAULT_X,
        characters=arguments.character,
        facts=arguments.facts,
        seed=seed,
        overrides=overrides,
        rating=arguments.rating,
        workers=workers,
        progress=_progress(count),
    )
    earlier = f", {written.earlier} of them by an earlier run" if written.earlier else ""
    print(f"{written.path}: {count} utterance{'s' * (count != 1)}{earlier}")


def _progress(count: int) -> Callable[[int], object]:
    """Return what shows how far the work is, on a terminal; elsewhere it shows nothing."""
    if sys.stderr is None or not sys.stderr.isatty():
        return int

    def show(done: int) -> None:
        end = "\r\x1b[K" if done == count else ""
        print(f"\r{done} of {count} utterances{end}", end="", file=sys.stderr, flush=True)

    return show
