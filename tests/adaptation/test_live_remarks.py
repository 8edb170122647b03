"""Remarks in the middle of a session are evidence; accepting and refusing never is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adaptation.learners import LEARNERS
from adaptation.storyteller.protocols import Acquaintance
from adaptation.storyteller.replaying import replayed
from adaptation.storyteller.session_log import read_sessions
from personage_lite.cli.live import generator_for
from tests.adaptation.scripted import Answer, Shown, told

LEVELS = np.arange(-2, 3)
QUIET = "--sensor none --seed 5 --characters alice,hatter"


def belief(turn: dict[str, Any]) -> Any:
    return np.array(turn["belief"]["preference"])


def liked(turn: dict[str, Any]) -> float:
    """Return the X that the learner expects to be liked."""
    return float(belief(turn) @ LEVELS)


class Notebook:
    """A memory that notes what the learner knew after each turn."""

    def __init__(self) -> None:
        self.learners: list[Mapping[str, Any]] = []

    def recall(self, name: str) -> Acquaintance | None:
        return None

    def begin(self, name: str, when: float) -> Acquaintance:
        return Acquaintance(name, 1, {}, None, None)

    def remember(
        self,
        name: str,
        turn: Mapping[str, Any],
        learner: Mapping[str, Any],
        told: Mapping[str, Mapping[str, int]],
    ) -> None:
        self.learners.append(learner)

    def forget(self, name: str) -> bool:
        return False

    def close(self) -> None: ...


def talk(tmp_path: Path, *script: Answer, options: str = QUIET, turns: int = 4) -> Shown:
    return told(f"{options} --turns {turns}", script, tmp_path / "log.jsonl")


@pytest.mark.parametrize(
    ("remark", "direction"),
    [("less of that", -1), ("calm down, please", -1), ("more of that", 1), ("speak up", 1)],
)
def test_a_remark_while_it_speaks_moves_belief_and_x(
    tmp_path: Path, remark: str, direction: int
) -> None:
    shown = talk(tmp_path, Answer("yes"), Answer("more of that", 1), Answer(remark, 1))
    (first, second) = [line for line in shown.of("heard") if line["remark"]]
    assert first["speaking"]
    assert second["speaking"]
    assert second["text"] == remark
    turns = shown.of("turn")
    # The first remark was heard in the first utterance, at X = 0; the other in the second.
    assert liked(turns[0]) > 0.5
    assert (liked(turns[1]) - liked(turns[0])) * direction > 0
    assert (turns[2]["x"] - turns[1]["x"]) * direction >= 0
    assert turns[1]["x"] == 1


def test_praise_keeps_and_blame_leaves_an_x(tmp_path: Path) -> None:
    after: dict[str, tuple[float, list[int]]] = {}
    for remark in ("that's great", "boring"):
        shown = told(
            f"{QUIET} --turns 4", [Answer("yes"), Answer(remark, 1)], tmp_path / f"{len(after)}"
        )
        turns = shown.of("turn")
        assert turns[0]["x"] == 0
        after[remark] = (belief(turns[0])[2], [turn["x"] for turn in turns[1:]])
    assert after["that's great"][0] > 0.6
    assert after["boring"][0] < 0.2
    assert after["that's great"][1] == [0, 0, 0]
    assert all(x != 0 for x in after["boring"][1])


@pytest.mark.parametrize(
    "answers",
    [
        ["no", "no", "no"],
        ["yes"],
        ["no", "alice"],
        ["who", "nonsense", "no", "yes"],
        ["pause", "go on", "yes please"],
        ["great", "no"],
        ["boring", "yes"],
    ],
)
@pytest.mark.parametrize("learner", ["bayes", "q-learning"])
def test_answers_never_touch_the_learner(
    tmp_path: Path, answers: Sequence[str], learner: str
) -> None:
    memory = Notebook()
    shown = told(
        f"--name Anna --sensor none --seed 5 --turns 3 --learner {learner}",
        [Answer(text) for text in answers],
        tmp_path / "log.jsonl",
        memory=memory,
    )
    assert not [line for line in shown.of("heard") if line["remark"]]
    assert memory.learners == [LEARNERS[learner](1).save()] * len(shown.of("turn"))


def test_a_refusal_in_the_middle_of_speech_is_no_evidence(tmp_path: Path) -> None:
    refused = talk(tmp_path, Answer("alice"), Answer("no", 2), Answer("yes"))
    assert [line["sense"] for line in refused.of("heard")] == ["name", "no", "yes"]
    assert not [line for line in refused.of("heard") if line["remark"]]
    assert [turn["character"] for turn in refused.of("turn")][:3] == ["alice", "alice", "hatter"]
    assert all(turn["belief"]["preference"] == [0.2] * 5 for turn in refused.of("turn"))


def test_a_suggestion_is_accepted_by_praise_and_refused_by_blame(tmp_path: Path) -> None:
    shown = talk(tmp_path, Answer("boring"), Answer("great"))
    assert [line["sense"] for line in shown.of("heard")] == ["no", "yes"]
    refused, accepted = (say["character"] for say in shown.of("say") if say["character"])
    assert {turn["character"] for turn in shown.of("turn")} == {accepted} != {refused}


def test_a_remark_weighs_beside_what_is_sensed_and_is_replayed(tmp_path: Path) -> None:
    """Before a listener whom a sensor watches the remark is one piece of evidence of two."""
    log = tmp_path / "log.jsonl"
    options = "--sensor simulated --input live --seed 5 --characters alice --turns 6"
    shown = told(options, [Answer("yes"), Answer("more of that", 3)], log)
    silent = told(options, [Answer("yes")], tmp_path / "silent.jsonl")
    turns, others = shown.of("turn"), silent.of("turn")
    assert [turn["reward"] is not None for turn in turns] == [True] * 6
    assert turns[:2] == [{**turn, "when": turns[0]["when"]} for turn in others[:2]]
    assert liked(turns[2]) > liked(others[2])
    (session,) = read_sessions(str(log))
    again = [line.text for line in replayed(session, generator_for(None), str(log)) if line.said]
    assert again == [line["text"] for line in shown.log if line["line"] in ("say", "turn")]
