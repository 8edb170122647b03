"""Measures personage-lite beside other realizers, interleaved: `python benchmarks/run.py`."""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
from datetime import date
from importlib.machinery import EXTENSION_SUFFIXES
from importlib.util import find_spec
from pathlib import Path
from time import perf_counter

import throughput
from report import COMPILED, Report, Spread
from sentences import SENTENCES
from throughput import Plan
from workers import HERE, BenchmarkError, child

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
REMEMBERED = ("nothing", "styled", "realizer", "pyrealb")


def start_up(rounds: int, compiled: Path | None) -> dict[str, list[float]]:
    """Return the seconds of each whole process, a value a round; a first round is not counted."""
    processes: dict[str, tuple[list[str], Path | None]] = {
        name: (arguments, None) for name, arguments in START_UPS.items()
    }
    if compiled:
        processes[OUR_START + COMPILED] = (OURS, compiled)
    seconds: dict[str, list[float]] = {name: [] for name in processes}
    for _ in range(rounds + 1):
        for name, (arguments, package) in processes.items():
            start = perf_counter()
            said = child(*arguments, package=package).strip()
            seconds[name].append(perf_counter() - start)
            expected = SENTENCES["copula"] if name == PYREALB_START else said
            if said != expected or (arguments is OURS and not said):
                raise BenchmarkError(f"{name}: unexpected text '{said}'")
    return {name: values[1:] for name, values in seconds.items()}


def memory(counts: tuple[int, ...], compiled: Path | None) -> dict[str, list[float]]:
    """Return each subject's peak memory in MiB after so many texts, in a process of its own."""
    asked = [str(count) for count in counts]
    peaks: dict[str, list[float]] = {}
    for name in REMEMBERED:
        command = (str(HERE / "worker.py"), name, *asked)
        peaks[name] = json.loads(child(*command))
        if compiled and name in ("styled", "realizer"):
            peaks[name + COMPILED] = json.loads(child(*command, package=compiled))
    return peaks


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


def measure(plan: Plan, counts: tuple[int, ...], *, all_parts: bool) -> Report:
    """Measure everything, or the realizers alone."""
    system = machine()
    times: dict[str, list[float]] = {}
    if all_parts:
        _progress("start-up")
        times = start_up(plan.rounds, plan.compiled)
    _progress("throughput")
    measured = throughput.measure(plan)
    peaks: dict[str, list[float]] = {}
    if all_parts:
        _progress("memory")
        peaks = memory(counts, plan.compiled)
    return Report(
        date=date.today().isoformat(),
        machine=system,
        python=platform.python_version(),
        rounds=plan.rounds,
        slice_seconds=plan.seconds,
        sentences=len(SENTENCES),
        realizers=measured.realizers,
        left_out=measured.left_out,
        start_up_seconds={name: Spread.of(values) for name, values in times.items()},
        start_up_ratio=Spread.of_ratios(times[PYREALB_START], times[OUR_START]) if times else None,
        throughput=measured.throughput,
        memory_counts=counts,
        memory_mib=peaks,
    )


def _progress(what: str) -> None:
    if sys.stderr.isatty():
        print(f"measuring {what} …", file=sys.stderr)


def _rounds(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number from 1 on")
    return int(text)


def _compiled(text: str) -> Path:
    folder = Path(text).resolve()
    suffixes = tuple(EXTENSION_SUFFIXES)
    if not any(path.name.endswith(suffixes) for path in folder.glob("personage_lite/*")):
        raise argparse.ArgumentTypeError(f"'{text}' holds no compiled personage_lite")
    return folder


def main(arguments: list[str] | None = None) -> int:
    """Run the command; the figures never change the exit code."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=_rounds, metavar="N", help=f"rounds (default {ROUNDS})")
    parser.add_argument("--quick", action="store_true", help="short and few rounds: a smoke test")
    parser.add_argument(
        "--realizers", action="store_true", help="only the realizers over the mixed sentences"
    )
    parser.add_argument(
        "--jar", type=Path, metavar="FILE", help="SimpleNLG's jar, instead of downloading one"
    )
    parser.add_argument(
        "--compiled", type=_compiled, metavar="FOLDER", help="a folder with a compiled build too"
    )
    parser.add_argument("--format", choices=("text", "json"), default="text")
    options = parser.parse_args(arguments)
    if find_spec("pyrealb") is None:
        print("pyrealb is missing: pip install personage-lite[benchmarks]", file=sys.stderr)
        return 1
    plan = Plan(
        rounds=options.rounds or (QUICK_ROUNDS if options.quick else ROUNDS),
        seconds=QUICK_SLICE_SECONDS if options.quick else SLICE_SECONDS,
        quick=options.quick,
        styled=not options.realizers,
        jar=options.jar,
        compiled=options.compiled,
    )
    counts = QUICK_MEMORY_COUNTS if options.quick else MEMORY_COUNTS
    try:
        report = measure(plan, counts, all_parts=not options.realizers)
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
