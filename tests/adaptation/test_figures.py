"""The plot: a whole picture or none, and what it shows."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from adaptation import figures
from adaptation.comparison import BASELINES, Run, compare
from adaptation.experiment import Experiment
from adaptation.listeners import listener
from personage_lite.errors import PersonageError

ROOT = Path(__file__).resolve().parents[2]


def runs(*learners: str, noises: tuple[float, ...] = (0.0, 0.3), **settings: Any) -> list[Run]:
    return list(compare(learners, noises, Experiment(listener("match"), trials=20, **settings)))


def test_a_picture_that_opens(tmp_path: Path) -> None:
    target = tmp_path / "figure.png"
    figures.plot(runs("q-learning"), runs(*BASELINES, noises=(0.0,)), target)
    with Image.open(target) as picture:
        picture.verify()
    with Image.open(target) as picture:
        width, height = picture.size
        assert width > 1200
        assert height > 300
        colours = picture.convert("RGB").getcolors(1 << 20)
    assert len(colours or ()) > 50, "it is not blank"
    assert os.listdir(tmp_path) == ["figure.png"]


@pytest.mark.parametrize(
    ("suffix", "start"), [(".svg", b"<?xml"), (".pdf", b"%PDF"), (".PNG", b"\x89PNG")]
)
def test_other_formats(tmp_path: Path, suffix: str, start: bytes) -> None:
    target = tmp_path / f"figure{suffix}"
    figures.plot(runs("random"), [], target)
    assert target.read_bytes().startswith(start)


def test_what_it_shows() -> None:
    learners = runs("q-learning", "random", steps=10, changes=(4, 8))
    figure = figures._drawn(learners, runs(*BASELINES, noises=(0.0,), steps=10))
    assert len(figure.axes) == 6
    for axes in figure.axes:
        labels = axes.get_legend_handles_labels()[1]
        assert "always X = 0 (noise 0)" in labels
        assert "oracle (noise 0)" in labels
        assert [label for label in labels if label.startswith("noise")] == ["noise 0", "noise 0.3"]
        changes = [line for line in axes.lines if line.get_label() == "preference drawn anew"]
        assert [line.get_xdata()[0] for line in changes] == [3.5, 7.5]  # type: ignore[index]
        assert len(axes.collections) == 2, "a confidence band for each noise level"
    curve = learners[1].result.curve("match").value
    drawn = {line.get_label(): line for line in figure.axes[1].lines}
    assert list(drawn["noise 0.3"].get_ydata()) == curve.tolist()  # type: ignore[arg-type]


def test_one_trial_one_step(tmp_path: Path) -> None:
    lone = list(compare(["random"], [0.0], Experiment(listener("live"), trials=1, steps=1)))
    figures.plot(lone, [], tmp_path / "a.png")


def test_the_same_runs_give_the_same_file(tmp_path: Path) -> None:
    for name in ("a.png", "b.png"):
        figures.plot(runs("random"), [], tmp_path / name)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


@pytest.mark.parametrize("name", ["figure", "figure.gif", "figure.txt", ".png/"])
def test_an_unknown_suffix(tmp_path: Path, name: str) -> None:
    with pytest.raises(PersonageError, match=r"choose a name in \.png, \.svg, \.pdf"):
        figures.check_target(tmp_path / name)


def test_a_place_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "folder.png").mkdir()
    for path in (tmp_path / "none" / "a.png", tmp_path / "folder.png"):
        with pytest.raises(PersonageError, match="choose a file in a folder that you may write"):
            figures.check_target(path)


def test_nothing_is_left_of_a_plot_that_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise KeyboardInterrupt

    (tmp_path / "a.png").write_bytes(b"the old one")
    monkeypatch.setattr(os, "replace", fail)
    with pytest.raises(KeyboardInterrupt):
        figures.plot(runs("random"), [], tmp_path / "a.png")
    assert os.listdir(tmp_path) == ["a.png"]
    assert (tmp_path / "a.png").read_bytes() == b"the old one"


def test_a_full_disk_is_one_clear_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(PersonageError, match="No space left on device; choose another place"):
        figures.plot(runs("random"), [], tmp_path / "a.png")
    assert os.listdir(tmp_path) == []


def test_without_matplotlib(tmp_path: Path) -> None:
    code = (
        "import sys; sys.modules['matplotlib'] = None; from adaptation import figures;"
        f"figures.check_target({str(tmp_path / 'a.png')!r})"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert "a plot needs matplotlib; pip install personage-lite[plots]" in done.stderr
