"""A report as a picture: a panel a feature, X on its axis, the published direction beside it."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from personage_lite.errors import PersonageError, shown
from personage_lite.measure.extras import imported
from personage_lite.measure.report import Report, Row

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SUFFIXES = (".png", ".svg", ".pdf")
_COLUMNS = 6
# Inches: the whole width, a panel with what is between panels, and what is above and below.
_WIDTH, _PANEL, _TOP, _BOTTOM = 15.0, 1.75, 0.75, 0.75
# 95 % of a normal distribution.
_BAND = 1.96
# Apart for colour-blind eyes, too (M. Okabe and K. Ito, "Color universal design", 2008).
_COLOURS = {"agrees": "#0072b2", "disagrees": "#d55e00", "no trend": "#8c6d00", "": "#666666"}
_ARROWS = {"rises": "↗", "falls": "↘", "none": "–"}
_LEGEND = {
    "agrees": "agrees with the published direction",
    "disagrees": "disagrees with it",
    "no trend": "no certain trend",
    "": "no direction published",
}


def check_plot_path(path: str | PathLike[str]) -> Path:
    """Return the path of a plot; raises `PersonageError` if none can be written there.

    It is asked before the long work, so nothing is written yet.
    """
    place = Path(path)
    if place.suffix.lower() not in SUFFIXES:
        raise PersonageError(
            f"a plot cannot be '{shown(place.name)}'; end its name in {', '.join(SUFFIXES)}"
        )
    folder = place.parent
    if not folder.is_dir():
        raise PersonageError(f"{place}: there is no folder {folder}; make it, or choose another")
    if place.is_dir() or not os.access(folder, os.W_OK):
        raise PersonageError(f"{place}: cannot be written; choose another place")
    return place


def plot(report: Report, path: str | PathLike[str]) -> None:
    """Draw a report of several X to a file, whole or not at all.

    Each panel has the values with a band of 95 % (1.96 standard errors). Its colour says whether
    the trend is the published one, the arrow which one is published.
    """
    place = check_plot_path(path)
    if len(report.groups) < 2:
        raise PersonageError("a plot needs records of two or more X; make some with corpus")
    style = {"font.size": 8, "font.family": "DejaVu Sans", "svg.hashsalt": "personage-lite"}
    style |= {"axes.spines.top": False, "axes.spines.right": False}
    with imported("matplotlib").rc_context(style), _whole(place) as unfinished:
        figure = _figure(report)
        # Without the time and the version, so that the same report gives the same file.
        missing = {".png": "Software", ".svg": "Date", ".pdf": "CreationDate"}
        kind = place.suffix.lower()
        figure.savefig(unfinished, format=kind[1:], metadata={missing[kind]: None})


@contextmanager
def _whole(place: Path) -> Iterator[Path]:
    """Give a path to write to, and put what was written in its place if all went well."""
    unfinished = place.with_name(f".{place.name}.{os.getpid()}")
    try:
        yield unfinished
        unfinished.replace(place)
    except OSError as error:
        raise PersonageError(
            f"{place}: cannot be written ({error.strerror}); choose another place"
        ) from None
    finally:
        unfinished.unlink(missing_ok=True)


def _figure(report: Report) -> Figure:
    lines = math.ceil(len(report.rows) / _COLUMNS)
    height = _TOP + lines * _PANEL + _BOTTOM
    figure: Figure = imported("matplotlib.figure").Figure(figsize=(_WIDTH, height), dpi=110)
    # Fixed edges, in inches: matplotlib's own layout takes longer than all the rest.
    figure.subplots_adjust(
        left=0.6 / _WIDTH,
        right=1 - 0.2 / _WIDTH,
        top=1 - _TOP / height,
        bottom=_BOTTOM / height,
        wspace=0.3,
        hspace=0.5,
    )
    panels = figure.subplots(lines, _COLUMNS, squeeze=False)
    places = [panel for line in panels for panel in line]
    for row, panel in zip(report.rows, places, strict=False):
        _draw(row, panel)
    for panel in places[len(report.rows) :]:
        panel.set_axis_off()
    figure.suptitle(_title(report), fontsize=12, y=1 - 0.3 / height)
    _add_legend(figure)
    return figure


def _title(report: Report) -> str:
    count = sum(group.utterances for group in report.groups)
    return f"Style features by extraversion X: {count:,} utterances, bands of 95 %"


def _draw(row: Row, panel: Axes) -> None:
    feature, colour = row.feature, _COLOURS[row.verdict]
    known = [
        (value.x, value.value, _BAND * (value.error or 0.0))
        for value in row.values
        if value.x is not None and value.value is not None
    ]
    xs = [x for x, _, _ in known]
    # But for the grades, which can be below 0, no feature can.
    lowest = -math.inf if feature.per == "text" else 0.0
    low = [max(value - band, lowest) for _, value, band in known]
    high = [value + band for _, value, band in known]
    panel.fill_between(xs, low, high, color=colour, alpha=0.2, linewidth=0)
    panel.plot(xs, [value for _, value, _ in known], color=colour, marker="o", markersize=3)
    panel.set_title(feature.label, fontsize=9, loc="left", x=0.09, pad=4)
    panel.text(
        0.0,
        1.035,
        _ARROWS[feature.direction],
        transform=panel.transAxes,
        fontsize=13,
        fontweight="bold",
        color=colour,
    )
    per = "" if feature.per in ("window", "text") else f"per {feature.per}"
    panel.set_ylabel(per, fontsize=7, color="#555555")
    panel.set_xticks([value.x for value in row.values if value.x is not None])
    panel.xaxis.set_major_formatter("{x:g}")
    panel.locator_params(axis="y", nbins=4)
    panel.tick_params(labelsize=7)
    if not any(high):
        panel.set_ylim(0, 1)
    elif feature.per != "text" and min(low) < max(high) / 2:
        panel.set_ylim(bottom=0)


def _add_legend(figure: Figure) -> None:
    line = imported("matplotlib.lines").Line2D
    handles = [
        line([], [], color=_COLOURS[verdict], marker="o", markersize=4, label=text)
        for verdict, text in _LEGEND.items()
    ]
    figure.legend(
        handles=handles,
        loc="lower center",
        ncols=len(handles),
        frameon=False,
        fontsize=9,
        title="↗ ↘: how extraverts are published to differ from introverts",
        title_fontsize=9,
    )
