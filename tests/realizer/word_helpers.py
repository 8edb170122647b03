"""Has the inflection of both dialects, and reads reviewed tables, for the tests of words."""

from __future__ import annotations

from pathlib import Path

from personage_lite.realizer.inflection import Dialect, Inflection, read_inflection
from personage_lite.realizer.words import Degree, VerbForm
from personage_lite.yaml_reader import read_yaml
from tests.realizer.lemminflect_comparison import DIALECTS

FILE = Path(__file__).parents[2] / "lexicons" / "inflection.yaml"
INFLECTIONS: dict[Dialect, Inflection] = {
    dialect: read_inflection(read_yaml(FILE), dialect) for dialect in DIALECTS
}
BRITISH, AMERICAN = INFLECTIONS["british"], INFLECTIONS["american"]
FORMS: tuple[VerbForm, ...] = ("third", "past", "participle", "gerund")
DEGREES: tuple[Degree, ...] = ("comparative", "superlative")


def rows(table: str) -> list[list[str]]:
    """Return the cells of a table, with blanks for underscores."""
    return [
        [cell.replace("_", " ") for cell in line.split()] for line in table.strip().splitlines()
    ]


def sides(cells: list[str]) -> tuple[list[str], list[str]]:
    """Return the British and the American cells."""
    return [cell.split("/")[0] for cell in cells], [cell.split("/")[-1] for cell in cells]
