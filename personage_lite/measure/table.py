"""A report as text for people and as records for programs (docs/measure.md)."""

from __future__ import annotations

from collections.abc import Sequence

from personage_lite.measure.report import Report, Row
from personage_lite.measure.richness import Richness

_MISSING = "–"
_SHORT = {"100 sentences": "100 sent."}
_ARROWS = {"rises": "rises", "falls": "falls", "none": _MISSING}


def table(report: Report, with_richness: bool = False) -> str:
    """Return a report as lines: a row a feature, a column an X, and the sources below."""
    numbers = _numbers(report)
    several = len(report.groups) > 1
    heads = [_x(group.x) for group in report.groups] if several else ["value", "±"]
    ends = ["trend", "published", "verdict", "sources"] if several else ["published", "sources"]
    lines = [
        ["feature", "per", *heads, *ends],
        *([name, "", *sizes] for name, sizes in _sizes(report, several)),
        *(_cells(row, several, numbers) for row in report.rows),
    ]
    return "\n".join(
        [
            *_aligned(lines, 2 + len(heads) + several),
            "",
            *(["X is rounded to whole numbers"] if report.rounded else []),
            "published: how extraverts differ, by the sources (! found the opposite)",
            *(f"{number:>3} {report.sources[key]}" for key, number in numbers.items()),
            *(_richness_lines(report.richness) if with_richness else ()),
        ]
    )


def records(report: Report, with_richness: bool = False) -> list[dict[str, object]]:
    """Return a report as JSON-ready records: one a feature, and with richness one an X."""
    found = [_record(row, report) for row in report.rows]
    if with_richness:
        found += [_richness_record(one) for one in report.richness]
    return found


def _numbers(report: Report) -> dict[str, int]:
    """Return the sources that the features name, numbered in their order in the file."""
    named = {key for row in report.rows for key in (*row.feature.sources, *row.feature.contrary)}
    return {key: number for number, key in enumerate((k for k in report.sources if k in named), 1)}


def _sizes(report: Report, several: bool) -> list[tuple[str, list[str]]]:
    """Return the rows that say how much was measured."""
    sizes = [
        ("utterances in all", [group.utterances for group in report.groups]),
        ("sentences in all", [group.sentences for group in report.groups]),
        ("words in all", [group.words for group in report.groups]),
    ]
    return [(name, [*map(str, counts), *([""] * (not several))]) for name, counts in sizes]


def _cells(row: Row, several: bool, numbers: dict[str, int]) -> list[str]:
    feature = row.feature
    sources = [str(numbers[key]) for key in feature.sources]
    sources += [f"!{numbers[key]}" for key in feature.contrary]
    published = [_ARROWS[feature.direction]]
    values = [_number(value.value) for value in row.values]
    if several:
        values.append(_MISSING if row.trend is None else f"{row.trend:+.2f}")
        published.append(row.verdict)
    else:
        values.append(_number(row.values[0].error))
    per = "" if feature.per in ("window", "text") else _SHORT.get(feature.per, feature.per)
    return [feature.label, per, *values, *published, " ".join(sources)]


def _aligned(lines: Sequence[Sequence[str]], numbers_end: int) -> list[str]:
    """Return lines of cells in columns: numbers to the right, from the third cell on."""
    count = max(map(len, lines))
    full = [[*line, *[""] * (count - len(line))] for line in lines]
    widths = [max(map(len, column)) for column in zip(*full, strict=True)]
    return [
        "  ".join(
            f"{cell:>{width}}" if 2 <= place < numbers_end else f"{cell:<{width}}"
            for place, (cell, width) in enumerate(zip(line, widths, strict=True))
        ).rstrip()
        for line in full
    ]


def _x(x: float | None) -> str:
    return "text" if x is None else f"X={x:g}"


def _number(value: float | None) -> str:
    if value is None:
        return _MISSING
    return f"{value:.0f}" if abs(value) >= 1000 else f"{value:.2f}"


def _richness_lines(groups: Sequence[Richness]) -> list[str]:
    lines = [["richness", "over", *(_x(one.x) for one in groups)]]
    first = groups[0].words
    lines.append(["distinct words", f"{first} words", *(_number(one.distinct_1) for one in groups)])
    lines.append(["distinct pairs", f"{first} words", *(_number(one.distinct_2) for one in groups)])
    openings = [_number(one.repeated_openings) for one in groups]
    lines.append(["repeated openings", "all utterances", *openings])
    found = ["", *_aligned(lines, 2 + len(groups))]
    for one in groups:
        found += ["", f"most worn phrases, {_x(one.x)} (utterances that hold them)"]
        found += [f"{worn.utterances:>6}  {worn.phrase}" for worn in one.worn] or ["     –"]
    return found


def _record(row: Row, report: Report) -> dict[str, object]:
    feature = row.feature
    return {
        "feature": feature.name,
        "label": feature.label,
        "per": feature.per,
        "values": [
            {
                "x": value.x,
                "value": _rounded(value.value),
                "error": _rounded(value.error),
                "utterances": group.utterances,
                "words": group.words,
            }
            for value, group in zip(row.values, report.groups, strict=True)
        ],
        "trend": _rounded(row.trend),
        "published": feature.direction,
        "verdict": row.verdict,
        "finding": feature.finding,
        "sources": [report.sources[key] for key in feature.sources],
        "contrary": [report.sources[key] for key in feature.contrary],
    }


def _richness_record(one: Richness) -> dict[str, object]:
    return {
        "x": one.x,
        "words": one.words,
        "distinct_1": _rounded(one.distinct_1),
        "distinct_2": _rounded(one.distinct_2),
        "repeated_openings": _rounded(one.repeated_openings),
        "worn_phrases": [worn._asdict() for worn in one.worn],
    }


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 4)
