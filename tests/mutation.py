"""Spoils data files for the tests of their readers: a mistake or two that a person might make."""

from __future__ import annotations

import re

from hypothesis import strategies as st

VALUES = (
    *("", "no", "7", "-1", "1e9", "[]", "{}", "~", "''", "*x", "&x", "!!int x", "|", "'", '"'),
    *("{alice}", "{nobody}", "{", "#", "😀", "\t", "\x07", "[[a]]", ".nan", "a: b"),
)


@st.composite
def spoilt(draw: st.DrawFn, content: str) -> bytes:
    """Draw a copy of a file with a line dropped or doubled, a value swapped, or its end cut off."""
    for _ in range(draw(st.integers(1, 2))):
        lines = content.split("\n")
        place = draw(st.integers(0, len(lines) - 1))
        kind = draw(st.sampled_from(("drop", "double", "swap", "move", "cut", "byte")))
        if kind == "drop":
            del lines[place]
        elif kind == "double":
            lines.insert(place, lines[place])
        elif kind == "move":
            lines[place] = "  " + lines[place]
        elif kind == "swap":
            words = [*re.finditer(r"[\w.{}-]+", lines[place])]
            if words:
                word = draw(st.sampled_from(words))
                value = draw(st.sampled_from(VALUES))
                line = lines[place]
                lines[place] = line[: word.start()] + value + line[word.end() :]
        content = "\n".join(lines)
        if kind == "cut":
            content = content[: draw(st.integers(0, len(content)))]
        elif kind == "byte":
            raw = content.encode()
            at = draw(st.integers(0, len(raw)))
            return raw[:at] + draw(st.binary(min_size=1, max_size=4)) + raw[at + 1 :]
    return content.encode()


def check_message(error: Exception) -> None:
    """Require that an error's message is one line with a remedy."""
    message = str(error)
    assert len(message.splitlines()) == 1, message
    assert "; " in message, message
