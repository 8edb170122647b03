"""`Generator.say`: what the storyteller says beside its facts, in the style of X."""

from __future__ import annotations

import re
from statistics import fmean
from typing import Any

import pytest

from personage_lite import Generator
from personage_lite.errors import PersonageError
from personage_lite.state import ConversationState

GENERATOR = Generator()
# What each act must be given; the others need nothing.
NAMED = ("greeting_named", "greeting_again", "farewell_named")
ABOUT = ("suggestion", "another", "exhausted", "told_already", "asked_again", "silence")
NEEDED: dict[str, dict[str, Any]] = {
    **{act: {"name": "Anna"} for act in NAMED},
    **{act: {"character": "the White Rabbit"} for act in ABOUT},
    "unknown_name": {"heard": "Pinocchio"},
}
ACTS = sorted(GENERATOR.dialog.acts)
SEEDS = range(40)


@pytest.mark.parametrize("act", ACTS)
@pytest.mark.parametrize("x", [-2, -1, 0, 1, 2])
def test_every_act_is_said_at_every_x(act: str, x: int) -> None:
    texts = set()
    for seed in SEEDS:
        said = GENERATOR.say(act, **NEEDED.get(act, {}), x=x, seed=seed)
        assert re.search(r"[.!?…]”?$", said.text), said.text
        assert said.text[0].isupper() or said.text[0] in "“…", said.text
        assert "{" not in said.text
        assert "  " not in said.text
        assert (said.act, said.x, said.seed, said.turn) == (act, x, seed, 0)
        assert said.state.turn == 1
        texts.add(said.text)
    assert len(texts) > 1


@pytest.mark.parametrize("act", sorted(NEEDED))
def test_what_is_to_be_named_is_named(act: str) -> None:
    (slot,) = NEEDED[act].values()
    word = slot.split()[-1]
    said = [GENERATOR.say(act, **NEEDED[act], x=0, seed=seed).text for seed in SEEDS]
    named = sum(word in text for text in said)
    if act in ("asked_again", "silence"):  # the question before has named them
        assert named < len(said)
        return
    assert named == len(said)
    with pytest.raises(PersonageError):
        GENERATOR.say(act)


def test_it_is_a_pure_function() -> None:
    state = ConversationState()
    one = GENERATOR.say("suggestion", character="alice", x=1, seed=3, state=state)
    assert GENERATOR.say("suggestion", character="alice", x=1, seed=3, state=state) == one
    assert Generator().say("suggestion", character="alice", x=1, seed=3) == one
    assert state == ConversationState()
    later = GENERATOR.say("suggestion", character="alice", x=1, seed=3, state=one.state)
    assert (later.turn, later.state.turn) == (1, 2)


def test_style_goes_with_x() -> None:
    def said(x: int) -> list[str]:
        acts = ("greeting", "suggestion", "farewell")
        return [
            GENERATOR.say(act, **NEEDED.get(act, {}), x=x, seed=seed).text
            for act in acts
            for seed in range(100)
        ]

    loud = {x: fmean("!" in text for text in said(x)) for x in (-2, 0, 2)}
    assert loud[-2] < 0.05 < loud[2]
    assert loud[-2] <= loud[0] < loud[2]
    stutters = re.compile(r"\b([A-Za-z]{1,3})-\1", re.IGNORECASE)
    broken = {x: sum(bool(stutters.search(text)) for text in said(x)) for x in (-2, 2)}
    assert broken[-2] > broken[2]


@pytest.mark.parametrize(
    ("act", "more"),
    [("sing", {}), ("suggestion", {"character": "pinocchio"}), ("greeting", {"x": 3})],
)
def test_faults(act: str, more: dict[str, Any]) -> None:
    with pytest.raises(PersonageError):
        GENERATOR.say(act, **more)
