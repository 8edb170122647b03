"""Proves that no entry of the inflection's tables is idle, and that a fault names its line."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from personage_lite.errors import DataError
from personage_lite.realizer.inflection import Inflection, read_inflection
from personage_lite.realizer.words import (
    countability,
    inflect_adjective,
    inflect_verb,
    pluralize,
    spell,
)
from personage_lite.yaml_reader import parse_yaml
from tests.realizer.word_helpers import BRITISH, DEGREES, FILE, FORMS, INFLECTIONS


def test_spelling_is_settled_at_once() -> None:
    """A word spelt once is spelt: no pair leads to another."""
    for inflection in INFLECTIONS.values():
        for word in (*inflection.spellings, *inflection.spellings.values()):
            once = spell(word, inflection)
            assert spell(once, inflection) == once


def _verb_forms(lemma: str, inflection: Inflection) -> list[str]:
    return [inflect_verb(lemma, form, inflection) for form in FORMS]


def _plurals(noun: str, inflection: Inflection) -> list[str]:
    return [pluralize(noun, inflection), pluralize(noun[0].upper() + noun[1:], inflection)]


def _degrees(word: str, inflection: Inflection) -> list[str]:
    return [inflect_adjective(word, degree, inflection) for degree in DEGREES]


# The table, and what it serves
SERVES: dict[str, Callable[[str, Inflection], list[str]]] = {
    "verbs": _verb_forms,
    "third_person": _verb_forms,
    "gerunds": _verb_forms,
    "doubling": _verb_forms,
    "not_doubling": _verb_forms,
    "o_es": lambda word, inflection: [
        *_verb_forms(word, inflection),
        pluralize(word, inflection),
    ],
    "plurals": _plurals,
    "degrees": _degrees,
    "with_er": _degrees,
    "with_more": _degrees,
    "countability": lambda word, inflection: [countability(word, inflection)],
}


@pytest.mark.parametrize("table", SERVES)
def test_no_entry_is_idle(table: str) -> None:
    """What the rules would give anyway, in both dialects, has no place in the tables."""
    forms = SERVES[table]
    idle = []
    for word in getattr(BRITISH, table):
        if table == "countability" and BRITISH.countability[word] != "countable":
            continue  # it serves the plural too
        if all(
            forms(word, each) == forms(word, _without(word, table, each))
            for each in INFLECTIONS.values()
        ):
            idle.append(word)
    # What is uncountable, or a compound's last part, has its place elsewhere.
    named = BRITISH.countability.keys() | BRITISH.compounds.keys()
    assert [word for word in idle if table != "plurals" or word not in named] == []


def _without(word: str, table: str, inflection: Inflection) -> Inflection:
    entries: Any = getattr(inflection, table)
    if isinstance(entries, frozenset):
        less: Any = entries - {word}
    else:
        less = {key: value for key, value in entries.items() if key != word}
    changed: dict[str, Any] = {table: less}
    return inflection._replace(**changed)


def _line_of(text: str, start: str) -> int:
    return text[: text.index(start)].count("\n") + 1


# What is replaced, by what, the line that the message names (by its beginning), and the message
FAULTS = (
    ("  take took taken\n", "  take\n", "  take\n", "'take' has 1 words; write 2 to 3 words"),
    ("  take took taken\n", "  take a b c\n", "  take a", "'take a b c' has 4 words; write 2 to 3"),
    ("  ox oxen\n", "  ox oxen s\n", "  ox oxen s", "'ox oxen s' has 3 words; write 2 words"),
    (
        "  ox oxen\n",
        "  ox oxen/\n",
        "  ox oxen/",
        "has more or less than a word beside each slash; write British/Am",
    ),
    (
        "  ox oxen\n",
        "  ox oxen\n  ox oxes\n",
        "  ox oxes",
        "'ox' stands in 'irregular_plurals' twice",
    ),
    (
        "third_person: |\n",
        "third_persons: |\n",
        "irregular_verbs",
        "'third_person' is missing; add",
    ),
    ("pairs: |\n", "twins: |\n", "irregular_verbs", "'pairs' is missing; add 'pairs: …'"),
    ("with_er: |\n", "with: |\n  x\nwith_er: |\n", "with: |", "unknown field 'with'; did you mean"),
    ("  be is\n", "", None, None),
)


@pytest.mark.parametrize(("old", "new", "place", "message"), FAULTS)
def test_fault_names_its_line(old: str, new: str, place: str | None, message: str | None) -> None:
    """A bad line is named with its own number and a remedy."""
    text = FILE.read_text(encoding="utf-8")
    assert old in text
    text = text.replace(old, new)
    if place is None:
        read_inflection(parse_yaml(text, "x.yaml"))
        return
    with pytest.raises(DataError) as caught:
        read_inflection(parse_yaml(text, "x.yaml"))
    assert str(message) in str(caught.value)
    assert caught.value.line == _line_of(text, place)


def test_table_that_is_no_block() -> None:
    """A table on one line would be read as one entry."""
    text = FILE.read_text(encoding="utf-8")
    start = text.index("gerunds: |")
    end = text.index("\n\n", start)
    text = text[:start] + "gerunds: age ageing" + text[end:]
    with pytest.raises(DataError, match=r"'gerunds' is not a block of lines; write"):
        read_inflection(parse_yaml(text, "x.yaml"))
