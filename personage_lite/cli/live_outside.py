"""What `live` takes from outside: terminal, clock, log, memory, voice and ears."""

from __future__ import annotations

import argparse
import os
import sys
import time
from contextlib import ExitStack
from typing import TYPE_CHECKING

from personage_lite.errors import PersonageError

if TYPE_CHECKING:
    from collections.abc import Callable

    from adaptation.storyteller.assembly import Options, Outside
    from adaptation.storyteller.kept_logs import KeptLog
    from adaptation.storyteller.protocols import Clock, Speaker
    from adaptation.storyteller.screen import Screen
    from adaptation.storyteller.session_log import NoLog, SessionLog
    from adaptation.voice.speaker import VoiceSpeaker


def outside_of(
    arguments: argparse.Namespace, options: Options, say: Callable[[str], None], stack: ExitStack
) -> Outside:
    """Return the devices; what is opened is closed by `stack`, whatever happens."""
    from adaptation.storyteller.answers import Typed  # noqa: F401 - the slow part first
    from adaptation.storyteller.assembly import Outside

    if sys.stdin is None:
        raise PersonageError("nobody can answer; do not close standard input")
    drawn = _can_draw(arguments, say)
    lines = Lines(say)
    log = _log(arguments.log, lines.say)
    stack.callback(log.close)
    hint = _hint(arguments, options, drawn)

    def screen(line: Callable[[], str]) -> Screen:
        made = lines.follow(_screen(drawn, line))
        if hint and drawn:
            made.note(hint)  # where it can be read: what was there before is hidden
        elif hint:
            say(hint)
        return made

    outside = Outside(
        screen=screen,
        typed=(sys.stdin.fileno(), drawn),
        wall=time.time,
        say=lines.say,
        log=log,
    )
    _add_voice(arguments, outside, lines.say)
    if options.name and arguments.memory != "none":
        from adaptation.memory import open_memory

        outside.memory = open_memory(arguments.memory, learner=options.learner)
        stack.callback(outside.memory.close)
    elif arguments.memory not in (None, "none"):
        raise PersonageError("--memory remembers listeners by their names; add --name NAME")
    return outside


class Lines:
    """Says lines for the user: beside the story while a terminal is drawn on, else on stderr."""

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say = say
        self._screen: Screen | None = None

    def follow(self, screen: Screen) -> Screen:
        """Take note of the screen, and return it."""
        self._screen = screen
        return screen

    def say(self, line: str) -> None:
        """Say a line."""
        if self._screen is not None and self._screen.drawn:
            self._screen.note(line)
        else:
            self._say(line)


def _log(asked: str | None, say: Callable[[str], None]) -> SessionLog | KeptLog | NoLog:
    """Return the log that was asked for, or a new one in the user's own folder."""
    from adaptation.storyteller.kept_logs import KeptLog, log_folder
    from adaptation.storyteller.session_log import NoLog, SessionLog

    if asked is None:
        return KeptLog(log_folder(), time.time, say)
    return NoLog() if asked == "none" else SessionLog(asked)


def _add_voice(arguments: argparse.Namespace, outside: Outside, say: Callable[[str], None]) -> None:
    """Let the session speak and hear, if asked to; it does not hear itself."""
    voices: list[VoiceSpeaker] = []
    if arguments.speak or arguments.wav is not None:
        from adaptation.voice import speaker_from

        def voice(clock: Clock, instead: Speaker) -> VoiceSpeaker:
            speaker = speaker_from(
                arguments.voice, arguments.wav, clock=clock, instead=instead, say=say,
                play=arguments.speak,
            )  # fmt: skip
            voices.append(speaker)
            return speaker

        outside.voice = voice
    elif arguments.voice is not None:
        raise PersonageError("--voice says who speaks; add --speak or --wav FILE")
    if arguments.ear or arguments.microphone is not None:
        from adaptation.voice import ear_from

        outside.hears = lambda clock, typed: ear_from(
            arguments.ear or (), arguments.microphone, clock=clock, typed=typed, say=say,
            deaf=lambda: any(speaker.speaking for speaker in voices),
        )  # fmt: skip


def _can_draw(arguments: argparse.Namespace, say: Callable[[str], None]) -> bool:
    """Whether the terminal can be drawn on; where it is too small a line says so."""
    if arguments.plain or not (sys.stdin.isatty() and sys.stdout.isatty()):
        return False
    if os.environ.get("TERM", "dumb") == "dumb":
        return False
    from adaptation.storyteller.console import LEAST_COLUMNS, LEAST_ROWS

    columns, rows = os.get_terminal_size(sys.stdout.fileno())
    if columns < LEAST_COLUMNS or rows < LEAST_ROWS:
        say(
            f"the terminal is {columns}x{rows}, so the story comes as plain text; "
            f"make it {LEAST_COLUMNS}x{LEAST_ROWS} for the status"
        )
        return False
    return True


def _screen(drawn: bool, line: Callable[[], str]) -> Screen:
    if drawn:
        from adaptation.storyteller.console import Console

        return Console(sys.stdin.fileno(), sys.stdout, "NO_COLOR" not in os.environ, line)
    from adaptation.storyteller.screen import PlainScreen

    return PlainScreen(sys.stdout, letters=sys.stdout.isatty())


def _hint(arguments: argparse.Namespace, options: Options, drawn: bool) -> str:
    """Return what more there is, for who has asked for nothing of it."""
    if arguments.sensor or arguments.name or options.listener is not None:
        return ""
    more = "more: --name YOU, --sensor camera, --speak"
    if options.sensors:
        how = "press +" if drawn else "type + and Enter"
        return f"{how} when you like it and - when not; {more}"
    return f"nobody watches you, so nothing is learned; {more}"
