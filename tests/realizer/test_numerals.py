"""Proves that numbers, ordinals and dates are said and written as they should be.

Tables hold reviewed forms; num2words and pyrealb, where they are installed, are second opinions.
"""

from __future__ import annotations

import datetime
from pathlib import Path
from typing import Any, Literal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from personage_lite.errors import DataError, PersonageError
from personage_lite.realizer.numerals import (
    Date,
    NumberWords,
    cardinal,
    date_text,
    ordinal,
    read_numerals,
)
from personage_lite.yaml_reader import parse_yaml

CONTENT = (Path(__file__).parents[2] / "lexicons" / "numerals.yaml").read_text()


def read(
    dialect: Literal["british", "american"] = "british", content: str = CONTENT
) -> NumberWords:
    return read_numerals(parse_yaml(content, "numerals.yaml"), dialect)


BRITISH, AMERICAN = read(), read("american")

# number | British | American, if it is another | figures
CARDINALS = """
0 | zero | | 0
1 | one | | 1
13 | thirteen | | 13
20 | twenty | | 20
21 | twenty-one | | 21
100 | one hundred | | 100
101 | one hundred and one | one hundred one | 101
999 | nine hundred and ninety-nine | nine hundred ninety-nine | 999
1000 | one thousand | | 1,000
1001 | one thousand and one | one thousand one | 1,001
1100 | one thousand one hundred | | 1,100
1862 | one thousand eight hundred and sixty-two | one thousand eight hundred sixty-two | 1,862
100000 | one hundred thousand | | 100,000
101001 | one hundred and one thousand and one | one hundred one thousand one | 101,001
1000000 | one million | | 1,000,000
2000005 | two million and five | two million five | 2,000,005
1000000000 | one billion | | 1,000,000,000
-3 | minus three | | -3
-3.5 | minus three point five | | -3.5
2.5 | two point five | | 2.5
2.0 | two | | 2
-0.0 | zero | | 0
0.05 | zero point zero five | | 0.05
0.00001 | zero point zero zero zero zero one | | 0.00001
1234.5 | one thousand two hundred and thirty-four point five | one thousand two hundred thirty-four point five | 1,234.5
1e20 | one hundred quintillion | | 100,000,000,000,000,000,000
"""  # noqa: E501
ORDINALS = """
0 | zeroth | | 0th
1 | first | | 1st
2 | second | | 2nd
3 | third | | 3rd
4 | fourth | | 4th
5 | fifth | | 5th
8 | eighth | | 8th
9 | ninth | | 9th
11 | eleventh | | 11th
12 | twelfth | | 12th
13 | thirteenth | | 13th
20 | twentieth | | 20th
21 | twenty-first | | 21st
32 | thirty-second | | 32nd
43 | forty-third | | 43rd
100 | one hundredth | | 100th
101 | one hundred and first | one hundred first | 101st
111 | one hundred and eleventh | one hundred eleventh | 111th
112 | one hundred and twelfth | one hundred twelfth | 112th
1000 | one thousandth | | 1,000th
1002 | one thousand and second | one thousand second | 1,002nd
1000000 | one millionth | | 1,000,000th
-1 | minus first | | -1st
"""
# date | figures, British | American | words, British | American, if they are others
DATES = """
1862-07-04 | 4 July 1862 | July 4, 1862 | the fourth of July, eighteen sixty-two | July fourth, eighteen sixty-two
2005-01-31 | 31 January 2005 | January 31, 2005 | the thirty-first of January, two thousand and five | January thirty-first, two thousand five
2024-02-29 | 29 February 2024 | February 29, 2024 | the twenty-ninth of February, twenty twenty-four | February twenty-ninth, twenty twenty-four
--02-29 | 29 February | February 29 | the twenty-ninth of February | February twenty-ninth
--12-01 | 1 December | December 1 | the first of December | December first
1862-07 | July 1862 | | July eighteen sixty-two |
--07 | July | | July |
0005 | 5 | | five |
0476 | 476 | | four hundred and seventy-six | four hundred seventy-six
1000 | 1000 | | one thousand |
1066 | 1066 | | ten sixty-six |
1800 | 1800 | | eighteen hundred |
1900 | 1900 | | nineteen hundred |
1905 | 1905 | | nineteen oh five |
1910 | 1910 | | nineteen ten |
2000 | 2000 | | two thousand |
2005 | 2005 | | two thousand and five | two thousand five
2010 | 2010 | | twenty ten |
2026 | 2026 | | twenty twenty-six |
2100 | 2100 | | twenty-one hundred |
2105 | 2105 | | twenty-one oh five |
"""  # noqa: E501
IMPOSSIBLE = [
    (Date(), "the date lacks a month"),
    (Date(day=4), "the date lacks a month"),
    (Date(1862, day=4), "the date lacks a month"),
    (Date(month=13), "no calendar has month 13"),
    (Date(month=0), "no calendar has month 0"),
    (Date(month=2, day=31), "no calendar has month 2, day 31"),
    (Date(month=4, day=31), "no calendar has month 4, day 31"),
    (Date(month=4, day=0), "no calendar has month 4, day 0"),
    (Date(2023, 2, 29), "no calendar has year 2023, month 2, day 29"),
    (Date(1900, 2, 29), "no calendar has year 1900, month 2, day 29"),
    (Date(0), "no calendar has year 0"),
    (Date(10000, 1, 1), "no calendar has year 10000"),
    (Date(1862, 7, weekday=True), "a weekday needs a whole date"),
    (Date(month=7, day=4, weekday=True), "a weekday needs a whole date"),
]
# what is spoilt: by what | the fault
FAULTS = [
    ("hundred: hundred\n", "", "'hundred' is missing; add 'hundred: …'"),
    ("hundred: hundred", "hundred: 100", "expected text, found '100'"),
    ("Tuesday ", "", "'weekdays' has 6 words; write 7"),
    (" zero", " zero naught", "'units' has 21 words; write 20"),
    ("{day} {month}", "{day}", "'{day}' is no pattern for 'figures'; write {day} and {month} once"),
    ("{day} {month}", "{day} {month} {x}", "is no pattern for 'figures'"),
    ("minus: minus", "minus: minus\nmius: minus", "unknown field 'mius'; did you mean minus?"),
    ("  and: and", "  and: and\n  or: or", "unknown field 'or'"),
]
# Far-off numbers as well as a few thousand near ones.
NUMBERS = [
    *range(3300),
    *(10**power + more for power in range(3, 36) for more in (-1, 0, 1, 12, 100, 101)),
    *range(1, 10**9, 1234567),
]


def rows(table: str) -> list[list[str]]:
    return [[cell.strip() for cell in line.split("|")] for line in table.strip().splitlines()]


@pytest.mark.parametrize("row", rows(CARDINALS), ids=lambda row: str(row[0]))
def test_cardinal(row: list[str]) -> None:
    """A number reads as the table says, in both dialects and in figures."""
    number = float(row[0]) if "." in row[0] or "e" in row[0] else int(row[0])
    assert cardinal(number, BRITISH) == row[1]
    assert cardinal(number, AMERICAN) == (row[2] or row[1])
    assert cardinal(number, BRITISH, figures=True) == row[3]


@pytest.mark.parametrize("row", rows(ORDINALS), ids=lambda row: str(row[0]))
def test_ordinal(row: list[str]) -> None:
    """So does an ordinal."""
    assert ordinal(int(row[0]), BRITISH) == row[1]
    assert ordinal(int(row[0]), AMERICAN) == (row[2] or row[1])
    assert ordinal(int(row[0]), BRITISH, figures=True) == row[3]


def test_beyond_the_largest_scale() -> None:
    """What no scale word reaches is written in figures."""
    assert cardinal(10**36 - 1, BRITISH).startswith("nine hundred and ninety-nine decillion")
    assert cardinal(-(10**36), BRITISH) == "-1" + ",000" * 12
    assert ordinal(10**36 + 1, BRITISH) == "1" + ",000" * 11 + ",001st"


@pytest.mark.parametrize("number", [float("nan"), float("inf"), float("-inf")])
def test_no_number(number: float) -> None:
    """What is no finite number is refused."""
    with pytest.raises(PersonageError, match="cannot be said; give a finite number"):
        cardinal(number, BRITISH)


@pytest.mark.parametrize("row", rows(DATES), ids=lambda row: str(row[0]))
def test_date(row: list[str]) -> None:
    """A date reads as the table says, in both dialects, and as ISO writes it."""
    year, *rest = row[0].removeprefix("--").split("-")
    parts = [None, int(year), *map(int, rest)] if row[0][0] == "-" else [int(year), *map(int, rest)]
    date = Date(*parts)
    assert date_text(date, BRITISH) == row[1]
    assert date_text(date, AMERICAN) == (row[2] or row[1])
    assert date_text(date._replace(style="words"), BRITISH) == row[3]
    assert date_text(date._replace(style="words"), AMERICAN) == (row[4] or row[3])
    assert date_text(date._replace(style="iso"), BRITISH) == row[0]


def test_weekday() -> None:
    """A whole date may begin with its weekday, except in ISO."""
    date = Date(1862, 7, 4, weekday=True)
    assert date_text(date, BRITISH) == "Friday, 4 July 1862"
    assert date_text(date, AMERICAN) == "Friday, July 4, 1862"
    said = date_text(date._replace(style="words"), BRITISH)
    assert said == "Friday, the fourth of July, eighteen sixty-two"
    assert date_text(date._replace(style="iso"), BRITISH) == "1862-07-04"


@given(st.dates())
def test_any_weekday(day: datetime.date) -> None:
    """Every day of the calendar has its own weekday, and ISO is its own form."""
    date = Date(day.year, day.month, day.day, weekday=True)
    name = date_text(date, BRITISH).partition(",")[0]
    assert BRITISH.weekdays.index(name) == day.weekday()
    assert date_text(date._replace(style="iso"), BRITISH) == day.isoformat()


@pytest.mark.parametrize(("date", "fault"), IMPOSSIBLE)
@pytest.mark.parametrize("style", ["figures", "words", "iso"])
def test_impossible_date(date: Date, fault: str, style: Any) -> None:
    """What no calendar has is refused, with a remedy."""
    with pytest.raises(PersonageError, match=f"^{fault}.*; give "):
        date_text(date._replace(style=style), BRITISH)


@pytest.mark.parametrize(("old", "new", "fault"), FAULTS)
def test_spoilt_file(old: str, new: str, fault: str) -> None:
    """A fault in the file names the line and a remedy, whatever the dialect."""
    assert old in CONTENT
    for dialect in ("british", "american"):
        with pytest.raises(DataError, match=r"^numerals.yaml:\d+: ") as error:
            read(dialect, CONTENT.replace(old, new, 1))
        assert fault in str(error.value)


@given(st.integers(), st.sampled_from([BRITISH, AMERICAN]))
def test_any_number(number: int, words: NumberWords) -> None:
    """Figures read back; another number is said otherwise."""
    assert int(cardinal(number, words, figures=True).replace(",", "")) == number
    assert int(ordinal(number, words, figures=True).replace(",", "")[:-2]) == number
    assert cardinal(number, words) != cardinal(number + 1, words)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_any_float(number: float) -> None:
    """So do decimals."""
    assert float(cardinal(number, BRITISH, figures=True).replace(",", "")) == number
    assert cardinal(number, BRITISH)


def test_agrees_with_num2words() -> None:
    """num2words says the same, but for its commas, and its "oh-" and short years below 1000."""
    say: Any = pytest.importorskip("num2words").num2words
    for number in NUMBERS:
        assert cardinal(number, BRITISH) == say(number).replace(",", "")
        assert cardinal(-number, BRITISH) == say(-number).replace(",", "")
        assert ordinal(number, BRITISH) == say(number, to="ordinal").replace(",", "")
        figures = ordinal(number, BRITISH, figures=True).replace(",", "")
        assert figures == say(number, to="ordinal_num")
    for year in range(1000, 10000):
        theirs = say(year, to="year").replace("oh-", "oh ")
        assert date_text(Date(year, style="words"), BRITISH) == theirs


def test_agrees_with_pyrealb() -> None:
    """So does pyrealb, below the "quatrillion" it misspells.

    It says "and" only here and there, which is compared away, and has no ordinal of 0.
    """
    pyrealb: Any = pytest.importorskip("pyrealb")
    pyrealb.loadEn()
    for number in (number for number in NUMBERS if number < 10**15):
        for how, said in (("nat", cardinal), ("ord", ordinal)):
            theirs = pyrealb.NO(number).dOpt({how: True}).realize().replace(" and ", " ")
            assert said(number, AMERICAN) == theirs or (number, how) == (0, "ord")
