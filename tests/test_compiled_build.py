"""The two builds of the wheel: the plain one holds no binary, the compiled one says the same.

They take minutes, a compiler and what pip downloads: set PERSONAGE_LITE_TEST_COMPILED=1.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from zipfile import ZipFile

import pytest

ROOT = Path(__file__).resolve().parents[1]
ASKED = os.environ.get("PERSONAGE_LITE_TEST_COMPILED") == "1"
pytestmark = pytest.mark.skipif(
    not ASKED, reason="builds wheels, with a compiler: set PERSONAGE_LITE_TEST_COMPILED=1"
)
# What users hand values to or are handed must stay Python, and what all nesting passes through.
INTERPRETED = (
    *("generator", "plan", "state", "style"),
    *("realizer", "realizer.numerals", "realizer.specification", "realizer.syntax"),
)
FILES = """\
import importlib, sys
for name in sys.argv[1:]:
    print(importlib.import_module(name).__file__)
"""


def run(*command: str, **environment: str) -> str:
    kept = {k: v for k, v in os.environ.items() if k != "PERSONAGE_LITE_COMPILE"}
    done = subprocess.run(
        command,
        check=False,
        capture_output=True,
        text=True,
        encoding="utf-8",
        cwd=Path(sys.prefix),
        env={**kept, "PYTHONUTF8": "1", **environment},
    )
    assert not done.returncode, done.stdout + done.stderr
    return done.stdout


def build(folder: Path, **environment: str) -> Path:
    """Build a wheel of a copy of the checkout, as pip does, and return its path."""
    ignored = shutil.ignore_patterns(".*", "__pycache__", "build", "dist", "*.egg-info")
    source = shutil.copytree(ROOT, folder / "source", ignore=ignored)
    pip = (sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps")
    run(*pip, "--wheel-dir", str(folder), str(source), **environment)
    (wheel,) = folder.glob("*.whl")
    return wheel


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the compiled wheel is installed."""
    folder = tmp_path_factory.mktemp("compiled")
    wheel = build(folder, PERSONAGE_LITE_COMPILE="1")
    assert "none-any" not in wheel.name
    pip = (sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index")
    run(*pip, "--target", str(folder / "installed"), str(wheel))
    return folder / "installed"


def test_the_plain_wheel_needs_no_compiler(tmp_path: Path) -> None:
    """Without the variable the wheel is for any machine, and there is no compiler to call."""
    wheel = build(tmp_path, CC="no-compiler")
    assert wheel.name.endswith("-py3-none-any.whl")
    with ZipFile(wheel) as content:
        kinds = {Path(name).suffix for name in content.namelist()}
    assert not kinds & {".so", ".pyd", ".c"}


def test_what_is_hot_is_compiled(installed: Path) -> None:
    """Every module that setup.py names is a binary; what users meet is not."""
    sources = installed.rglob("personage_lite/**/*.py")
    names = [".".join(path.relative_to(installed).with_suffix("").parts) for path in sources]
    names = sorted(name.removesuffix(".__init__") for name in names if "__main__" not in name)
    files = run(sys.executable, "-c", FILES, *names, PYTHONPATH=str(installed)).splitlines()
    assert all(Path(file).is_relative_to(installed) for file in files)
    compiled = {
        name.removeprefix("personage_lite.")
        for name, file in zip(names, files, strict=True)
        if not file.endswith(".py")
    }
    assert {"operators", "sentence_planner", "realizer.clauses"} <= compiled
    assert compiled.isdisjoint(INTERPRETED)


def test_both_builds_say_the_same(installed: Path) -> None:
    """Texts, decisions, states, traces, realized cases and messages are equal."""
    script = str(ROOT / "tests" / "everything_said.py")
    # The tests' own modules come from the checkout either way.
    pure = run(sys.executable, script, PYTHONPATH=str(ROOT))
    found = run(sys.executable, script, PYTHONPATH=os.pathsep.join((str(installed), str(ROOT))))
    for one, other in zip(pure.splitlines(), found.splitlines(), strict=True):
        assert one == other
    assert pure.count("\n") > 4000


@pytest.mark.parametrize("kind", ["coordination", "owner", "speech"])
def test_what_is_nested_too_deep_is_refused(installed: Path, kind: str) -> None:
    """Compiled code has no limit of its own: the stack must not overflow."""
    nests = {
        "coordination": 'Coordination((nest, "x"))',
        "owner": 'NounPhrase("cat", possessor=nest)',
        "speech": 'Clause("say", "she", quotation=Quotation(Sentence(nest)))',
    }
    script = (
        "from personage_lite import PersonageError, english\n"
        "from personage_lite.realizer import *\n"
        "nest = NounPhrase('cat')\n"
        f"for _ in range(100_000): nest = {nests[kind]}\n"
        "try: english().realize(nest)\n"
        "except PersonageError as error: print(error)\n"
    )
    said = run(sys.executable, "-c", script, PYTHONPATH=str(installed))
    assert "levels deep; nest less" in said
