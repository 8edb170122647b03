"""Measures how well whole live sessions adapt, beside the same learners in the bare experiment.

Run as `python benchmarks/live.py [SESSIONS]`; it prints the table of docs/live.md. Sessions are as
by `personage-lite live --listener live --changes none --turns 30`: utterances as they come, E from
the cues of a simulated listener through the network. All time is simulated.
"""

from __future__ import annotations

import os
import sys
from collections import Counter
from io import StringIO
from statistics import fmean, stdev
from typing import Any, NamedTuple

from adaptation.experiment import Experiment
from adaptation.learners import LEARNERS
from adaptation.listeners import listener
from adaptation.live_world import Sensor
from adaptation.storyteller.assembly import Options, Outside, run_session
from adaptation.storyteller.screen import PlainScreen
from adaptation.storyteller.session_log import NoLog
from personage_lite.cli.live import generator_for

TURNS = 30
NAMES = ("bayes", "discounted-ucb", "always-zero", "oracle")
# The sensor of the bare experiment, and one that errs as cues and network do.
SENSORS = (Sensor(), Sensor(0.9, 4.0))


class Tally(NamedTuple):
    """A session: shares of utterances that match, mean true E, and whether the taste was found.

    It was found if no other X was more frequent in the last third.
    """

    match: float
    engagement: float
    found: bool


class Turns(NoLog):
    """A log that keeps the turns in memory."""

    def __init__(self) -> None:
        self.turns: list[dict[str, Any]] = []

    def write(self, line: str, **fields: Any) -> None:
        """Keep a turn."""
        if line == "turn":
            self.turns.append(fields)


def session(learner: str, seed: int) -> Tally:
    """Return what came of one session."""
    log, nobody = Turns(), os.open(os.devnull, os.O_RDONLY)
    outside = Outside(
        screen=lambda _line: PlainScreen(StringIO(), letters=False),
        typed=(nobody, False), wall=lambda: 0.0, say=print, log=log,
    )  # fmt: skip
    options = Options(seed=seed, learner=learner, listener="live", speed=0, turns=TURNS)
    run_session(GENERATOR, options, outside)
    os.close(nobody)
    heard = [turn["listener"] for turn in log.turns]
    taste = heard[-1]["preference"]
    last = Counter(turn["x"] for turn in log.turns[-TURNS // 3 :])
    return Tally(
        fmean(turn["x"] == taste for turn in log.turns),
        fmean(each["engagement"] for each in heard),
        last[taste] == max(last.values()),
    )


def bare(learner: str, sensor: Sensor) -> Tally:
    """Return the means of a thousand trials of the experiment."""
    experiment = Experiment(
        listener("live"), trials=1000, steps=TURNS, changes=(), floor_bonus=False, sensor=sensor
    )
    match, engagement, found = [], [], []
    for block in experiment.blocks(LEARNERS[learner]):
        match.append(float(block.match.mean()))
        engagement.append(float(block.engagement.mean()))
        last = slice(-TURNS // 3, None)
        for trial in range(block.x.shape[1]):
            xs = Counter(block.x[last, trial].tolist())
            right = int(block.match[last, trial].sum())
            found.append(right > 0 and right == max(xs.values()))
    return Tally(fmean(match), fmean(engagement), fmean(found))  # type: ignore[arg-type]


def shown(values: list[float]) -> str:
    """Return a mean and half its 95 % confidence interval."""
    return f"{fmean(values):.3f} ± {1.96 * stdev(values) / len(values) ** 0.5:.3f}"


def main(count: int) -> None:
    """Print the table."""
    print("learner          what                  match           true E          found")
    for name in NAMES:
        found = [session(name, 1000 + number) for number in range(count)]
        columns = [shown([float(value) for value in part]) for part in zip(*found, strict=True)]
        print(f"{name:16} {f'{count} sessions':20}", *columns, sep="  ", flush=True)
        for sensor in SENSORS:
            tally = bare(name, sensor)
            what = f"bare, {sensor.sigma:g} for {sensor.memory:g} s"
            print(f"{name:16} {what:20}", *(f"{value:<13.3f}" for value in tally), sep="  ")


GENERATOR = generator_for(None)
if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 200)
