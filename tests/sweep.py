"""The whole truth test: `python tests/sweep.py` says every character at every X in 5,000 turns.

They are talks of 20 turns, so that stories, settings and what is taken up again are heard too.

It fails with the first faults found, and prints how many utterances were read.
"""

from __future__ import annotations

import argparse
import sys
from concurrent.futures import ProcessPoolExecutor, as_completed

from personage_lite import Generator
from personage_lite.truth import truth_faults

XS = (-2, -1, 0, 1, 2)


TURNS = 20


def sweep(character: str, x: int, talks: int) -> tuple[int, list[str]]:
    """Generate and check; returns how many utterances were read and the faults in them."""
    generator = Generator()
    about = generator.character(character)
    faults = []
    for seed in range(talks):
        for said in generator.turns(character, x, seed, count=TURNS):
            found = truth_faults(said, about, generator.lexicon)
            if found:
                place = f"{character}, X = {x}, seed {seed}, turn {said.turn + 1}"
                faults.append(f"{place}: {said.text}\n  {found}")
    return talks * TURNS, faults


def main() -> int:
    """Run all jobs on all cores, with progress on stderr."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--talks", type=int, default=250, help="talks for each character and X")
    talks = options.parse_args().talks
    characters = [character.entity.id for character in Generator().characters()]
    total, faults = 0, []
    with ProcessPoolExecutor() as pool:
        jobs = [pool.submit(sweep, name, x, talks) for name in characters for x in XS]
        for done, job in enumerate(as_completed(jobs), 1):
            count, found = job.result()
            total += count
            faults += found
            print(f"\r{done} of {len(jobs)} jobs", end="", file=sys.stderr)
    print(file=sys.stderr)
    print(*faults[:20], sep="\n")
    print(f"{total} utterances read, {len(faults)} with a fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
