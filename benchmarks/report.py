"""The figures of one run and how they are shown."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from statistics import median

from subjects import XS

START_UP_GOAL = 3.0
RATE_GOAL = 2 / 3


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
    """How fast one subject is; a text is an utterance or a sentence."""

    texts_per_second: Spread
    sentences_per_second: Spread
    sentences_per_text: float
    words_per_text: float
    texts_to_pyrealb: Spread
    sentences_to_pyrealb: Spread


@dataclass(frozen=True)
class Goal:
    """A figure that the project wants to reach."""

    what: str
    at_least: float
    value: float
    reached: bool


@dataclass(frozen=True)
class Report:
    """All that one run has measured."""

    date: str
    machine: str
    versions: str
    rounds: int
    slice_seconds: float
    start_up_seconds: dict[str, Spread]
    start_up_ratio: Spread
    throughput: dict[str, Rate]
    memory_counts: tuple[int, ...]
    memory_mib: dict[str, list[float]]

    def goals(self) -> list[Goal]:
        """Return the goals, in the order of the report, by the medians."""
        values = [("start-up, pyrealb / personage-lite", START_UP_GOAL, self.start_up_ratio.median)]
        for x in XS:
            ratio = self.throughput[f"styled, X = {x}"].texts_to_pyrealb.median
            values.append((f"utterances / pyrealb's sentences, X = {x}", RATE_GOAL, ratio))
        return [Goal(what, least, value, value >= least) for what, least, value in values]

    def json(self) -> str:
        """Return the report as JSON."""
        goals = [asdict(goal) for goal in self.goals()]
        return json.dumps({**asdict(self), "goals": goals}, indent=2)

    def text(self) -> str:
        """Return the report as aligned tables."""
        start_up = [[f"start-up, ms ({self.rounds} rounds)", "median", "lowest", "highest"]]
        for name, time in self.start_up_seconds.items():
            start_up.append([name, *_cells(time, "{:.0f}", 1000)])
        start_up.append(["pyrealb / personage-lite", *_cells(self.start_up_ratio, "{:.2f}")])

        title = f"throughput ({self.rounds} rounds of {self.slice_seconds:g} s)"
        speed = [[title, "texts/s", "lowest", "highest", "sentences/s", "sent./text", "words/text"]]
        ratios = [["throughput / pyrealb's", "texts", "lowest", "highest", "sentences"]]
        for name, rate in self.throughput.items():
            speed.append([name, *_cells(rate.texts_per_second, "{:,.0f}")])
            speed[-1].append(f"{rate.sentences_per_second.median:,.0f}")
            speed[-1].extend((f"{rate.sentences_per_text:.2f}", f"{rate.words_per_text:.1f}"))
            if name != "pyrealb":
                ratios.append([name, *_cells(rate.texts_to_pyrealb, "{:.2f}")])
                ratios[-1].append(f"{rate.sentences_to_pyrealb.median:.2f}")

        memory = [["peak memory, MiB", *(f"{count:,} made" for count in self.memory_counts)]]
        for name, peaks in self.memory_mib.items():
            memory.append([name, *(f"{peak:.1f}" for peak in peaks)])

        goals = [["goal", "at least", "is", ""]]
        for goal in self.goals():
            verdict = "reached" if goal.reached else "missed"
            goals.append([goal.what, f"{goal.at_least:.2f}", f"{goal.value:.2f}", verdict])
        head = f"{self.date}, {self.versions}\n{self.machine}"
        return "\n\n".join((head, *map(_table, (start_up, speed, ratios, memory, goals))))


def _cells(spread: Spread, form: str, scale: float = 1) -> list[str]:
    return [form.format(v * scale) for v in (spread.median, spread.lowest, spread.highest)]


def _table(rows: Sequence[Sequence[str]]) -> str:
    lines = []
    for name, *cells in rows:
        lines.append(f"{name:<44}" + "".join(f"{cell:>13}" for cell in cells))
    return "\n".join(line.rstrip() for line in lines)
