"""The committed sample of generated text can be made again, to the byte, by its own command."""

from __future__ import annotations

import json
import re
from collections import Counter
from pathlib import Path

from personage_lite.cli import main

CORPORA = Path(__file__).parent.parent / "corpora"


def test_the_sample_regenerates(tmp_path: Path) -> None:
    """The command line in corpora/README.md gives the committed file."""
    page = (CORPORA / "README.md").read_text("utf-8")
    command = re.search(r"^\$ personage-lite (corpus .*)$", page, re.MULTILINE)
    assert command is not None
    *arguments, name = command.group(1).split()
    assert main([*arguments, str(tmp_path / name)]) == 0
    assert (tmp_path / name).read_bytes() == (CORPORA / name).read_bytes(), (
        "run the command in corpora/ again, and read the difference"
    )


def test_the_sample_is_what_its_page_says() -> None:
    """200 utterances, 40 a level, of all characters."""
    lines = (CORPORA / "sample-200.jsonl").read_text("utf-8").splitlines()
    records = [json.loads(line) for line in lines]
    assert Counter(record["x"] for record in records) == dict.fromkeys((-2, -1, 0, 1, 2), 40)
    assert len({record["character"] for record in records}) >= 20
    assert len({record["text"] for record in records}) > 180
