"""One rule for listeners' names: any script is said as it is, and what is no name is one line."""

from __future__ import annotations

import pytest

from personage_lite import Generator
from personage_lite.errors import PersonageError
from personage_lite.names import LONGEST, checked_name

NAMES = [
    "Anna",
    "Zoë Ünïcøde",
    "李小龙",
    "می\u200cخواهم",
    "ක්\u200dෂ",
    "👩\u200d🚀",
    "O'Brien",
    "X" * LONGEST,
]
REFUSED = [
    ("", "is empty; give one"),
    (" \t ", "is empty; give one"),
    ("\u200d\u200c", "is empty; give one"),
    ("x" * 10_240, "is 10240 characters long; give at most 100"),
    ("ﷺ" * 9, "is 162 characters long; give at most 100"),
    ("a\x1b[31m", "U+001B, which cannot be seen; leave it out"),
    ("a\0b", "U+0000, which cannot be seen; leave it out"),
    ("a\nb", "U+000A, which cannot be seen; leave it out"),
    ("a\x85b", "U+0085, which cannot be seen; leave it out"),
    ("a\u2028b", "U+2028, which cannot be seen; leave it out"),
    ("a\u2029b", "U+2029, which cannot be seen; leave it out"),
    ("\u202eanna", "U+202E, which cannot be seen; leave it out"),
    ("a\u2066b", "U+2066, which cannot be seen; leave it out"),
    ("a\u200bb", "U+200B, which cannot be seen; leave it out"),
    ("a\ud800", "U+D800, which cannot be seen; leave it out"),
]


@pytest.fixture(scope="module")
def generator() -> Generator:
    return Generator()


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_said_as_it_is(name: str, generator: Generator) -> None:
    assert checked_name(f"  {name} ") == name
    for act in ("greeting_named", "greeting_again", "farewell_named"):
        for seed in range(5):
            assert name in generator.say(act, name=name, x=1, seed=seed).text


@pytest.mark.parametrize(("name", "message"), REFUSED)
def test_what_is_no_name_is_refused_in_one_line(
    name: str, message: str, generator: Generator
) -> None:
    with pytest.raises(PersonageError) as fault:
        checked_name(name)
    assert str(fault.value).endswith(message)
    assert str(fault.value).isprintable()
    assert len(str(fault.value)) < 150
    with pytest.raises(PersonageError) as said:
        generator.say("greeting_named", name=name)
    assert str(said.value) == str(fault.value) or not name


def test_spaces_and_composition_are_made_one() -> None:
    assert checked_name(" Zoe\u0308   K\n") == "Zoë K"
