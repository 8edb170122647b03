"""Every session has a log, in the user's own folder, unless another or none is asked for."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from adaptation.storyteller.kept_logs import claimed, erase_logs, last_log, log_folder
from adaptation.storyteller.session_log import read_sessions
from personage_lite.cli import main
from personage_lite.errors import PersonageError

ROOT = Path(__file__).resolve().parents[2]
SHORT = ("live", "--listener", "match", "--speed", "0", "--turns", "2", "--seed", "1")


def run(*options: str) -> int:
    with open("/dev/null") as nothing, pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.stdin", nothing)
        return main([*SHORT, *options])


def logs() -> list[Path]:
    return sorted(log_folder().glob("*"))


def test_a_session_keeps_a_log_for_the_user_alone(capfd: pytest.CaptureFixture[str]) -> None:
    assert run() == 0
    shown = capfd.readouterr()
    (log,) = logs()
    assert f"live --replay {log}" in shown.err
    assert stat.S_IMODE(log.stat().st_mode) == 0o600
    assert stat.S_IMODE(log.parent.stat().st_mode) == 0o700
    assert stat.S_IMODE(log.parent.parent.stat().st_mode) == 0o700
    (session,) = read_sessions(str(log))
    assert len(session.turns) == 2
    assert session.lines[-1].kind == "end"
    assert main(["live", "--replay"]) == 0
    assert capfd.readouterr().out == shown.out


def test_plain_text_names_no_log(capfd: pytest.CaptureFixture[str]) -> None:
    assert run("--plain") == 0
    assert "replay" not in capfd.readouterr().err
    assert len(logs()) == 1


def test_another_log_or_none(tmp_path: Path) -> None:
    assert run("--no-log") == 0
    assert run("--log", str(tmp_path / "mine.jsonl")) == 0
    assert logs() == []
    assert (tmp_path / "mine.jsonl").exists()


def test_sessions_at_once_share_no_log() -> None:
    started = [
        subprocess.Popen(
            [sys.executable, "-m", "personage_lite", *SHORT, "--plain"],
            cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        )
        for _ in range(4)
    ]  # fmt: skip
    assert [process.wait(60) for process in started] == [0] * 4
    assert [len(read_sessions(str(log))) for log in logs()] == [1] * 4


def test_a_name_is_claimed_once(tmp_path: Path) -> None:
    names = [claimed(tmp_path / "a" / "logs", 0.0).name for _ in range(3)]
    start = "1970-01-01T00-00-00Z"
    assert names == [f"{start}.jsonl", f"{start}.2.jsonl", f"{start}.3.jsonl"]


def test_without_a_place_for_it_the_story_is_told(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    log_folder().parent.mkdir()
    log_folder().write_text("in the way", "utf-8")
    assert run() == 0
    shown = capfd.readouterr()
    assert len(shown.out.splitlines()) == 6
    (line,) = shown.err.splitlines()
    assert line.startswith(f"personage-lite: {log_folder()}: no log can be made there (")
    assert line.endswith("the story goes on, but no more of it is logged")

    def full(*_: Any) -> int:
        raise OSError(28, "No space left on device")

    log_folder().unlink()
    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", full)
        assert run() == 0
    (line,) = [line for line in capfd.readouterr().err.splitlines() if "No space" in line]
    assert line.endswith("the story goes on, but no more of it is logged")


def test_forgetting_somebody_erases_their_logs(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    place = str(tmp_path / "friends.sqlite")
    assert run("--name", "Anna", "--memory", place) == 0
    assert run("--name", "ANNA", "--memory", "none") == 0
    assert run("--name", "Anne", "--memory", place) == 0
    assert run() == 0
    mine = tmp_path / "mine.jsonl"
    assert run("--name", "Anna", "--memory", "none", "--log", str(mine)) == 0
    capfd.readouterr()
    assert main(["forget", "anna", "--memory", place]) == 0
    assert capfd.readouterr().out.splitlines() == [
        "2 session logs of anna on this machine are erased.",
        f"Everything about anna is erased from {place}.",
    ]
    left = [read_sessions(str(log))[0].header.fields["name"] for log in logs()]
    assert sorted(left) == ["", "Anne"]
    assert mine.exists()
    assert main(["forget", "anna", "--memory", place]) == 1


def test_who_was_met_without_a_memory_is_forgotten_too(capfd: pytest.CaptureFixture[str]) -> None:
    assert run("--name", "Anna", "--memory", "none") == 0
    capfd.readouterr()
    assert main(["forget", "Anna"]) == 0
    assert capfd.readouterr().out == "1 session log of Anna on this machine is erased.\n"
    assert logs() == []
    assert main(["forget", "Anna"]) == 1


def test_what_is_no_log_of_ours_stays(tmp_path: Path) -> None:
    for number, content in enumerate(
        (b"", b"Anna\n", b'{"line": "header"\n', b'{"line": "header", "name": 3}\n', b"\xff\n")
    ):
        (tmp_path / f"{number}.jsonl").write_bytes(content)
    assert erase_logs(tmp_path, "Anna") == 0
    assert len(list(tmp_path.iterdir())) == 5


def test_no_log_to_say_again(capfd: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(PersonageError, match="holds no session log; give --replay one"):
        last_log(log_folder())
    assert main(["live", "--replay"]) == 1
    assert len(capfd.readouterr().err.splitlines()) == 1
