"""Thousands of specifications said by our realizer and by pyrealb: where they differ, and why.

`python -m tests.realizer.pyrealb_comparison` prints the counts and each class of differences.
pyrealb is a second opinion, not the truth: pyrealb_differences.yaml says for each class who is
right. A class is found by mending: its rule rewrites pyrealb's text in that one point, and a
difference is explained if the rules together turn pyrealb's text into ours, letter by letter.
"""

from __future__ import annotations

import contextlib
import io
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from personage_lite.realizer.files import read_data
from tests.realizer.pyrealb_grid import GRID, read_words
from tests.realizer.pyrealb_rules import RULES, Pair, Rule, listed
from tests.realizer.pyrealb_translation import ours, theirs

FILE = Path(__file__).with_name("pyrealb_differences.yaml")
WHO = ("ours", "both", "not comparable", "theirs")


class Review(NamedTuple):
    """What was found of one class of differences."""

    who: str
    why: str
    # our text and pyrealb's
    example: tuple[str, str]
    # pyrealb's words with ours, where the class is about single words
    words: dict[str, str]


class Comparison(NamedTuple):
    """What came out; a pair that differs in several points is in several classes."""

    pairs: list[Pair]
    classes: dict[str, list[Pair]]
    unexplained: list[Pair]

    @property
    def differing(self) -> list[Pair]:
        """Return the pairs whose texts differ."""
        return [pair for pair in self.pairs if pair.ours != pair.theirs]


@cache
def _data() -> dict[str, Any]:
    found: dict[str, Any] = read_data(str(FILE))
    return found


def reviews() -> dict[str, Review]:
    """Return the reviewed classes by id."""
    return {
        name: Review(
            row["who"],
            row["why"],
            (row["example"][0], row["example"][1]),
            dict(_two(words) for words in row.get("words", "").split()),
        )
        for name, row in _data()["classes"].items()
    }


def _two(words: str) -> tuple[str, str]:
    its, mine = words.replace("_", " ").split("/")
    return its, mine


def compare() -> Comparison:
    """Return all pairs with the classes of those that differ; pyrealb's warnings stay unsaid."""
    rules = {**RULES, **{name: listed(row.words) for name, row in reviews().items() if row.words}}
    found = Comparison([], {name: [] for name in rules}, [])
    with contextlib.redirect_stderr(io.StringIO()):
        found.pairs.extend(_pairs())
    for pair in found.differing:
        names, text = _explain(pair, rules)
        if text != pair.ours:
            found.unexplained.append(pair)
        else:
            for name in names:
                found.classes[name].append(pair)
    return found


def _pairs() -> Iterator[Pair]:
    words = read_words(_data())
    for part, described in GRID.items():
        for said in described(words):
            yield Pair(part, said, ours(said), theirs(said))


def _explain(pair: Pair, rules: dict[str, Rule]) -> tuple[list[str], str]:
    """Return the classes that a pair is in, and pyrealb's text mended by their rules."""
    names, text = [], pair.theirs
    for name, rule in rules.items():
        mended = rule(pair, text)
        if mended != text:
            names.append(name)
            text = mended
    return names, text


def main() -> None:
    """Print the counts and every class with its example."""
    found, reviewed = compare(), reviews()
    differing = Counter(pair.part for pair in found.differing)
    total = len(found.pairs)
    equal = total - differing.total()
    print(f"{total} pairs, {equal} equal ({100 * equal / total:.1f} %)")
    for part, count in Counter(pair.part for pair in found.pairs).items():
        print(f"  {part}: {count} pairs, {differing[part]} differ")
    for who in WHO:
        members = {name: row for name, row in reviewed.items() if row.who == who}
        said = {pair for name in members for pair in found.classes.get(name, ())}
        print(f"\n{who}: {len(said)} pairs in {len(members)} classes")
        for name, row in members.items():
            print(f"  {len(found.classes.get(name, ())):4} {name}: {row.why}")
            print(f"       ours: {row.example[0]}  pyrealb: {row.example[1]}")
    print(f"\nnot explained: {len(found.unexplained)}")
    for pair in found.unexplained:
        print(f"  ours: {pair.ours}  pyrealb: {pair.theirs}")


if __name__ == "__main__":
    main()
