"""The `realize` command, through real processes: what it says, and that every fault is one line."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from personage_lite.cli import main
from tests.test_cli import COMMAND, ENVIRONMENT, ROOT, fault, one_line, run, say

RABBIT = "verb: run\nsubject: {noun: rabbit, determiner: a}\n"
LIST = """- {items: [tea, jam, cake]}
- {verb: be, subject: {noun: it, pronoun: true}, contracted: true, complement: late}
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """Return a file that says one sentence."""
    path = tmp_path / "spec.yaml"
    path.write_text(RABBIT, "utf-8")
    return path


def feed(
    content: bytes, *arguments: str, command: tuple[str, ...] = ("realize", "-")
) -> tuple[int, str, str]:
    """Return exit code, stdout and stderr of the command that reads from a pipe."""
    ran = subprocess.run(
        [*COMMAND, *command, *arguments],
        cwd=ROOT,
        env=ENVIRONMENT,
        input=content,
        capture_output=True,
        timeout=60,
        check=False,
    )
    return ran.returncode, ran.stdout.decode(), ran.stderr.decode()


def here(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    """Return the same of the command in this process, which is faster."""
    try:
        code = main(["realize", *arguments])
    except SystemExit as leaving:
        code = int(leaving.code or 0)
    said = capsys.readouterr()
    return code, said.out, said.err


# What it says


def test_a_file(file: Path) -> None:
    assert say("realize", str(file)) == ["A rabbit runs."]


def test_standard_input() -> None:
    assert feed(RABBIT.encode()) == (0, "A rabbit runs.\n", "")
    assert feed(json.dumps([{"noun": "cat"}, "a dog"]).encode()) == (0, "Cat.\nA dog.\n", "")


def test_the_example_of_the_help(file: Path) -> None:
    """It says what it promises, through a shell."""
    example = "\n".join(say("realize", "--help")).partition("example: ")[2]
    shell = example.replace("personage-lite", " ".join(COMMAND))
    ran = subprocess.run(
        ["sh", "-c", shell], cwd=ROOT, env=ENVIRONMENT, capture_output=True, check=False
    )
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, b"Alice runs.\n", b"")


def test_json_files(file: Path) -> None:
    path = file.with_suffix(".json")
    path.write_text('{"sentences": [{"noun": "cat", "determiner": "a"}, "so…"]}', "utf-8")
    assert say("realize", str(path)) == ["A cat.", "So…"]


def test_json_lines(file: Path) -> None:
    file.write_text("- {noun: café, determiner: a}\n- '“Oh”, she said'\n", "utf-8")
    code, out, err = run("realize", str(file), "--format", "json")
    assert (code, err) == (0, "")
    assert [json.loads(line) for line in out.splitlines()] == [
        {"text": "A café."},
        {"text": "“Oh”, she said."},
    ]
    assert "é" in out, "texts are readable in JSON too"


@pytest.mark.parametrize(
    ("options", "lines"),
    [
        ((), ["Tea, jam and cake.", "It's late."]),
        (("--oxford-comma",), ["Tea, jam, and cake.", "It's late."]),
        (("--curly-apostrophes",), ["Tea, jam and cake.", "It’s late."]),
        (("--oxford-comma", "--curly-apostrophes"), ["Tea, jam, and cake.", "It’s late."]),
    ],
)
def test_options(
    options: tuple[str, ...], lines: list[str], file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file.write_text(LIST, "utf-8")
    code, out, err = here(capsys, str(file), *options)
    assert (code, out.splitlines(), err) == (0, lines, "")
    assert here(capsys, *options, str(file)) == (code, out, err)


def test_dialects(file: Path) -> None:
    file.write_text(
        "- {verb: learn, subject: she, tense: past, object: the colour}\n"
        "- {year: 1862, month: 7, day: 4}\n- {value: 101}\n",
        "utf-8",
    )
    british = say("realize", str(file), "--dialect", "british")
    assert british == ["She learnt the colour.", "4 July 1862.", "One hundred and one."]
    assert say("realize", str(file)) == british
    american = say("realize", str(file), "--dialect", "american")
    assert american == ["She learned the colour.", "July 4, 1862.", "One hundred one."]


def test_own_lexicons(tmp_path: Path, file: Path) -> None:
    folder = tmp_path / "lexicons"
    shutil.copytree(ROOT / "lexicons", folder)
    words = (folder / "inflection.yaml").read_text("utf-8")
    (folder / "inflection.yaml").write_text(words.replace("mouse mice", "mouse meese"), "utf-8")
    file.write_text("{noun: mouse, cardinal: 2}", "utf-8")
    assert say("realize", str(file), "--lexicons", str(folder)) == ["Two meese."]
    assert say("realize", str(file)) == ["Two mice."]
    # The realizer alone needs no more than its four files.
    for path in folder.iterdir():
        if path.stem not in ("grammar", "inflection", "numerals", "articles"):
            path.unlink()
    assert say("realize", str(file), "--lexicons", str(folder)) == ["Two meese."]


def test_schema(file: Path) -> None:
    """With or without a file, which is not read."""
    code, out, err = run("realize", "--schema")
    assert (code, err) == (0, "")
    assert json.loads(out)["$schema"].startswith("https://json-schema.org/")
    assert run("realize", "--schema", "/nowhere") == (0, out, "")
    assert run("realize", str(file), "--schema", "--format", "json") == (0, out, "")


@pytest.mark.parametrize(
    "content",
    [
        b"\xef\xbb\xbfnoun: cat\ndeterminer: a\n",
        b'\xef\xbb\xbf{"noun": "cat", "determiner": "a"}',
        b"noun: cat\r\ndeterminer: a\r\n",
        b'{"noun": "cat",\r\n"determiner": "a"}\r\n',
        b"noun: cat\ndeterminer: a",
        b"\n\n# a comment\n---\nnoun: cat\ndeterminer: a\n...\n",
    ],
    ids=["BOM", "BOM JSON", "CRLF", "CRLF JSON", "no end of line", "document marks"],
)
def test_ways_to_write_a_file(
    content: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("spec.yaml", "spec.json", "spec", "-spec.txt"):
        (tmp_path / name).write_bytes(content)
        assert here(capsys, str(tmp_path / name)) == (0, "A cat.\n", "")
    assert feed(content) == (0, "A cat.\n", "")


def test_odd_names_of_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("a b.yaml", "ü😀.yaml", "%s{}.yaml", "a\nb.yaml"):
        (tmp_path / name).write_text("noun: cat", "utf-8")
        assert here(capsys, str(tmp_path / name)) == (0, "Cat.\n", "")
        (tmp_path / name).write_text("noun: 7", "utf-8")
        code, out, err = here(capsys, str(tmp_path / name))
        assert (code, out) == (1, "")
        assert ":1: noun: expected a text, found '7'; put it in quotes" in one_line(err)


def test_many_sentences(tmp_path: Path) -> None:
    """Every one of 20,000 is said, in order."""
    path = tmp_path / "many.yaml"
    rows = (f"- {{verb: run, subject: rabbit {at}}}\n" for at in range(20_000))
    path.write_text("".join(rows), "utf-8")
    lines = say("realize", str(path))
    assert lines == [f"Rabbit {at} runs." for at in range(20_000)]


def test_a_fault_in_the_last_of_many(tmp_path: Path) -> None:
    """Nothing is said by halves."""
    path = tmp_path / "many.yaml"
    path.write_text("- a cat\n" * 2000 + "- {noun: 7}\n", "utf-8")
    line = fault("realize", str(path))
    assert f"{path}:2001: [2000].noun: expected a text, found '7'; put it in quotes" in line
    path.write_text("- a cat\n" * 2000 + "- {verb: go}\n", "utf-8")
    assert f"{path}:2001: [2000]: the clause with the verb 'go' has no" in fault(
        "realize", str(path), "--format", "json"
    )


# What is wrong


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", ":1: the file is empty; "),
        (b"\n# nothing\n", ":1: the file is empty; "),
        (b"\xef\xbb\xbf", ":1: the file is empty; "),
        (b"- a\n- \xff\xfe\n", ":2: this is not UTF-8 text; save the file as UTF-8"),
        ("noun: cat".encode("utf-16"), ":1: this is not UTF-8 text; save the file as UTF-8"),
        (bytes(range(256)), "; "),
        (b"\x00" * 1000, ":1: not valid YAML (control characters are not allowed); remove it"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", ":1: this is not UTF-8 text; save the file as UTF-8"),
        (b"noun: [", ": not valid YAML"),
        (b"noun: cat\nnoun: dog\n", ":2: the key 'noun' stands here a second time; remove one"),
        (b"- noun: cat\n- nuon: dog\n", ":2: [1]: nothing says what this is; give it one of: adj"),
        (b"{verb: go}", ":1: the clause with the verb 'go' has no subject; add one"),
        (b"{noun: cat, determinr: a}", ":1: determinr: NounPhrase has no field 'determinr'; did"),
        (b"[" * 100_000, ":1: more than 2500 levels deep; nest less"),
        (b"{year: 2000, month: 13}", ":1: no calendar has year 2000, month 13; give a date of the"),
        (b'""', ":1: "),
        (b"{items: []}", ":1: "),
    ],
)
def test_wrong_files(
    content: bytes, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """From a file and from standard input, one line that names it."""
    path = tmp_path / "spec.yaml"
    path.write_bytes(content)
    code, out, err = here(capsys, str(path))
    assert (code, out) == (1, "")
    assert one_line(err).startswith(f"personage-lite: {path}:")
    assert message in err
    assert "this cannot be said" not in err


@pytest.mark.parametrize(
    "content",
    [b"", b"\xff", b"noun: [", b"noun: 7", b"{verb: go}", b"[" * 100_000, b'{"noun": NaN}'],
)
def test_wrong_standard_input(content: bytes) -> None:
    code, out, err = feed(content)
    assert (code, out) == (1, "")
    assert one_line(err).startswith("personage-lite: standard input:")


@pytest.mark.parametrize(
    "content",
    [
        '{"value": NaN}',
        '{"value": 1e999}',
        f'{{"value": {"9" * 5000}}}',
        '{"year": 99999999999999999999}',
        '{"noun": "cat", "stutter": 1000000000000000}',
        '{"noun": "\\ud800"}',
        '{"noun": "cat", "noun": "dog"}',
        '{"noun": "a\\nb"}',
        '["…"]',
    ],
    ids=lambda content: str(content)[:30],
)
@pytest.mark.parametrize("form", ["text", "json"])
def test_no_traceback(content: str, form: str, tmp_path: Path) -> None:
    """Whatever JSON can hold is said in one line, or is a fault in one line."""
    path = tmp_path / "spec.json"
    path.write_text(content, "utf-8")
    code, out, err = run("realize", str(path), "--format", form)
    assert "Traceback" not in err
    if code == 0:
        assert err == ""
        assert len(out.splitlines()) == 1
        assert out.strip()
        assert form == "text" or json.loads(out)["text"]
    else:
        assert (code, out) == (1, "")
        assert one_line(err).startswith(f"personage-lite: {path}:")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["/nowhere.yaml"], "/nowhere.yaml: cannot be read (No such file or directory); check the"),
        ([""], ": cannot be read (No such file or directory); check the path"),
        (["docs"], "docs: cannot be read (Is a directory); check the path"),
        (["README.md/x"], "README.md/x: cannot be read (Not a directory); check the path"),
        (["/" + "x" * 5000], "cannot be read (File name too long); check the path"),
        ([], "no file to realize; name one, or - for standard input"),
        (["--format", "json"], "no file to realize; name one, or - for standard input"),
        (
            ["FILE", "--lexicons", "/nowhere"],
            "cannot be read (No such file or directory); check the",
        ),
        (["FILE", "--lexicons", "README.md"], "cannot be read (Not a directory); check the path"),
        (
            ["FILE", "--lexicons", "docs"],
            "cannot be read (No such file or directory); check the pa",
        ),
    ],
)
def test_wrong_places(
    arguments: list[str], message: str, file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    given = [str(file) if argument == "FILE" else argument for argument in arguments]
    code, out, err = here(capsys, *given)
    assert (code, out) == (1, "")
    assert message in one_line(err)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--loud", "x.yaml"], "unrecognized arguments: --loud; see personage-lite"),
        (["x.yaml", "y.yaml"], "unrecognized arguments: y.yaml; see personage-lite --help"),
        (["x.yaml", "--format", "xml"], "invalid choice: 'xml' (choose from 'text', 'json'); see"),
        (["x.yaml", "--format"], "argument --format: expected one argument; see"),
        (["x.yaml", "--dialect", "scots"], "invalid choice: 'scots' (choose from 'british', 'ame"),
        (["x.yaml", "--lexicons"], "argument --lexicons: expected one argument; see"),
        (
            ["x.yaml", "--oxford-comma=no"],
            "argument --oxford-comma: ignored explicit argument 'no'",
        ),
        (["x.yaml", "--seed", "7"], "unrecognized arguments: --seed 7; see"),
    ],
)
def test_wrong_usage(
    arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, err = here(capsys, *arguments)
    assert (code, out) == (2, "")
    assert message in one_line(err)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root reads all")
def test_a_locked_file(file: Path) -> None:
    file.chmod(0)
    assert "cannot be read (Permission denied); check the path" in fault("realize", str(file))


def test_a_file_that_never_ends_or_cannot_be_read() -> None:
    """A device and a pipe of a shell are files too."""
    ran = subprocess.run(
        ["bash", "-c", f'{" ".join(COMMAND)} realize <(echo "noun: cat"); {COMMAND[0]} --version']
        if shutil.which("bash")
        else [*COMMAND, "--version"],
        cwd=ROOT,
        env=ENVIRONMENT,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert ran.returncode == 0
    assert ran.stderr == ""
    assert ran.stdout.startswith("Cat.\n") or not shutil.which("bash")
    if Path("/dev/null").exists():
        assert "/dev/null:1: the file is empty; " in fault("realize", "/dev/null")
    if Path("/proc/self/mem").exists():
        assert "/proc/self/mem: cannot be read (" in fault("realize", "/proc/self/mem")


# Streams that end early


@pytest.mark.skipif(sys.platform == "win32", reason="closes it in the POSIX way")
def test_a_closed_input(file: Path) -> None:
    for name, code, said in (("-", 1, ""), (str(file), 0, "A rabbit runs.\n")):
        ran = subprocess.run(
            ["sh", "-c", 'exec "$0" "$@" <&-', *COMMAND, "realize", name],
            cwd=ROOT,
            env=ENVIRONMENT,
            capture_output=True,
            encoding="utf-8",
            check=False,
        )
        assert (ran.returncode, ran.stdout) == (code, said)
        if code:
            assert "there is no standard input to read; name a file" in one_line(ran.stderr)


@pytest.mark.skipif(sys.platform == "win32", reason="closes it in the POSIX way")
def test_a_closed_output(file: Path) -> None:
    ran = subprocess.run(
        ["sh", "-c", 'exec "$0" "$@" >&-', *COMMAND, "realize", str(file)],
        cwd=ROOT,
        env=ENVIRONMENT,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        check=False,
    )
    assert ran.returncode == 1
    assert "there is no output to write to; do not close it" in one_line(ran.stderr)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@pytest.mark.parametrize("arguments", [["FILE"], ["FILE", "--format", "json"], ["--schema"]])
def test_a_full_disk(arguments: list[str], file: Path) -> None:
    given = [str(file) if argument == "FILE" else argument for argument in arguments]
    with open("/dev/full", "w", encoding="utf-8") as full:
        code, _, err = run("realize", *given, stdout=full)
    assert code == 1
    assert "cannot write the output: No space left on device; choose another" in one_line(err)


@pytest.mark.parametrize("form", ["text", "json"])
def test_a_reader_that_goes(form: str, tmp_path: Path) -> None:
    """As `| head -1` does; what is printed of the rest is nobody's."""
    path = tmp_path / "many.json"
    path.write_text(json.dumps([f"a cat {'and a dog ' * 50}"] * 5000), "utf-8")
    with subprocess.Popen(
        [*COMMAND, "realize", str(path), "--format", form],
        cwd=ROOT,
        env=ENVIRONMENT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        first = process.stdout.readline()
        process.stdout.close()
        err = process.stderr.read()
        assert process.wait(60) == 1
    assert "A cat and a dog" in first
    assert first.endswith("\n")
    assert "the reader of the output has gone; let it read on, or ask for less" in one_line(err)


@pytest.mark.skipif(not shutil.which("head"), reason="there is no head")
def test_head(tmp_path: Path) -> None:
    path = tmp_path / "many.json"
    path.write_text(json.dumps(["a cat"] * 20_000), "utf-8")
    shell = f"{' '.join(COMMAND)} realize {path} | head -1"
    ran = subprocess.run(
        ["sh", "-c", shell],
        cwd=ROOT,
        env=ENVIRONMENT,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert (ran.returncode, ran.stdout) == (0, "A cat.\n")
    assert "Traceback" not in ran.stderr
    assert len(ran.stderr.splitlines()) <= 1


def test_help() -> None:
    """Every option is explained, in lines of one width."""
    lines: list[Any] = say("realize", "--help")
    text = " ".join(lines)
    for option in (
        *("--format", "--dialect", "--oxford-comma", "--curly-apostrophes", "--lexicons"),
        *("--schema", "--help", "file"),
    ):
        assert re.search(rf"(?<!\S){option}", text), option
    assert max(map(len, lines[:-1])) <= 92
    assert "realize" in " ".join(say("--help"))
