"""The dialog of figure 4: states, transitions, and what answers mean."""

from __future__ import annotations

import pytest

from adaptation.storyteller.dialog import (
    MOST_UNANSWERED,
    Began,
    Dialog,
    Do,
    Ended,
    Event,
    Heard,
    Listen,
    Say,
    Silence,
    Stock,
    Tell,
    Told,
    order,
    step,
)
from adaptation.storyteller.understanding import Meaning, Sense, Understanding, names_of
from personage_lite import Generator
from personage_lite.data import data_folder

STOCK = Stock({"alice": 3, "hatter": 2, "dodo": 1}, ("alice", "hatter", "dodo"))
WAITING = Dialog("waiting", "alice")
TELLING = Dialog("telling", "alice")


def heard(sense: Sense, name: str = "") -> Event:
    return Heard(Meaning(sense, name))


def test_a_session_greets_and_suggests() -> None:
    for known, name, act in (
        (False, "", "greeting"),
        (False, "Anna", "greeting_named"),
        (True, "Anna", "greeting_again"),
    ):
        dialog, do = step(Dialog(), Began(known, name), STOCK)
        assert dialog.phase == "waiting"
        assert do == (Say(act), Say("suggestion", "alice"), Listen())


@pytest.mark.parametrize(
    ("dialog", "event", "phase", "do"),
    [
        (WAITING, heard("yes"), "telling", (Tell("alice"),)),
        (WAITING, heard("no"), "waiting", (Say("another", "hatter"), Listen())),
        (WAITING, heard("name", "dodo"), "telling", (Tell("dodo"),)),
        (WAITING, heard("unknown_name", "x"), "waiting", (Say("unknown_name", "", "x"), Listen())),
        (WAITING, heard("unclear"), "waiting", (Say("not_understood"), Listen())),
        (WAITING, heard("pause"), "paused", (Say("pause"), Listen(True))),
        (WAITING, heard("quit"), "farewell", (Say("farewell"),)),
        (WAITING, Silence(), "waiting", (Say("asked_again", "alice"), Listen())),
        (TELLING, Told(), "telling", (Tell("alice"),)),
        (TELLING, heard("yes"), "telling", (Tell("alice"),)),
        (TELLING, heard("unclear"), "telling", (Tell("alice"),)),
        (TELLING, heard("no"), "waiting", (Say("another", "hatter"), Listen())),
        (TELLING, heard("name", "dodo"), "telling", (Tell("dodo"),)),
        (TELLING, heard("pause"), "paused", (Say("pause"), Listen(True))),
        (TELLING, Ended(), "farewell", (Say("farewell"),)),
        (TELLING, Ended(politely=False), "over", ()),
    ],
)
def test_transitions(dialog: Dialog, event: Event, phase: str, do: tuple[object, ...]) -> None:
    after, done = step(dialog, event, STOCK)
    assert (after.phase, done) == (phase, do)


def test_a_pause_goes_back_to_where_it_began() -> None:
    paused, _ = step(TELLING, heard("pause"), STOCK)
    assert step(paused, Silence(), STOCK) == (paused, (Listen(patient=True),))
    after, do = step(paused, heard("resume"), STOCK)
    assert (after.phase, do) == ("telling", (Say("resume"), Tell("alice")))


def test_what_is_exhausted_is_never_suggested() -> None:
    stock = Stock({"hatter": 2}, ("hatter",))
    after, do = step(TELLING, Told(), stock)
    assert do == (Say("exhausted", "alice"), Say("suggestion", "hatter"), Listen())
    assert step(after, heard("name", "alice"), stock)[1][0] == Say("told_already", "alice")
    nothing = Stock({}, ())
    assert step(TELLING, Told(), nothing)[1][-2:] == (Say("all_told"), Say("farewell"))


def test_who_refuses_all_is_let_go() -> None:
    dialog = WAITING
    do: tuple[Do, ...] = ()
    for _ in STOCK.order:
        dialog, do = step(dialog, heard("no"), STOCK)
    assert do == (Say("none_wanted"), Say("farewell"))


def test_silence_is_asked_about_once_and_is_no_refusal() -> None:
    dialog, _ = step(WAITING, Silence(), STOCK)
    dialog, do = step(dialog, Silence(), STOCK)
    assert (dialog.phase, do) == ("telling", (Say("silence", "alice"), Tell("alice")))


def test_nobody_there_is_not_told_all_day() -> None:
    dialog = WAITING._replace(silences=1, unanswered=MOST_UNANSWERED - 1)
    assert step(dialog, Silence(), STOCK)[0].phase == "farewell"


def test_who_was_mentioned_comes_first() -> None:
    assert order({"a": 1, "b": 1}, ("b", "gone"), ("a", "b")) == ("b", "a")


# Meanings


@pytest.fixture(scope="module")
def understanding() -> Understanding:
    generator = Generator(facts=f"{data_folder('facts')}/wonderland")
    return Understanding(generator.dialog.heard, names_of(generator.characters()))


@pytest.mark.parametrize(
    ("text", "sense", "name"),
    [
        ("Yes, please!", "yes", ""),
        ("y", "yes", ""),
        ("NO.", "no", ""),
        ("something else please", "no", ""),
        ("please stop", "quit", ""),
        ("pause", "pause", ""),
        ("no, the Hatter", "name", "hatter"),
        ("tell me about the WHITE-RABBIT", "name", "white_rabbit"),
        ("the white rabit", "name", "white_rabbit"),
        ("white_rabbit", "name", "white_rabbit"),
        ("queen", "name", "queen_of_hearts"),
        ("tell me about Robin Hood", "unknown_name", "Robin Hood"),
        ("'; DROP TABLE listener; --", "unclear", ""),
        ("a" * 10_000, "unclear", ""),
        ("\x1b[2J\x07", "unknown_name", "2j"),
        ("", "unclear", ""),
        ("?", "who", ""),
    ],
)
def test_meanings(understanding: Understanding, text: str, sense: str, name: str) -> None:
    assert understanding.meaning(text) == Meaning(sense, name)  # type: ignore[arg-type]


def test_go_on_means_what_the_state_asks_for(understanding: Understanding) -> None:
    assert understanding.meaning("go on").sense == "yes"
    assert understanding.meaning("go on", ("resume",)).sense == "resume"
