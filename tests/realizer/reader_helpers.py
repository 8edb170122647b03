"""Reads data as specification files for the tests of the reader, and has data of every type."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

from personage_lite import english
from personage_lite.errors import PersonageError
from personage_lite.realizer import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Date,
    Embedded,
    Joined,
    NounPhrase,
    Numeral,
    Opener,
    PrepositionalPhrase,
    Question,
    Quotation,
    Relative,
    Sentence,
    SpecificationError,
    Subordinate,
    Text,
)
from personage_lite.realizer.files import read_data, realize_file
from personage_lite.realizer.reader import read_specification
from personage_lite.realizer.types import FIELDS, choices, item_type, options
from tests.mutation import check_message
from tests.realizer.case_list import FOLDER

REALIZER = english()
CASE_FILES = sorted(FOLDER.glob("*.yaml"))
KINDS: tuple[Any, ...] = tuple(FIELDS)
EVERY_FIELD = [(kind, name) for kind, fields in FIELDS.items() for name in fields]
FIELD_IDS = [f"{kind.__name__}.{name}" for kind, name in EVERY_FIELD]
# What the realizer says of a fault that nobody foresaw: no user can do anything with it.
UNFORESEEN = "this cannot be said ("


def case_specs(path: Path) -> list[Any]:
    """Return the plain data of each specification in a file of cases."""
    return [row["spec"] for rows in read_data(str(path))["groups"].values() for row in rows]


def say(content: str, name: str = "spec.yaml") -> list[str]:
    """Return the texts of a file's content."""
    return realize_file(content, name, REALIZER)


def refusal(content: str, name: str = "spec.yaml") -> str:
    """Return the message of a file that is refused, which is one line with a remedy."""
    with pytest.raises(PersonageError) as caught:
        say(content, name)
    check_message(caught.value)
    message = str(caught.value)
    assert message.startswith(f"{name}:"), message
    assert UNFORESEEN not in message, message
    return message


def read_or_refused(content: str, name: str) -> None:
    """Require clean texts, or an error that names the file."""
    message = ""
    try:
        texts = say(content, name)
    except PersonageError as error:
        check_message(error)
        message = str(error)
    if message:
        assert message.startswith(f"{name}:"), message
        assert UNFORESEEN not in message, message
    else:
        assert all(clean(text) for text in texts), [text for text in texts if not clean(text)]


def heard(spec: Any) -> str:
    """Return the text of a specification, or why it is refused."""
    try:
        return REALIZER.realize(spec)
    except SpecificationError as error:
        check_message(error)
        if UNFORESEEN in str(error):
            raise AssertionError(str(error)) from None
        return f"refused: {error}"


def flow(data: object) -> str:
    """Return data as YAML that is not taken for JSON."""
    return "---\n" + json.dumps(data)


def block(data: object) -> str:
    """Return data as YAML in lines."""
    return "---\n" + yaml.safe_dump(data, sort_keys=False, allow_unicode=True)


def clean(text: str) -> bool:
    """Whether a text is one line of words, without a blank too many."""
    broken = "  " in text or len(text.splitlines()) > 1 or any(sign < " " for sign in text)
    return bool(text) and text == text.strip() and not broken


def made(data: Any) -> Any:
    """Return the specification of plain data."""
    return read_specification(data)


def data_of(kind: Any) -> tuple[dict[str, Any], Callable[[Any], Any], str]:
    """Return the least data of a type, what puts it into a specification, and the path there."""
    clause = {"verb": "go", "subject": "a"}
    holders: dict[Any, tuple[dict[str, Any], Callable[[Any], Any], str]] = {
        Sentence: ({"body": "a"}, lambda data: data, ""),
        Clause: (dict(clause), lambda data: data, ""),
        NounPhrase: ({"noun": "a"}, lambda data: data, ""),
        AdjectivePhrase: ({"adjective": "a"}, lambda data: data, ""),
        PrepositionalPhrase: ({"preposition": "in", "object": "a"}, lambda data: data, ""),
        Coordination: ({"items": ["a"]}, lambda data: data, ""),
        Embedded: ({"lead": "a", "clause": clause}, lambda data: data, ""),
        Cased: ({"phrase": {"noun": "a"}}, lambda data: {"parts": [data]}, "parts[0]."),
        Text: ({"parts": ["a"]}, lambda data: data, ""),
        Numeral: ({"value": 1}, lambda data: data, ""),
        Date: ({"year": 2000}, lambda data: data, ""),
        Quotation: ({"speech": "a"}, lambda data: {**clause, "quotation": data}, "quotation."),
        Question: (
            {"phrase": "who"},
            lambda data: {"verb": "go", "mood": "interrogative", "question": data},
            "question.",
        ),
        Relative: (
            {"clause": {"verb": "go"}},
            lambda data: {"noun": "a", "relative": data},
            "relative.",
        ),
        Subordinate: (
            {"conjunction": "if", "clause": clause},
            lambda data: {**clause, "subordinates": [data]},
            "subordinates[0].",
        ),
        Joined: (
            {"conjunction": "and", "body": clause},
            lambda data: {"body": clause, "joined": [data]},
            "joined[0].",
        ),
        Opener: ({"text": "Oh"}, lambda data: {"body": "a", "openers": [data]}, "openers[0]."),
    }
    return holders[kind]


def takes(hint: Any, value: object) -> bool:
    """Whether a field of a type takes a plain value, as the reader should see it."""
    for option in options(hint):
        if choices(option):
            if any(value == each and type(value) is type(each) for each in choices(option)):
                return True
        elif item_type(option) is not None:
            if isinstance(value, list) and all(takes(item_type(option), each) for each in value):
                return True
        elif option is Text:
            if isinstance(value, str) or (
                isinstance(value, list)
                and value
                and all(takes(FIELDS[Text]["parts"], [each]) for each in value)
            ):
                return True
        elif type(value) is option or (option is float and type(value) is int):
            return True
    return False
