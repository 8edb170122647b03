"""The command contract, through real processes (docs/commands.md).

Results on stdout, everything else on stderr; every fault is one line that names what, where and a
remedy, with an exit code of its own; and nothing is half-written.
"""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

from personage_lite import Generator, __version__
from personage_lite.cli import COMMANDS as NAMES
from personage_lite.cli import main, parser
from personage_lite.lexicon import MARKER_PLACES
from personage_lite.style import STAGES

ROOT = Path(__file__).resolve().parents[1]
COMMAND = [sys.executable, "-m", "personage_lite"]
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT), "COLUMNS": "80", "PYTHONIOENCODING": "ascii"}
MARKERS = yaml.safe_load((ROOT / "lexicons" / "markers.yaml").read_text("utf-8"))
HEAD = "about: ann\nentities: {ann: {name: Ann}}\nfacts:\n"
KIND = "  - {id: kind, attribute: kind, topic: nature}\n"
TALL = "  - {id: tall, attribute: tall, topic: nature}\n"


def run(*arguments: str, **options: Any) -> tuple[int, str, str]:
    """Return a command's exit code, stdout and stderr."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
    ran = subprocess.run(
        [*COMMAND, *arguments],
        cwd=ROOT,
        env=ENVIRONMENT,
        stdin=subprocess.DEVNULL,
        encoding="utf-8",
        timeout=60,
        check=False,
        **pipes,
    )
    return ran.returncode, ran.stdout or "", ran.stderr or ""


def say(*arguments: str) -> list[str]:
    """Return the lines that a right command prints; stderr stays empty."""
    code, out, err = run(*arguments)
    assert (code, err) == (0, "")
    assert out.endswith("\n")
    return out.splitlines()


def alice(*arguments: str) -> list[str]:
    """Return what is said about Alice."""
    seed = () if "--seed" in arguments else ("--seed", "7")
    return say("generate", "--character", "alice", *seed, *arguments)


def one_line(err: str) -> str:
    """Return a fault's line: there is but one, it ends, and it is no traceback."""
    assert "Traceback" not in err
    assert err.endswith("\n")
    assert len(err.splitlines()) == 1, err
    assert err.startswith("personage-lite")
    assert "; " in err, "no remedy"
    return err


def fault(*arguments: str, code: int = 1) -> str:
    """Return the line of a wrong command, which prints nothing else."""
    exited, out, err = run(*arguments)
    assert (exited, out) == (code, "")
    return one_line(err)


# generate


@pytest.mark.parametrize("name", ["white_rabbit", "WHITE Rabbit", "the white-rabbit"])
def test_character(name: str) -> None:
    (line,) = say("generate", "--character", name, "--seed", "1", "--format", "json")
    assert json.loads(line)["character"] == "white_rabbit"


@pytest.mark.parametrize("x", ["-2", "-.5", "1.25"])
def test_x(x: str) -> None:
    (line,) = alice("--x", x, "--format", "json")
    assert json.loads(line)["x"] == float(x)


def test_the_same_seed_gives_the_same_text() -> None:
    assert alice("--seed", "7", "--x", "1") == alice("--seed", "7", "--x", "1")
    seeds = ("1", "2", "3", "4", "5", str(2**63 - 1))
    talks = {tuple(alice("--seed", seed, "--count", "3")) for seed in seeds}
    assert len(talks) > 3


def test_a_seed_is_drawn_and_printed() -> None:
    code, out, err = run("generate", "--character", "alice", "--count", "2")
    assert code == 0
    seed = re.fullmatch(r"seed (\d+)\n", err)
    assert seed is not None
    assert out.splitlines() == alice("--seed", seed.group(1), "--count", "2")


@pytest.mark.parametrize("x", ["-2", "2"])
def test_no_fact_returns_before_all_are_told(x: str) -> None:
    every = {fact.id for fact in Generator().character("alice").facts}
    told: set[str] = set()
    lines = alice("--x", x, "--count", str(len(every)), "--format", "json")
    assert len(lines) == len(every)
    for turn, line in enumerate(lines):
        record = json.loads(line)
        assert record["turn"] == turn
        if told == every:
            told = set()
        new = set(record["facts"])
        # A turn that tells the last facts can go on with the first ones.
        assert not new & told or new | told == every
        told = new if new & told else told | new


def test_json() -> None:
    """Exactly the documented fields, of the documented types."""
    lines = alice("--x", "1", "--count", "5", "--format", "json")
    style = Generator().style
    for line in lines:
        record = json.loads(line)
        assert {key: type(value) for key, value in record.items()} == {
            "text": str,
            "character": str,
            "x": float,
            "seed": int,
            "turn": int,
            "facts": list,
            "recalled": list,
            "parameters": dict,
            "decisions": list,
        }
        assert record["facts"]
        assert all(type(fact) is str for fact in record["facts"])
        assert list(record["parameters"]) == list(style.parameters)
        assert all(0 <= value <= 1 for value in record["parameters"].values())
        assert record["decisions"]
        for decision in record["decisions"]:
            assert {key: type(value) for key, value in decision.items()} == {
                "operator": str,
                "stage": str,
                "probability": float,
                "draw": float,
                "status": str,
                "target": str,
            }
            assert decision["stage"] in STAGES
            assert decision["status"] in ("applied", "not_applicable", "not_drawn")
            assert 0 <= decision["draw"] < 1
    assert [json.loads(line)["text"] for line in lines] == alice("--x", "1", "--count", "5")


def test_trace() -> None:
    """The text, then every decision by stage; with JSON, on stderr."""
    options = ("--x", "2", "--set", "verbosity=0.6")
    lines = alice(*options, "--trace")
    assert lines[0] == alice(*options)[0]
    assert lines[1:3] == ["  Alice, X = 2, seed 7, turn 1", "  facts chosen:"]
    stages = [stage.replace("_", " ") for stage in STAGES]
    shown = [line.strip(" :") for line in lines if re.fullmatch(r"  [a-z ]+:", line)]
    assert [line for line in shown if line in stages] == [s for s in stages if s in shown]
    assert {"content planning", "pragmatic markers"} <= set(shown)
    assert any(re.fullmatch(r"    \w+ \(.*drew 0\.\d\d of [01]\.\d\d\)", line) for line in lines)
    assert any(line.startswith("      → ") for line in lines)
    command = ("generate", "--character", "alice", "--seed", "7", *options, "--format", "json")
    code, out, err = run(*command, "--trace")
    assert code == 0
    assert err.splitlines() == lines[1:]
    assert json.loads(out)["text"] == lines[0]


def test_own_facts(tmp_path: Path) -> None:
    """A file or a folder."""
    path = tmp_path / "folder" / "ann.yaml"
    path.parent.mkdir()
    path.write_text(HEAD + KIND, "utf-8")
    for place in (path, tmp_path):
        (line,) = say("generate", "--facts", str(place), "--character", "Ann", "--seed", "1")
        assert "Ann " in line
        assert say("characters", "--facts", str(place)) == ["ann    1 fact   Ann"]


def test_own_lexicons(tmp_path: Path) -> None:
    for path in (ROOT / "lexicons").iterdir():
        content = path.read_text("utf-8").replace("text: damn,", "text: crikey,")
        (tmp_path / path.name).write_text(content, "utf-8")
    options = ("--count", "30", "--x", "2", "--set", "expletives=1", "--rating", "strong")
    assert "crikey" in " ".join(alice("--lexicons", str(tmp_path), *options)).lower()
    assert "crikey" not in " ".join(alice(*options)).lower()


def test_set_can_be_repeated() -> None:
    (line,) = alice("--set", "verbosity=0", "--set", "exclamation=1", "--format", "json")
    parameters = json.loads(line)["parameters"]
    assert (parameters["verbosity"], parameters["exclamation"]) == (0, 1)


@pytest.mark.parametrize(
    ("rating", "allowed"),
    [("clean", set()), ("mild", {"near_expletives"}), ("strong", {"expletives"})],
)
def test_rating(rating: str, allowed: set[str]) -> None:
    """The words of both kinds of expletives are heard where they are allowed, and only there."""
    text = ""
    for x in ("1", "2"):
        options = ("--set", "expletives=1", "--set", "near_expletives=1", "--rating", rating)
        text += " ".join(alice("--x", x, "--seed", "1", "--count", "400", *options)).lower()
    for kind in ("expletives", "near_expletives"):
        assert kind in MARKER_PLACES
        words = {marker["text"] for marker in MARKERS[kind]}
        heard = {word for word in words if re.search(rf"\b{word}\b", text)}
        if kind in allowed:
            assert heard == words
        elif rating != "strong":
            assert not heard, rating


def test_mild_is_the_default() -> None:
    options = ("--x", "2", "--count", "20", "--set", "near_expletives=1", "--set", "expletives=1")
    assert alice(*options) == alice(*options, "--rating", "mild")


# characters, check, and the command itself


def test_characters() -> None:
    files = (ROOT / "facts").rglob("*.yaml")
    ids = sorted(path.stem for path in files if path.stem != "entities")
    assert len(ids) >= 20
    assert [line.split()[0] for line in say("characters")] == ids
    records = [json.loads(line) for line in say("characters", "--format", "json")]
    assert [record["character"] for record in records] == ids
    for record in records:
        assert {key: type(value) for key, value in record.items()} == {
            "character": str,
            "name": str,
            "facts": int,
        }


def test_check(tmp_path: Path) -> None:
    (line,) = say("check")
    assert line.endswith(": no faults")
    assert say("check", "lexicons")[0].endswith(": no faults")
    assert say("check", "facts")[0].startswith("facts (2")
    path = tmp_path / "ann.yaml"
    path.write_text(HEAD + KIND + KIND + TALL.replace("tall,", "yes,", 1), "utf-8")
    code, out, err = run("check", str(path))
    assert (code, err) == (1, "")
    assert out.splitlines() == [
        f"{path}:5: a second fact 'kind'; give it an id of its own",
        f"{path}:6: 'yes' is a truth value in YAML, not a word; put it in quotes: \"yes\"",
        "facts (1 character, 1 fact): 2 faults",
    ]
    code, out, err = run("check", str(tmp_path / ("x" * 5000)))
    assert (code, err) == (1, "")
    assert "File name too long; check the path" in out


def test_version_and_help() -> None:
    assert say("--version") == [f"personage-lite {__version__}"]
    assert {"generate", "characters", "check", "measure", "corpus"} <= set(
        " ".join(say("--help")).split()
    )
    for command in ("generate", "characters", "check", "measure", "corpus"):
        assert say(command, "--help")[-1].startswith(f"example: personage-lite {command}")


@pytest.mark.parametrize("command", NAMES)
@pytest.mark.parametrize(
    "rest", [["--help"], ["--hel"], ["--loud"], ["a", "b", "c", "d", "--loud"]]
)
def test_a_command_alone_reads_as_among_all(
    command: str, rest: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    """Only the command that comes first is loaded; its help and faults stay the same."""
    said = []
    for parse in (main, parser().parse_args):
        with pytest.raises(SystemExit) as ended:
            parse([command, *rest])
        said.append((ended.value.code, *capsys.readouterr()))
    assert said[0] == said[1]
    assert f"personage-lite {command}" in "".join(said[0][1:]) or "unrecognized" in said[0][2]


def test_a_command_loads_no_other() -> None:
    code = (
        "import sys; from personage_lite.cli import main; main(['characters']); print(*sys.modules)"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, env=ENVIRONMENT, capture_output=True, check=True
    )
    loaded = ran.stdout.decode().split()
    assert [name for name in NAMES if f"personage_lite.cli.{name}" in loaded] == ["characters"]


# Bad input


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--character", "alcie"], "no character 'alcie'; did you mean alice?"),
        (["--character", "😀"], "no character '😀'; choose from: alice, bill, caterpillar"),
        (["--character", ""], "no character ''; choose from: alice"),
        (["--character", "a" * 10_000], f"no character '{'a' * 40}…'; choose from"),
        (["--character", "al\nice"], "no character 'al ice'; did you mean alice?"),
        (["--character", "al\udcffce"], "no character 'al?ce'; did you mean alice?"),
        (["--x", "2.01"], "X is 2.01; give a number from -2 (introvert) to 2 (extravert)"),
        (["--x", "-3"], "X is -3; give a number"),
        (["--x", "nan"], "X is nan; give a number"),
        (["--x=-inf"], "X is -inf; give a number"),
        (["--x", "1e999"], "X is 1e999; give a number"),
        (["--x", "much"], "X is much; give a number"),
        (["--x", ""], "X is empty; give a number"),
        (["--x", "1\n2"], "X is 1 2; give a number"),
        (["--set", "verbosty=1"], "no parameter 'verbosty'; did you mean verbosity"),
        (["--set", "😀=1"], "no parameter '😀'; choose from: "),
        (["--set", "verbosity=1.5"], "verbosity is 1.5; give a number from 0 to 1"),
        (["--set", "verbosity=nan"], "verbosity is nan; give a number from 0 to 1"),
        (["--set", "verbosity=-1"], "verbosity is -1; give a number from 0 to 1"),
        (["--set", "verbosity"], "--set 'verbosity' cannot be read; write PARAMETER=VALUE, as"),
        (["--set", "verbosity="], "--set 'verbosity=' cannot be read; write PARAMETER=VALUE"),
        (["--set", "=1"], "no parameter ''; choose from: "),
        (["--set", "a=" + "b" * 10_000], "--set 'a=bbb"),
        (["--count", "0"], "--count is '0'; give a whole number from 1 to 2^63 - 1"),
        (["--count", "-1"], "--count is '-1'; give"),
        (["--count", "1.5"], "--count is '1.5'; give"),
        (["--count", "many"], "--count is 'many'; give"),
        (["--count", "9" * 5000], f"--count is '{'9' * 40}…'; give"),
        (["--seed", "-1"], "--seed is '-1'; give a whole number from 0 to 2^63 - 1"),
        (["--seed", ""], "--seed is ''; give"),
        (["--seed", str(2**63)], "--seed is '9223372036854775808'; give"),
        (["--seed", "0x1"], "--seed is '0x1'; give"),
        (["--facts", "/nowhere"], "/nowhere: no such file or folder; check the path"),
        (["--facts", "lexicons/none"], "lexicons/none: no such file or folder; check the path"),
        (["--facts", "/" + "x" * 5000], "File name too long; check the path"),
        (["--facts", "docs"], "docs: holds no facts file; see docs/facts.md for how to write one"),
        (["--lexicons", "/nowhere"], "/nowhere/templates.yaml: cannot be read (No such file or di"),
        (["--lexicons", "docs/facts.md"], "docs/facts.md/templates.yaml: cannot be read (Not a di"),
    ],
)
def test_bad_values(arguments: list[str], message: str) -> None:
    """Also without a seed: the one that is drawn is printed only once there is a text."""
    character = () if "--character" in arguments else ("--character", "alice")
    line = fault("generate", *character, *arguments)
    assert line.startswith("personage-lite: ")
    assert message in line
    assert len(line) < 1500 or "File name" in message


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "the following arguments are required: COMMAND; see personage-lite --help"),
        (["generate"], "required: --character; see personage-lite generate --help"),
        (["generate", "--character"], "argument --character: expected one argument; see"),
        (["generate", "--character", "alice", "--loud"], "unrecognized arguments: --loud; see"),
        (["generate", "--character", "alice", "a\nb"], "unrecognized arguments: a b; see"),
        (["generate", "--character", "alice", "x" * 10_000], "xxx…xxx"),
        (["generate", "--character", "alice", "--rating", "rude"], "(choose from 'clean', 'mild'"),
        (["generate", "--character", "alice", "--rating", "x" * 10_000], "'strong'); see"),
        (["generate", "--character", "alice", "--format", "xml"], "invalid choice: 'xml' (choose"),
        (["characters", "alice"], "unrecognized arguments: alice; see personage-lite --help"),
        (["check", "facts", "lexicons"], "unrecognized arguments: lexicons; see"),
        (["speak"], "'speak' (choose from 'generate', 'characters', 'realize', 'measure', "),
        (["--loud"], "required: COMMAND; see personage-lite --help"),
    ],
)
def test_bad_usage(arguments: list[str], message: str) -> None:
    line = fault(*arguments, code=2)
    assert message in line
    assert len(line) < 600


# Broken files


@pytest.mark.parametrize(
    ("content", "line", "message"),
    [
        (HEAD + KIND + "facts: []\n", 5, "the key 'facts' stands here a second time; remove one"),
        (HEAD + KIND.replace("kind, topic", "yes, topic"), 4, "'yes' is a truth value in YAML"),
        (HEAD + KIND.replace("topic", "colour: red, topic"), 4, "unknown field 'colour'; "),
        (
            HEAD + KIND + "relations:\n  - {kind: contrast, nucleus: kind, satellite: kid}\n",
            6,
            "no fact 'kid'; did you mean kind?",
        ),
        (
            HEAD
            + KIND
            + TALL
            + "relations:\n  - {kind: sequence, nucleus: kind, satellite: tall}\n"
            + "  - {kind: sequence, nucleus: tall, satellite: kind}\n",
            7,
            "kind, tall wait for each other; remove one",
        ),
        (HEAD + KIND.replace("topic", "adverbials: [''], topic"), 4, "the text is empty; write"),
        (HEAD.replace("Ann}", "Ann, nouns: []}") + KIND, 2, "the list is empty; add at least one"),
        ("", 1, "the file is empty; see docs/facts.md for what it holds"),
        (HEAD + KIND.replace("}", ""), 5, "not valid YAML"),
        (HEAD + KIND + "source: '\udcff'\n", 5, "this is not UTF-8 text; save the file as UTF-8"),
        (HEAD + "  " + "[" * 100_000, 4, "more than 100 levels deep; nest less"),
    ],
)
def test_broken_facts(content: str, line: int, message: str, tmp_path: Path) -> None:
    path = tmp_path / "ann.yaml"
    path.write_bytes(content.encode(errors="surrogateescape"))
    command = ("characters",) if line % 2 else ("generate", "--character", "ann")
    said = fault(*command, "--facts", str(path))
    assert said.startswith(f"personage-lite: {path}:{line}: ")
    assert message in said


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("markers.yaml", "expletives:", "near_expletives:", "stands here a second time; remove"),
        (
            "markers.yaml",
            "text: damn",
            "text: no",
            "'no' is a truth value in YAML, not a word; put",
        ),
        ("markers.yaml", "text: damn", "text: damn, size: 1", "unknown field 'size'; "),
        ("grammar.yaml", "negators: [not, never,", "negators: []\nx: [", "the list is empty; add"),
        ("grammar.yaml", "neuter:", "neutral:", "'neuter' is missing; add"),
        ("verbs.yaml", "[admit, 0.6,", "[admit,", "3 values; write [word, frequency"),
        ("templates.yaml", "{animate: someone,", "{animate: [", "not valid YAML"),
        ("extraversion-v1.yaml", "  contractions:", "  contraction:", "'contractions' is missing;"),
    ],
)
def test_broken_lexicons(file: str, old: str, new: str, message: str, tmp_path: Path) -> None:
    for path in (ROOT / "lexicons").iterdir():
        content = path.read_text("utf-8")
        if path.name == file:
            assert old in content
            content = content.replace(old, new, 1)
        (tmp_path / path.name).write_text(content, "utf-8")
    line = fault("generate", "--character", "alice", "--lexicons", str(tmp_path))
    assert re.match(rf"personage-lite: {re.escape(str(tmp_path / file))}:\d+: ", line)
    assert message in line


def test_a_folder_in_the_place_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "ann.yaml").mkdir()
    line = fault("characters", "--facts", str(tmp_path))
    assert f"{tmp_path / 'ann.yaml'}: cannot be read (Is a directory); check the path" in line


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root reads all")
def test_a_locked_file(tmp_path: Path) -> None:
    path = tmp_path / "ann.yaml"
    path.write_text(HEAD + KIND, "utf-8")
    path.chmod(0)
    assert "cannot be read (Permission denied)" in fault("characters", "--facts", str(path))
    path.chmod(0o600)
    tmp_path.chmod(0)
    assert "Permission denied; check the path" in fault("characters", "--facts", str(path))
    tmp_path.chmod(0o700)


# Output that ends early


COMMANDS = [
    ["generate", "--character", "alice", "--seed", "1"],
    ["generate", "--character", "alice", "--seed", "1", "--count", "500", "--format", "json"],
    ["characters"],
    ["check"],
    ["check", "/nowhere"],
    ["--help"],
    ["generate", "--help"],
    ["--version"],
]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@pytest.mark.parametrize("arguments", COMMANDS, ids=" ".join)
def test_a_full_disk(arguments: list[str]) -> None:
    with open("/dev/full", "w", encoding="utf-8") as full:
        code, _, err = run(*arguments, stdout=full)
    assert code == 1
    assert "cannot write the output: No space left on device; choose another" in one_line(err)


@pytest.mark.skipif(sys.platform == "win32", reason="closes it in the POSIX way")
def test_a_closed_output() -> None:
    shell = ["sh", "-c", 'exec "$0" "$@" >&-', *COMMAND, "characters"]
    ran = subprocess.run(
        shell, cwd=ROOT, env=ENVIRONMENT, stderr=subprocess.PIPE, encoding="utf-8", check=False
    )
    assert ran.returncode == 1
    assert "there is no output to write to; do not close it" in one_line(ran.stderr)


def _listen_to_signals() -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def _until(
    stop: Callable[[subprocess.Popen[str]], None], *options: str
) -> tuple[int, str, str, float]:
    """Start a long output and stop it; return its exit code, its streams, and the time to end."""
    with subprocess.Popen(
        [*COMMAND, "generate", "--character", "alice", "--seed", "1", *options],
        cwd=ROOT,
        env=ENVIRONMENT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        # A shell may have started us in the background, deaf to Ctrl-C.
        preexec_fn=None if sys.platform == "win32" else _listen_to_signals,  # noqa: PLW1509
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        first = process.stdout.readline()
        stop(process)
        start = time.monotonic()
        rest = "" if process.stdout.closed else process.stdout.read()
        err = process.stderr.read()
        return process.wait(60), first + rest, err, time.monotonic() - start


@pytest.mark.parametrize("form", ["text", "json"])
def test_a_reader_that_goes(form: str) -> None:
    def close(process: subprocess.Popen[str]) -> None:
        assert process.stdout is not None
        process.stdout.close()

    code, first, err, _ = _until(close, "--count", "5000", "--format", form)
    assert code == 1
    assert first == alice("--seed", "1", "--format", form)[0] + "\n"
    assert "the reader of the output has gone; let it read on, or ask for less" in one_line(err)


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGINT to send")
@pytest.mark.parametrize(
    ("form", "wait"), [("text", 0.0), ("json", 0.0), ("json", 0.5)], ids=["text", "json", "slow"]
)
def test_an_interruption(form: str, wait: float) -> None:
    """Even where the pipe is full because its reader is slow, every line is whole."""

    def interrupt(process: subprocess.Popen[str]) -> None:
        time.sleep(wait)
        process.send_signal(signal.SIGINT)

    code, out, err, seconds = _until(interrupt, "--count", "100000", "--format", form)
    assert code == 130
    assert seconds < 5
    assert "interrupted; what is printed is whole, run it again for the rest" in one_line(err)
    lines = out.splitlines()
    assert out.endswith("\n")
    count = str(len(lines))
    assert lines == alice("--seed", "1", "--count", count, "--format", form)
