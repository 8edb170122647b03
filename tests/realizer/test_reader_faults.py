"""Proves that wrong fields, types and values of a specification are refused, each with its path.

Whatever is wrong is one line that names the file, the path inside it and a remedy; the same in
JSON, in YAML and in data. So it is with what reads and cannot be said.
"""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from personage_lite.errors import PersonageError
from personage_lite.realizer.reader import MisreadError, read_specification
from personage_lite.realizer.types import FIELDS
from tests.mutation import check_message
from tests.realizer.bad_specifications import BAD, BLANKS, UNSAID, Bad
from tests.realizer.reader_helpers import (
    EVERY_FIELD,
    FIELD_IDS,
    block,
    clean,
    data_of,
    flow,
    read_or_refused,
    refusal,
    say,
    takes,
)


@pytest.mark.parametrize("bad", BAD, ids=lambda bad: json.dumps(bad.data)[:60])
def test_bad_specifications(bad: Bad) -> None:
    """Each is refused as JSON, as YAML and as data, with the same path."""
    path = f"{bad.path}: " if bad.path else ""
    message = refusal(json.dumps(bad.data), "spec.json")
    # What is no mapping or list is no JSON file, but a line of YAML.
    assert message.removeprefix("spec.json:").removeprefix("1:").startswith(f" {path}")
    assert bad.message in message
    for content in (flow(bad.data), block(bad.data)):
        message = refusal(content)
        assert re.match(rf"spec\.yaml:\d+: {re.escape(path)}", message), message
        assert bad.message in message


@pytest.mark.parametrize("bad", UNSAID, ids=lambda bad: json.dumps(bad.data)[:60])
def test_what_cannot_be_said(bad: Bad) -> None:
    """It is named as clearly as what cannot be read, wherever in the file it stands."""
    message = refusal(json.dumps(["a", bad.data]), "spec.json")
    assert bad.message in message
    assert leads_to(bad.path, message.removeprefix("spec.json: ")), message
    message = refusal(block(["a", bad.data]))
    assert bad.message in message
    line, _, said = message.removeprefix("spec.yaml:").partition(": ")
    assert int(line) > 2
    assert leads_to(bad.path, said), message
    refusal(json.dumps(bad.data), "spec.json")


def leads_to(path: str, message: str) -> bool:
    """Whether a message begins with a path inside the second specification, or to what holds it."""
    said = message.partition(": ")[0]
    return said.startswith("[1]") and (said == "[1]" or path.startswith(said[3:].lstrip(".")))


@pytest.mark.parametrize("data", BLANKS, ids=lambda data: json.dumps(data)[:60])
def test_blank_words(data: Any) -> None:
    """Words that are none are refused, or said as if they weren't there."""
    read_or_refused(json.dumps(data), "spec.json")
    read_or_refused(block(data), "spec.yaml")


def test_truth_values_are_named_as_they_are_written() -> None:
    """As YAML and JSON have them, not as Python does."""
    for data in ({"noun": True}, {"value": False}, {"noun": "a", "person": True}, [True]):
        message = refusal(json.dumps(data), "spec.json")
        assert "True" not in message
        assert "False" not in message


@pytest.mark.parametrize("key", ["y" * 5000, "y\n" * 500, "y\u2028y", "", " ", "😀", "\x00"])
def test_odd_keys(key: str) -> None:
    """However long or odd a key is, the message is one line that can be read."""
    for data in (
        {"noun": "a", key: 1},
        {"sentences": ["a"], key: 1},
        {"verb": "go", "subject": {"noun": "a", key: {}}},
    ):
        assert len(refusal(json.dumps(data), "spec.json")) < 600
    content = f'[{{"noun": "a", {json.dumps(key)}: 1, {json.dumps(key)}: 2}}]'
    assert len(refusal(content, "spec.json")) < 600


@pytest.mark.parametrize("word", ["y" * 5000, "y\n" * 500, "😀", "{}", "%s"])
def test_odd_values(word: str) -> None:
    """However long or odd a value is, the message is one line that can be read."""
    for data in (
        {"noun": "a", "number": word},
        {"noun": "a", "animate": word},
        {"noun": "a", "stutter": word},
        {"noun": "a", "relative": word},
        {"verb": word},
    ):
        assert len(refusal(json.dumps(data), "spec.json")) < 600


@pytest.mark.parametrize("word", ["a\nb", "a\x00b", "\x00", "a\tb", "a\u2028b", "a\r\nb", "\x07"])
def test_control_characters_in_words(word: str) -> None:
    """A sentence is a line: what would break it in two is refused or said as a blank."""
    for data in (word, {"noun": word}, {"verb": word, "subject": word}, [word, "egg"]):
        for content, name in ((json.dumps(data), "spec.json"), (block(data), "spec.yaml")):
            try:
                texts = say(content, name)
            except PersonageError as error:
                check_message(error)
            else:
                assert all(clean(text) for text in texts), texts
                assert "An" not in "".join(texts), "NUL is no article"


def test_a_block_of_text_is_one_line() -> None:
    """YAML's `|` ends in a line break, which nobody means to say."""
    for content in ("noun: |\n  cat\n", "|\n  a\n  cat\n", "[>\n  a cat\n]"):
        try:
            texts = say(content)
        except PersonageError as error:
            check_message(error)
        else:
            assert all(clean(text) for text in texts), texts


@pytest.mark.parametrize(("kind", "name"), EVERY_FIELD, ids=FIELD_IDS)
def test_wrong_types(kind: Any, name: str) -> None:
    """Every field refuses every value that is not of its type, and takes the others."""
    least, embed, path = data_of(kind)
    read_specification(embed(least))
    hint = FIELDS[kind][name]
    values: tuple[Any, ...] = (
        None,
        True,
        7,
        1.5,
        "zz",
        [],
        ["zz"],
        [7],
        [None],
        {},
        {"zz": 1},
        [{}],
        b"",
        (),
    )
    for value in values:
        data = embed({**least, name: value})
        if takes(hint, value):
            read_specification(data)
            continue
        with pytest.raises(MisreadError) as caught:
            read_specification(data)
        check_message(caught.value)
        assert str(caught.value).startswith(f"{path}{name}"), (value, str(caught.value))
