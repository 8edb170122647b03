"""The storyteller's screen in a terminal: the talk, a line to type in, and a status below it.

Plain ANSI codes; only rows that have changed are written. The size is asked for before each
drawing, so that it follows the window. On leaving, the talk stands in the terminal as text.
"""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable
from typing import Any, TextIO

from adaptation.storyteller.layout import dim, plain_rows, status_rows, wrap
from adaptation.storyteller.screen import Status, printable

LEAST_ROWS, LEAST_COLUMNS = 12, 48
# Wider lines are hard to read.
_WIDEST = 84
_ENTER, _LEAVE = "\x1b[?1049h\x1b[?7l", "\x1b[?7h\x1b[?25h\x1b[?1049l"
_HIDE, _SHOW, _CLEAR = "\x1b[?25l", "\x1b[?25h", "\x1b[0m\x1b[2J"
_PROMPT = "> "
# So many texts are kept to be drawn again, and for the end.
_KEPT = 2000
_WAITING = ("Enter: yes", "Tab: somebody else", "or a name", "Esc: pause", "Ctrl-D: quit")
_TELLING = ("Space: skip", "Tab: somebody else", "or a name", "Esc: pause", "+ -: like it?")
_PAUSED = ("Esc: go on", "or a name", "Ctrl-D: quit")


class Console:
    """The screen of a terminal that can be drawn on; see `Screen`.

    `keys` is the terminal's descriptor; `line` returns what has been typed so far; `colour` says
    whether dim letters may be used.
    """

    def __init__(self, keys: int, out: TextIO, colour: bool, line: Callable[[], str]) -> None:
        self._descriptor = keys
        self._out = out
        self._colour = colour
        self._line = line
        self._texts: deque[tuple[str, str]] = deque(maxlen=_KEPT)
        # What was heard while a text was appearing: it comes after it.
        self._meanwhile: list[tuple[str, str]] = []
        self._text = ""
        self._shown = 0
        self._status: Status | None = None
        self._drawn: list[str] = []
        self._size = (0, 0)
        self._before: list[Any] | None = None
        self._open = False
        self.skipped = False

    def start(self) -> None:
        """Take the terminal: keys come one by one, without echo; Ctrl-C works as ever."""
        self._keys_at_once()
        self._open = True
        self._write(_ENTER)
        self.refresh()

    def _keys_at_once(self) -> None:
        import termios
        import tty

        self._before = termios.tcgetattr(self._descriptor)
        tty.setcbreak(self._descriptor, termios.TCSANOW)

    def close(self) -> None:
        """Give the terminal back, with the talk in it as text; may be called twice."""
        if not self._open:
            return
        self._open = False
        try:
            self._write(_LEAVE)
            columns = self._columns_now()
            for row in plain_rows(self._texts, min(columns, _WIDEST), _PROMPT):
                self._write(f"{row}\n")
        finally:
            self._restore()

    def _restore(self) -> None:
        if self._before is not None:
            import termios

            before, self._before = self._before, None
            termios.tcsetattr(self._descriptor, termios.TCSADRAIN, before)

    def suspend(self) -> None:
        """Give the terminal back for a while, as for Ctrl-Z."""
        if self._open:
            self._write(_LEAVE)
            self._restore()

    def resume(self) -> None:
        """Take the terminal again."""
        if self._open:
            self._keys_at_once()
            self._drawn, self._size = [], (0, 0)
            self._write(_ENTER)
            self.refresh()

    # What is shown

    @property
    def drawn(self) -> bool:
        """Whether the terminal is taken, so that nothing else may write to it."""
        return self._open

    @property
    def busy(self) -> bool:
        """Whether a text is appearing."""
        return bool(self._text)

    def skip(self) -> None:
        """Let the present text appear at once."""
        self.skipped = True

    def begin(self, text: str) -> None:
        """Begin to show a text."""
        self._text, self._shown, self.skipped = text, 0, False

    def appear(self, share: float) -> None:
        """Show so much of it."""
        self._shown = int(len(self._text) * min(max(share, 0.0), 1.0))
        self.refresh()

    def finish(self) -> None:
        """Keep the text, all of it."""
        self._texts.append(("said", self._text))
        self._texts.extend(self._meanwhile)
        self._meanwhile.clear()
        self._text, self._shown = "", 0
        self.refresh()

    def cut(self) -> None:
        """Nothing is to be done: the whole text stands there."""

    def heard(self, text: str, typed: bool = False) -> None:
        """Show an answer."""
        self._keep("heard", text)

    def note(self, text: str) -> None:
        """Show a line that nobody says."""
        self._keep("note", text)
        self.refresh()

    def _keep(self, kind: str, text: str) -> None:
        """Put a line below the present text, if there is one."""
        (self._meanwhile if self._text else self._texts).append((kind, printable(text)))

    def status(self, status: Status) -> None:
        """Take note of where the session stands."""
        self._status = status
        self.refresh()

    # Drawing

    def refresh(self) -> None:
        """Draw the rows that have changed."""
        if not self._open:
            return
        size = self._size_now()
        if size != self._size:
            self._write(_CLEAR)
            self._drawn, self._size = [], size
        columns, rows = size
        wanted = self._rows(columns, rows)
        before = self._drawn or [""] * len(wanted)
        changes = [
            f"\x1b[{number};1H\x1b[K{row}"
            for number, (row, old) in enumerate(zip(wanted, before, strict=True), 1)
            if row != old
        ]
        self._drawn = wanted
        typed = len(printable(self._line())[-(columns - 4) :])
        place = f"\x1b[{rows - self._below()};{len(_PROMPT) + typed + 2}H"
        if changes:
            self._write(_HIDE + "".join(changes) + place + _SHOW)

    def _below(self) -> int:
        return 3 if self._status is not None and self._size[1] >= LEAST_ROWS else 0

    def _rows(self, columns: int, rows: int) -> list[str]:
        """Return the whole screen, row by row."""
        below = self._below()
        status = [] if self._status is None or not below else status_rows(self._status, columns)
        body = self._body(columns, rows - below - 2)
        typed = printable(self._line())[-(columns - 4) :]
        prompt = f" {_PROMPT}{typed}" if typed else f" {_PROMPT}{self._dim(self._hint(columns))}"
        rule = self._dim("─" * columns)
        return [*body, "", prompt, *([rule, *status] if below else [])]

    def _hint(self, columns: int) -> str:
        phase = self._status.phase if self._status is not None else ""
        hints: tuple[str, ...] = _WAITING
        if phase in ("paused", "telling"):
            hints = _PAUSED if phase == "paused" else _TELLING
        # As many as have room, each whole.
        while len("   ".join(hints)) > columns - 4:
            hints = hints[:-1]
        return "   ".join(hints)

    def _dim(self, text: str) -> str:
        return dim(text) if self._colour else text

    def _body(self, columns: int, rows: int) -> list[str]:
        """Return the last rows of the talk, at the bottom of its part of the screen."""
        width = max(10, min(columns - 4, _WIDEST))
        found: deque[str] = deque()
        if self._text:
            # Wrapped as a whole, so that no word jumps to the next row while it appears.
            left = self._shown
            for row in wrap(self._text, width):
                if left <= 0:
                    break
                found.append("  " + row[:left])
                left -= len(row) + 1
        for kind, text in reversed(self._texts):
            if len(found) >= rows:
                break
            lines = wrap(f"{_PROMPT}{text}" if kind == "heard" else text, width)
            shown = [f"  {self._dim(row) if kind != 'said' else row}" for row in lines]
            gap = [""] if found else []
            found.extendleft(reversed([*shown, *gap]))
        last = list(found)[-rows:] if rows > 0 else []
        return [""] * (rows - len(last)) + last

    def _size_now(self) -> tuple[int, int]:
        try:
            columns, rows = os.get_terminal_size(self._out.fileno())
        except OSError:
            return self._size if self._size[0] else (80, 24)
        return max(columns, 10), max(rows, 4)

    def _columns_now(self) -> int:
        return self._size_now()[0] - 1

    def _write(self, text: str) -> None:
        self._out.write(text)
        self._out.flush()
