"""Proves that the JSON Schema of specification files says what the reader does."""

from __future__ import annotations

import json
from pathlib import Path
from types import NoneType
from typing import Any

import pytest

from personage_lite.realizer.reader import read_specification
from personage_lite.realizer.schema import schema, schema_text
from personage_lite.realizer.types import FIELDS, MARKS, choices, item_type, options, required
from tests.realizer.bad_specifications import BAD, BLANKS, UNSAID, Bad
from tests.realizer.random_data import RandomData
from tests.realizer.reader_helpers import (
    CASE_FILES,
    EVERY_FIELD,
    FIELD_IDS,
    case_specs,
    data_of,
    takes,
)

jsonschema = pytest.importorskip("jsonschema")
SCHEMA = schema()
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
# What a JSON Schema cannot say, and the reader refuses: that a whole number has no point (1.0 is
# one to JSON Schema), equal keys, what contains itself (JSON cannot), and more than 64 levels.
# Nor does it know what cannot be said: a missing subject, a doubled role, a day that never was.
INEXPRESSIBLE = [bad for bad in BAD if not bad.expressible]


def test_it_is_a_valid_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert SCHEMA["$schema"] == "https://json-schema.org/draft/2020-12/schema"


def test_its_text_is_the_schema() -> None:
    assert json.loads(schema_text()) == json.loads(json.dumps(SCHEMA))
    assert schema() == SCHEMA


def test_every_reference_leads_somewhere() -> None:
    """And every definition is used."""
    names = set()

    def walk(part: Any) -> None:
        if isinstance(part, dict):
            if isinstance(part.get("$ref"), str):
                names.add(part["$ref"].removeprefix("#/$defs/"))
            for inner in part.values():
                walk(inner)
        elif isinstance(part, list):
            for inner in part:
                walk(inner)

    walk(SCHEMA)
    assert names == set(SCHEMA["$defs"])


@pytest.mark.parametrize("path", CASE_FILES, ids=lambda path: str(path.stem))
def test_it_accepts_every_case(path: Path) -> None:
    for spec in case_specs(path):
        assert VALIDATOR.is_valid(spec), spec


def test_it_accepts_every_shape_of_file() -> None:
    for data in (
        "a cat",
        ["a cat"],
        [["a", "cat"], {"noun": "cat"}],
        {"sentences": "a cat"},
        {"sentences": ["a cat", {"noun": "cat"}], "shared": {"any": [None, 1]}},
        {"shared": None, "sentences": [["a", {"phrase": {"noun": "cat"}, "case": "possessive"}]]},
    ):
        assert VALIDATOR.is_valid(data), data


@pytest.mark.parametrize(
    "bad", [bad for bad in BAD if bad.expressible], ids=lambda bad: json.dumps(bad.data)[:60]
)
def test_it_rejects_what_the_reader_rejects(bad: Bad) -> None:
    assert not VALIDATOR.is_valid(bad.data)


def test_what_it_cannot_say_is_little() -> None:
    assert len(INEXPRESSIBLE) == 2
    for bad in INEXPRESSIBLE:
        assert VALIDATOR.is_valid(bad.data), "it can say this: remove the mark"
    for bad in UNSAID:
        assert VALIDATOR.is_valid(bad.data) or "stutter" in bad.data or not bad.data, bad.data
    for data in BLANKS:
        json.dumps(data)


@pytest.mark.parametrize(("kind", "name"), EVERY_FIELD, ids=FIELD_IDS)
def test_it_rejects_every_wrong_type(kind: Any, name: str) -> None:
    """For each field the schema takes exactly the values that the reader takes."""
    least, embed, _ = data_of(kind)
    assert VALIDATOR.is_valid(embed(least))
    values: tuple[Any, ...] = (
        *(None, True, 7, 1.5, "zz", [], ["zz"], [7], {}, {"zz": 1}, [[]]),
        *(["subject"], {"noun": "a"}, {"verb": "go"}),
    )
    for value in values:
        data = embed({**least, name: value})
        try:
            read_specification(data)
        except Exception:
            assert not VALIDATOR.is_valid(data), value
        else:
            assert VALIDATOR.is_valid(data), value
    assert not VALIDATOR.is_valid(embed({**least, f"{name}x": 1}))
    if name in required(kind):
        del least[name]
        assert not VALIDATOR.is_valid(embed(least))


@pytest.mark.parametrize("odd", [0.0, 0.05], ids=["right", "nearly right"])
def test_it_agrees_with_the_reader_on_random_data(odd: float) -> None:
    for seed in range(150):
        random = RandomData(seed, odd)
        data = random.mapping(random.rng.choice(list(FIELDS)[:4]), 3)
        try:
            read_specification(data)
            right = True
        except Exception:
            right = False
        assert VALIDATOR.is_valid(data) == right, data


@pytest.mark.parametrize("kind", FIELDS, ids=lambda kind: str(kind.__name__))
def test_every_type_and_field_is_there(kind: Any) -> None:
    """With its description, what it cannot do without, and its defaults."""
    made = SCHEMA["$defs"][kind.__name__]
    assert made["type"] == "object"
    assert made["additionalProperties"] is False
    assert list(made["properties"]) == list(kind._fields) == list(FIELDS[kind])
    assert made.get("required", []) == [
        name for name in kind._fields if name not in kind._field_defaults
    ]
    if not made.get("required"):
        assert made["anyOf"] == [{"required": [mark]} for mark in MARKS[kind]]
    first = (kind.__doc__ or "").split(".")[0].split(":")[0].split()
    assert made["description"].split()[: len(first) - 1] == first[:-1]
    for name, default in kind._field_defaults.items():
        found = made["properties"][name]
        if default is None or default == ():
            # What is left out is not there: no default that could be written says so.
            assert found.get("default") in (None, [])
        else:
            assert found["default"] == default
            assert type(found["default"]) is type(default)
            assert takes(FIELDS[kind][name], found["default"])
            inner = {key: value for key, value in found.items() if key != "default"}
            field = jsonschema.Draft202012Validator({**inner, "$defs": SCHEMA["$defs"]})
            assert field.is_valid(default)
    for name in required(kind):
        assert "default" not in made["properties"][name]


@pytest.mark.parametrize(("kind", "name"), EVERY_FIELD, ids=FIELD_IDS)
def test_every_value_of_a_choice_is_there(kind: Any, name: str) -> None:
    found = json.dumps(SCHEMA["$defs"][kind.__name__]["properties"][name])
    for option in options(FIELDS[kind][name]):
        inner = item_type(option)
        for value in choices(option) or (choices(inner) if inner is not None else ()):
            assert json.dumps(value) in found
        if option is NoneType:
            assert '"null"' in found
