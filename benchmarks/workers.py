"""The processes that run.py measures, and how it talks with them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

HERE = Path(__file__).resolve().parent


class BenchmarkError(Exception):
    """A measured process has failed: there is no figure."""


def environment(package: Path | None = None) -> dict[str, str]:
    """Return the children's environment: this repository's package, bytecode kept for all.

    `package` is a folder with another build of the package, which is found instead.
    """
    path = os.environ.get("PYTHONPATH")
    found = os.pathsep.join([str(package or HERE.parent), *([path] if path else [])])
    kept = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    return {**kept, "PYTHONPATH": found}


def child(*arguments: str, package: Path | None = None) -> str:
    """Return what a Python process with these arguments prints."""
    command = [sys.executable, *arguments]
    done = subprocess.run(
        command, check=False, capture_output=True, text=True, env=environment(package)
    )
    if done.returncode:
        raise BenchmarkError(last_line(done.stderr) or f"{arguments[:2]}: {done.returncode}")
    return done.stdout


def last_line(text: str) -> str:
    """Return the last line of a process's errors."""
    lines = text.strip().splitlines()
    return lines[-1] if lines else ""


class Worker:
    """A warm process that answers each line with a line of JSON."""

    def __init__(
        self, command: Sequence[str], errors: IO[str], package: Path | None = None
    ) -> None:
        self._errors = errors
        # In a session of its own: Ctrl-C reaches run.py alone, which then ends its workers.
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._errors,
            text=True,
            encoding="utf-8",
            env=environment(package),
            start_new_session=True,
        )

    def ask(self, line: str) -> dict[str, Any]:
        """Return the answer to this line."""
        assert self._process.stdin
        assert self._process.stdout
        with suppress(BrokenPipeError):  # It has ended: there is no answer either.
            print(line, file=self._process.stdin, flush=True)
        said = self._process.stdout.readline()
        if not said:
            self._process.wait()
            self._errors.seek(0)
            raise BenchmarkError(last_line(self._errors.read()) or "a worker has ended")
        answer: dict[str, Any] = json.loads(said)
        return answer

    def stop(self) -> None:
        """End the process."""
        self._process.kill()
        # Closes the pipes and waits; a request that was never read breaks its pipe.
        with suppress(BrokenPipeError), self._process:
            pass
