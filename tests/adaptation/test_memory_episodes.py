"""Two episodes with one listener, through the storyteller itself, on SQLite and on PostgreSQL."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from adaptation.memory import open_memory
from adaptation.storyteller.session_log import Session, read_sessions
from personage_lite.cli import main

ROOT = Path(__file__).resolve().parents[2]


def episode(place: str, log: Path, name: str, turns: int, *more: str) -> Session:
    """Run a session with a simulated listener whose taste is 2; returns what was logged."""
    arguments = ["live", "--listener", "live", "--tastes", "2", "--changes", "none", "--plain"]
    arguments += ["--speed", "0", "--turns", str(turns), "--name", name, "--memory", place]
    command = [sys.executable, "-m", "personage_lite", *arguments, "--log", str(log), *more]
    done = subprocess.run(
        command, cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stderr.decode()
    return read_sessions(str(log))[-1]


def facts(session: Session) -> list[tuple[str, str]]:
    return [(turn["character"], fact) for turn in session.turns for fact in turn["facts"]]


def test_a_second_episode_goes_on_from_the_first(database: str, tmp_path: Path) -> None:
    log = tmp_path / "log.jsonl"
    # Eleven of twelve seeds find the taste in so many utterances, nine in fourteen.
    first = episode(database, log, "Anna", 24, "--seed", "3")
    second = episode(database, log, "  anna", 6, "--seed", "2")
    stranger = episode(database, log, "Bert", 3, "--seed", "2")
    greeted = next(line.fields for line in second.lines if line.kind == "say")
    assert greeted["act"] == "greeting_again"
    assert "anna" in greeted["text"].lower()
    assert not set(facts(first)) & set(facts(second))
    assert len(set(facts(first)) | set(facts(second))) == len(facts(first) + facts(second))
    assert abs(first.turns[-1]["x"] - 2) <= 1, "the taste was learned"
    assert abs(second.turns[0]["x"] - 2) <= 1, "and is known at once"
    assert first.turns[0]["x"] == stranger.turns[0]["x"] == 0
    met = next(line.fields for line in stranger.lines if line.kind == "say")
    assert met["act"] == "greeting_named"
    memory = open_memory(database)
    kept: list[Any] = memory.turns("anna")
    assert [[turn["text"] for turn in turns] for turns in kept] == [
        [turn["text"] for turn in session.turns] for session in (first, second)
    ]
    memory.close()


def test_forgotten_means_a_stranger(
    database: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    log = tmp_path / "log.jsonl"
    episode(database, log, "Anna", 3)
    episode(database, log, "Bert", 3)
    capsys.readouterr()
    assert main(["forget", "--list", "--memory", database, "--format", "json"]) == 0
    listed = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [(each["name"], each["episodes"], each["turns"]) for each in listed] == [
        ("Anna", 1, 3),
        ("Bert", 1, 3),
    ]
    assert main(["forget", "ANNA", "--memory", database]) == 0
    assert capsys.readouterr().out.startswith("Everything about ANNA is erased from ")
    assert main(["forget", "Anna", "--memory", database]) == 1
    assert capsys.readouterr().err == (
        "personage-lite: nobody called 'Anna' is remembered; forget --list shows who is\n"
    )
    assert main(["forget", "Brt", "--memory", database]) == 1
    assert "did you mean Bert?" in capsys.readouterr().err
    assert episode(database, log, "Anna", 2).turns[0]["x"] == 0
