"""Steps a second: the vectorised experiment beside plain loops, in one run, number for number.

    pip install personage-lite[adaptation]
    python benchmarks/adaptation/speed.py

Both run Q-learning as published on the listener `match`. They take turns, so that a slow moment of
the machine hits both. Both sides' time includes drawing the random numbers, the vectorised side's
also adding up the results.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time

from plain import numbers, run_trial

from adaptation.experiment import Experiment
from adaptation.learners.q_learning import QLearning
from adaptation.listeners.match import Match

GOAL = 15
NOISE = 0.2


def main() -> int:
    """Measure, and print what was found."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--rounds", type=int, default=11, help="how many rounds (default 11)")
    parser.add_argument("--plain-trials", type=int, default=1000, help="a round (default 1000)")
    parser.add_argument("--trials", type=int, default=20_480, help="a round (default 20,480)")
    parser.add_argument("--format", choices=("text", "json"), default="text")
    given = parser.parse_args()
    experiment = Experiment(
        Match(), trials=given.trials, listener_noise=NOISE, sensor_noise=NOISE, seed=1
    )
    agree(experiment, min(200, given.trials))
    plain, vectorised = [], []
    for round_number in range(given.rounds + 1):
        slow = plain_rate(experiment, given.plain_trials)
        fast = vectorised_rate(experiment)
        if round_number:  # The first one warms up.
            plain.append(slow)
            vectorised.append(fast)
    ratio = statistics.median(f / s for f, s in zip(vectorised, plain, strict=True))
    if given.format == "json":
        print(json.dumps({"plain": plain, "vectorised": vectorised, "ratio": ratio}))
        return 0
    for name, rates in (("plain loops", plain), ("vectorised", vectorised)):
        print(
            f"{name:12} {statistics.median(rates):>12,.0f} steps/s"
            f"  ({min(rates):,.0f} to {max(rates):,.0f})"
        )
    print(f"{'ratio':12} {ratio:>12.1f}  (goal {GOAL}: {'met' if ratio >= GOAL else 'missed'})")
    return 0


def agree(experiment: Experiment, trials: int) -> None:
    """Stop unless both sides agree in every number of so many trials."""
    given = numbers(experiment.seed, trials, experiment.steps, experiment.changes)
    block = next(experiment.blocks(QLearning))
    for index, own in enumerate(given):
        trial = run_trial(own, experiment.steps, experiment.changes, NOISE, experiment.floor_bonus)
        for measure in ("reward", "match", "engagement"):
            if getattr(trial, measure) != getattr(block, measure)[:, index].tolist():
                raise SystemExit(f"trial {index + 1}: {measure} differs; nothing was timed")


def plain_rate(experiment: Experiment, trials: int) -> float:
    """Return the steps a second of the plain loops."""
    start = time.perf_counter()
    for own in numbers(experiment.seed, trials, experiment.steps, experiment.changes):
        run_trial(own, experiment.steps, experiment.changes, NOISE, experiment.floor_bonus)
    return trials * experiment.steps / (time.perf_counter() - start)


def vectorised_rate(experiment: Experiment) -> float:
    """Return the steps a second of the vectorised experiment."""
    start = time.perf_counter()
    experiment.run(QLearning)
    return experiment.trials * experiment.steps / (time.perf_counter() - start)


if __name__ == "__main__":
    sys.exit(main())
