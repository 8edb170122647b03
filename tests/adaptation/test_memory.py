"""The memory keeps what it is given, on SQLite and on PostgreSQL, whatever listeners are called."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from adaptation.memory import open_memory
from adaptation.memory.knowledge import pooled
from adaptation.memory.names import key
from adaptation.memory.places import found_place, shown_place, usual_place
from personage_lite.errors import PersonageError

ROOT = Path(__file__).resolve().parents[2]
LEARNED: dict[str, Any] = {
    "learner": "ucb",
    "version": 1,
    "settings": {},
    "trials": 1,
    "state": {"sums": [[1.0, 0.1 + 0.2]]},
}
STRANGE = [
    "Robert'); DROP TABLE listener;--",
    "../../etc/passwd",
    "C:\\con",
    "%s %(name)s :key {0}",
    'O\'Brien "the Cat"',
    "Zoë Ünïcøde 李小龙 🐇",
    "می\u200cخواهم 👩\u200d🚀",
    "x" * 100,
    "-",
]


def test_a_stranger_is_met_and_known_again(database: str) -> None:
    memory = open_memory(database)
    assert memory.recall("Anna") is None
    assert memory.begin("Anna", 100.0) == ("Anna", 1, {}, None, None)
    memory.remember("Anna", {"text": "Oh…", "e": 0.1}, LEARNED, {"alice": {"clumsy": 1}})
    memory.remember("Anna", {"text": "\0", "e": math.nan}, LEARNED, {"alice": {"clumsy": 2}})
    memory.close()
    memory.close()
    again = open_memory(database)
    known = again.begin("  ANNA ", 5000.5)
    assert tuple(known) == ("Anna", 2, {"alice": {"clumsy": 2}}, LEARNED, 100.0)
    assert again.turns("anna") == [[{"text": "Oh…", "e": 0.1}, {"text": "\0", "e": None}], []]
    recalled = again.recall("anna")
    assert recalled is not None
    assert recalled.last_seen == 5000.5
    again.remember("anna", {"when": 6000}, LEARNED, known.told)
    assert [known.last_seen for known in again.listeners()] == [6000.0]
    again.close()


@pytest.mark.parametrize("name", STRANGE)
def test_strange_names_are_names(database: str, name: str) -> None:
    memory = open_memory(database)
    memory.begin("Anna", 0.0)
    memory.begin(name, 0.0)
    memory.remember(name, {}, {}, {name: {name: 1}})
    assert sorted(known.name for known in memory.listeners()) == sorted(["Anna", name])
    recalled = memory.recall(name)
    assert recalled is not None
    assert recalled.told == {name: {name: 1}}
    assert memory.forget(name)
    assert [known.name for known in memory.listeners()] == ["Anna"]
    memory.close()


@pytest.mark.parametrize(
    "name",
    [
        "",
        "  ",
        "x" * 10_240,
        "a\0b",
        "a\nb",
        "a\tb",
        "\x1b[31mred",
        "\u202eanna",
        "\ud800",
        "ﷺ" * 9,
    ],
)
def test_what_is_no_name_is_refused_in_one_line(sqlite: str, name: str) -> None:
    memory = open_memory(sqlite)
    for call in (memory.recall, memory.forget, lambda name: memory.begin(name, 0.0)):
        with pytest.raises(PersonageError) as fault:
            call(name)
        assert len(str(fault.value)) < 150
        assert str(fault.value).isprintable()
    memory.close()


def test_case_spaces_and_composition_make_no_other_name() -> None:
    assert len({key(name) for name in ("Zoë  K", " zoë k", "ZOE\u0308 K", "Zoe\u0308 \u212a")}) == 1
    assert key("Anna") != key("Anne")


def test_nothing_is_remembered_without_an_episode(sqlite: str) -> None:
    memory = open_memory(sqlite)
    with pytest.raises(PersonageError, match="begin one first"):
        memory.remember("Anna", {}, {}, {})
    with pytest.raises(PersonageError, match="at no time"):
        memory.begin("Anna", math.nan)
    memory.begin("Anna", 0.0)
    with pytest.raises(PersonageError, match="cannot be kept"):
        memory.remember("Anna", {"x": object()}, {}, {})
    assert memory.turns("Anna") == [[]]
    memory.close()


def test_each_learner_finds_what_it_knew(database: str) -> None:
    first, second = {**LEARNED, "learner": "bayes"}, {**LEARNED, "learner": "ucb"}
    for saved in (first, second):
        memory = open_memory(database)
        memory.begin("Anna", 0.0)
        memory.remember("Anna", {}, saved, {})
        memory.close()
    for learner, expected in (("bayes", first), ("ucb", second), (None, second), ("pgrl", None)):
        memory = open_memory(database, learner=learner)
        recalled = memory.recall("Anna")
        assert recalled is not None
        assert recalled.learner == expected
        memory.close()


def learned(value: float) -> dict[str, Any]:
    return {**LEARNED, "state": {"sums": [value]}}


def test_what_two_sessions_at_once_learn_is_averaged_by_their_turns(database: str) -> None:
    one, other = open_memory(database), open_memory(database)
    for memory in (one, other):
        memory.begin("Anna", 0.0)
    for value in (1.0, 2.0, 3.0):
        one.remember("anna", {"from": 1}, learned(value), {"alice": {"clumsy": 1, "late": 1}})
    other.remember("anna", {"from": 2}, learned(7.0), {"alice": {"clumsy": 2}, "dodo": {"wet": 1}})
    one.remember("anna", {"from": 1}, learned(3.0), {"alice": {"clumsy": 1, "late": 1}})
    third = open_memory(database)
    known = third.begin("Anna", 1.0)
    assert known.learner == learned(3.8)  # 4 turns of 3, one of 7
    assert known.told == {"alice": {"clumsy": 2, "late": 1}, "dodo": {"wet": 1}}
    assert [len(episode) for episode in third.turns("Anna")] == [4, 1, 0]
    # The third session knew of both: what it learns replaces the average.
    third.remember("anna", {}, learned(5.0), {})
    recalled = third.recall("anna")
    assert recalled is not None
    assert recalled.learner == learned(5.0)
    for memory in (one, other, third):
        memory.close()


def test_only_what_can_be_averaged_is() -> None:
    places = {**LEARNED, "state": {"arms": [1, 2]}}
    other = {**LEARNED, "state": {"arms": [1, 3]}}
    assert pooled([(places, 1), (other, 1)]) == places
    assert pooled([(places, 1), ({**other, "version": 2}, 1)]) == places
    assert pooled([(places, 1), ({**LEARNED, "state": {"arms": [[1.0], [1.0, 2.0]]}}, 1)]) == places
    assert pooled([({}, 1), ({}, 1)]) == {}


_WRITER = """
import sys
from adaptation.memory import open_memory
where, name, own, count = sys.argv[1:]
memory = open_memory(where, patience=60.0)
told = {own: {}}
memory.begin(name, 1.0)
for number in range(int(count)):
    told[own][f"fact{number}"] = 1
    told["shared"] = {"fact": number}
    memory.remember(name, {"own": own, "number": number}, {}, told)
memory.close()
"""


@pytest.mark.parametrize("names", [("Anna", "Bert"), ("Anna", "anna")])
def test_two_processes_at_once_mix_nothing_and_lose_nothing(
    database: str, names: tuple[str, str]
) -> None:
    # On a database that is not there yet: both want to make its tables.
    writers = [
        subprocess.Popen(
            [sys.executable, "-c", _WRITER, database, name, own, "25"],
            cwd=ROOT,
            stderr=subprocess.PIPE,
            text=True,
        )
        for name, own in zip(names, ("one", "other"), strict=True)
    ]
    for writer in writers:
        assert writer.communicate(timeout=120)[1] == ""
        assert writer.returncode == 0
    memory = open_memory(database)
    facts = {f"fact{number}": 1 for number in range(25)}
    for name, own in zip(names, ("one", "other"), strict=True):
        recalled = memory.recall(name)
        assert recalled is not None
        assert recalled.told[own] == facts
        assert recalled.told["shared"] == {"fact": 24}
        assert recalled.episodes == (2 if key(names[0]) == key(names[1]) else 1)
        assert len(recalled.told) == (3 if recalled.episodes == 2 else 2)
        episodes = [episode for episode in memory.turns(name) if episode[0]["own"] == own]
        assert episodes == [[{"own": own, "number": number} for number in range(25)]]
    memory.close()


def test_places() -> None:
    assert found_place("a b.sqlite").database == "a b.sqlite"
    assert found_place(None).database == str(usual_place())
    assert found_place("postgres://u:p@h/d").drivername == "postgresql+psycopg"
    assert shown_place(found_place("postgres://u:p@h/d")) == "postgresql://u:***@h/d"
    assert usual_place({"XDG_DATA_HOME": "rel", "HOME": "/h"}, "linux").parts[:3] == (
        "/",
        "h",
        ".local",
    )
    for wrong in ("", " ", "a\0b", "://", "postgresql://u:p@h:port/d", "mysql://u@h/d", "x://"):
        with pytest.raises(PersonageError, match=r"^memory: .*give"):
            found_place(wrong)
