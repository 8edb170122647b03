"""The dialog of figure 4 as explicit states and pure transitions (the paper, section IV-A).

    greeting → suggesting → waiting → telling → suggesting … → farewell → over
                                ↕         ↕
                              paused    paused

`step` takes a state and what happened and returns the next state and what is to be done. It
touches nothing else: devices, generator and learner are the driver's. Accepting and refusing
never reach the learner, because only what is told does.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, NamedTuple, TypeAlias

from adaptation.storyteller.understanding import Meaning

Phase: TypeAlias = Literal[
    "greeting", "suggesting", "waiting", "telling", "paused", "farewell", "over"
]
# After so many suggestions in a row that nobody answered, nobody seems to be there.
MOST_UNANSWERED = 3


class Say(NamedTuple):
    """An act to be said, about a character or a name that was heard."""

    act: str
    character: str = ""
    heard: str = ""


class Listen(NamedTuple):
    """Wait for an answer; `patient` for however long it takes."""

    patient: bool = False


class Tell(NamedTuple):
    """Tell the next facts about a character."""

    character: str


class ShowNames(NamedTuple):
    """Show who can be told about."""


Do: TypeAlias = Say | Listen | Tell | ShowNames


class Began(NamedTuple):
    """The session begins; `known` if the listener has been here before, `name` if they gave one."""

    known: bool = False
    name: str = ""


class Heard(NamedTuple):
    """The listener answered, or said something while being told."""

    meaning: Meaning


class Silence(NamedTuple):
    """Nobody answered in time."""


class Told(NamedTuple):
    """Facts were told."""


class Ended(NamedTuple):
    """It is over: `politely` with a farewell, as after a last turn; else at once."""

    politely: bool = True


Event: TypeAlias = Began | Heard | Silence | Told | Ended


class Stock(NamedTuple):
    """What can still be told: `left` counts new facts by character, none of them 0.

    `order` are those characters, the ones to be suggested first at its front.
    """

    left: Mapping[str, int]
    order: Sequence[str]


class Dialog(NamedTuple):
    """Where the dialog stands.

    `topic` is the character suggested or told about; `refused` those that were refused in this
    session; `silences` how often the present question was met with silence; `unanswered` how many
    suggestions in a row were; `before` the phase that a pause goes back to.
    """

    phase: Phase = "greeting"
    topic: str = ""
    refused: tuple[str, ...] = ()
    silences: int = 0
    unanswered: int = 0
    before: Phase = "waiting"
    named: bool = False


Step: TypeAlias = tuple[Dialog, tuple[Do, ...]]


def step(dialog: Dialog, event: Event, stock: Stock) -> Step:
    """Return the state after an event, and what is to be done then, in order.

    >>> stock = Stock({"alice": 3, "hatter": 2}, ("alice", "hatter"))
    >>> dialog, do = step(Dialog(), Began(), stock)
    >>> dialog.phase, dialog.topic, [each.act for each in do[:2]]
    ('waiting', 'alice', ['greeting', 'suggestion'])
    >>> dialog, do = step(dialog, Heard(Meaning("no")), stock)
    >>> dialog.topic, dialog.refused, do[0].act
    ('hatter', ('alice',), 'another')
    >>> step(dialog, Heard(Meaning("yes")), stock)[1]
    (Tell(character='hatter'),)
    """
    if dialog.phase in ("farewell", "over"):
        return dialog._replace(phase="over"), ()
    if isinstance(event, Ended):
        return _farewell(dialog) if event.politely else (dialog._replace(phase="over"), ())
    if isinstance(event, Began):
        return _begun(dialog, event, stock)
    if isinstance(event, Told):
        return _told(dialog, stock)
    if isinstance(event, Silence):
        return _silent(dialog, stock)
    return _answered(dialog, event.meaning, stock)


def _begun(dialog: Dialog, event: Began, stock: Stock) -> Step:
    act = "greeting"
    if event.name:
        act = "greeting_again" if event.known else "greeting_named"
    return _suggest(dialog._replace(named=bool(event.name)), stock, (Say(act),))


def _suggest(
    dialog: Dialog, stock: Stock, first: tuple[Do, ...] = (), act: str = "suggestion"
) -> Step:
    """Suggest whoever has something new to be told of and was not refused; else take leave."""
    able = [key for key in stock.order if key not in dialog.refused]
    if not able:
        return _farewell(dialog, (*first, Say("none_wanted" if stock.order else "all_told")))
    waiting = dialog._replace(phase="waiting", topic=able[0], silences=0)
    return waiting, (*first, Say(act, able[0]), Listen())


def _farewell(dialog: Dialog, first: tuple[Do, ...] = ()) -> Step:
    act = "farewell_named" if dialog.named else "farewell"
    return dialog._replace(phase="farewell"), (*first, Say(act))


def _told(dialog: Dialog, stock: Stock) -> Step:
    """Go on while there is something new about the character; then suggest another."""
    if stock.left.get(dialog.topic):
        return dialog, (Tell(dialog.topic),)
    return _suggest(dialog, stock, (Say("exhausted", dialog.topic),))


def _silent(dialog: Dialog, stock: Stock) -> Step:
    """Ask again once, then begin: silence is no refusal. Nobody there for long: take leave."""
    if dialog.phase == "paused":
        return dialog, (Listen(patient=True),)
    if dialog.silences == 0:
        return dialog._replace(silences=1), (Say("asked_again", dialog.topic), Listen())
    unanswered = dialog.unanswered + 1
    if unanswered >= MOST_UNANSWERED:
        return _farewell(dialog)
    telling = dialog._replace(phase="telling", silences=0, unanswered=unanswered)
    return telling, (Say("silence", dialog.topic), Tell(dialog.topic))


def _answered(dialog: Dialog, meaning: Meaning, stock: Stock) -> Step:
    there = dialog._replace(unanswered=0)
    sense = meaning.sense
    if sense == "quit":
        return _farewell(there)
    if sense == "name":
        return _named(there, meaning.name, stock)
    if dialog.phase == "paused":
        return _resumed(there, sense, stock)
    if sense == "pause":
        paused = there._replace(phase="paused", before=dialog.phase)
        return paused, (Say("pause"), Listen(patient=True))
    if dialog.phase == "telling":
        return _while_telling(there, meaning, stock)
    return _while_waiting(there, meaning, stock)


def _named(dialog: Dialog, name: str, stock: Stock) -> Step:
    if stock.left.get(name):
        kept = tuple(key for key in dialog.refused if key != name)
        return dialog._replace(phase="telling", topic=name, refused=kept), (Tell(name),)
    return _suggest(dialog, stock, (Say("told_already", name),))


def _resumed(dialog: Dialog, sense: str, stock: Stock) -> Step:
    """Go on after a pause; whatever is understood ends it, the key that began it, too."""
    if sense in ("unclear", "unknown_name"):
        return dialog, (Listen(patient=True),)
    if sense == "no" or dialog.before != "telling":
        return _suggest(dialog, stock, (Say("resume"),))
    return dialog._replace(phase="telling"), (Say("resume"), Tell(dialog.topic))


def _while_waiting(dialog: Dialog, meaning: Meaning, stock: Stock) -> Step:
    sense = meaning.sense
    if sense in ("yes", "resume"):
        return dialog._replace(phase="telling"), (Tell(dialog.topic),)
    if sense == "no":
        refused = dialog._replace(refused=(*dialog.refused, dialog.topic))
        return _suggest(refused, stock, act="another")
    if sense == "who":
        return dialog, (ShowNames(), Listen())
    if sense == "unknown_name":
        return dialog, (Say("unknown_name", heard=meaning.name), Listen())
    return dialog, (Say("not_understood"), Listen())


def _while_telling(dialog: Dialog, meaning: Meaning, stock: Stock) -> Step:
    """Take what is said in the middle of telling; what is no wish changes nothing."""
    if meaning.sense == "no":
        refused = dialog._replace(refused=(*dialog.refused, dialog.topic))
        return _suggest(refused, stock, act="another")
    names: tuple[Do, ...] = (ShowNames(),) if meaning.sense == "who" else ()
    return _with_first(names, _told(dialog, stock))


def _with_first(first: tuple[Do, ...], then: Step) -> Step:
    return then[0], (*first, *then[1])


def order(
    left: Mapping[str, int], mentioned: Sequence[str], default: Sequence[str]
) -> tuple[str, ...]:
    """Return who is to be suggested, first those mentioned lately; none without new facts.

    `mentioned` are ids, the latest first, `default` all ids in the order that holds otherwise.

    >>> order({"alice": 3, "dinah": 2, "hatter": 1}, ("dinah", "nobody"), ("alice", "hatter", "dinah"))
    ('dinah', 'alice', 'hatter')
    """  # noqa: E501
    return tuple(key for key in dict.fromkeys([*mentioned, *default]) if left.get(key))
