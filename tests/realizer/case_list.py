"""Reads `cases/*.yaml`: reviewed texts with their specifications, in the format of `realize`."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from personage_lite.realizer import Phrase, Sentence
from personage_lite.realizer.files import read_data
from personage_lite.realizer.reader import read_specification

FOLDER = Path(__file__).with_name("cases")
# What a case may say beside its name, text and specification: the realizer's options.
OPTIONS = ("dialect", "oxford_comma", "curly_apostrophes")


class Case(NamedTuple):
    """One reviewed case: what is realized, with which options, and the only text that is right."""

    phenomenon: str
    group: str
    name: str
    spec: Sentence | Phrase
    text: str
    options: tuple[tuple[str, Any], ...] = ()


def read_cases() -> list[Case]:
    """Return every case of the folder, file by file, in their order."""
    return [case for path in sorted(FOLDER.glob("*.yaml")) for case in _read_file(path)]


def _read_file(path: Path) -> list[Case]:
    found = []
    for group, rows in read_data(str(path))["groups"].items():
        for row in rows:
            place = (path.stem, group, row["name"])
            options = tuple((key, row[key]) for key in OPTIONS if key in row)
            unknown = set(row) - {"name", "text", "spec", *OPTIONS}
            assert not unknown, f"{place}: {unknown}"
            found.append(Case(*place, read_specification(row["spec"], place), row["text"], options))
    return found
