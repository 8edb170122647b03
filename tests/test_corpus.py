"""Corpora: even, the same at every run, said again record by record, and resumed where cut."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite import Generator
from personage_lite.corpus import TURNS, Order, write_corpus
from personage_lite.errors import PersonageError
from tests.mutation import check_message
from tests.test_cli import COMMAND, ENVIRONMENT, HEAD, KIND, ROOT, fault, one_line, say

COUNT = 60


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """Return a corpus of 60 utterances."""
    path = tmp_path_factory.mktemp("whole") / "corpus.jsonl"
    write_corpus(path, COUNT)
    return path.read_bytes()


def records(content: bytes) -> list[dict[str, object]]:
    return [json.loads(line) for line in content.splitlines()]


def test_the_command(whole: bytes, tmp_path: Path) -> None:
    path = tmp_path / "corpus.jsonl"
    assert say("corpus", "--count", str(COUNT), "--out", str(path)) == [f"{path}: 60 utterances"]
    assert path.read_bytes() == whole
    assert [one.name for one in tmp_path.iterdir()] == ["corpus.jsonl"]


def test_it_is_even_and_each_utterance_has_its_own_seed(whole: bytes) -> None:
    found = records(whole)
    cells = Counter((one["x"], one["character"]) for one in found)
    assert {x for x, _ in cells} == {-2.0, -1.0, 0.0, 1.0, 2.0}
    assert len(cells) == min(COUNT, 5 * len(Generator().characters()))
    assert max(cells.values()) - min(cells.values()) <= 1
    assert len({one["seed"] for one in found}) == COUNT
    assert {one["turn"] for one in found} > {0}


def test_any_beginning_is_even_over_x(whole: bytes) -> None:
    for count in range(1, COUNT):
        xs = Counter(one["x"] for one in records(whole)[:count])
        assert max(xs.values()) - min([*xs.values(), *([0] * (5 - len(xs)))]) <= 1


def test_each_record_can_be_generated_again(whole: bytes) -> None:
    lines = whole.decode().splitlines()
    later = [line for line in lines if json.loads(line)["turn"]]
    for line in (*lines[:3], *later[:2]):
        one = json.loads(line)
        asked = ("--character", one["character"], "--x", str(one["x"]), "--seed", str(one["seed"]))
        count = ("--count", str(one["turn"] + 1), "--format", "json")
        assert say("generate", *asked, *count)[-1] == line


def test_the_options(tmp_path: Path) -> None:
    facts = tmp_path / "ann.yaml"
    facts.write_text(HEAD + KIND, "utf-8")
    path = tmp_path / "corpus.json"
    options = ("--x", "1.5", "--x", "-0", "--character", "Ann", "--facts", str(facts))
    more = ("--seed", "7", "--set", "exclamation=1", "--rating", "clean")
    say("corpus", "--count", "4", "--out", str(path), *options, *more)
    found = records(path.read_bytes())
    assert [one["x"] for one in found] == [1.5, 0.0, 1.5, 0.0]
    assert {one["character"] for one in found} == {"ann"}
    assert "-0.0" not in path.read_text("utf-8")
    parameters = [one["parameters"] for one in found]
    assert all(isinstance(one, dict) and one["exclamation"] == 1 for one in parameters)
    last = found[-1]
    again = Generator(facts=facts).turns(
        "ann",
        0,
        int(str(last["seed"])),
        count=int(str(last["turn"])) + 1,
        overrides={"exclamation": 1},
        rating="clean",
    )
    assert [one.record() for one in again][-1] == last


def test_seeds_depend_on_nothing_else() -> None:
    few = Order(3, (2.0,), ("alice",), {}, "mild", None)
    many = Order(3, (-2.0, 2.0), ("alice", "hatter"), {}, "mild", None)
    assert few.request(5) == many.request(5 * 4 + 1)
    assert few.request(5) != few._replace(seed=4).request(5)
    turns = [few.request(index).turn for index in range(len(TURNS))]
    assert sorted(turns) == sorted(TURNS)
    start = turns.index(3) - TURNS.index(3)
    assert turns == [*TURNS[-start:], *TURNS[:-start]]


def test_workers_change_no_byte(whole: bytes, tmp_path: Path) -> None:
    one, two = tmp_path / "one.jsonl", tmp_path / "two.jsonl"
    write_corpus(one, 130)
    say("corpus", "--count", "130", "--out", str(two), "--workers", "2")
    assert one.read_bytes() == two.read_bytes()
    assert one.read_bytes().startswith(whole)


# Going on


@settings(max_examples=25, deadline=None)
@given(share=st.floats(0, 1))
def test_it_goes_on_wherever_it_was_cut(
    share: float, whole: bytes, tmp_path_factory: pytest.TempPathFactory
) -> None:
    path = tmp_path_factory.mktemp("cut") / "corpus.jsonl"
    kept = whole[: round(share * len(whole))]
    path.with_name("corpus.jsonl.partial").write_bytes(kept)
    seen: list[int] = []
    written = write_corpus(path, COUNT, progress=seen.append)
    assert path.read_bytes() == whole
    assert written.earlier == seen[0] == kept.count(b"\n")
    assert seen[-1] == COUNT
    assert [one.name for one in path.parent.iterdir()] == ["corpus.jsonl"]


def test_a_longer_or_shorter_corpus_goes_on_from_it(whole: bytes, tmp_path: Path) -> None:
    path, partial = tmp_path / "a.jsonl", tmp_path / "a.jsonl.partial"
    partial.write_bytes(whole)
    shown = say("corpus", "--count", "40", "--out", str(path))
    assert shown == [f"{path}: 40 utterances, 40 of them by an earlier run"]
    assert path.read_bytes() == b"".join(whole.splitlines(keepends=True)[:40])
    partial.write_bytes(path.read_bytes())
    write_corpus(path, COUNT)
    assert path.read_bytes() == whole


@pytest.mark.parametrize("line", [0, 20, 59])
def test_what_another_command_began_is_left_alone(line: int, whole: bytes, tmp_path: Path) -> None:
    lines = whole.splitlines(keepends=True)
    if line == 20:  # Of a file of 25 lines it is one of the last 16.
        lines = lines[:25]
    lines[line] = lines[line].replace(b'"x": ', b'"x": 1')
    partial = tmp_path / "corpus.jsonl.partial"
    partial.write_bytes(b"".join(lines))
    found = fault("corpus", "--count", "60", "--out", str(tmp_path / "corpus.jsonl"))
    assert f"corpus.jsonl.partial is of another command (line {line + 1} differs); run" in found
    assert partial.read_bytes() == b"".join(lines)
    assert not (tmp_path / "corpus.jsonl").exists()


def test_another_seed_does_not_go_on(whole: bytes, tmp_path: Path) -> None:
    (tmp_path / "corpus.jsonl.partial").write_bytes(whole)
    with pytest.raises(PersonageError, match="is of another command"):
        write_corpus(tmp_path / "corpus.jsonl", COUNT, seed=1)


def _listen_to_signals() -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.mark.skipif(sys.platform == "win32", reason="no signals")
@pytest.mark.parametrize("workers", ["1", "2"])
def test_ctrl_c_leaves_whole_lines_and_the_same_command_goes_on(
    workers: str, tmp_path: Path
) -> None:
    path, partial = tmp_path / "corpus.jsonl", tmp_path / "corpus.jsonl.partial"
    options = ("corpus", "--count", "400", "--out", str(path), "--x", "2", "--workers", workers)
    process = subprocess.Popen(
        [*COMMAND, *options],
        cwd=ROOT,
        env=ENVIRONMENT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        start_new_session=True,
        # A shell lets what it starts in the background not hear Ctrl-C.
        preexec_fn=_listen_to_signals,  # noqa: PLW1509 - there are no threads
    )
    while process.poll() is None and not (partial.exists() and partial.stat().st_size):
        time.sleep(0.01)
    # As the terminal does it: to all processes of the command.
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=60)
    if process.returncode == 0:
        pytest.skip("it was faster than the signal")
    assert (process.returncode, out) == (130, "")
    assert "interrupted" in one_line(err)
    kept = partial.read_bytes()
    assert kept.endswith(b"\n")
    lines = kept.count(b"\n")
    assert 0 < lines < 400
    (shown,) = say(*options)
    assert f"{lines} of them by an earlier run" in shown
    assert path.read_bytes().startswith(kept)


@pytest.mark.skipif(sys.platform == "win32", reason="no locks")
def test_two_processes_do_not_write_one_file(tmp_path: Path) -> None:
    import fcntl

    with open(tmp_path / "corpus.jsonl.partial", "ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        found = fault("corpus", "--count", "3", "--out", str(tmp_path / "corpus.jsonl"))
    assert "another process is writing" in found


@pytest.mark.skipif(sys.platform == "win32", reason="no terminals of this kind")
def test_progress_is_shown_on_a_terminal_only(tmp_path: Path) -> None:
    import pty

    ours, theirs = pty.openpty()
    options = ("corpus", "--count", "120", "--out", str(tmp_path / "corpus.jsonl"))
    done = subprocess.run(
        [*COMMAND, *options],
        cwd=ROOT,
        env=ENVIRONMENT,
        stdout=subprocess.PIPE,
        stderr=theirs,
        check=True,
        timeout=60,
    )
    os.close(theirs)
    shown = os.read(ours, 10_000).decode()
    os.close(ours)
    assert "\r50 of 120 utterances\r100 of 120 utterances\r120 of 120" in shown
    assert shown.endswith("\x1b[K")
    assert done.stdout.count(b"\n") == 1


# Faults


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--count", "0"), "--count is '0'; give a whole number from 1"),
        (("--count", "many"), "--count is 'many'; give"),
        (("--seed", "-1"), "--seed is '-1'; give"),
        (("--workers", "0"), "--workers is '0'; give"),
        (("--x", "3"), "X is 3; give a number from -2 (introvert) to 2 (extravert)"),
        (("--x", "high"), "X is high; give a number"),
        (("--x", "1", "--x", "1.0"), "X 1 is given twice; give each but once"),
        (("--character", "alcie"), "no character 'alcie'; did you mean alice?"),
        (("--character", "alice", "--character", "Alice"), "character 'alice' is given twice"),
        (("--set", "verbosy=1"), "no parameter 'verbosy'; did you mean"),
        (("--set", "verbosity=2"), "verbosity"),
        (("--facts", "nowhere"), "nowhere: no such file or folder; check the path"),
        (("--out", "corpus.parquet"), "'corpus.parquet' is no such name; end it in .jsonl"),
        (("--out", "corpus"), "'corpus' is no such name; end it in .jsonl"),
        (("--out", "nowhere/corpus.jsonl"), "cannot be written (No such file or directory); cho"),
        (("--out", "folder.json"), "folder.json: is a folder; name a file in it"),
    ],
)
def test_faults(options: tuple[str, ...], message: str, tmp_path: Path) -> None:
    (tmp_path / "folder.json").mkdir()
    given_options = list(options)
    if "--out" in given_options:
        given_options[1] = str(tmp_path / given_options[1])
    else:
        given_options += ["--out", str(tmp_path / "corpus.jsonl")]
    if "--count" not in given_options:
        given_options += ["--count", "3"]
    assert message in fault("corpus", *given_options)
    assert [one.name for one in tmp_path.iterdir()] == ["folder.json"]


def test_what_is_required() -> None:
    assert "required: --count, --out" in fault("corpus", code=2)
    assert "invalid choice: 'rude'" in fault(
        *("corpus", "--count", "1", "--out", "a.jsonl", "--rating", "rude"), code=2
    )


def test_faults_of_the_call(tmp_path: Path) -> None:
    for options in ({"xs": [5]}, {"characters": ["nobody"]}, {"rating": "rude"}):
        with pytest.raises(PersonageError) as caught:
            write_corpus(tmp_path / "corpus.jsonl", 3, **options)
        check_message(caught.value)
    assert not [*tmp_path.iterdir()]
