"""The storyteller in a real terminal (a pty): keys, sizes, signals, and the terminal restored."""

from __future__ import annotations

import os
import re
import signal
import sys
import termios
from pathlib import Path
from typing import Any

import pytest

from adaptation.storyteller.session_log import read_sessions

pexpect = pytest.importorskip("pexpect")
ROOT = Path(__file__).resolve().parents[2]
_CODES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")


def start(tmp_path: Path, *options: str, rows: int = 24, columns: int = 80, **more: str) -> Any:
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "TERM": "xterm", "HOME": str(tmp_path)}
    environment.pop("NO_COLOR", None)
    arguments = ["-m", "personage_lite", "live", "--memory", "none", "--seed", "3", *options]
    return pexpect.spawn(
        sys.executable, arguments, env={**environment, **more}, dimensions=(rows, columns),
        encoding="utf-8", timeout=60,
    )  # fmt: skip


def finished(child: Any) -> str:
    """Wait for the end; the terminal must be as it was."""
    child.expect(pexpect.EOF)
    child.close()
    return str(child.before)


@pytest.mark.parametrize(("rows", "columns"), [(24, 80), (40, 120)])
def test_a_talk(tmp_path: Path, rows: int, columns: int) -> None:
    child = start(tmp_path, "--speed", "20", rows=rows, columns=columns)
    child.expect(r"Enter: yes")
    child.expect(r"likes?d? ?-2|liked -2")
    child.send("rabbit\r")
    child.expect("The White Rabbit is a")
    child.expect("telling")
    child.send("quit\r")
    child.expect("\x1b\\[\\?1049l")
    text = finished(child)
    assert "> quit" in text
    assert child.exitstatus == 0


def test_no_row_is_longer_than_the_terminal_and_no_colour_is_needed(tmp_path: Path) -> None:
    child = start(tmp_path, "--speed", "50", "--turns", "3", NO_COLOR="1")
    child.expect("Enter: yes")
    child.send("\r")
    drawn = str(child.before) + finished(child)
    assert "\x1b[2m" not in drawn
    for row in re.split(r"\x1b\[\d+;1H", drawn):
        assert len(_CODES.sub("", row).split("\r")[0]) <= 80 + 20


@pytest.mark.parametrize("wait", [0.0, 0.5, 1.5])
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_at_any_moment(tmp_path: Path, wait: float, number: signal.Signals) -> None:
    log = tmp_path / "log.jsonl"
    child = start(tmp_path, "--speed", "5", "--log", str(log))
    child.expect("press \\+ when you like it")
    before = termios.tcgetattr(child.child_fd)[3] & (termios.ECHO | termios.ICANON)
    if wait:
        child.expect("Enter: yes")
        child.send("\r")
        child.expect(pexpect.TIMEOUT, timeout=wait)
    child.kill(number)
    text = finished_open(child)
    after = text[1][3] & (termios.ECHO | termios.ICANON) if text[1] else before
    assert after == termios.ECHO | termios.ICANON
    entered, left = text[0].count("\x1b[?1049h"), text[0].count("\x1b[?1049l")
    assert left >= entered or not wait
    assert "Traceback" not in text[0]
    if wait:
        assert read_sessions(str(log))[0].lines[-1].kind == "end"


def finished_open(child: Any) -> tuple[str, Any]:
    """Wait for the end, and look at the terminal before it is gone."""
    text = str(child.after) if isinstance(child.after, str) else ""
    state = None
    try:
        while True:
            state = termios.tcgetattr(child.child_fd)
            text += child.read_nonblocking(65536, timeout=10)
    except (pexpect.EOF, pexpect.TIMEOUT, termios.error):
        pass
    child.close(force=True)
    return text, state


def test_a_small_terminal_gets_plain_text(tmp_path: Path) -> None:
    child = start(tmp_path, "--speed", "0", "--turns", "1", rows=8, columns=40)
    child.expect("the terminal is 40x8, so the story comes as plain text")
    child.send("yes\r")
    text = finished(child)
    assert "\x1b[" not in text
    assert child.exitstatus == 0


def test_plain_shows_no_status(tmp_path: Path) -> None:
    child = start(tmp_path, "--plain", "--speed", "0", "--turns", "2")
    child.expect(r"\?|\.")
    child.send("alice\r")
    text = finished(child)
    assert "liked" not in text
    assert "\x1b[" not in text


def test_the_window_changes_its_size(tmp_path: Path) -> None:
    child = start(tmp_path, "--speed", "5", rows=40, columns=120)
    child.expect("Enter: yes")
    child.send("\r")
    child.setwinsize(14, 50)
    child.expect("\x1b\\[14;1H")
    child.setwinsize(4, 12)
    child.expect("\x1b\\[4;1H")
    child.setwinsize(24, 80)
    child.expect("liked")
    child.send("\x04")
    child.send("\x15quit\r")
    finished(child)
    assert child.exitstatus == 0


def test_an_answer_in_the_middle_of_speech(tmp_path: Path) -> None:
    log = tmp_path / "log.jsonl"
    child = start(tmp_path, "--speed", "0.5", "--log", str(log))
    child.expect("Enter: yes")
    child.send(" ")  # skips the greeting
    child.send("alice\r")
    child.expect("telling")
    child.send("the hatter\r")
    child.expect("the Hatter")
    child.send("\x1b[200~junk\x00\x07" + "x" * 5000 + "\x15quit\r")
    finished(child)
    (session,) = read_sessions(str(log))
    assert [turn["character"] for turn in session.turns][:1] == ["alice"]
    assert child.exitstatus == 0


def test_the_end_of_the_input_is_a_farewell(tmp_path: Path) -> None:
    import subprocess

    done = subprocess.run(
        [sys.executable, "-m", "personage_lite", "live", "--memory", "none", "--speed", "0"],
        input=b"", capture_output=True, check=False, timeout=60,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert done.returncode == 0
    assert len(done.stdout.splitlines()) == 3
    assert b"Traceback" not in done.stderr


def test_ctrl_z_gives_the_terminal_back_and_fg_takes_it_again(tmp_path: Path) -> None:
    """In a shell with job control, as a person has it."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "TERM": "xterm", "PS1": "READY> "}
    shell = pexpect.spawn(
        "/bin/bash", ["--norc", "-i"], env=environment, dimensions=(24, 80), encoding="utf-8",
        timeout=60,
    )  # fmt: skip
    shell.expect("READY> ")
    before = termios.tcgetattr(shell.child_fd)[3]
    log = tmp_path / "log.jsonl"
    shell.sendline(f"{sys.executable} -m personage_lite live --seed 3 --speed 2 --log {log}")
    shell.expect("Enter: yes")
    assert termios.tcgetattr(shell.child_fd)[3] & termios.ICANON == 0
    shell.send("alice\r")
    shell.expect("telling")
    shell.send("\x1a")
    shell.expect("\x1b\\[\\?1049l")
    shell.expect("Stopped")
    shell.expect("READY> ")
    shell.sendline("fg")
    shell.expect("\x1b\\[\\?1049h")
    shell.expect("liked")
    assert termios.tcgetattr(shell.child_fd)[3] & (termios.ICANON | termios.ECHO) == 0
    shell.send("quit\r")
    shell.expect("\x1b\\[\\?1049l")
    shell.expect("READY> ")
    after = termios.tcgetattr(shell.child_fd)[3]
    flags = termios.ICANON | termios.ECHO
    assert after & flags == before & flags
    shell.sendline("exit")
    finished(shell)
    (session,) = read_sessions(str(log))
    assert session.lines[-1].fields["reason"] == "farewell"


def test_stopped_and_continued_by_signals(tmp_path: Path) -> None:
    """Without a shell that would set the terminal right: while stopped it is as it was."""
    child = start(tmp_path, "--speed", "2")
    flags = termios.ICANON | termios.ECHO
    child.expect("Enter: yes")
    assert termios.tcgetattr(child.child_fd)[3] & flags == 0
    for _ in range(2):
        child.kill(signal.SIGTSTP)
        child.expect("\x1b\\[\\?1049l")
        os.waitpid(child.pid, os.WUNTRACED)
        assert termios.tcgetattr(child.child_fd)[3] & flags == flags
        child.kill(signal.SIGCONT)
        child.expect("\x1b\\[\\?1049h")
        child.expect("liked")
        assert termios.tcgetattr(child.child_fd)[3] & flags == 0
    child.send("quit\r")
    finished(child)
    assert child.exitstatus == 0
