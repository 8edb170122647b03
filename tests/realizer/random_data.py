"""Random data that nearly fits the specification's types, for the reader and its schema."""

from __future__ import annotations

from random import Random
from typing import Any

from personage_lite.realizer import Clause, Date, Numeral
from personage_lite.realizer.types import FIELDS, MARKS, choices, item_type, options

WORDS = ("cat", "a", "the", "go", "be", "who", "very", "and", "no", "Alice", "it's", "…", "auto")
ODD: tuple[Any, ...] = (
    None,
    True,
    0,
    -1,
    3,
    10**25,
    1.5,
    -2.5,
    "",
    " ",
    "x" * 99,
    [],
    {},
    [[]],
    {"noun": "a"},
)


class RandomData:
    """Makes data that nearly fits the specification's types."""

    def __init__(self, seed: int, odd: float) -> None:
        self.rng = Random(seed)
        self.odd = odd

    def value(self, hint: Any, depth: int) -> Any:
        """Return a value of a type, or now and then any other."""
        if self.rng.random() < self.odd:
            return self.rng.choice(ODD)
        able = list(options(hint))
        if depth <= 0:
            able = [option for option in able if option not in FIELDS] or able
        option = self.rng.choice(able)
        if choices(option):
            return self.rng.choice(choices(option))
        if item_type(option) is not None:
            items = range(self.rng.randint(1, 2))
            return [self.value(item_type(option), depth - 1) for _ in items]
        if option in FIELDS:
            return self.mapping(option, depth)
        return {
            str: self.rng.choice(WORDS),
            bool: self.rng.random() < 0.5,
            int: self.rng.randint(-1, 40),
            float: self.rng.choice((0.5, 2.0, 1e6, 3.25)),
        }.get(option)

    def mapping(self, kind: Any, depth: int) -> dict[str, Any]:
        """Return a mapping with the fields that a type needs, and some others."""
        if kind is Numeral or kind is Date:
            return {"value": self.rng.randint(1, 99)}
        needed = set(MARKS[kind][:1]) | {
            name for name in FIELDS[kind] if name not in kind._field_defaults
        }
        if kind is Clause and self.rng.random() < 0.8:
            needed.add("subject")
        found = {
            name: self.value(hint, depth - 1)
            for name, hint in FIELDS[kind].items()
            if name in needed or self.rng.random() < 0.12
        }
        if self.rng.random() < self.odd:
            found[self.rng.choice(("verb", "noun", "x", "items", "", "<<"))] = "cat"
        return {name: value for name, value in found.items() if value is not None or self.odd}
