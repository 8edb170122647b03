"""Measures personage-lite beside pyrealb in one interleaved run: `python benchmarks/run.py`."""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
from contextlib import ExitStack, suppress
from datetime import date
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryFile
from time import perf_counter
from typing import IO

from report import Rate, Report, Spread
from subjects import SENTENCES, XS

HERE = Path(__file__).resolve().parent
ROUNDS, SLICE_SECONDS, MEMORY_COUNTS = 11, 0.5, (1, 1_000, 10_000)
QUICK_ROUNDS, QUICK_SLICE_SECONDS, QUICK_MEMORY_COUNTS = 2, 0.05, (1, 20, 200)

# What the installed command does, without the shell's and pip's share.
OURS = [
    "-c",
    "from personage_lite.cli import main; main()",
    *("generate", "--character", "alice", "--x", "2", "--seed", "1"),
]
PYREALB = """\
from pyrealb import A, D, N, NP, Q, S, V, VP
print(S(Q("Alice"), VP(V("be"), NP(D("a"), A("imaginative"), N("girl")))).realize())
"""
BARE_START, OUR_START, PYREALB_START = (
    "bare interpreter",
    "personage-lite, first styled utterance",
    "pyrealb, first sentence",
)
START_UPS = {BARE_START: ["-c", "pass"], OUR_START: OURS, PYREALB_START: ["-c", PYREALB]}
RATED = (*(f"styled, X = {x}" for x in XS), "realizer", "pyrealb")
REMEMBERED = ("nothing", "styled", "realizer", "pyrealb")


class BenchmarkError(Exception):
    """A measured process has failed: there is no figure."""


def environment() -> dict[str, str]:
    """Return the children's environment: this repository's package, bytecode kept for all."""
    path = os.environ.get("PYTHONPATH")
    found = os.pathsep.join([str(HERE.parent), *([path] if path else [])])
    kept = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    return {**kept, "PYTHONPATH": found}


def child(*arguments: str) -> str:
    """Return what a Python process with these arguments prints."""
    command = [sys.executable, *arguments]
    done = subprocess.run(command, check=False, capture_output=True, text=True, env=environment())
    if done.returncode:
        raise BenchmarkError(_last_line(done.stderr) or f"{arguments[:2]}: {done.returncode}")
    return done.stdout


def start_up(rounds: int) -> dict[str, list[float]]:
    """Return the seconds of each whole process, a value a round; a first round is not counted."""
    seconds: dict[str, list[float]] = {name: [] for name in START_UPS}
    for _ in range(rounds + 1):
        for name, arguments in START_UPS.items():
            start = perf_counter()
            said = child(*arguments).strip()
            seconds[name].append(perf_counter() - start)
            expected = SENTENCES[0] if name == PYREALB_START else said
            if said != expected or (name == OUR_START and not said):
                raise BenchmarkError(f"{name}: unexpected text '{said}'")
    return {name: values[1:] for name, values in seconds.items()}


class Worker:
    """A warm process that makes one subject's texts for a slice of time when asked."""

    def __init__(self, name: str, errors: IO[str]) -> None:
        self._errors = errors
        # In a session of its own: Ctrl-C reaches run.py alone, which then ends its workers.
        self._process = subprocess.Popen(
            [sys.executable, str(HERE / "worker.py"), name],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._errors,
            text=True,
            env=environment(),
            start_new_session=True,
        )

    def run(self, seconds: float) -> dict[str, float]:
        """Return the counts of one slice."""
        assert self._process.stdin
        assert self._process.stdout
        with suppress(BrokenPipeError):  # It has ended: there is no answer either.
            print(seconds, file=self._process.stdin, flush=True)
        line = self._process.stdout.readline()
        if not line:
            self._process.wait()
            self._errors.seek(0)
            raise BenchmarkError(_last_line(self._errors.read()) or "a worker has ended")
        answer: dict[str, float] = json.loads(line)
        return answer

    def stop(self) -> None:
        """End the process."""
        self._process.kill()
        # Closes the pipes and waits; a request that was never read breaks its pipe.
        with suppress(BrokenPipeError), self._process:
            pass


def throughput(rounds: int, seconds: float) -> dict[str, list[dict[str, float]]]:
    """Return each subject's slices, a slice a round; a first round warms up and is not counted."""
    slices: dict[str, list[dict[str, float]]] = {name: [] for name in RATED}
    with ExitStack() as stack:
        workers: dict[str, Worker] = {}
        for name in RATED:
            errors = stack.enter_context(TemporaryFile("w+", encoding="utf-8"))
            workers[name] = Worker(name, errors)
            stack.callback(workers[name].stop)
        for _ in range(rounds + 1):
            for name, worker in workers.items():
                slices[name].append(worker.run(seconds))
    return {name: values[1:] for name, values in slices.items()}


def rates(slices: dict[str, list[dict[str, float]]]) -> dict[str, Rate]:
    """Return rates and ratios; a ratio is taken within a round."""
    texts = {name: [s["texts"] / s["seconds"] for s in each] for name, each in slices.items()}
    sentences = {
        name: [s["sentences"] / s["seconds"] for s in each] for name, each in slices.items()
    }
    found = {}
    for name, each in slices.items():
        made = sum(s["texts"] for s in each)
        found[name] = Rate(
            texts_per_second=Spread.of(texts[name]),
            sentences_per_second=Spread.of(sentences[name]),
            sentences_per_text=sum(s["sentences"] for s in each) / made,
            words_per_text=sum(s["words"] for s in each) / made,
            texts_to_pyrealb=Spread.of_ratios(texts[name], sentences["pyrealb"]),
            sentences_to_pyrealb=Spread.of_ratios(sentences[name], sentences["pyrealb"]),
        )
    return found


def memory(counts: tuple[int, ...]) -> dict[str, list[float]]:
    """Return each subject's peak memory in MiB after so many texts, in a process of its own."""
    asked = [str(count) for count in counts]
    return {name: json.loads(child(str(HERE / "worker.py"), name, *asked)) for name in REMEMBERED}


def machine() -> str:
    """Return the processor, the number of cores, the system and the load."""
    processor = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text().splitlines():
            if line.startswith("model name"):
                processor = line.partition(":")[2].strip()
                break
    load = f", load {os.getloadavg()[0]:.2f} before" if hasattr(os, "getloadavg") else ""
    return f"{processor}, {os.cpu_count()} cores, {platform.system()} {platform.release()}{load}"


def measure(rounds: int, seconds: float, counts: tuple[int, ...]) -> Report:
    """Measure everything."""
    system = machine()
    _progress("start-up")
    times = start_up(rounds)
    _progress("throughput")
    slices = throughput(rounds, seconds)
    _progress("memory")
    return Report(
        date=date.today().isoformat(),
        machine=system,
        versions=f"Python {platform.python_version()}, pyrealb {version('pyrealb')}",
        rounds=rounds,
        slice_seconds=seconds,
        start_up_seconds={name: Spread.of(values) for name, values in times.items()},
        start_up_ratio=Spread.of_ratios(times[PYREALB_START], times[OUR_START]),
        throughput=rates(slices),
        memory_counts=counts,
        memory_mib=memory(counts),
    )


def _last_line(text: str) -> str:
    lines = text.strip().splitlines()
    return lines[-1] if lines else ""


def _progress(what: str) -> None:
    if sys.stderr.isatty():
        print(f"measuring {what} …", file=sys.stderr)


def _rounds(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number from 1 on")
    return int(text)


def main(arguments: list[str] | None = None) -> int:
    """Run the command; the figures never change the exit code."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=_rounds, metavar="N", help=f"rounds (default {ROUNDS})")
    parser.add_argument("--quick", action="store_true", help="short and few rounds: a smoke test")
    parser.add_argument("--format", choices=("text", "json"), default="text")
    options = parser.parse_args(arguments)
    if find_spec("pyrealb") is None:
        print("pyrealb is missing: pip install personage-lite[benchmarks]", file=sys.stderr)
        return 1
    try:
        if options.quick:
            rounds = options.rounds or QUICK_ROUNDS
            report = measure(rounds, QUICK_SLICE_SECONDS, QUICK_MEMORY_COUNTS)
        else:
            report = measure(options.rounds or ROUNDS, SLICE_SECONDS, MEMORY_COUNTS)
    except BenchmarkError as error:
        print(f"benchmark failed: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return 130
    print(report.json() if options.format == "json" else report.text())
    return 0


if __name__ == "__main__":
    sys.exit(main())
