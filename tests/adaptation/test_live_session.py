"""Whole sessions in simulated time: adaptation, log, replay, comparison."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from statistics import fmean
from typing import Any

import pytest

from adaptation.storyteller.session_log import SessionLog, read_sessions
from personage_lite.cli import main
from personage_lite.errors import PersonageError


def run(tmp_path: Path, *options: str) -> list[dict[str, Any]]:
    log = tmp_path / "log.jsonl"
    with open("/dev/null") as nothing, pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.stdin", nothing)
        assert main(["live", "--speed", "0", "--memory", "none", "--log", str(log), *options]) == 0
    return [json.loads(line) for line in log.read_text("utf-8").splitlines()]


def turns(lines: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [line for line in lines if line["line"] == "turn"]


@pytest.mark.parametrize(("listener", "before"), [("match", 0.3), ("live", 0.8)])
def test_x_follows_the_taste_and_its_change(tmp_path: Path, listener: str, before: float) -> None:
    """Over a few sessions; a single one can have bad luck with its sensor."""
    early, late = [], []
    for seed in range(2, 10):
        folder = tmp_path / str(seed)
        folder.mkdir()
        lines = run(
            folder, "--listener", listener, "--tastes", "2,-2", "--changes", "25",
            "--turns", "50", "--seed", str(seed),
        )  # fmt: skip
        told = turns(lines)
        assert told[0]["x"] == 0
        assert [turn["listener"]["preference"] for turn in told] == [2] * 24 + [-2] * 26
        assert all(abs(b["x"] - a["x"]) <= 1 for a, b in pairwise(told))
        early += [turn["x"] for turn in told[12:24]]
        late += [turn["x"] for turn in told[-8:]]
    assert fmean(early) > before
    assert fmean(late) < -0.8


def test_no_fact_is_told_twice_and_every_turn_is_logged(tmp_path: Path) -> None:
    lines = run(tmp_path, "--listener", "match", "--turns", "12", "--seed", "1")
    told = turns(lines)
    assert [line["line"] for line in lines][0 :: len(lines) - 1] == ["header", "end"]
    facts = [fact for turn in told for fact in turn["facts"]]
    assert len(facts) == len(set(facts))
    for turn in told:
        assert len(turn["stream"]) == pytest.approx(turn["duration"] / 0.2, abs=2)
        assert turn["reward"] is not None
        assert sum(turn["belief"]["preference"]) == pytest.approx(1, abs=1e-3)


def test_the_log_is_said_again_in_the_same_words(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run(tmp_path, "--listener", "match", "--turns", "10", "--seed", "1")
    said = capsys.readouterr().out
    log = tmp_path / "log.jsonl"
    assert main(["live", "--replay", str(log)]) == 0
    assert capsys.readouterr().out == said
    log.write_text(log.read_text("utf-8").replace("Alice", "Malice"), "utf-8")
    assert main(["live", "--replay", str(log)]) == 1
    assert "log.jsonl:" in capsys.readouterr().err


def test_learners_are_compared(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run(tmp_path, "--listener", "match", "--turns", "10", "--seed", "1", "--learner", "random")
    capsys.readouterr()
    assert main(["live", "--replay", str(tmp_path / "log.jsonl"), "--compare"]) == 0
    table = capsys.readouterr().out.splitlines()
    assert table[0] == "9 utterances with a choice and a reward"
    rows = {line.split()[0]: line.split() for line in table[2:-1]}
    assert abs(float(rows["random"][1]) - 1 / 3) < 0.1
    assert rows["bayes"]


def test_another_session_goes_on_with_the_log(tmp_path: Path) -> None:
    run(tmp_path, "--listener", "match", "--turns", "2", "--seed", "1")
    with open(tmp_path / "log.jsonl", "ab") as log:
        log.write(b'{"line": "turn", "x": ')  # killed in the middle of it
    run(tmp_path, "--listener", "match", "--turns", "2", "--seed", "2")
    assert [len(session.turns) for session in read_sessions(str(tmp_path / "log.jsonl"))] == [2, 2]


def test_what_is_no_log_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "diary.txt"
    path.write_text("Dear diary,\n", "utf-8")
    with pytest.raises(PersonageError, match="is no session log"):
        SessionLog(str(path))
    with pytest.raises(PersonageError, match=r"diary.txt:1: not JSON"):
        read_sessions(str(path))
    assert path.read_text("utf-8") == "Dear diary,\n"


@pytest.mark.parametrize("name", ["می\u200cخواهم", "ක්\u200dෂ", "李小龙"])
def test_a_listener_is_greeted_in_any_script(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    run(tmp_path, "--listener", "match", "--name", name, "--turns", "1", "--seed", "1")
    assert name in capsys.readouterr().out.splitlines()[0]


def test_two_sessions_do_not_write_one_log(tmp_path: Path) -> None:
    log = SessionLog(str(tmp_path / "log.jsonl"))
    with pytest.raises(PersonageError, match="another session is writing it"):
        SessionLog(str(tmp_path / "log.jsonl"))
    log.close()


def test_a_full_disk_is_said(tmp_path: Path) -> None:
    log = SessionLog("/dev/full")
    with pytest.raises(PersonageError, match="cannot be written"):
        log.write("end")
    log.close()


@pytest.mark.parametrize(
    ("options", "fault"),
    [
        (["--listener", "mach"], "no listener 'mach'"),
        (["--learner", "bays"], "no learner 'bays'"),
        (["--sensor", "camra"], "no sensor 'camra'"),
        (["--name", "a\x1bb"], "holds the character U+001B, which cannot be seen; leave it out"),
        (["--name", "a" * 10_000], "is 10000 characters long; give at most 100"),
        (["--speed", "-1"], "--speed is '-1'"),
        (["--turns", "0"], "--turns is '0'"),
        (["--characters", "alcie"], "no character 'alcie'; did you mean alice?"),
        (["--compare"], "add --replay LOG"),
        (["--replay", "/nowhere"], "cannot be read"),
        (["--log", "/nowhere/log"], "cannot be written"),
        (["--learner", "oracle"], "add --listener"),
        (["--listener", "match", "--tastes", "3"], "whole numbers from -2 to 2"),
    ],
)
def test_faults(options: list[str], fault: str, capsys: pytest.CaptureFixture[str]) -> None:
    with open("/dev/null") as nothing, pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.stdin", nothing)
        assert main(["live", "--memory", "none", *options]) == 1
    lines = capsys.readouterr().err.splitlines()
    assert fault in lines[-1]
    assert all(line.startswith("personage-lite: ") for line in lines)
