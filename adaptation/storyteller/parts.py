"""What a session is joined from, how it goes, and what it leaves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from adaptation.storyteller.audience import Audience
from adaptation.storyteller.kept_logs import KeptLog
from adaptation.storyteller.learning import Move, TalkLearner
from adaptation.storyteller.pace import seconds_to_say
from adaptation.storyteller.protocols import Ear, Memory, Speaker
from adaptation.storyteller.remarks import Remarks
from adaptation.storyteller.screen import Screen
from adaptation.storyteller.senses import Sensed, Senses
from adaptation.storyteller.session_log import NoLog, SessionLog
from adaptation.storyteller.stock import Stories
from adaptation.storyteller.ticking import Ticker
from adaptation.storyteller.understanding import Understanding
from personage_lite.generator import Generator
from personage_lite.plan import Utterance


@dataclass
class Settings:
    """How a session goes.

    `breath` is the pause between utterances, `patience` how long an answer is waited for, both in
    seconds; `turns` ends the session after so many utterances; `wall` returns epoch seconds.
    """

    seed: int = 0
    turns: int | None = None
    name: str = ""
    known: bool = False
    breath: float = 0.4
    patience: float = 20.0
    wall: Callable[[], float] = lambda: 0.0


@dataclass
class Parts:
    """What a session is joined from."""

    generator: Generator
    stories: Stories
    understanding: Understanding
    talk: TalkLearner
    senses: Senses
    clock: Ticker
    speaker: Speaker
    ear: Ear
    screen: Screen
    log: SessionLog | KeptLog | NoLog = field(default_factory=NoLog)
    memory: Memory | None = None
    audience: Audience | None = None
    remarks: Remarks | None = None
    seconds: Callable[[str, float], float] = seconds_to_say


@dataclass
class Summary:
    """What came of a session: utterances, seconds spoken, seconds between utterances."""

    turns: int = 0
    spoken: float = 0.0
    pauses: list[float] = field(default_factory=list)
    reason: str = "fault"


class Times(NamedTuple):
    """How long an utterance took, and the pause before it (None after anything but another one)."""

    duration: float
    pause: float | None


def turn_record(
    number: int,
    utterance: Utterance,
    turn: int,
    move: Move,
    sensed: Sensed,
    times: Times,
    reward: float | None,
    chosen_at: float | None,
    believed: Mapping[str, Any] | None,
    listener: Mapping[str, Any] | None,
) -> dict[str, Any]:
    """Return what the log and the memory keep of an utterance, ready for JSON (docs/live.md)."""
    return {
        "number": number,
        "state": "telling",
        "x": move.x,
        "action": move.action,
        "probability": move.probability,
        "chosen": move.learned,
        "text": utterance.text,
        "character": utterance.character,
        "facts": list(utterance.facts),
        "seed": utterance.seed,
        "turn": turn,
        "engagement_chosen": chosen_at,
        "engagement_before": sensed.before,
        "engagement_after": sensed.after,
        "reward": reward,
        "duration": times.duration,
        "pause": times.pause,
        "stream": list(sensed.stream),
        "belief": believed,
        "listener": listener,
    }
