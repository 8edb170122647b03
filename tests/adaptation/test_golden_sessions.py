"""Golden sessions: what a person sees of a whole talk, for a person to review.

Each tests/golden/session_*.yaml holds episodes of one acquaintance: the arguments of the command
`live`, what the listener types (with `during`: in the middle of which utterance since the last
answer), the screen as text, and for each utterance X, the action, and the facts. Time is simulated,
whatever the speed, and Python's hash seed is another one each time.

`pytest tests/adaptation/test_golden_sessions.py --update` rewrites screens and utterances; read the
difference before you commit it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from adaptation.memory import open_memory
from adaptation.storyteller.replaying import replayed
from adaptation.storyteller.session_log import read_sessions
from personage_lite.cli.live import generator_for
from tests.adaptation.scripted import Shown, answers, told

GOLDEN = Path(__file__).parents[1] / "golden"
SESSIONS = sorted(GOLDEN.glob("session_*.yaml"))
# A day lies between two episodes, in seconds.
DAY = 86_400.0


def episodes_of(golden: list[dict[str, Any]], folder: Path) -> list[Shown]:
    """Run the episodes one after the other, with one memory and one log."""
    memory = open_memory(str(folder / "friends.sqlite"))
    try:
        return [
            told(
                episode["arguments"], answers(episode["listener"]), folder / "log.jsonl",
                memory=memory, wall=1_800_000_000.0 + number * DAY,
            )
            for number, episode in enumerate(golden)
        ]  # fmt: skip
    finally:
        memory.close()


def described(episode: dict[str, Any], shown: Shown) -> dict[str, Any]:
    """Return the golden record of an episode."""
    utterances = [
        f"X = {turn['x']:2} ({turn['action']:+d}) {turn['character']}: {', '.join(turn['facts'])}"
        + ("" if turn["listener"] is None else f" (likes {turn['listener']['preference']})")
        for turn in shown.of("turn")
    ]
    return {
        "arguments": episode["arguments"],
        "listener": episode["listener"],
        "screen": shown.screen,
        "utterances": utterances,
    }


def test_there_are_golden_sessions() -> None:
    assert len(SESSIONS) == 3


@pytest.mark.parametrize("path", SESSIONS, ids=lambda path: path.stem)
def test_golden_sessions(path: Path, tmp_path: Path, update: bool) -> None:
    golden = yaml.safe_load(path.read_text("utf-8"))
    shown = episodes_of(golden, tmp_path)
    now = [described(*each) for each in zip(golden, shown, strict=True)]
    if update:
        content = yaml.safe_dump(now, allow_unicode=True, sort_keys=False, width=100)
        path.write_text(content, encoding="utf-8")
        golden = yaml.safe_load(content)
    assert now == golden, "read the new session; if it is right, run with --update"


@pytest.mark.parametrize("path", SESSIONS, ids=lambda path: path.stem)
def test_golden_sessions_are_said_again_from_their_logs(path: Path, tmp_path: Path) -> None:
    golden = yaml.safe_load(path.read_text("utf-8"))
    shown = episodes_of(golden, tmp_path)
    log = str(tmp_path / "log.jsonl")
    for session, then in zip(read_sessions(log), shown, strict=True):
        again = [line.text for line in replayed(session, generator_for(None), log) if line.said]
        assert again == [line["text"] for line in then.log if line["line"] in ("say", "turn")]
