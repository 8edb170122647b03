"""Proves that data of any depth, and data that contains itself, is read or refused with its path.

It is nested through every field that can hold a mapping, by brackets, indentation and anchors.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any

import pytest

from personage_lite.realizer.reader import MisreadError, read_specification
from personage_lite.realizer.types import DEEPEST, FIELDS, item_type, options
from tests.realizer.reader_helpers import EVERY_FIELD, clean, flow, heard, refusal, say


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
    "Coordination.relative": lambda x: {
        **{"items": ["a", "b"], "relative": {"clause": {"verb": "see", "object": x}}}
    },
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


def test_data_5000_deep_in_python() -> None:
    for level in ({"noun": "a", "possessor": None}, [None]):
        value: Any = "a"
        for _ in range(5000):
            value = {**level, "possessor": value} if isinstance(level, dict) else [value]
        with pytest.raises(MisreadError, match=r"more than 64 levels deep; nest less$"):
            read_specification(value)
