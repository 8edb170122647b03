"""Where the story appears: what every screen can do, and the plain one, which only adds text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple, Protocol, TextIO

from personage_lite.realizer.features import JOINERS


class Status(NamedTuple):
    """What the status line shows: the dialog's phase and topic, X in force, E, the belief, turns.

    `engagement` in [-2, 2], None if nothing is sensed; `belief` as `learning.belief` gives it;
    `preference` is a simulated listener's, who has no secrets; `fault` a sensor's last one.
    """

    phase: str
    topic: str
    x: int
    engagement: float | None
    belief: Mapping[str, Any] | None
    turns: int
    preference: int | None
    fault: str


class Screen(Protocol):
    """Shows the session."""

    @property
    def skipped(self) -> bool:
        """Whether the listener wants to see the present text at once."""
        ...

    @property
    def busy(self) -> bool:
        """Whether a text is appearing."""
        ...

    @property
    def drawn(self) -> bool:
        """Whether the terminal is taken, so that nothing else may write to it."""
        ...

    def skip(self) -> None:
        """Let the present text appear at once."""
        ...

    def start(self) -> None:
        """Begin; may change the terminal."""
        ...

    def begin(self, text: str) -> None:
        """Begin to show a text of the storyteller's."""
        ...

    def appear(self, share: float) -> None:
        """Show so much of it, from 0 to 1."""
        ...

    def finish(self) -> None:
        """End the text, with as much of it as is to be read."""
        ...

    def cut(self) -> None:
        """Take note that the text before was broken off."""
        ...

    def heard(self, text: str, typed: bool = False) -> None:
        """Show an answer; `typed`: a terminal that echoes what is typed shows it already."""
        ...

    def note(self, text: str) -> None:
        """Show a line that nobody says."""
        ...

    def status(self, status: Status) -> None:
        """Take note of where the session stands."""
        ...

    def refresh(self) -> None:
        """Draw what has changed; called often."""
        ...

    def suspend(self) -> None:
        """Give the terminal back for a while, as for Ctrl-Z."""
        ...

    def resume(self) -> None:
        """Take the terminal again."""
        ...

    def close(self) -> None:
        """Leave the terminal as it was; may be called twice."""
        ...


class PlainScreen:
    """Text and nothing else: for pipes, for small or dumb terminals, and for who wants no status.

    Where the output is a terminal, text appears letter by letter.
    """

    def __init__(self, out: TextIO, letters: bool) -> None:
        self._out = out
        self._letters = letters
        self._text = ""
        self._shown = 0
        self.skipped = False
        self.drawn = False
        # What is to be shown below the text that is appearing.
        self._meanwhile: list[str] = []

    @property
    def busy(self) -> bool:
        """Whether a text is appearing."""
        return bool(self._text)

    def skip(self) -> None:
        """Let the present text appear at once."""
        self.skipped = True

    def suspend(self) -> None:
        """Nothing was changed."""

    def resume(self) -> None:
        """Nothing is to be done."""

    def start(self) -> None:
        """Nothing is changed."""

    def begin(self, text: str) -> None:
        """Begin a line."""
        self._text, self._shown, self.skipped = text, 0, False

    def appear(self, share: float) -> None:
        """Write the letters that have come since."""
        if self._letters:
            self._until(int(len(self._text) * min(max(share, 0.0), 1.0)))

    def _until(self, count: int) -> None:
        if count > self._shown:
            self._out.write(self._text[self._shown : count])
            self._out.flush()
            self._shown = count

    def finish(self) -> None:
        """Write the rest, end the line, and write what came meanwhile."""
        self._until(len(self._text))
        self._text, self._shown = "", 0
        self._lines("", *self._meanwhile)
        self._meanwhile.clear()

    def cut(self) -> None:
        """Nothing is to be done: the whole text stands there."""

    def heard(self, text: str, typed: bool = False) -> None:
        """Write the answer as if it had been typed, unless the terminal has shown it."""
        if not (typed and self._letters):
            self._add(f"> {printable(text)}")

    def note(self, text: str) -> None:
        """Write a line in brackets."""
        self._add(f"[{printable(text)}]")

    def _add(self, line: str) -> None:
        """Write a line, below the present text if there is one."""
        if self._text:
            self._meanwhile.append(line)
        else:
            self._lines(line)

    def _lines(self, *lines: str) -> None:
        self._out.write("".join(f"{line}\n" for line in lines))
        self._out.flush()

    def status(self, status: Status) -> None:
        """Adaptation stays unobtrusive, as the paper demands (section III)."""

    def refresh(self) -> None:
        """All is written already."""

    def close(self) -> None:
        """Nothing was changed."""


def printable(text: str) -> str:
    r"""Return a text without what could command a terminal; joiners cannot.

    >>> printable("a\x1b[2Jb")
    'a[2Jb'
    """
    return "".join(sign for sign in text if sign.isprintable() or sign in JOINERS)
