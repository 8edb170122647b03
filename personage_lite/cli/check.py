"""`check`: validates facts and lexicons and names each fault."""

from __future__ import annotations

import argparse

HELP = "validate facts and lexicons; exit 1 and name each fault"
EXAMPLE = "personage-lite check facts/wonderland/alice.yaml"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options."""
    command.add_argument(
        "path",
        nargs="?",
        help="a facts file or folder, or a folder of lexicons (default: all that is shipped)",
    )


def run(arguments: argparse.Namespace) -> None:
    """Print what was checked; raise if there is any fault."""
    from personage_lite.checks import check_all, check_path

    report = check_all() if arguments.path is None else check_path(arguments.path)
    for fault in report.faults:
        print(fault)
    print(f"{report.checked}: {len(report.faults) or 'no'} fault{'s'[: len(report.faults) != 1]}")
    if report.faults:
        raise SystemExit(1)
