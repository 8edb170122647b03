"""The figures of one run and how they are shown."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from statistics import median

from subjects import MIXED

START_UP_GOAL = 3.0
UTTERANCES_GOAL = 2.0
REALIZER_GOAL = 10.0
JVM_AIM = 1.0

OURS, PYREALB, JVM = "personage-lite", "pyrealb", "SimpleNLG (JVM)"
# What is added to a name where the compiled build is measured.
COMPILED = ", compiled"


@dataclass(frozen=True)
class Spread:
    """A median over the rounds with the lowest and the highest value."""

    median: float
    lowest: float
    highest: float

    @classmethod
    def of(cls, values: Iterable[float]) -> Spread:
        """Return the spread of one value a round."""
        values = list(values)
        return cls(median(values), min(values), max(values))

    @classmethod
    def of_ratios(cls, above: Iterable[float], below: Iterable[float]) -> Spread:
        """Return the spread of the quotients, each taken within its round."""
        return cls.of(a / b for a, b in zip(above, below, strict=True))


@dataclass(frozen=True)
class Rate:
    """How fast styled utterances are made; `to_pyrealb` is utterances to pyrealb's sentences."""

    texts_per_second: Spread
    sentences_per_second: Spread
    sentences_per_text: float
    words_per_text: float
    to_pyrealb: Spread


@dataclass(frozen=True)
class RealizerRate:
    """How fast a realizer is over the sentences that it says rightly.

    `wrong` is what it says instead of the others, or nothing if it was not even tried.
    `ours_to_it` is over the `common` sentences, those that both say.
    """

    version: str
    says: int
    wrong: dict[str, str | None]
    sentences_per_second: Spread
    to_pyrealb: Spread
    common: int
    ours_to_it: Spread | None


@dataclass(frozen=True)
class Goal:
    """A figure that the project wants to reach; no value where it was not measured."""

    what: str
    at_least: float
    value: float | None
    reached: bool | None


@dataclass(frozen=True)
class Report:
    """All that one run has measured; a run of the realizers alone leaves the rest empty."""

    date: str
    machine: str
    python: str
    rounds: int
    slice_seconds: float
    sentences: int
    realizers: dict[str, RealizerRate]
    left_out: dict[str, str]
    start_up_seconds: dict[str, Spread]
    start_up_ratio: Spread | None
    throughput: dict[str, Rate]
    memory_counts: tuple[int, ...]
    memory_mib: dict[str, list[float]]

    def goals(self) -> list[Goal]:
        """Return the goals, in the order of the report, by the medians."""
        values: list[tuple[str, float, Spread | None]] = []
        if self.start_up_ratio:
            values.append(
                ("start-up, pyrealb / personage-lite", START_UP_GOAL, self.start_up_ratio)
            )
        if self.throughput:
            what = "styled utterances / pyrealb's sentences"
            for build in ("", COMPILED):
                rate = self.throughput.get(MIXED + build)
                if rate is not None:
                    values.append((what + build, UTTERANCES_GOAL, rate.to_pyrealb))
        for what, least, name in (
            ("realizer / pyrealb, same sentences", REALIZER_GOAL, PYREALB),
            ("realizer / SimpleNLG on the JVM (an aim)", JVM_AIM, JVM),
        ):
            rate = self.realizers.get(name)
            values.append((what, least, rate.ours_to_it if rate else None))
        return [
            Goal(what, least, ratio and ratio.median, ratio and ratio.median >= least)
            for what, least, ratio in values
        ]

    def json(self) -> str:
        """Return the report as JSON."""
        goals = [asdict(goal) for goal in self.goals()]
        return json.dumps({**asdict(self), "goals": goals}, indent=2)

    def text(self) -> str:
        """Return the report as aligned tables."""
        parts = [f"{self.date}, Python {self.python}\n{self.machine}"]
        if self.start_up_ratio:
            parts.append(_table(self._start_up(self.start_up_ratio)))
        if self.throughput:
            parts.extend((_table(self._throughput()), _table(self._utterance_ratios())))
        parts.extend((_table(self._realizers()), _table(self._ratios()), self._not_said()))
        if self.memory_mib:
            parts.append(_table(self._memory()))
        goals = [["goal", "at least", "is", ""]]
        for goal in self.goals():
            value = "–" if goal.value is None else f"{goal.value:.2f}"
            verdict = {None: "not measured", True: "reached", False: "missed"}[goal.reached]
            goals.append([goal.what, f"{goal.at_least:.2f}", value, verdict])
        return "\n\n".join((*parts, _table(goals)))

    def _start_up(self, ratio: Spread) -> list[list[str]]:
        rows = [[f"start-up, ms ({self.rounds} rounds)", "median", "lowest", "highest"]]
        for name, time in self.start_up_seconds.items():
            rows.append([name, *_cells(time, "{:.0f}", 1000)])
        return [*rows, ["pyrealb / personage-lite", *_cells(ratio, "{:.2f}")]]

    def _throughput(self) -> list[list[str]]:
        title = f"utterances ({self.rounds} rounds of {self.slice_seconds:g} s)"
        rows = [[title, "texts/s", "lowest", "highest", "sent./s", "sent./text", "words/text"]]
        for name, rate in self.throughput.items():
            row = [name, *_cells(rate.texts_per_second, "{:,.0f}")]
            row.append(f"{rate.sentences_per_second.median:,.0f}")
            rows.append([*row, f"{rate.sentences_per_text:.2f}", f"{rate.words_per_text:.1f}"])
        return rows

    def _utterance_ratios(self) -> list[list[str]]:
        rows = [["utterances / pyrealb's sentences", "ratio", "lowest", "highest"]]
        rows.extend([name, *_ratio(rate.to_pyrealb)] for name, rate in self.throughput.items())
        return rows

    def _realizers(self) -> list[list[str]]:
        title = f"realizers ({self.rounds} rounds of {self.slice_seconds:g} s)"
        rows = [[title, "says", "sent./s", "lowest", "highest", "/ pyrealb", "version"]]
        for name, rate in self.realizers.items():
            row = [name, f"{rate.says} of {self.sentences}"]
            row.extend(_cells(rate.sentences_per_second, "{:,.0f}"))
            rows.append([*row, _ratio(rate.to_pyrealb)[0], f"  {rate.version}"])
        return rows

    def _ratios(self) -> list[list[str]]:
        rows = [
            ["our realizer / theirs, same sentences", "sentences", "ratio", "lowest", "highest"]
        ]
        for name, rate in self.realizers.items():
            if name != OURS:
                ratio = _ratio(rate.ours_to_it) if rate.ours_to_it else ["–"]
                rows.append([name, str(rate.common), *ratio])
        return rows

    def _not_said(self) -> str:
        lines = []
        for name, rate in self.realizers.items():
            if rate.wrong:
                lines.append(f"{name} says wrongly, and is not timed over:")
                lines.extend(f"  {key:<20} {text}" for key, text in rate.wrong.items() if text)
                untried = [key for key, text in rate.wrong.items() if not text]
                if untried:
                    lines.append(f"  not tried: {', '.join(untried)}")
        lines.extend(f"{name} is left out: {reason}" for name, reason in self.left_out.items())
        return "\n".join(lines or ["all say all sentences"])

    def _memory(self) -> list[list[str]]:
        rows = [["peak memory, MiB", *(f"{count:,} made" for count in self.memory_counts)]]
        for name, peaks in self.memory_mib.items():
            rows.append([name, *(f"{peak:.1f}" for peak in peaks)])
        return rows


def _cells(spread: Spread, form: str, scale: float = 1) -> list[str]:
    return [form.format(v * scale) for v in (spread.median, spread.lowest, spread.highest)]


def _ratio(spread: Spread) -> list[str]:
    """Return a ratio that may lie far from 1 in about three figures."""
    values = (spread.median, spread.lowest, spread.highest)
    return [f"{v:,.0f}" if v >= 100 else f"{v:.3g}" for v in values]


def _table(rows: Sequence[Sequence[str]]) -> str:
    lines = []
    for name, *cells in rows:
        lines.append(f"{name:<42}" + "".join(f"  {cell:>11}" for cell in cells))
    return "\n".join(line.rstrip() for line in lines)
