"""`personage-lite simulate`, through real processes."""

from __future__ import annotations

import json
import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from tests.test_cli import COMMAND, ENVIRONMENT, ROOT, fault, one_line, run, say


def records(*arguments: str) -> list[dict[str, Any]]:
    return [json.loads(line) for line in say("simulate", "--format", "json", *arguments)]


def test_the_defaults_are_the_papers_protocol() -> None:
    found = records()
    assert [record["noise"] for record in found] == [0, 0.1, 0.2, 0.3, 0.4, 0.5]
    for record in found:
        assert record["learner"] == "q-learning"
        assert (record["trials"], record["steps"], record["seed"]) == (30, 30, 0)
        assert (record["listener"], record["changes"]) == ("match", [15, 26])
        assert record["floor_bonus"] is True
        for measure in ("reward", "match", "engagement"):
            assert len(record[f"{measure}_by_step"]) == 30
        assert record["mean_reward"] == pytest.approx(sum(record["reward_by_step"]) / 30, abs=1e-5)


def test_the_options() -> None:
    (record,) = records(
        *("--learner", "oracle", "--noise", "0.25", "--listener", "level", "--trials", "7"),
        *("--steps", "12", "--seed", "5", "--changes", "4,9", "--no-floor-bonus"),
        *("--sensor-noise", "0"),
    )
    assert record["learner"] == "oracle"
    assert (record["noise"], record["listener_noise"], record["sensor_noise"]) == (0.25, 0.25, 0)
    assert (record["listener"], record["trials"], record["steps"]) == ("level", 7, 12)
    assert (record["seed"], record["changes"], record["floor_bonus"]) == (5, [4, 9], False)
    assert records("--changes", "none", "--noise", "0")[0]["changes"] == []


def test_several_learners_each_once() -> None:
    found = records(
        *("--learner", "random", "--learner", "always-zero", "--learner", "random"),
        *("--noise", "0.2", "--noise", "0", "--noise", "0.2"),
    )
    assert [(record["learner"], record["noise"]) for record in found] == [
        ("random", 0),
        ("random", 0.2),
        ("always-zero", 0),
        ("always-zero", 0.2),
    ]


def test_the_same_command_prints_the_same() -> None:
    first, second = (say("simulate", "--noise", "0.3", "--format", "json") for _ in range(2))
    assert first == second
    assert first != say("simulate", "--noise", "0.3", "--format", "json", "--seed", "1")


def test_the_table_has_always_zero_and_the_oracle_beside_it() -> None:
    lines = say("simulate", "--noise", "0", "--trials", "1000")
    assert lines[0].startswith(
        "listener match, 1000 trials of 30 steps, preference anew at steps 15"
    )
    starts = [line.split()[:2] for line in lines if "±" in line and line[0] not in "m"]
    assert starts == [["q-learning", "0.0"], ["always-zero", "0.0"], ["oracle", "0.0"]]


def test_the_plot(tmp_path: Path) -> None:
    target = tmp_path / "figure.png"
    say("simulate", "--noise", "0", "--plot", str(target))
    with Image.open(target) as picture:
        picture.verify()
    assert os.listdir(tmp_path) == ["figure.png"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--noise", "1.5"], "--noise is '1.5'; give a number from 0 to 1"),
        (["--noise", "-0.1"], "--noise is '-0.1'; give"),
        (["--noise", "nan"], "--noise is 'nan'; give"),
        (["--noise", "much"], "--noise is 'much'; give"),
        (["--sensor-noise", "2"], "--sensor-noise is '2'; give"),
        (["--listener-noise", "x"], "--listener-noise is 'x'; give"),
        (["--trials", "0"], "--trials is '0'; give a whole number from 1"),
        (["--trials", "-3"], "--trials is '-3'; give"),
        (["--trials", "1.5"], "--trials is '1.5'; give"),
        (["--steps", "0"], "--steps is '0'; give"),
        (["--steps", "1000000000"], "--steps is 1000000000; give a whole number from 1 to 100000"),
        (["--seed", "-1"], "--seed is '-1'; give"),
        (
            ["--learner", "dice"],
            "no learner 'dice'; choose from: q-learning, sarsa, expected-sarsa",
        ),
        (["--listener", "mach"], "no listener 'mach'; choose from: match, closer, graded, near"),
        (["--changes", "26,15"], "--changes is '26,15'; give rising steps from 2 to 30"),
        (["--changes", "15,31"], "--changes is '15,31'; give"),
        (["--changes", "a"], "--changes is 'a'; give"),
        (["--plot", "figure.gif"], "cannot plot to figure.gif; choose a name in .png"),
        (["--plot", "nowhere/figure.png"], "cannot plot to nowhere/figure.png; choose a file"),
    ],
)
def test_bad_input(arguments: list[str], message: str) -> None:
    # So many trials would take an hour: all of these are found before.
    slow = () if "--trials" in arguments else ("--trials", "1000000000")
    assert message in fault("simulate", *arguments, *slow)


def test_without_numpy() -> None:
    code = (
        "import sys; sys.modules['numpy'] = None; from personage_lite.cli import main;"
        "sys.exit(main(['simulate']))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        env=ENVIRONMENT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout) == (1, "")
    assert "simulate needs numpy; pip install personage-lite[adaptation]" in one_line(done.stderr)


def test_other_commands_do_not_load_numpy() -> None:
    code = (
        "import sys; from personage_lite.cli import main; main(['characters']);"
        "sys.exit('numpy' in sys.modules or 'adaptation' in sys.modules)"
    )
    subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, env=ENVIRONMENT, stdout=subprocess.PIPE, check=True
    )


def _listen_to_ctrl_c() -> None:
    """Undo what a shell does to commands in the background: they do not hear Ctrl-C."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def test_ctrl_c_leaves_no_half_file(tmp_path: Path) -> None:
    target = tmp_path / "figure.png"
    command = [*COMMAND, "simulate", "--trials", "1000000000", "--plot", str(target)]
    with subprocess.Popen(
        command,
        cwd=ROOT,
        env=ENVIRONMENT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=_listen_to_ctrl_c,  # noqa: PLW1509 - there are no threads
    ) as process:
        time.sleep(3)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=30)
    assert process.returncode == 130
    assert out == ""
    assert "interrupted" in one_line(err)
    assert os.listdir(tmp_path) == []


def _on_terminal(*arguments: str) -> str:
    """Return what a command shows on a terminal; it is interrupted once a bar is there."""
    ours, its = pty.openpty()
    shown = b""
    with subprocess.Popen(
        [*COMMAND, *arguments],
        cwd=ROOT,
        env=ENVIRONMENT,
        stdout=subprocess.DEVNULL,
        stderr=its,
        preexec_fn=_listen_to_ctrl_c,  # noqa: PLW1509 - there are no threads
    ) as process:
        os.close(its)
        interrupted = False
        while True:
            try:
                part = os.read(ours, 1 << 16)
            except OSError:  # It has ended.
                break
            if not part:
                break
            shown += part
            if b"%" in shown and not interrupted:
                interrupted = True
                process.send_signal(signal.SIGINT)
    os.close(ours)
    assert process.returncode == 130
    return shown.decode()


@pytest.mark.skipif(sys.platform == "win32", reason="needs a terminal")
def test_a_progress_bar_on_a_terminal_if_it_takes_long() -> None:
    shown = _on_terminal("simulate", "--trials", "1000000000", "--noise", "0")
    assert "[....." in shown
    assert "\x1b" not in shown, "plain returns only"
    last = shown.rstrip().splitlines()[-1]
    assert last.split("\r")[-1].startswith("personage-lite: interrupted"), "the bar is gone"


def test_no_bar_elsewhere() -> None:
    code, _, err = run("simulate", "--trials", "100")
    assert (code, err) == (0, "")
