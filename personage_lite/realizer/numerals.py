"""Numbers, ordinals and dates, in words or in figures.

>>> from personage_lite.data import data_folder
>>> from personage_lite.yaml_reader import read_yaml
>>> words = read_numerals(read_yaml(data_folder("lexicons") + "/numerals.yaml"))
>>> cardinal(101, words), cardinal(2.5, words), cardinal(1000000, words, figures=True)
('one hundred and one', 'two point five', '1,000,000')
>>> ordinal(21, words), ordinal(112, words, figures=True)
('twenty-first', '112th')
>>> date_text(Date(1862, 7, 4, weekday=True), words)
'Friday, 4 July 1862'
"""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from math import isfinite
from typing import Literal, NamedTuple

from personage_lite.errors import PersonageError, shown
from personage_lite.realizer.features import checked
from personage_lite.yaml_reader import Node

# What each pattern of a date puts together.
_DAY, _YEAR = ("day", "month"), ("date", "year")
_PATTERNS = (
    *(("figures", _DAY), ("words", _DAY), ("figures_year", _YEAR), ("words_year", _YEAR)),
    *(("month_year", ("month", "year")), ("with_weekday", ("weekday", "date"))),
)


class NumberWords(NamedTuple):
    """The words of numbers and dates, and the ways of a dialect; never changed after loading."""

    units: tuple[str, ...]
    tens: tuple[str, ...]
    scales: tuple[str, ...]
    limit: int  # the first number that the scales cannot say
    ordinals: dict[str, str]  # the last word of a cardinal: of its ordinal
    months: tuple[str, ...]
    weekdays: tuple[str, ...]
    hundred: str
    ordinal_ending: str
    minus: str
    point: str
    oh: str
    link: str  # between hundreds and the rest: " and " or a blank
    patterns: dict[str, str]  # how the parts of a date stand together


@checked(style=Literal["figures", "words", "iso"])
class Date(NamedTuple):
    """A day, a month, a year, or what is known of them; ISO dates show no weekday."""

    year: int | None = None
    month: int | None = None
    day: int | None = None
    weekday: bool = False
    style: Literal["figures", "words", "iso"] = "figures"


def read_numerals(node: Node, dialect: Literal["british", "american"] = "british") -> NumberWords:
    """Read the numerals file for one dialect; every fault (`DataError`) names its line."""
    units, tens = _words(node, "units", 20), _words(node, "tens", 8)
    ordinals = (*_words(node, "unit_ordinals", 20), *_words(node, "ten_ordinals", 8))
    of_cardinals = dict(zip(units + tens, ordinals, strict=True))
    scales = _words(node, "scales")
    months, weekdays = _words(node, "months", 12), _words(node, "weekdays", 7)
    keys = ("hundred", "ordinal_ending", "minus", "point", "oh")
    hundred, ending, minus, point, oh = (node.need(key).text() for key in keys)
    links, patterns = {}, {}
    for name in ("british", "american"):  # Both are read: a fault in either is a fault.
        ways = node.need(name)
        links[name] = f" {ways.text_of('and')} ".replace("  ", " ")
        patterns[name] = {key: _pattern(ways, key, places) for key, places in _PATTERNS}
        ways.done()
    node.done()
    return NumberWords(
        *(units, tens, scales, int(1000 ** (len(scales) + 1)), of_cardinals, months, weekdays),
        *(hundred, ending, minus, point, oh, links[dialect], patterns[dialect]),
    )


def _words(node: Node, key: str, count: int = 0) -> tuple[str, ...]:
    """Return the words under `key`, which must be `count`, if that is given."""
    block = node.need(key)
    found = tuple(block.text().split())
    if count and len(found) != count:
        raise block.fault(f"'{key}' has {len(found)} words", f"write {count}, with blanks between")
    return found


def _pattern(node: Node, key: str, places: tuple[str, str]) -> str:
    """Return the text under `key`, which must hold each place once and no other."""
    found = node.need(key)
    text = found.text()
    if any(text.count(f"{{{x}}}") != 1 for x in places) or text.count("{") + text.count("}") != 4:
        remedy = f"write {{{places[0]}}} and {{{places[1]}}} once each"
        raise found.fault(f"'{text}' is no pattern for '{key}'", remedy)
    return text


def cardinal(number: int | float, words: NumberWords, figures: bool = False) -> str:
    """Return a number in words, or in figures; beyond the largest scale always in figures."""
    text = _figures(number)
    whole, _, decimals = text.lstrip("-").replace(",", "").partition(".")
    if figures or int(whole) >= words.limit:
        return text
    said = [words.minus] if number < 0 else []
    after = [words.point, *(words.units[int(figure)] for figure in decimals)] if decimals else []
    return " ".join((*said, _said(int(whole), words), *after))


def ordinal(number: int, words: NumberWords, figures: bool = False) -> str:
    """Return an ordinal in words, or in figures; beyond the largest scale always in figures."""
    if number != int(number):
        raise PersonageError(f"{number} is no place in a row; give a whole number")
    if figures or abs(number) >= words.limit:
        # The mark is the end of the word: first, 1st.
        return f"{number:,}{ordinal(abs(number) % 100, words)[-2:]}"
    said = cardinal(number, words)
    start = max(said.rfind(" "), said.rfind("-")) + 1
    return said[:start] + words.ordinals.get(said[start:], said[start:] + words.ordinal_ending)


def date_text(date: Date, words: NumberWords) -> str:
    """Return a date as it is written or said, with those parts that it has.

    Raises `PersonageError` for a date that no calendar has. Weekdays are Gregorian.
    """
    name = words.weekdays[_weekday(date)]
    year, month, day, weekday, style = date
    if style not in ("figures", "words", "iso"):
        raise PersonageError(f"'{shown(str(style))}' is no style; write figures, words or iso")
    if style == "iso":
        first = "-" if year is None else f"{year:04}"
        return "-".join((first, *(f"{part:02}" for part in (month, day) if part)))
    said = "" if year is None else _year(year, words) if style == "words" else str(year)
    if month is None:
        return said
    text = words.months[month - 1]
    if day is None:
        return words.patterns["month_year"].format(month=text, year=said) if said else text
    figure = ordinal(day, words) if style == "words" else str(day)
    text = words.patterns[style].format(day=figure, month=text)
    if year is None:
        return text
    text = words.patterns[style + "_year"].format(date=text, year=said)
    return words.patterns["with_weekday"].format(weekday=name, date=text) if weekday else text


def _figures(number: int | float) -> str:
    """Return a number in figures: 1,000,000; -3.5; 2 for 2.0."""
    if isinstance(number, float):
        if not isfinite(number):
            raise PersonageError(f"{number} cannot be said; give a finite number")
        if number != int(number):
            from decimal import Decimal  # imported here: such numbers are rare

            return f"{Decimal(repr(number)):,f}"
    return f"{int(number):,}"


def _said(number: int, words: NumberWords) -> str:
    """Return a whole number from 0 in words."""
    if number < 20:
        return words.units[number]
    if number < 100:
        ten, unit = words.tens[number // 10 - 2], number % 10
        return f"{ten}-{words.units[unit]}" if unit else ten
    step = (len(str(number)) - 1) // 3
    size, name = (1000**step, words.scales[step - 1]) if step else (100, words.hundred)
    count, rest = divmod(number, size)
    text = f"{_said(count, words)} {name}"
    return text + (words.link if rest < 100 else " ") + _said(rest, words) if rest else text


def _year(year: int, words: NumberWords) -> str:
    """Return a year as it is said: in twos from 1000 on, except two thousand (and five)."""
    century, rest = divmod(year, 100)
    if year < 1000 or (century % 10 == 0 and rest < 10):
        return _said(year, words)
    last = f"{words.oh} {words.units[rest]}" if 0 < rest < 10 else _said(rest, words)
    return f"{_said(century, words)} {last if rest else words.hundred}"


def _weekday(date: Date) -> int:
    """Return the weekday of a date, 0 for Monday; raise `PersonageError` for what is no date."""
    from datetime import date as calendar  # imported here: most texts hold no date

    year, month, day, weekday, _ = date
    if weekday and None in date:
        raise PersonageError("a weekday needs a whole date; give year, month and day")
    if month is None and (year is None or day is not None):
        raise PersonageError("the date lacks a month; give a month, a month and a day, or a year")
    try:
        # What is not known is filled in from a year that has a 29 February.
        known = zip((year, month, day), (2000, 1, 1), strict=True)
        return calendar(*(default if part is None else part for part, default in known)).weekday()
    except (ValueError, OverflowError):
        parts = (("year", year), ("month", month), ("day", day))
        given = ", ".join(f"{name} {part}" for name, part in parts if part is not None)
        raise PersonageError(f"no calendar has {given}; give a date of the years 1-9999") from None
