"""The process in which one realizer runs; run.py starts it, java/Worker.java is its like.

It answers "say" with what the realizer says, and "SECONDS NAME…" with the counts after making
these sentences, in turns, for so many seconds.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from time import perf_counter

from realizers import Builders, builders, said


def time_slice(functions: Builders, seconds: float, names: Sequence[str]) -> dict[str, float]:
    """Make all of these sentences again and again for about so many seconds."""
    build = [functions[name] for name in names]
    passes = 0
    start = perf_counter()
    while (elapsed := perf_counter() - start) < seconds or not passes:
        for say in build:
            say()
        passes += 1
    return {"seconds": elapsed, "sentences": passes * len(build)}


def main(name: str) -> None:
    """Answer line by line until the input ends."""
    functions = builders(name)
    for line in sys.stdin:
        request, *names = line.split()
        if request == "say":
            answer = json.dumps(said(functions))
        else:
            answer = json.dumps(time_slice(functions, float(request), names))
        print(answer, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
