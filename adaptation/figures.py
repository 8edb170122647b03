"""The plot of the experiment: the paper's figure 2, and beside it what that curve hides."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from adaptation.comparison import BASELINES, MEASURES, Run
from personage_lite.errors import PersonageError, shown

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SUFFIXES = (".png", ".svg", ".pdf")
_TITLES = {
    "reward": "Reward",
    "match": "Match: share of trials with X = preference",
    "engagement": "True engagement E",
}
_BASELINE_LINES: dict[str, dict[str, Any]] = {
    "always-zero": {"color": "0.35", "linestyle": (0, (5, 2)), "label": "always X = 0"},
    "oracle": {"color": "0.35", "linestyle": (0, (1, 1.5)), "label": "oracle"},
}


def check_target(path: str | Path) -> Path:
    """Return where a plot goes; raises `PersonageError` if none can be written there.

    To be asked before a long run: that matplotlib is there is checked, too.

    >>> check_target("figure.gif")
    Traceback (most recent call last):
    personage_lite.errors.PersonageError: cannot plot to figure.gif; choose a name in .png, .svg, .pdf
    """  # noqa: E501
    target = Path(path)
    place = shown(str(path))
    if target.suffix.lower() not in SUFFIXES:
        raise PersonageError(f"cannot plot to {place}; choose a name in {', '.join(SUFFIXES)}")
    if target.is_dir() or not target.parent.is_dir() or not os.access(target.parent, os.W_OK):
        raise PersonageError(
            f"cannot plot to {place}; choose a file in a folder that you may write"
        )
    try:
        import matplotlib  # noqa: F401 (only to see whether it is there)
    except ModuleNotFoundError as error:
        raise PersonageError(
            f"a plot needs {error.name}; pip install personage-lite[plots]"
        ) from None
    return target


def plot(runs: Sequence[Run], baselines: Sequence[Run], path: str | Path) -> None:
    """Plot learners, one a row: reward, match and true engagement in each step, by noise.

    `baselines` are runs of always X = 0 and the oracle, at one noise level: lines for scale. The
    bands are 95 % confidence intervals. The file appears when it is whole. Raises
    `PersonageError` where it cannot be written.
    """
    target = check_target(path)
    figure = _drawn(runs, baselines)
    try:
        handle, name = tempfile.mkstemp(dir=target.parent, suffix=target.suffix)
        os.close(handle)
        try:
            # Without the date, so that the same runs give the same file.
            metadata = {"Software": None} if target.suffix.lower() == ".png" else None
            figure.savefig(name, metadata=metadata)
            os.chmod(name, 0o666 & ~_umask())
            os.replace(name, target)
        except BaseException:
            os.unlink(name)
            raise
    except OSError as error:
        raise PersonageError(
            f"cannot plot to {shown(str(path))}: {error.strerror}; choose another place"
        ) from None


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _drawn(runs: Sequence[Run], baselines: Sequence[Run]) -> Figure:
    """Return the figure, not yet written."""
    from matplotlib.figure import Figure

    learners = list(dict.fromkeys(run.learner for run in runs))
    noises = sorted({run.noise for run in runs})
    colours = dict(zip(noises, _colours(len(noises)), strict=True))
    experiment = runs[0].experiment
    height = 3.1 * len(learners) + 1.1
    figure = Figure(figsize=(15, height), dpi=120, layout="constrained")
    rows: Any = figure.subplots(
        len(learners), len(MEASURES), squeeze=False, sharex=True, sharey="col"
    )
    for learner, row in zip(learners, rows, strict=True):
        own = [run for run in runs if run.learner == learner]
        for measure, axes in zip(MEASURES, row, strict=True):
            _panel(axes, measure, own, baselines, colours)
        row[0].set_ylabel(learner, fontsize=11, fontweight="bold")
    for measure, axes in zip(MEASURES, rows[0], strict=True):
        axes.set_title(_TITLES[measure], fontsize=11, loc="left")
    if (learners, experiment.listener.name) == (["q-learning"], "match"):
        rows[0][0].set_title("Reward (the paper's figure 2)", fontsize=11, loc="left")
    for axes in rows[-1]:
        axes.set_xlabel("step")
    handles: dict[str, Any] = {}
    for axes in rows.flat:
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            handles.setdefault(label, handle)
    labels = sorted(handles, key=lambda label: not label.startswith("noise"))
    figure.legend(
        [handles[label] for label in labels],
        labels,
        loc="outside lower center",
        ncols=min(len(labels), 9),
        frameon=False,
    )
    figure.suptitle(
        f"listener {experiment.listener.name}, {experiment.trials:,} trials"
        + ("" if experiment.floor_bonus else ", no floor bonus")
        + "; bands: 95 % confidence intervals",
        fontsize=11,
        x=0.01,
        ha="left",
    )
    return figure


def _panel(
    axes: Axes,
    measure: str,
    runs: Sequence[Run],
    baselines: Sequence[Run],
    colours: dict[float, Any],
) -> None:
    """Draw one measure of one learner."""
    experiment = runs[0].experiment
    steps = np.arange(1, experiment.steps + 1)
    for change in experiment.changes:
        if change <= experiment.steps:
            axes.axvline(change - 0.5, color="0.8", linewidth=1.2, label="preference drawn anew")
    axes.axhline(0, color="0.85", linewidth=0.8, zorder=0)
    for run in baselines:
        if run.learner in BASELINES:
            look = dict(_BASELINE_LINES[run.learner])
            look["label"] += f" (noise {run.noise:g})"
            axes.plot(steps, run.result.curve(measure).value, linewidth=1.3, **look)
    for run in runs:
        curve = run.result.curve(measure)
        colour = colours[run.noise]
        axes.plot(
            steps, curve.value, color=colour, linewidth=1.5, label=f"noise {run.noise:g}", zorder=3
        )
        axes.fill_between(
            steps,
            curve.value - curve.ci95,
            curve.value + curve.ci95,
            color=colour,
            alpha=0.06 + 0.12 / len(runs),
            linewidth=0,
        )
    axes.set_xlim(0.5, experiment.steps + 0.5)
    if measure == "match":
        axes.set_ylim(-0.03, 1.03)
    elif measure == "engagement":
        axes.set_ylim(-2.1, 2.1)
    axes.spines[["top", "right"]].set_visible(False)


def _colours(count: int) -> list[Any]:
    """Return colours from dark (the lowest noise) to light."""
    from matplotlib import colormaps

    return [colormaps["plasma"](0.85 * number / max(count - 1, 1)) for number in range(count)]
