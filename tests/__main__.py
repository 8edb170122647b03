"""`python -m tests`: everything that must hold, one check after the other; stops at the first."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent
BIN = Path(sys.executable).parent
CHECKS = (
    ("formatter", [str(BIN / "ruff"), "format", "--check", "."]),
    ("linter", [str(BIN / "ruff"), "check", "."]),
    ("type checker", [str(BIN / "mypy")]),
    ("import layers", [str(BIN / "lint-imports")]),
    ("facts and lexicons", [sys.executable, "-m", "personage_lite", "check"]),
    ("tests", [sys.executable, "-m", "pytest", "-q", *sys.argv[1:]]),
)


def main() -> int:
    """Run the checks; returns the exit code of the one that failed, or 0."""
    for name, command in CHECKS:
        print(f"== {name}", flush=True)
        done = subprocess.run(command, cwd=TOP, check=False)
        if done.returncode:
            print(f"== {name} failed", file=sys.stderr)
            return done.returncode
    return 0


if __name__ == "__main__":
    sys.exit(main())
