"""Golden texts: what is said for a request, for a person to review (tests/golden/*.yaml).

`pytest tests/test_golden.py --update` rewrites them; read the difference before you commit it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from personage_lite import Generator
from personage_lite.plan import Utterance

GOLDEN = Path(__file__).parent / "golden"
CHARACTERS = ("alice", "white_rabbit", "queen_of_hearts")
# Whole conversations: turn after turn of each, short of everything there is to tell.
TALKS = ("gardeners", "hatter", "mock_turtle", "saturn")
TALKED = [(-2, 14), (0, 12), (2, 10)]
REQUESTS = [(x, seed) for x in (-2, -1, 0, 1, 2) for seed in (1, 2, 3)]


def applied(utterance: Utterance) -> list[str]:
    """Return the operators that left their mark, in the order of the pipeline."""
    silent = ("verbosity", "contractions")
    return [
        decision.operator
        if decision.operator != "lexical_choice"
        else f"{decision.before} → {decision.after}"
        for decision in utterance.decisions
        if decision.status == "applied" and decision.operator not in silent
    ]


def described(utterance: Utterance) -> dict[str, Any]:
    """Return the golden record of one utterance."""
    return {
        "request": {"x": int(utterance.x), "seed": utterance.seed, "turn": utterance.turn},
        "text": utterance.text,
        "facts": list(utterance.facts),
        "applied": applied(utterance),
    }


@pytest.mark.parametrize("character", CHARACTERS)
def test_golden_texts(character: str, update: bool) -> None:
    """The first two turns for every X and three seeds are as reviewed."""
    generator = Generator()
    said = [
        described(utterance)
        for x, seed in REQUESTS
        for utterance in generator.turns(character, x, seed, count=2)
    ]
    _compare(GOLDEN / f"{character}.yaml", said, update)


@pytest.mark.parametrize("character", TALKS)
def test_golden_talks(character: str, update: bool) -> None:
    """Conversations of a dozen turns are as reviewed: topics flow, stories keep their order."""
    generator = Generator()
    said = [
        described(utterance)
        for x, count in TALKED
        for utterance in generator.turns(character, x, 1, count=count)
    ]
    _compare(GOLDEN / f"talk_{character}.yaml", said, update)


def _compare(path: Path, said: list[dict[str, Any]], update: bool) -> None:
    if update:
        content = yaml.safe_dump(said, allow_unicode=True, sort_keys=False, width=100)
        path.write_text(content, encoding="utf-8")
    reviewed = yaml.safe_load(path.read_text(encoding="utf-8"))
    for now, then in zip(said, reviewed, strict=True):
        assert now == then, "read the new text; if it is right, run with --update"
