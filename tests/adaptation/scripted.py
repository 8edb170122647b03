"""Whole sessions in simulated time, with a person whose answers are a script."""

from __future__ import annotations

import argparse
import io
import json
import os
import shlex
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from adaptation.storyteller.assembly import Outside, run_session
from adaptation.storyteller.clocks import SimulatedClock
from adaptation.storyteller.protocols import Clock, Ear, EndOfInput, Heard, Memory
from adaptation.storyteller.screen import PlainScreen, Screen
from adaptation.storyteller.session_log import SessionLog
from personage_lite.cli import live

# Who answers in the middle of an utterance does so after so many seconds of it.
_INTO = 1.0


class Answer(NamedTuple):
    """An answer: given when the storyteller waits for one.

    With `during` in the middle of an utterance, the one of that number since the last answer.
    """

    say: str
    during: int = 0


class ScriptedEar:
    """Hears the answers of a script in their order; then the input is at its end."""

    def __init__(self, script: Sequence[Answer], clock: Clock) -> None:
        self._left = deque(script)
        self._clock = clock
        self._begun = 0
        self._since = 0.0

    def begin(self) -> None:
        """Take note that an utterance begins."""
        self._begun += 1
        self._since = self._clock.now()

    def listen(self, seconds: float | None) -> Heard | None:
        if seconds == 0:
            following = self._left[0] if self._left else None
            if following is None or not following.during or following.during > self._begun:
                return None
            if self._clock.now() < self._since + _INTO:
                return None
        elif not self._left:
            raise EndOfInput
        elif self._left[0].during:
            assert seconds is not None, "the script has no answer where one is waited for"
            self._clock.sleep(seconds)
            return None
        else:
            self._clock.sleep(0.8)
        self._begun = 0
        return Heard(self._left.popleft().say)

    def expect(self, phrases: Sequence[str]) -> None: ...

    def close(self) -> None: ...


class ScriptedScreen(PlainScreen):
    """Plain text, with the answers in it as a terminal would show them."""

    def __init__(self, out: io.StringIO, begun: Callable[[], None]) -> None:
        super().__init__(out, letters=False)
        self._begun = begun

    def begin(self, text: str) -> None:
        self._begun()
        super().begin(text)


class Shown(NamedTuple):
    """What came of a session: the screen's lines, the lines for the user, the log's lines."""

    screen: list[str]
    said: list[str]
    log: list[dict[str, Any]]

    def of(self, kind: str) -> list[dict[str, Any]]:
        return [line for line in self.log if line["line"] == kind]


def told(
    arguments: str,
    script: Sequence[Answer],
    log: Path,
    *,
    memory: Memory | None = None,
    wall: float = 1_800_000_000.0,
    **parts: Any,
) -> Shown:
    """Run `personage-lite live` with these arguments before a person with a script.

    `parts` are further fields of `Outside`. With a simulated listener only what is said in the
    middle of utterances cannot be in the script.
    """
    parser = argparse.ArgumentParser()
    live.add_arguments(parser)
    options = live.options_of(parser.parse_args(shlex.split(arguments)))
    out, said = io.StringIO(), list[str]()
    ears: list[ScriptedEar] = []

    def hears(clock: Clock, _typed: Ear) -> Ear:
        ears.append(ScriptedEar(script, clock))
        return ears[0]

    def screen(_line: Callable[[], str]) -> Screen:
        return ScriptedScreen(out, lambda: ears[0].begin() if ears else None)

    record = SessionLog(str(log))
    before = log.stat().st_size
    nothing = os.open(os.devnull, os.O_RDONLY)
    try:
        run_session(
            live.generator_for(None),
            options,
            Outside(
                screen=screen, typed=(nothing, True), wall=lambda: wall, say=said.append,
                log=record, memory=memory, hears=hears, clock=SimulatedClock(), **parts,
            ),
        )  # fmt: skip
    finally:
        record.close()
        os.close(nothing)
    lines = log.read_bytes()[before:].decode("utf-8").splitlines()
    return Shown(out.getvalue().splitlines(), said, [json.loads(line) for line in lines])


def answers(script: Sequence[Mapping[str, Any]]) -> list[Answer]:
    """Return the answers of a script as the golden files hold it."""
    return [Answer(**each) for each in script]
