"""The process in which one subject runs; run.py starts it.

`worker.py SUBJECT` makes texts for as many seconds as each line of its input says and answers
with the counts; `worker.py SUBJECT COUNT…` says how much memory that many texts have taken.
"""

from __future__ import annotations

import json
import resource
import sys
from pathlib import Path
from time import perf_counter

from subjects import SUBJECTS, Subject


def time_slice(subject: Subject, seconds: float, first: int) -> dict[str, float]:
    """Make texts from this number on for about so many seconds; counting is not timed."""
    made: list[tuple[str, int]] = []
    number = first
    start = perf_counter()
    while (elapsed := perf_counter() - start) < seconds or not made:
        made.append(subject(number))
        number += 1
    return {
        "seconds": elapsed,
        "texts": len(made),
        "sentences": sum(sentences for _, sentences in made),
        "words": sum(len(text.split()) for text, _ in made),
    }


def peak_mib() -> float:
    """Return the most memory this process has held.

    On Linux from /proc: there getrusage counts the parent's memory before exec too.
    """
    status = Path("/proc/self/status")
    if status.exists():
        for line in status.read_text().splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) / 1024
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / 1024 / (1024 if sys.platform == "darwin" else 1)


def main(name: str, *counts: str) -> None:
    """Serve the slices that the input asks for, or measure memory."""
    subject = SUBJECTS[name]()
    made = 0
    if counts:
        peaks = []
        for count in map(int, counts):
            for number in range(made, count):
                subject(number)
            made = count
            peaks.append(peak_mib())
        print(json.dumps(peaks))
        return
    for line in sys.stdin:
        answer = time_slice(subject, float(line), made)
        made += int(answer["texts"])
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
