"""`measure`, through real processes, and its plots (docs/commands.md)."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from personage_lite.corpus import write_corpus
from personage_lite.errors import PersonageError
from personage_lite.measure import Said, measure
from personage_lite.measure.plot import check_plot_path, plot
from tests.mutation import check_message
from tests.test_cli import COMMAND, ENVIRONMENT, ROOT, fault, one_line, say


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a corpus of 150 utterances at five X."""
    path = tmp_path_factory.mktemp("corpus") / "corpus.jsonl"
    write_corpus(path, 150)
    return path


@pytest.fixture
def text(tmp_path: Path) -> Path:
    """Return a text of two utterances."""
    path = tmp_path / "text.txt"
    path.write_text("She is kind.\nShe isn't late, is she?\n", "utf-8")
    return path


def given(content: str, *arguments: str) -> tuple[int, str, str]:
    """Run `measure -` with something on standard input."""
    done = subprocess.run(
        [*COMMAND, "measure", "-", *arguments],
        cwd=ROOT,
        env=ENVIRONMENT,
        input=content,
        capture_output=True,
        encoding="utf-8",
        timeout=60,
        check=False,
    )
    return done.returncode, done.stdout, done.stderr


def test_a_text(text: Path) -> None:
    lines = say("measure", str(text))
    assert lines[0].split() == ["feature", "per", "value", "±", "published", "sources"]
    assert lines[4].split()[:4] == ["words", "utterance", "4.00", "1.00"]
    assert max(map(len, lines[:40])) < 90


def test_a_corpus(corpus: Path) -> None:
    lines = say("measure", str(corpus))
    assert "X=-2   X=-1    X=0    X=1    X=2" in lines[0]
    (words,) = [line for line in lines if line.startswith("words  ")]
    assert "rises" in words
    assert "agrees" in words
    assert max(map(len, lines[:40])) <= 120


def test_json(corpus: Path) -> None:
    found = [json.loads(line) for line in say("measure", str(corpus), "--format", "json")]
    assert [one["feature"] for one in found][:2] == ["words", "sentences"]
    first = found[0]
    assert [*first] == [
        *("feature", "label", "per", "values", "trend", "published", "verdict", "finding"),
        *("sources", "contrary"),
    ]
    assert [value["x"] for value in first["values"]] == [-2, -1, 0, 1, 2]
    assert sum(value["utterances"] for value in first["values"]) == 150
    assert first["values"][0].keys() == {"x", "value", "error", "utterances", "words"}


def test_richness(corpus: Path, text: Path) -> None:
    assert "most worn phrases, X=2 (utterances that hold them)" in say(
        "measure", str(corpus), "--richness"
    )
    last = json.loads(say("measure", str(text), "--richness", "--format", "json")[-1])
    assert [*last] == [
        *("x", "words", "distinct_1", "distinct_2", "repeated_openings", "worn_phrases"),
    ]


def test_standard_input() -> None:
    code, out, err = given("She is kind.", "--format", "json")
    assert (code, err) == (0, "")
    assert json.loads(out.splitlines()[0])["values"][0]["value"] == 3


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "standard input holds no text; give"),
        ('{"text": "a", "x": 1}\n{', "standard input:2: this is no JSON record"),
    ],
)
def test_faults_of_standard_input(content: str, message: str) -> None:
    code, out, err = given(content)
    assert (code, out) == (1, "")
    assert message in one_line(err)


def test_faults(text: Path, tmp_path: Path) -> None:
    assert "nowhere.txt: cannot be read" in fault("measure", "nowhere.txt")
    assert "cannot be read (Is a directory)" in fault("measure", str(tmp_path))
    assert "features.yaml: cannot be read" in fault(
        "measure", str(text), "--lexicons", str(_without_features(tmp_path))
    )
    binary = tmp_path / "binary"
    binary.write_bytes(b"a\n\xff")
    assert "binary:2: this is not UTF-8 text" in fault("measure", str(binary))
    assert "the following arguments are required: file" in fault("measure", code=2)


def _without_features(folder: Path) -> Path:
    lexicons = folder / "lexicons"
    lexicons.mkdir()
    for path in (ROOT / "lexicons").glob("*.yaml"):
        if path.name != "features.yaml":
            (lexicons / path.name).symlink_to(path)
    return lexicons


@pytest.mark.parametrize(
    ("module", "options"),
    [("textstat", ()), ("vaderSentiment", ()), ("matplotlib", ("--plot", "style.png"))],
)
def test_a_missing_package_is_one_line(
    module: str, options: tuple[str, ...], text: Path, tmp_path: Path
) -> None:
    (tmp_path / f"{module}.py").write_text("raise ImportError('No module named pkg_resources')")
    environment = {**ENVIRONMENT, "PYTHONPATH": f"{tmp_path}{os.pathsep}{ROOT}"}
    done = subprocess.run(
        [sys.executable, "-m", "personage_lite", "measure", str(text), *options],
        env=environment,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert (done.returncode, done.stdout) == (1, "")
    assert f"measuring needs {module}, which cannot be imported" in done.stderr
    assert "run: pip install 'personage-lite[measure]'" in one_line(done.stderr)


# Plots


def test_a_plot(corpus: Path, tmp_path: Path) -> None:
    from matplotlib.image import imread

    place = tmp_path / "style.PNG"
    place.write_text("what was there before")
    assert say("measure", str(corpus), "--plot", str(place)) == say("measure", str(corpus))
    assert [path.name for path in tmp_path.iterdir()] == [place.name]
    picture = imread(place, format="png")
    assert picture.shape == (1320, 1650, 4)
    assert picture.std() > 0.05


@pytest.mark.parametrize(
    ("suffix", "start"), [(".png", b"\x89PNG\r\n\x1a\n"), (".svg", b"<?xml"), (".pdf", b"%PDF")]
)
def test_the_same_report_gives_the_same_plot(suffix: str, start: bytes, tmp_path: Path) -> None:
    report = measure([Said("She is kind.", x) for x in (-1, 1)])
    one, two = tmp_path / f"one{suffix}", tmp_path / f"two{suffix}"
    plot(report, one)
    plot(report, two)
    assert one.read_bytes().startswith(start)
    assert one.read_bytes() == two.read_bytes()


def test_groups_without_words_can_be_plotted(tmp_path: Path) -> None:
    plot(measure([Said("", -1), Said("Kind.", 0), Said("😊", 1)]), tmp_path / "a.png")


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("style.gif", "a plot cannot be 'style.gif'; end its name in .png, .svg, .pdf"),
        ("style", "a plot cannot be 'style'; end"),
        ("nowhere/style.png", "there is no folder"),
        ("folder.png", "folder.png: cannot be written; choose another place"),
    ],
)
def test_where_no_plot_can_be(name: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "folder.png").mkdir()
    with pytest.raises(PersonageError) as caught:
        check_plot_path(tmp_path / name)
    check_message(caught.value)
    assert message in str(caught.value)
    # Before anything is read.
    assert message in fault("measure", "nowhere.txt", "--plot", str(tmp_path / name))


def test_a_text_has_nothing_to_plot(text: Path, tmp_path: Path) -> None:
    place = tmp_path / "style.png"
    assert "text.txt has not two X to plot; give" in fault(
        "measure", str(text), "--plot", str(place)
    )
    assert not place.exists()
    with pytest.raises(PersonageError, match="a plot needs records of two or more X"):
        plot(measure(["a"]), place)


def test_a_plot_that_fails_leaves_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "style.png"
    place.write_text("before")

    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("matplotlib.figure.Figure.savefig", full)
    with pytest.raises(PersonageError, match="cannot be written \\(No space left"):
        plot(measure([Said("a", -1), Said("b", 1)]), place)
    assert place.read_text() == "before"
    assert [path.name for path in tmp_path.iterdir()] == ["style.png"]
