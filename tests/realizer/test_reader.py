"""Proves that right specification files mean the same in YAML and in JSON, in every shape.

Words stay words and flags flags, anchors and merge keys work, and the data is left as it was.
"""

from __future__ import annotations

import copy
import json
from pathlib import Path

import pytest

from personage_lite.realizer.reader import read_specification
from personage_lite.realizer.types import FIELDS, MARKS
from tests.realizer.reader_helpers import CASE_FILES, block, case_specs, data_of, flow, say


@pytest.mark.parametrize("path", CASE_FILES, ids=lambda path: str(path.stem))
def test_yaml_and_json_mean_the_same(path: Path) -> None:
    """A case file's data, written as JSON and read again, gives equal specifications."""
    for data in case_specs(path):
        spec = read_specification(data)
        again = read_specification(json.loads(json.dumps(data)))
        assert again == spec
        # Two types with the same values are equal tuples: their names tell them apart.
        assert repr(again) == repr(spec)


@pytest.mark.parametrize("path", CASE_FILES[::4], ids=lambda path: str(path.stem))
def test_yaml_and_json_files_are_said_alike(path: Path) -> None:
    """The same data as JSON, as YAML in flow style and in lines gives the same texts."""
    specs = case_specs(path)[::5]
    texts = say(json.dumps(specs), "spec.json")
    assert len(texts) == len(specs)
    assert say(json.dumps(specs, indent="\t"), "spec.json") == texts
    assert say(json.dumps({"shared": [1], "sentences": specs}), "spec.json") == texts
    assert say(flow(specs)) == texts
    assert say(block(specs)) == texts
    assert say(block({"sentences": specs}).replace("\n", "\r\n")) == texts
    assert [say(json.dumps(spec), "one.json") for spec in specs] == [[text] for text in texts]


@pytest.mark.parametrize("word", ["no", "yes", "on", "off", "y", "No", "YES", "n"])
def test_bare_words_stay_words(word: str) -> None:
    """YAML 1.1 takes them for truth values; a sentence doesn't."""
    said = word[0].upper() + word[1:]
    assert say(word) == [f"{said}."]
    assert say(f"{{noun: {word}}}") == [f"{said}."]
    assert say(f"noun: cat\ndeterminer: {word}") == [f"{said} cat."]
    assert say(f"- {word}\n- [{word}, cat]") == [f"{said}.", f"{said} cat."]


@pytest.mark.parametrize("word", ["2001-01-01", "0x1F", "1:30", "1_000.x", "0o7", "=", "1e3"])
def test_what_looks_like_a_number_to_nobody_stays_a_word(word: str) -> None:
    assert say(f"{{noun: '{word}'}}") == say(f"{{noun: {word}}}")


@pytest.mark.parametrize("flag", ["true", "True", "TRUE", "false", "False", "FALSE"])
def test_true_and_false_are_flags_in_any_case(flag: str) -> None:
    truth = flag.lower() == "true"
    content = f"{{verb: run, subject: a cat, negated: {flag}}}"
    assert say(content) == ["A cat does not run." if truth else "A cat runs."]


def test_merge_keys() -> None:
    """Own keys go before merged ones, and of several mappings the first decides."""
    shared = "shared:\n  - &a {noun: cat, determiner: a}\n  - &b {noun: dog, number: plural}\n"
    for spec, text in (
        ("{<<: *a}", "A cat."),
        ("{<<: *a, noun: fox}", "A fox."),
        ("{noun: fox, <<: *a}", "A fox."),
        ("{<<: [*a, *b]}", "Cats."),
        ("{<<: [*b, *a]}", "Dogs."),
        ("{<<: [*b, *a], number: singular}", "A dog."),
        ("{<<: {<<: *a, noun: fox}, adjectives: [red]}", "A red fox."),
        ("{<<: [{noun: fox}, *a]}", "A fox."),
        ("*a", "A cat."),
    ):
        assert say(f"{shared}sentences: [{spec}]") == [text]


def test_an_anchor_may_be_used_any_number_of_times() -> None:
    content = "- &a {noun: cat, determiner: a}\n- {items: [*a, *a]}\n- {items: &l [*a]}\n- *l\n"
    assert say(content) == ["A cat.", "A cat and a cat.", "A cat.", "A cat."]


def test_shapes_of_files() -> None:
    """One specification, a list of them, or a list or one of them under `sentences`."""
    assert say("a cat") == ["A cat."]
    assert say('"a cat"', "spec.json") == ["A cat."]
    assert say("[a cat, [a, dog]]") == ["A cat.", "A dog."]
    assert say("sentences: a cat") == ["A cat."]
    assert say("sentences: [a cat]\nshared: {any: [thing]}") == ["A cat."]
    assert say("\ufeffnoun: cat") == ["Cat."]
    assert say('\ufeff{"noun": "cat"}', "spec.json") == ["Cat."]
    assert say("noun: cat\rdeterminer: a") == ["A cat."]


def test_every_type_can_be_read() -> None:
    """Every type of the specification has a mark that tells it, and least data."""
    assert set(MARKS) == set(FIELDS)
    for kind in FIELDS:
        least, embed, _ = data_of(kind)
        assert any(mark in least for mark in MARKS[kind])
        spec = read_specification(embed(least))
        assert kind.__name__ in repr(spec)


def test_reading_changes_nothing() -> None:
    """The data is left as it was, and each reading gives values of its own."""
    for path in CASE_FILES[:3]:
        specs = case_specs(path)
        before = copy.deepcopy(specs)
        assert [read_specification(spec) for spec in specs] == [
            read_specification(spec) for spec in specs
        ]
        assert specs == before
