"""Learners side by side, at several noise levels: records, and a table to read.

>>> from adaptation.experiment import Experiment
>>> from adaptation.listeners import listener
>>> runs = list(compare(["always-zero"], [0.0, 0.5], Experiment(listener("match"), trials=100)))
>>> [(run.learner, run.noise, run.record()["mean_match"]) for run in runs]
[('always-zero', 0.0, 0.191333), ('always-zero', 0.5, 0.191333)]
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from adaptation.experiment import Experiment, Progress
from adaptation.learners import LEARNERS
from adaptation.tally import Estimate, Result

# What stands beside each learner, for scale: without any learning, and knowing all.
BASELINES = ("always-zero", "oracle")
MEASURES = ("reward", "match", "engagement")


class Run(NamedTuple):
    """A learner at a noise level: the experiment, and what came of it."""

    learner: str
    noise: float
    experiment: Experiment
    result: Result

    def record(self) -> dict[str, Any]:
        """Return it ready for JSON, as `simulate --format json` prints it.

        Numbers are rounded to six decimals; an interval that does not exist is None.
        """
        experiment, result = self.experiment, self.result
        record: dict[str, Any] = {
            "learner": self.learner,
            "noise": self.noise,
            "listener": experiment.listener.name,
            "trials": experiment.trials,
            "steps": experiment.steps,
            "seed": experiment.seed,
            "listener_noise": experiment.listener_noise,
            "sensor_noise": experiment.sensor_noise,
            "changes": list(experiment.changes),
            "floor_bonus": experiment.floor_bonus,
        }
        for measure in MEASURES:
            mean = result.mean(measure)
            record[f"mean_{measure}"] = _rounded(mean.value)
            record[f"mean_{measure}_ci95"] = _rounded(mean.ci95)
        for measure in MEASURES:
            curve = result.curve(measure)
            record[f"{measure}_by_step"] = [_rounded(value) for value in curve.value.tolist()]
            record[f"{measure}_by_step_ci95"] = [_rounded(half) for half in curve.ci95.tolist()]
        return record


def _rounded(value: float) -> float | None:
    return None if math.isnan(value) else round(value, 6)


def compare(
    learners: Sequence[str],
    noises: Sequence[float],
    experiment: Experiment,
    *,
    listener_noise: float | None = None,
    sensor_noise: float | None = None,
    progress: Progress | None = None,
) -> Iterator[Run]:
    """Run each learner at each noise level, on the same listeners; yield what came of it.

    A noise level is the probability of both coins (see world.py), unless one of them is fixed
    with `listener_noise` or `sensor_noise`. Raises `PersonageError` for an unknown learner and
    for noise outside 0 to 1, before anything is run.
    """
    makers = {name: LEARNERS[name] for name in learners}
    protocols = {
        noise: replace(
            experiment,
            listener_noise=noise if listener_noise is None else listener_noise,
            sensor_noise=noise if sensor_noise is None else sensor_noise,
        )
        for noise in noises
    }
    return _runs([(name, noise) for name in makers for noise in protocols], protocols, progress)


def _runs(
    pairs: list[tuple[str, float]], protocols: dict[float, Experiment], progress: Progress | None
) -> Iterator[Run]:
    for number, (name, noise) in enumerate(pairs):

        def report(share: float, number: int = number) -> None:
            if progress:
                progress((number + share) / len(pairs))

        result = protocols[noise].run(LEARNERS[name], report)
        yield Run(name, noise, protocols[noise], result)


def table(runs: Sequence[Run], scale: Iterable[Run] = ()) -> str:
    """Return the overall means with their 95 % intervals; `scale` stands below, for scale.

    >>> from adaptation.listeners import listener
    >>> print(table(list(compare(["random"], [0.0], Experiment(listener("match"), trials=100)))))
    listener match, 100 trials of 30 steps, preference anew at steps 15 and 26, seed 0
    means ± 95 % confidence intervals; match: X is the preference; E: true engagement
    <BLANKLINE>
    learner  noise           reward            match                E
    random     0.0    0.237 ± 0.019    0.193 ± 0.022   -1.388 ± 0.103
    """
    below = list(scale)
    width = max(len(name) for name in ("learner", *(run.learner for run in (*runs, *below))))
    experiment = runs[0].experiment
    steps = " and ".join(str(change) for change in experiment.changes if change <= experiment.steps)
    lines = [
        f"listener {experiment.listener.name}, {experiment.trials} trials of"
        f" {experiment.steps} steps, "
        + (f"preference anew at steps {steps}, " if steps else "one preference, ")
        + f"seed {experiment.seed}"
        + ("" if experiment.floor_bonus else ", no floor bonus"),
        "means ± 95 % confidence intervals; match: X is the preference; E: true engagement",
        "",
        f"{'learner':<{width}}  noise {'reward':>16} {'match':>16} {'E':>16}",
    ]
    lines += [_row(run, width) for run in runs]
    if below:
        lines += ["", "for scale", *(_row(run, width) for run in below)]
    return "\n".join(lines)


def _row(run: Run, width: int) -> str:
    means = " ".join(f"{_with_interval(run.result.mean(measure)):>16}" for measure in MEASURES)
    return f"{run.learner:<{width}}  {run.noise:>5} {means}"


def _with_interval(mean: Estimate) -> str:
    half = "?" if math.isnan(mean.ci95) else f"{mean.ci95:.3f}"
    return f"{mean.value:.3f} ± {half}"
