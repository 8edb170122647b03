"""Proves that specification files are read strictly, and tries to break the reader.

Whatever is wrong in a file or in a value made in Python is one line that names the file, the path
inside it, for YAML the line, and a remedy; what is right means the same in YAML and in JSON.
"""

from __future__ import annotations

import copy
import json
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite import english
from personage_lite.errors import DataError, PersonageError
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
from personage_lite.realizer.reader import MisreadError, read_specification
from personage_lite.realizer.types import DEEPEST, FIELDS, MARKS, choices, item_type, options
from tests.mutation import check_message, spoilt
from tests.realizer.case_list import FOLDER, read_cases
from tests.realizer.random_specs import RandomSpecs

REALIZER = english()
CASE_FILES = sorted(FOLDER.glob("*.yaml"))
ROOT = Path(__file__).resolve().parents[2]
# What the realizer says of a fault that nobody foresaw: no user can do anything with it.
UNFORESEEN = "this cannot be said ("


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
    assert UNFORESEEN not in message
    return message


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


# Right files


def case_specs(path: Path) -> list[Any]:
    """Return the plain data of each specification in a file of cases."""
    return [row["spec"] for rows in read_data(str(path))["groups"].values() for row in rows]


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


# Wrong files


class Bad(NamedTuple):
    """A specification that is refused: its data, the path to the fault, and what is said of it.

    `expressible` says whether a JSON Schema can know it too.
    """

    data: Any
    path: str
    message: str
    expressible: bool = True


NOTHING = "nothing says what this is; give it one of: adjective, "
EMPTY_LIST = "the list is empty; add words, or remove the field"
# Numbers with nothing after the point are whole in a JSON Schema, not here.
WHOLE = False
BAD = [
    # what it is
    Bad({}, "", NOTHING),
    Bad({"a": 1}, "", NOTHING),
    Bad({"shared": ["a"]}, "shared", "'shared' without 'sentences'; put what is to be said under"),
    Bad({"weekday": True}, "", NOTHING),
    Bad({"speech": "a"}, "", NOTHING),
    Bad({"phrase": {"noun": "a"}}, "", NOTHING),
    Bad(None, "", "expected a phrase, found nothing; "),
    Bad(7, "", "expected a phrase, found '7'; put it in quotes"),
    Bad(1.5, "", "expected a phrase, found '1.5'; put it in quotes"),
    Bad(True, "", "expected a phrase, found "),
    Bad([], "", "no sentence to say; add one"),
    Bad([[]], "[0]", EMPTY_LIST),
    Bad({"sentences": []}, "sentences", "no sentence to say; add one"),
    Bad({"sentences": None}, "sentences", "expected a phrase, found nothing; "),
    Bad({"sentences": {}}, "sentences", NOTHING),
    Bad({"sentences": ["a"], "share": 1}, "share", "unknown field 'share' beside 'sentences'; put"),
    Bad({"sentences": ["a", {"noun": 1}]}, "sentences[1].noun", "expected a text, found '1'; "),
    Bad(["a", ["b", {"noun": 1}]], "[1][1].noun", "expected a text, found '1'; put it in quotes"),
    # fields
    Bad({"noun": "a", "determinr": "a"}, "determinr", "NounPhrase has no field 'determinr'; did"),
    Bad({"noun": "a", "xyz": 1}, "xyz", "NounPhrase has no field 'xyz'; choose from: adjectives"),
    Bad({"noun": "a", "verb": "go"}, "verb", "NounPhrase has no field 'verb'; "),
    Bad({"verb": "go", "subjct": "a"}, "subjct", "Clause has no field 'subjct'; did you mean sub"),
    Bad({"body": "a", "connectiv": "b"}, "connectiv", "has no field 'connectiv'; did you mean con"),
    Bad(
        {"verb": "go", "subject": {"noun": "a", "relative": {"clause": {"vreb": "go"}}}},
        "subject.relative.clause",
        "nothing says what this is; give it one of: items, verb",
    ),
    Bad(
        {"verb": "go", "subject": "a", "question": {"phrse": "who"}}, "question.phrse", "mean phra"
    ),
    Bad({"preposition": "in"}, "", "'object' is missing; add 'object: …'"),
    Bad({"lead": "I think"}, "", "'clause' is missing; add 'clause: …'"),
    Bad({"noun": "a", "relative": {}}, "relative", "'clause' is missing; add 'clause: …'"),
    Bad({"body": "a", "joined": [{"conjunction": "and"}]}, "joined[0]", "'body' is missing; add"),
    Bad({"body": "a", "openers": [{"mark": ","}]}, "openers[0]", "'text' is missing; add"),
    Bad(
        {"verb": "go", "subordinates": [{"conjunction": "if"}]},
        "subordinates[0]",
        "'clause' is missing; add 'clause: …'",
    ),
    Bad({"verb": "go", "quotation": {"first": True}}, "quotation", "'speech' is missing; add"),
    # texts
    Bad({"noun": 7}, "noun", "expected a text, found '7'; put it in quotes"),
    Bad({"noun": True}, "noun", "expected a text, found "),
    Bad({"noun": None}, "noun", "expected a text, found nothing; "),
    Bad({"noun": {"noun": "a"}}, "noun", "expected a text, found a mapping; "),
    Bad({"noun": ["a"]}, "noun", "expected a text, found a list; "),
    Bad({"noun": "a", "determiner": None}, "determiner", "expected a text, found nothing; "),
    Bad({"verb": "go", "subject": "a", "modal": 1}, "modal", "expected a text, found '1'; put it"),
    Bad({"body": "a", "tag": False}, "tag", "expected a text, found "),
    # flags
    Bad({"noun": "a", "animate": "yes"}, "animate", "expected true or false, found 'yes'; "),
    Bad({"noun": "a", "animate": 1}, "animate", "expected true or false, found '1'; "),
    Bad({"noun": "a", "animate": None}, "animate", "expected true or false, found nothing; "),
    Bad({"noun": "a", "animate": []}, "animate", "expected true or false, found a list; "),
    Bad({"value": 1, "ordinal": 2}, "ordinal", "expected true or false, found '2'; "),
    # numbers
    Bad({"noun": "a", "stutter": "2"}, "stutter", "expected a whole number, found '2'; "),
    Bad({"noun": "a", "stutter": 1.5}, "stutter", "expected a whole number, found '1.5'; "),
    Bad({"noun": "a", "stutter": 1.0}, "stutter", "expected a whole number, found '1.0'; ", WHOLE),
    Bad({"noun": "a", "stutter": True}, "stutter", "expected a whole number, found "),
    Bad({"noun": "a", "stutter": None}, "stutter", "expected a whole number, found nothing; "),
    Bad({"noun": "a", "ordinal": 1.5}, "ordinal", "expected a whole number, found '1.5'; "),
    Bad({"noun": "a", "cardinal": "two"}, "cardinal", "a number, found 'two'; "),
    Bad({"noun": "a", "cardinal": True}, "cardinal", "a number, found "),
    Bad({"value": "2"}, "value", "a number, found '2'; "),
    Bad({"value": None}, "value", "a number, found nothing; "),
    Bad({"year": "2000"}, "year", "expected a whole number, found '2000'; "),
    Bad({"year": 2000, "month": "July"}, "month", "expected a whole number, found 'July'; "),
    # one of several values
    Bad(
        {"noun": "a", "number": "plurl"}, "number", "'plurl' is not possible here; did you mean pl"
    ),
    Bad({"noun": "a", "number": ""}, "number", "'' is not possible here; choose from: plural, sin"),
    Bad({"noun": "a", "number": 2}, "number", "'2' is not possible here; choose from: plural, "),
    Bad({"noun": "a", "number": ["plural"]}, "number", "found a list; "),
    Bad({"noun": "a", "gender": None}, "gender", "; "),
    Bad({"noun": "a", "person": 4}, "person", "'4' is not possible here; choose from: 1, 2, 3"),
    Bad({"noun": "a", "person": "1"}, "person", "'1' is not possible here; "),
    Bad({"noun": "a", "person": True}, "person", "is not possible here; choose from: 1, 2, 3"),
    Bad({"noun": "a", "person": 1.0}, "person", "'1.0' is not possible here; ", WHOLE),
    Bad({"verb": "go", "subject": "a", "tense": "pst"}, "tense", "did you mean past"),
    Bad({"verb": "go", "mood": "askng"}, "mood", "'askng' is not possible here; choose from: de"),
    Bad({"verb": "go", "form": "finit"}, "form", "'finit' is not possible here; did you mean fin"),
    Bad({"adjective": "a", "degree": "more"}, "degree", "'more' is not possible here; choose from"),
    Bad(
        {"year": 2000, "style": "wrds"}, "style", "'wrds' is not possible here; did you mean words"
    ),
    Bad(
        {"verb": "go", "ellipsis": ["subjct"]},
        "ellipsis[0]",
        "'subjct' is not possible here; did you mean subject?",
    ),
    Bad(
        {"parts": [{"phrase": {"noun": "a"}, "case": "objectiv"}]},
        "parts[0].case",
        "'objectiv' is not possible here; did you mean objective",
    ),
    # lists
    Bad({"noun": "a", "adjectives": "big"}, "adjectives", "expected a list, found 'big'; write it"),
    Bad(
        {"noun": "a", "adjectives": None}, "adjectives", "expected a list, found nothing; write it"
    ),
    Bad(
        {"noun": "a", "adjectives": {"adjective": "big"}}, "adjectives", "found a mapping; write it"
    ),
    Bad({"noun": "a", "adjectives": [None]}, "adjectives[0]", "expected a phrase, found nothing; "),
    Bad(
        {"noun": "a", "adjectives": [7]}, "adjectives[0]", "expected a phrase, found '7'; put it in"
    ),
    Bad({"noun": "a", "adjectives": [[]]}, "adjectives[0]", EMPTY_LIST),
    Bad({"noun": "a", "modifiers": "b"}, "modifiers", "expected a list, found 'b'; write it as"),
    Bad({"verb": "go", "adverbs": "often"}, "adverbs", "expected a list, found 'often'; write it"),
    Bad(
        {"verb": "go", "adverbs": ["often", 1]}, "adverbs[1]", "expected a text, found '1'; put it"
    ),
    Bad({"verb": "go", "adverbs": [["often"]]}, "adverbs[0]", "expected a text, found a list; "),
    Bad({"verb": "go", "ellipsis": "subject"}, "ellipsis", "expected a list, found 'subject'; "),
    Bad({"items": "a"}, "items", "expected a list, found 'a'; write it as a list, [ … ]"),
    Bad({"items": None}, "items", "expected a list, found nothing; write it as a list, [ … ]"),
    Bad({"parts": "a"}, "parts", "expected a list, found 'a'; write it as a list, [ … ]"),
    Bad(
        {"body": "a", "joined": {"conjunction": "and", "body": "b"}}, "joined", "expected a list, "
    ),
    # phrases
    Bad({"verb": "go", "subject": 7}, "subject", "expected a phrase, found '7'; put it in quotes"),
    Bad({"verb": "go", "subject": False}, "subject", "expected a phrase, found "),
    Bad({"verb": "go", "subject": []}, "subject", EMPTY_LIST),
    Bad({"verb": "go", "subject": {}}, "subject", NOTHING),
    Bad({"noun": "a", "possessor": [{}]}, "possessor[0]", "nothing says what this is; give it one"),
    Bad({"lead": [], "clause": {"verb": "go", "subject": "a"}}, "lead", EMPTY_LIST),
    Bad({"preposition": "in", "object": None}, "object", "expected a phrase, found nothing; "),
    # other types
    Bad({"noun": "a", "relative": "b"}, "relative", "expected a Relative, found 'b'; "),
    Bad({"noun": "a", "relative": {"clause": "b"}}, "relative.clause", "found 'b'; "),
    Bad({"noun": "a", "relative": {"clause": {"noun": "b"}}}, "relative.clause", "items, verb"),
    Bad({"verb": "go", "question": "who"}, "question", "expected a Question, found 'who'; "),
    Bad({"verb": "go", "question": ["who"]}, "question", "expected a Question, found a list; "),
    Bad({"verb": "go", "quotation": 1}, "quotation", "expected a text or a Quotation, found '1'; "),
    Bad({"verb": "go", "quotation": ["a"]}, "quotation", "a text or a Quotation, found a list; "),
    Bad({"verb": "go", "quotation": {"verb": "go"}}, "quotation.verb", "Quotation has no field"),
    Bad(
        {"verb": "go", "subordinates": ["if so"]}, "subordinates[0]", "a Subordinate, found 'if so'"
    ),
    Bad({"body": "a", "openers": ["Oh"]}, "openers[0]", "Opener, found 'Oh'; "),
    Bad({"body": {"body": "a"}}, "body", NOTHING),
    Bad({"parts": [{"phrase": "a"}]}, "parts[0].phrase", "expected a NounPhrase, found 'a'; "),
    Bad(
        {"body": "a", "joined": [{"conjunction": "and", "body": "b"}]},
        "joined[0].body",
        "found 'b'",
    ),
]


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


# What reads and cannot be said.
UNSAID = [
    Bad({"verb": "go"}, "", "the clause with the verb 'go' has no subject; add one"),
    Bad({"verb": "say", "subject": "a", "object": {"verb": "go"}}, "object", "has no subject; add"),
    Bad({"noun": ""}, "", "a noun phrase says nothing; give it a noun"),
    Bad({"verb": "see", "subject": "a", "object": {"noun": ""}}, "object", "says nothing; give it"),
    Bad(
        {
            "verb": "go",
            "subject": "a",
            "mood": "interrogative",
            "question": {"phrase": "who", "role": "subject"},
        },
        "",
        "the subject stands twice, in the clause and before it; leave it out of the clause",
    ),
    Bad(
        {"noun": "a", "relative": {"clause": {"verb": "go", "object": "b"}, "role": "object"}},
        "relative",
        "the object stands twice, in the clause and before it; leave it out of the clause",
    ),
    Bad(
        {"noun": "a", "relative": {"clause": {"items": ["a"]}}},
        "relative.clause",
        "only clauses can be joined in a relative clause; ",
    ),
    Bad({"noun": "a", "relative": {"clause": {"items": []}}}, "relative.clause", "; "),
    # numbers and dates that nobody can say
    Bad({"year": 2000, "month": 13}, "", "no calendar has year 2000, month 13; give a date of the"),
    Bad(
        {"verb": "go", "subject": "a", "adverbials": [{"day": 3}]}, "adverbials[0]", "lacks a month"
    ),
    Bad({"year": 10000}, "", "no calendar has year 10000; give a date of the years 1-9999"),
    Bad({"year": 2**31}, "", "no calendar has year 2147483648; give a date of the years 1-9999"),
    Bad({"year": 2**64}, "", "no calendar has year "),
    Bad({"year": 2000, "month": 2, "day": 30}, "", "no calendar has year 2000, month 2, day 30; "),
    Bad({"year": 2000, "weekday": True}, "", "a weekday needs a whole date; give year, month and"),
    Bad({"value": 1.5, "ordinal": True}, "", "; "),
    Bad({"noun": "cat", "stutter": 10**15}, "stutter", "; "),
    Bad({"noun": "cat", "stutter": 10**30}, "stutter", "; "),
    # nothing to say
    Bad("", "", "; "),
    Bad({"body": ""}, "body", "; "),
    Bad({"adjective": ""}, "adjective", "; "),
    Bad({"items": []}, "items", "; "),
    Bad({"items": [""]}, "items[0]", "; "),
    Bad({"parts": []}, "parts", "; "),
]


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


BLANKS: tuple[Any, ...] = (
    *(
        " ",
        {"verb": " ", "subject": "a"},
        {"verb": "", "subject": "a"},
        {"noun": " "},
        {"verb": "go", "subject": ""},
    ),
    *({"verb": "go", "subject": {"parts": []}}, {"verb": "see", "subject": "a", "object": ""}),
    *({"verb": "see", "subject": "a", "adverbs": [""]}, {"noun": "a", "adjectives": [""]}),
    *({"preposition": "", "object": "a"}, {"body": "a", "openers": [{"text": ""}]}),
    *({"lead": "", "clause": {"verb": "go", "subject": "a"}}, {"body": "a", "tag": " "}),
    *({"verb": "say", "subject": "a", "quotation": {"speech": ""}}, {"items": ["a", "", "b"]}),
    *({"verb": "go", "subject": "a", "modal": " "}, {"noun": "cat", "determiner": " "}),
    {"verb": "go", "subject": "a", "subordinates": [{"conjunction": "", "clause": {"verb": "go"}}]},
    *({"noun": "cat", "stutter": -1}, "…", {"body": "!"}, {"noun": ","}, {"parts": ["a", "…"]}),
)


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


@pytest.mark.parametrize(
    ("content", "line", "message"),
    [
        ("noun: cat\n\n# more\ndeterminr: a\n", 4, "determinr: NounPhrase has no field 'determi"),
        ("- a\n- noun: cat\n  adjectives:\n    - big\n    - 7\n", 5, "[1].adjectives[1]: expected"),
        ("- a\n-\n- b\n", 2, "[1]: expected a phrase, found nothing; "),
        ("verb: go\nsubject:\n  noun:\n    7\n", 4, "subject.noun: expected a text, found '7'; "),
        (
            "- a\n- {verb: see, subject: a,\n   object:\n    {verb: go}}\n",
            4,
            "[1].object: the clause",
        ),
        ("sentences:\n  - a\nshare: 1\n", 3, "share: unknown field 'share' beside 'sentences'; "),
        (
            "shared: &a {noun: cat}\nsentences:\n  - *a\n  - {<<: *a,\n     nown: 1}\n",
            5,
            "].nown: ",
        ),
        ("shared: [&a {noun: 5}]\nsentences:\n  - *a\n", 1, "sentences[0].noun: expected a text, "),
        (
            "noun: cat\ndeterminer: a\nnoun: dog\n",
            3,
            "the key 'noun' stands here a second time; re",
        ),
        ("- a\n- items:\n  - {noun: x,\n     noun: y}\n", 4, "the key 'noun' stands here a second"),
        ("- a\n- {? [x] : y}\n", 2, "a key is no single word; write 'key: value'"),
        ("- a\n- {? {x: y} : y}\n", 2, "a key is no single word; write 'key: value'"),
        ("- a\n- {<<: cat}\n", 2, "'<<' takes over no mapping; name one, as in '<<: *alice'"),
        ("- a\n- {<<: [cat]}\n", 2, "'<<' takes over no mapping; name one, as in '<<: *alice'"),
        ("- a\n- {<<: }\n", 2, "'<<' takes over no mapping; name one, as in '<<: *alice'"),
        ("- a\n- noun: *x\n", 2, "not valid YAML (found undefined alias); mend the syntax"),
        ("noun: a\n--- \nnoun: b\n", 2, "not valid YAML (but found another document); mend the"),
        ("noun: [\n", 2, "not valid YAML (did not find expected node content); mend the syntax"),
        ("a: b\n\tc: d\n", 2, "not valid YAML (found a tab character that violates indentation)"),
        ("- a\n- b\x07\n", 2, "not valid YAML (control characters are not allowed); remove it"),
        ("", 1, "the file is empty; "),
        ("# nothing\n", 1, "the file is empty; "),
        ("---\n...\n", 2, "expected a phrase, found nothing; "),
        ("- a\n- !!python/name:os.system x\n- 7\n", 3, "[2]: expected a phrase, found '7'; "),
        ("- a\n- year: 2000\n  month: 13\n", 2, "[1]: no calendar has year 2000, month 13; "),
        ("- a\n- value: .inf\n", 2, "[1].value: "),
        ("- a\n- value: .nan\n", 2, "[1].value: "),
        ("- a\n- value: 1.0e+999\n", 2, "[1]"),
        (f"- a\n- value: {'9' * 5000}\n", 2, "[1].value: "),
    ],
)
def test_lines(content: str, line: int, message: str) -> None:
    """For YAML the error names the very line, and no part of it is half said."""
    with pytest.raises(DataError) as caught:
        say(content)
    check_message(caught.value)
    assert (caught.value.file, caught.value.line) == ("spec.yaml", line)
    assert str(caught.value).startswith(f"spec.yaml:{line}: ")
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("content", "line", "message"),
    [
        ('{"noun": "a"', 1, "not valid JSON (Expecting ',' delimiter); mend the syntax"),
        ('{"noun": "a",\n}', 2, "not valid JSON (Expecting property name enclosed in double quo"),
        ("[\n1,\n", 3, "not valid JSON (Expecting value); mend the syntax"),
        ('["a"]\n"b"', 2, "not valid JSON (Extra data); mend the syntax"),
        ("{'noun': 'a'}", 1, "not valid JSON (Expecting property name enclosed in double quotes"),
        ('["a\n"]', 1, "not valid JSON (Invalid control character at); mend the syntax"),
        ('["\\x"]', 1, "not valid JSON (Invalid \\escape); mend the syntax"),
        (
            '[\n"a",\n{"noun": "a", "noun": "b"}]',
            3,
            "the key 'noun' stands here a second time; remove one of the two",
        ),
        ('["a", {"value": NaN}]', None, "[1]"),
        ('["a", {"value": -Infinity}]', None, "[1]"),
        ('["a", {"value": 1e999}]', None, "[1]"),
        ('["a", {"noun": "b", "cardinal": NaN}]', None, "[1]"),
        (f'["a", {{"value": {"9" * 5000}}}]', None, "; "),
        ("", None, "the file is empty; "),
        (" \n", None, "the file is empty; "),
    ],
)
def test_json_faults(content: str, line: int | None, message: str) -> None:
    said = refusal(content, "spec.json")
    if line:
        assert said.startswith(f"spec.json:{line}: ")
    assert message in said


def test_equal_json_keys_are_found_where_they_are() -> None:
    """In a long file "somewhere" helps nobody."""
    said = refusal('["a",\n{"noun": "b", "possessor":\n{"noun": "c", "noun": "d"}}]', "spec.json")
    assert said.startswith(("spec.json:3: ", "spec.json: [1].possessor"))


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


# Wrong types, for every field


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


EVERY_FIELD = [(kind, name) for kind, fields in FIELDS.items() for name in fields]
FIELD_IDS = [f"{kind.__name__}.{name}" for kind, name in EVERY_FIELD]


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


def test_every_type_can_be_read() -> None:
    """Every type of the specification has a mark that tells it, and least data."""
    assert set(MARKS) == set(FIELDS)
    for kind in FIELDS:
        least, embed, _ = data_of(kind)
        assert any(mark in least for mark in MARKS[kind])
        spec = read_specification(embed(least))
        assert kind.__name__ in repr(spec)


# Deep and endless


def _going(inner: Any) -> dict[str, Any]:
    return {"verb": "see", "subject": "a", "object": inner}


def _speech(sentence: dict[str, Any]) -> dict[str, Any]:
    return {"verb": "say", "subject": "a", "quotation": {"speech": sentence}}


LEVELS: dict[str, Callable[[Any], Any]] = {
    "AdjectivePhrase.compared": lambda x: {
        **{"adjective": "big", "degree": "comparative", "compared": x}
    },
    "AdjectivePhrase.complement": lambda x: {"adjective": "big", "complement": x},
    "NounPhrase.adjectives": lambda x: {"noun": "a", "adjectives": [x]},
    "NounPhrase.possessor": lambda x: {"noun": "a", "possessor": x},
    "NounPhrase.modifiers": lambda x: {"noun": "a", "modifiers": [x]},
    "NounPhrase.apposition": lambda x: {"noun": "a", "apposition": x},
    "NounPhrase.relative": lambda x: {
        **{"noun": "a", "relative": {"clause": {"verb": "see", "object": x}}}
    },
    "Relative.clause": lambda x: {
        **{"noun": "a", "relative": {"clause": {"items": [{"verb": "see", "object": x}]}}}
    },
    "Cased.phrase": lambda x: {"parts": [{"phrase": {"noun": "a", "apposition": x}}]},
    "Text.parts": lambda x: {"parts": [x]},
    "a list": lambda x: [x],
    "PrepositionalPhrase.object": lambda x: {"preposition": "in", "object": x},
    "Coordination.items": lambda x: {"items": ["a", x]},
    "Question.phrase": lambda x: {
        **{"verb": "go", "mood": "interrogative", "question": {"phrase": x}}
    },
    "Quotation.speech": lambda x: _speech({"body": x}),
    "Quotation.rest": lambda x: {
        **{"verb": "say", "subject": "a"},
        "quotation": {"speech": "Well", "first": True, "rest": {"body": x}},
    },
    "Sentence.body": lambda x: _speech({"body": {"items": [x]}}),
    "Sentence.joined": lambda x: _speech(
        {"body": "a", "joined": [{"conjunction": "and", "body": _going(x)}]}
    ),
    "Joined.body": lambda x: _speech(
        {
            "body": "a",
            "joined": [{"conjunction": "and", "body": {"lead": "a", "clause": _going(x)}}],
        }
    ),
    "Embedded.lead": lambda x: _speech({"body": {"lead": [x], "clause": _going("b")}}),
    "Embedded.clause": lambda x: _speech({"body": {"lead": "a", "clause": _going(x)}}),
    "Subordinate.clause": lambda x: {
        **_going("b"),
        "subordinates": [{"conjunction": "if", "clause": _going(x)}],
    },
    "Clause.subordinates": lambda x: {
        **{"verb": "go", "subject": "a", "form": "infinitive"},
        "subordinates": [{"conjunction": "if", "fronted": True, "clause": _going(x)}],
    },
    "Clause.subject": lambda x: {"verb": "go", "subject": x},
    "Clause.indirect_object": lambda x: {**_going("b"), "indirect_object": x},
    "Clause.object": _going,
    "Clause.complement": lambda x: {"verb": "be", "subject": "a", "complement": x},
    "Clause.adverbials": lambda x: {**_going("b"), "adverbials": ["c", x]},
    "Clause.asides": lambda x: {**_going("b"), "asides": [x]},
    "Clause.preposed": lambda x: {**_going("b"), "preposed": [x]},
    "Clause.quotation": lambda x: {
        **{"verb": "say", "subject": "a"},
        "quotation": {"speech": {"body": x}, "first": True, "inverted": True},
    },
    "Clause.question": lambda x: {
        **{"verb": "see", "subject": "a", "mood": "interrogative"},
        "question": {"phrase": x, "role": "object"},
    },
    "Clause.agent": lambda x: {**_going("b"), "passive": True, "agent": x},
    # Sentences open with words alone.
    "Sentence.openers": lambda x: _speech({"body": x, "openers": [{"text": "Oh"}]}),
}


def depth(data: Any) -> int:
    """Return how many lists and mappings stand in each other."""
    inner = data.values() if isinstance(data, dict) else data if isinstance(data, list) else None
    return 0 if inner is None else 1 + max(map(depth, inner), default=0)


def nested(level: Callable[[Any], Any], times: int, inner: Any = "a") -> Any:
    """Return data with a level in itself so many times."""
    for _ in range(times):
        inner = level(inner)
    return inner


def test_every_field_that_nests_is_nested() -> None:
    """The levels leave out no field that can hold a mapping."""

    def holds(hint: Any) -> bool:
        return any(
            option in FIELDS or (item_type(option) is not None and holds(item_type(option)))
            for option in options(hint)
        )

    names = {f"{kind.__name__}.{name}" for kind, name in EVERY_FIELD if holds(FIELDS[kind][name])}
    assert names == set(LEVELS) - {"a list"}


@pytest.mark.parametrize("level", LEVELS.values(), ids=LEVELS)
def test_nested_200_deep(level: Callable[[Any], Any]) -> None:
    """It is refused with the limit and the path to where it is passed."""
    before, after = json.dumps(level("…"), ensure_ascii=False).split('"…"')
    data = before * 200 + '"a"' + after * 200
    for content, name in (
        (data, "spec.json"),
        (data.replace(" ", "\n\t"), "spec.json"),
        ("---\n" + data, "spec.yaml"),
        (data, "standard input"),
    ):
        message = refusal(content, name)
        assert message.endswith(f"more than {DEEPEST} levels deep; nest less"), message
        assert re.match(r"[\w. ]+:(\d+:)? (\[0\]|[a-z_]+[.\[])", message), message
        assert "…" in message
        assert len(message) < 300


@pytest.mark.parametrize("level", LEVELS.values(), ids=LEVELS)
def test_nested_as_deep_as_may_be(level: Callable[[Any], Any]) -> None:
    """What may be read can be said, or it is refused for a reason."""
    times = next(times for times in range(DEEPEST, 0, -1) if depth(nested(level, times)) <= DEEPEST)
    data = nested(level, times)
    spec = read_specification(data)
    text = heard(spec)
    assert text.startswith("refused: ") or clean(text)
    assert "levels deep" not in text


def test_the_deepest() -> None:
    possessors = LEVELS["NounPhrase.possessor"]
    assert say(json.dumps(nested(possessors, DEEPEST)), "spec.json")
    assert say(flow(nested(possessors, DEEPEST)))
    for content, name in (
        (json.dumps(nested(possessors, DEEPEST, {"noun": "a"})), "spec.json"),
        (flow(nested(possessors, DEEPEST, {"noun": "a"})), "spec.yaml"),
    ):
        assert "more than 64 levels deep; nest less" in refusal(content, name)


@pytest.mark.parametrize("name", ["spec.yaml", "spec.json"])
@pytest.mark.parametrize(
    ("start", "end"),
    [("[", "]"), ('{"noun": "a", "possessor": ', "}"), ("{a: ", "}"), ("- ", ""), ("? ", "")],
)
def test_nested_100000_deep(start: str, end: str, name: str) -> None:
    for times in (2400, 100_000):
        for content in (start * times, start * times + "1" + end * times):
            message = refusal(content, name)
            assert re.search("levels deep; nest less$|not valid|a key is no single word", message)
            assert len(message) < 300


def test_nested_by_indentation() -> None:
    """Without any character that shows it."""
    for key in ("possessor", "a"):
        message = refusal("".join(f"{' ' * deep}{key}:\n" for deep in range(2000)))
        assert "more than 64 levels deep; nest less" in message


def test_nested_by_anchors() -> None:
    """Each line is short, and the whole endless."""
    lines = ["shared:", "  - &a0 {noun: x}"]
    lines += [f"  - &a{at} {{noun: x, possessor: *a{at - 1}}}" for at in range(1, 2000)]
    message = refusal("\n".join([*lines, "sentences: [*a1999]"]))
    assert "more than 64 levels deep; nest less" in message
    assert " sentences[0].possessor.possessor." in message
    merged = [f"  - &a{at} {{<<: *a{at - 1}}}" for at in range(1, 2000)]
    assert say("\n".join([*lines[:2], *merged, "sentences: [*a1999]"])) == ["X."]
    assert "64 levels deep" in refusal("{<<: " * 300 + "{noun: a}" + "}" * 300 + "\n", "a.yaml")


@pytest.mark.parametrize(
    ("content", "path"),
    [
        ("&a [*a]", "[0][0]"),
        ("&a\n- b\n- [c, *a]\n", "[1][1]"),
        ("- b\n- &a\n  noun: cat\n  possessor: *a\n", "[1].possessor"),
        ("- b\n- &a {noun: cat, modifiers: [x, *a]}\n", "[1].modifiers[1]"),
        ("- b\n- noun: cat\n  modifiers: &m [x, *m]\n", "[1].modifiers[1]"),
        ("verb: go\nsubject: &s\n  noun: a\n  relative: {clause: {verb: go, object: *s}}\n", ""),
        (
            "&a {body: a, joined: [{conjunction: and, body: &b {verb: go, object: *b}}]}",
            "joined",
        ),
        (
            "shared: [&a {noun: x, possessor: &b {noun: y, possessor: *a}}]\nsentences: [*b]",
            "sen",
        ),
        (
            "shared: [&a {noun: x, possessor: *a}]\nsentences: [b, {<<: *a}]",
            "sentences[1].posse",
        ),
        # a mapping that takes over its own keys
        ("- b\n- &a {noun: cat, <<: *a}\n", ""),
        ("- b\n- &a {<<: *a, noun: cat}\n", ""),
        ("- b\n- &a {<<: [{noun: cat}, *a]}\n", ""),
        ("- b\n- &a {noun: cat, <<: &b {determiner: a, <<: *a}}\n", ""),
    ],
)
def test_what_contains_itself(content: str, path: str) -> None:
    """The line is that of the anchor: an alias has none of its own."""
    message = refusal(content)
    assert "contains itself; " in message
    assert re.match(rf"spec\.yaml:\d+: {re.escape(path)}", message), message


def test_data_that_contains_itself() -> None:
    """In Python too."""
    cycle: dict[str, Any] = {"noun": "a"}
    cycle["modifiers"] = [cycle]
    with pytest.raises(MisreadError, match=r"^modifiers\[0\]: this contains itself; write it out"):
        read_specification(cycle)
    shared = {"noun": "a"}
    read_specification([shared, {"items": [shared, [shared]]}])


# Random files


def _case_rows(path: Path) -> str:
    """Return a case file as `realize` reads it, with those cases that fill one line."""
    head, _, groups = path.read_text("utf-8").partition("\ngroups:\n")
    rows = re.findall(r"(?m)^ +- \{name: .*?, spec: (.*)\}$", groups)
    assert len(rows) > 10, path
    return head + "\nsentences:\n" + "".join(f"  - {row}\n" for row in rows[:: len(rows) // 30 + 1])


SPOILABLE = {path.stem: _case_rows(path) for path in CASE_FILES}


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


@pytest.mark.parametrize("stem", SPOILABLE)
def test_case_files_can_be_spoilt(stem: str) -> None:
    assert len(say(SPOILABLE[stem])) > 10


@settings(max_examples=120, deadline=None)
@given(data=st.data())
def test_spoilt_files_are_read_or_refused(data: st.DataObject) -> None:
    stem = data.draw(st.sampled_from(sorted(SPOILABLE)))
    content = data.draw(spoilt(SPOILABLE[stem]))
    read_or_refused(content.decode("utf-8", errors="replace"), "spec.yaml")


@settings(max_examples=120, deadline=None)
@given(data=st.data())
def test_spoilt_json_is_read_or_refused(data: st.DataObject) -> None:
    stem = data.draw(st.sampled_from(sorted(CASES_AS_JSON)))
    content = data.draw(spoilt(CASES_AS_JSON[stem]))
    name = data.draw(st.sampled_from(["spec.json", "standard input"]))
    read_or_refused(content.decode("utf-8", errors="replace"), name)


CASES_AS_JSON = {path.stem: json.dumps(case_specs(path)[::40], indent=1) for path in CASE_FILES}
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


@pytest.mark.parametrize("odd", [0.0, 0.02, 0.3], ids=["right", "nearly right", "wrong"])
def test_random_data_is_read_or_refused(odd: float) -> None:
    """Every error is one line; and of all that breaks this, the shortest is shown."""
    broken = []
    kinds: list[Any] = [Sentence, Clause, NounPhrase, Coordination, PrepositionalPhrase]
    for seed in range(1500):
        random = RandomData(seed, odd)
        content = json.dumps(random.mapping(random.rng.choice(kinds), 4))
        try:
            read_or_refused(content, "spec.json")
        except Exception as error:
            broken.append((len(content), content, f"{type(error).__name__}: {error}"[:200]))
        except AssertionError as error:
            broken.append((len(content), content, f"said badly: {error}"[:200]))
    assert not broken, f"{len(broken)} of 1500: {min(broken)[1:]}"


_SCALARS = st.none() | st.booleans() | st.integers() | st.floats() | st.text()
_KEYS = st.sampled_from(sorted({name for fields in FIELDS.values() for name in fields})) | st.text()


@settings(max_examples=150, deadline=None)
@given(st.recursive(_SCALARS, lambda x: st.lists(x) | st.dictionaries(_KEYS, x), max_leaves=8))
def test_any_data_is_read_or_refused(data: Any) -> None:
    """Data that has nothing to do with specifications, as JSON and as Python values."""
    read_or_refused(json.dumps(data), "spec.json")
    try:
        read_specification(data)
    except MisreadError as error:
        check_message(error)


@settings(max_examples=150, deadline=None)
@given(st.text())
def test_any_text_is_read_or_refused(content: str) -> None:
    for name in ("spec.yaml", "spec.json"):
        read_or_refused(content, name)


# Specifications made in Python

KINDS: tuple[Any, ...] = tuple(FIELDS)


def needs(kind: Any) -> dict[str, Any]:
    """Return some value for each feature that a type cannot do without."""
    given: dict[str, Any] = {each: "a" for each in kind._fields if each not in kind._field_defaults}
    # Of these a type may ask for more than one word.
    return given | {each: ("a",) for each in ("items", "parts") if each in given}


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: str(kind.__name__))
def test_misspelt_features(kind: Any) -> None:
    """A feature that does not exist is an error as soon as it is written, with the nearest name."""
    for name in kind._fields:
        wrong = f"{name}x"
        with pytest.raises(SpecificationError) as caught:
            kind(**{**needs(kind), wrong: "a"})
        check_message(caught.value)
        start = f"{kind.__name__} has no feature '{wrong}'; did you mean "
        assert str(caught.value).startswith(start)
        assert name in str(caught.value)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: str(kind.__name__))
def test_missing_and_doubled_features(kind: Any) -> None:
    """They are told as Python tells them of any call, with the type's name."""
    first = kind._fields[0]
    calls: list[Callable[[], Any]] = [
        lambda: kind(*["a"] * (len(kind._fields) + 1)),
        lambda: kind("a", **{first: "a"}),
    ]
    if first not in kind._field_defaults:
        calls.append(kind)
    for call in calls:
        with pytest.raises((TypeError, SpecificationError)) as caught:
            call()
        assert len(str(caught.value).splitlines()) == 1
        assert kind.__name__ in str(caught.value)
        assert ".it " not in str(caught.value)


LITERALS = [
    (kind, name) for kind, name in EVERY_FIELD if any(map(choices, options(FIELDS[kind][name])))
]


@pytest.mark.parametrize(
    ("kind", "name"), LITERALS, ids=[f"{kind.__name__}.{name}" for kind, name in LITERALS]
)
def test_wrong_literal_values(kind: Any, name: str) -> None:
    """A value that a feature cannot have is an error as soon as it is written."""
    needed = needs(kind)
    for value in ("zz", "", None, 7, ["plural"], {}, NounPhrase("a"), object()):
        with pytest.raises(SpecificationError) as caught:
            kind(**{**needed, name: value})
        check_message(caught.value)
        assert str(caught.value).startswith(f"{kind.__name__}: {name} cannot be '")
    assert kind(**needed)


def made(data: Any) -> Any:
    """Return the specification of plain data."""
    return read_specification(data)


def placed(kind: Any, name: str, value: object) -> Any:
    """Return a specification whose one part has a value that nobody checked."""
    least, embed, _ = data_of(kind)

    def put(part: Any) -> Any:
        if type(part) is kind:
            return kind(**{**part._asdict(), name: value})
        if isinstance(part, tuple):
            items = [put(each) for each in part]
            return type(part)(*items) if hasattr(part, "_fields") else tuple(items)
        return part

    return put(made(embed(least)))


@pytest.mark.parametrize(("kind", "name"), EVERY_FIELD, ids=FIELD_IDS)
def test_wrong_types_in_python(kind: Any, name: str) -> None:
    """What is of a wrong type is refused with the path to it, or it does no harm.

    Harmless is a list for a tuple, and whatever is said as if it weren't there; but never a text
    with Python's names, or letters set apart.
    """
    hint = FIELDS[kind][name]
    path = data_of(kind)[2]
    values: tuple[Any, ...] = (
        *(None, 7, 1.5, "zz", b"zz", ["zz"], ("zz",), {"noun": "a"}, object(), {}, []),
        *(NounPhrase("zz"), Relative(Clause("go")), Opener("zz"), Sentence("zz"), (None,), (7,)),
    )
    for value in values:
        if takes(hint, value) or (isinstance(value, tuple) and takes(hint, list(value))):
            continue
        if type(value) in options(hint):
            continue
        try:
            said = heard(placed(kind, name, value))
        except SpecificationError as error:
            check_message(error)
            said = f"refused: {error}".replace(f"{kind.__name__}: ", path, 1)
        if not said.startswith("refused: "):
            assert not re.search(r"(?i)None|z z|z, z|[(\[]|object at", said), (value, said)
        elif bool not in options(hint) or said not in (
            heard(placed(kind, name, False)),
            heard(placed(kind, name, True)),
        ):
            assert said.startswith(f"refused: {path}{name}"), (value, said)


def heard(spec: Any) -> str:
    """Return the text of a specification, or why it is refused."""
    try:
        return REALIZER.realize(spec)
    except SpecificationError as error:
        check_message(error)
        if UNFORESEEN in str(error):
            raise AssertionError(str(error)) from None
        return f"refused: {error}"


UNSAYABLE: list[tuple[Callable[[], Any], str]] = [
    (lambda: None, "expected a phrase, found nothing; "),
    (lambda: 7, "expected a phrase, found '7'; "),
    (list, "expected a phrase, found a list; "),
    (tuple, "expected a phrase, found a tuple; "),
    (lambda: ("a",), "expected a phrase, found a tuple; "),
    (lambda: {"noun": "cat"}, "expected a phrase, found a mapping; "),
    (lambda: b"cat", "expected a phrase, found a value of type bytes; "),
    (lambda: made({"body": "a"})._replace(body=None), "body: expected a phrase, found nothing; "),
    (lambda: Sentence(Any), "body: expected a phrase, found a value of type "),  # type: ignore[arg-type]
    (
        lambda: Sentence(made({"body": "a"})),
        "body: expected a phrase, found a value of type Sentence",
    ),
    (lambda: Clause("run"), "the clause with the verb 'run' has no subject; add one"),
    (
        lambda: Clause("say", "a", object=Clause("run")),
        "object: the clause with the verb 'run' has no subject; add one",
    ),
    (
        lambda: Sentence("a", joined=(Joined("and", Clause("run")),)),
        "joined[0].body: the clause with the verb 'run' has no subject; add one",
    ),
    (
        lambda: Clause("go", "a", subordinates=(Subordinate("if", Clause("run")),)),
        "subordinates[0].clause: the clause with the verb 'run' has no subject; add one",
    ),
    (lambda: NounPhrase(""), "a noun phrase says nothing; give it a noun"),
    (
        lambda: Clause("see", "a", object=NounPhrase("")),
        "object: a noun phrase says nothing; give it a noun",
    ),
    (
        lambda: Clause("run", "a", mood="interrogative", question=Question("who")),
        "the subject stands twice, in the clause and before it; leave it out of the clause",
    ),
    (
        lambda: NounPhrase("a", relative=Relative(Clause("see", "b", object="c"), role="object")),
        "relative: the object stands twice, in the clause and before it; leave it out of the",
    ),
    (
        # The same word stands before the one at fault.
        lambda: NounPhrase("a", relative=Relative(Coordination(("a", "b")))),
        "relative.clause",
    ),
    (lambda: Coordination(()), ""),
    (lambda: Text(()), ""),
    (lambda: AdjectivePhrase(""), ""),
    (lambda: Numeral(float("nan")), "nan cannot be said; give a finite number"),
    (lambda: Numeral(1.5, ordinal=True), ""),
    (lambda: made({"noun": "a"})._replace(ordinal=1.5), "ordinal: expected a whole number"),
    (lambda: NounPhrase("cat", cardinal=float("inf")), "inf cannot be said; give a finite number"),
    (Date, "the date lacks a month; give a month, a month and a day, or a year"),
    (lambda: Clause("go", "a", adverbials=(Date(2000, 13),)), "adverbials[0]: no calendar has"),
    (lambda: Date(2**70), "no calendar has year "),
    (lambda: NounPhrase("cat", stutter=10**15), "stutter"),
    (lambda: Clause("go", "a", ellipsis=("subj",)), "Clause: ellipsis cannot be 'subj'; did you"),  # type: ignore[arg-type]
]


@pytest.mark.parametrize(("make", "message"), UNSAYABLE, ids=[row[1][:40] for row in UNSAYABLE])
def test_what_cannot_be_said_from_python(make: Callable[[], Any], message: str) -> None:
    """When it is made or when it is said, and then with the path."""
    with pytest.raises(SpecificationError) as caught:
        REALIZER.realize(make())
    check_message(caught.value)
    assert UNFORESEEN not in str(caught.value)
    told = str(caught.value)
    # A feature may be named with its path, or when the value is made with its type.
    path = message.partition(":")[0]
    assert message in told
    assert told.startswith(message) or re.match(rf"[A-Z]\w+: {re.escape(path)}", told), told


@pytest.mark.parametrize("times", [200, 5000])
@pytest.mark.parametrize(
    "level",
    [
        lambda x: NounPhrase("a", possessor=x),
        lambda x: NounPhrase("a", modifiers=(x,)),
        lambda x: NounPhrase("a", relative=Relative(Clause("see", object=x))),
        lambda x: AdjectivePhrase("big", complement=x),
        lambda x: Coordination((x, "a")),
        lambda x: Text((x,)),
        lambda x: Text((Cased(NounPhrase("a", apposition=x)),)),
        lambda x: PrepositionalPhrase("in", x),
        lambda x: Clause("see", "a", object=x),
        lambda x: Clause("see", x),
        lambda x: Clause("say", "a", quotation=Quotation(Sentence(x))),
        lambda x: Clause("go", mood="interrogative", question=Question(x)),
        lambda x: (x,),
        lambda x: [x],
        lambda x: {"noun": x},
    ],
    ids=[
        *("possessor", "modifiers", "relative", "complement", "coordination", "text", "cased"),
        *("prepositional", "object", "subject", "quotation", "question", "tuple", "list", "dict"),
    ],
)
def test_deep_python_values(level: Callable[[Any], Any], times: int) -> None:
    """They are said, or refused: even those that Python itself cannot print."""
    value: Any = NounPhrase("a")
    for _ in range(times):
        value = level(value)
    for spec in (value, Clause("see", "a", object=value), Sentence(value)):
        text = heard(spec)
        assert len(text) < 300 if text.startswith("refused: ") else clean(text)


def test_data_5000_deep_in_python() -> None:
    for level in ({"noun": "a", "possessor": None}, [None]):
        value: Any = "a"
        for _ in range(5000):
            value = {**level, "possessor": value} if isinstance(level, dict) else [value]
        with pytest.raises(MisreadError, match=r"more than 64 levels deep; nest less$"):
            read_specification(value)


# Values that nobody can change


def specimens() -> list[Any]:
    """Return a value of every type, and some whole specifications."""
    found = {type(part): part for seed in range(300) for part in _parts(_random(seed))}
    assert set(found) >= set(KINDS), set(KINDS) - set(found)
    return [found[kind] for kind in KINDS] + [_random(seed) for seed in range(20)]


def _random(seed: int) -> Sentence:
    return RandomSpecs(seed).sentence()


def _parts(spec: Any) -> list[Any]:
    if not isinstance(spec, tuple):
        return []
    own = [spec] if type(spec) in FIELDS else []
    return own + [part for each in spec for part in _parts(each)]


@pytest.mark.parametrize("spec", specimens(), ids=lambda spec: type(spec).__name__)
def test_specifications_are_values(spec: Any) -> None:
    """They cannot be changed, can be hashed, copied and pickled, and are then equal."""
    with pytest.raises(AttributeError):
        setattr(spec, spec._fields[0], "b")
    with pytest.raises(AttributeError):
        spec.brand_new = 1
    with pytest.raises(AttributeError):
        delattr(spec, spec._fields[0])
    with pytest.raises(TypeError):
        spec[0] = "b"
    assert hash(spec) == hash(copy.deepcopy(spec))
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(spec, protocol))
        assert type(again) is type(spec)
        assert again == spec
        assert repr(again) == repr(spec)
    for again in (copy.copy(spec), copy.deepcopy(spec), type(spec)(*spec), spec._replace()):
        assert type(again) is type(spec)
        assert again == spec
    assert type(spec)(**spec._asdict()) == spec


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: str(kind.__name__))
def test_replace(kind: Any) -> None:
    """Another value is a copy's; a feature that does not exist is an error."""
    least, embed, _ = data_of(kind)
    spec = next(part for part in _parts(made(embed(least))) if type(part) is kind)
    first = kind._fields[0]
    assert getattr(spec._replace(**{first: "other"}), first) == "other"
    assert getattr(spec, first) != "other"
    for wrong in ("zz", f"{first}x", "_fields", ""):
        with pytest.raises((ValueError, SpecificationError)):
            spec._replace(**{wrong: 1})


def test_no_copy_has_a_value_that_a_feature_cannot_have() -> None:
    """It is refused when the copy is made, or at the latest when it is said."""
    wrong: list[tuple[Any, str, str]] = [
        (NounPhrase("cat"), "number", "many"),
        (Clause("go", "a"), "mood", "asking"),
        (Clause("go", "a"), "tense", "pst"),
        (AdjectivePhrase("big"), "degree", "more"),
        (Clause("go", "a"), "form", "going"),
    ]
    said = []
    for spec, name, value in wrong:
        try:
            said.append(REALIZER.realize(spec._replace(**{name: value})))
        except SpecificationError as error:
            check_message(error)
    assert not said


def test_every_case_is_a_value() -> None:
    for case in read_cases()[::7]:
        assert pickle.loads(pickle.dumps(case.spec)) == case.spec
        assert isinstance(hash(case.spec), int)


@pytest.mark.parametrize(
    "content", ["noun: 7", "noun: [", "{verb: go}"], ids=["reading", "syntax", "realizing"]
)
def test_errors_can_be_pickled(content: str) -> None:
    """A pool of processes sends them home; one that cannot be sent leaves the caller waiting."""
    with pytest.raises(PersonageError) as caught:
        say(content)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    with pytest.raises(SpecificationError) as misread:
        REALIZER.realize(Clause("go"))
    assert str(pickle.loads(pickle.dumps(misread.value))) == str(misread.value)


def test_reading_changes_nothing() -> None:
    """The data is left as it was, and each reading gives values of its own."""
    for path in CASE_FILES[:3]:
        specs = case_specs(path)
        before = copy.deepcopy(specs)
        assert [read_specification(spec) for spec in specs] == [
            read_specification(spec) for spec in specs
        ]
        assert specs == before
