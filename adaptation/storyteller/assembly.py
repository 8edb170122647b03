"""Puts a session together from what the command line asks for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from typing import Any

from adaptation.engagement.estimator import EngagementEstimator
from adaptation.engagement.network import load_network
from adaptation.learners import LEARNERS
from adaptation.listeners import listener
from adaptation.sensing import SENSORS, Setup
from adaptation.sensing.cues import Sensor
from adaptation.sensing.keyboard import Keyboard
from adaptation.sensing.session import Watch
from adaptation.sensing.supervisor import Supervisor
from adaptation.storyteller.answers import ANSWER_KEYS, Typed
from adaptation.storyteller.audience import Agreeable, Audience
from adaptation.storyteller.clocks import SimulatedClock, SystemClock
from adaptation.storyteller.driver import Storyteller
from adaptation.storyteller.kept_logs import KeptLog
from adaptation.storyteller.learning import TalkLearner
from adaptation.storyteller.pace import TextSpeaker, Voice
from adaptation.storyteller.parts import Parts, Settings, Summary
from adaptation.storyteller.protocols import Clock, Ear, Memory, Speaker
from adaptation.storyteller.remarks import Remarks
from adaptation.storyteller.screen import Screen
from adaptation.storyteller.senses import Senses
from adaptation.storyteller.session_log import KIND, VERSION, NoLog, SessionLog
from adaptation.storyteller.signals import interruptible
from adaptation.storyteller.stock import Stories
from adaptation.storyteller.ticking import Ticker
from adaptation.storyteller.understanding import Understanding, names_of
from personage_lite import __version__
from personage_lite.errors import PersonageError
from personage_lite.facts import Character
from personage_lite.generator import Generator
from personage_lite.randomness import Draws
from personage_lite.state import ConversationState


@dataclass
class Options:
    """What can be asked for; see `personage-lite live --help`.

    `speed` 0 is at once for a person; with a simulated listener time itself is simulated.
    `tastes`: what the simulated listener likes, the first one and one for each change.
    """

    seed: int = 0
    learner: str = "bayes"
    sensors: Sequence[tuple[str, str | None]] = ()
    listener: str | None = None
    changes: Sequence[int] = ()
    tastes: Sequence[int] = ()
    name: str = ""
    speed: float = 1.0
    turns: int | None = None
    characters: Sequence[str] = ()
    settings: dict[str, Any] = field(default_factory=dict)


@dataclass
class Outside:
    """What a session needs from outside.

    `screen` is made when what has been typed is known; `typed` is the descriptor of typed
    answers and whether it gives every key at once; `voice` and `hears` are made with the clock.
    `clock` is for another one than the options ask for.
    """

    screen: Callable[[Callable[[], str]], Screen]
    typed: tuple[int, bool]
    wall: Callable[[], float]
    say: Callable[[str], None]
    log: SessionLog | KeptLog | NoLog = field(default_factory=NoLog)
    memory: Memory | None = None
    voice: Callable[[Clock, Speaker], Voice] | None = None
    hears: Callable[[Clock, Ear], Ear] | None = None
    clock: Clock | None = None


class _Hooks:
    """What the clock calls; filled in when the parts are there."""

    def __init__(self) -> None:
        self.senses: Senses | None = None
        self.frames: list[Callable[[], None]] = []

    def tick(self, now: float) -> None:
        if self.senses is not None:
            self.senses.tick(now)

    def frame(self) -> None:
        for each in self.frames:
            each()


def run_session(generator: Generator, options: Options, outside: Outside) -> Summary:
    """Run one session; everything that was taken hold of is given back, whatever happens.

    Raises `PersonageError` for what cannot be: unknown names, a sensor that does not start.
    """
    characters = chosen(generator, options.characters)
    hooks = _Hooks()
    clock = Ticker(outside.clock or _clock(options), hooks.tick, hooks.frame)
    understanding = Understanding(generator.dialog.heard, names_of(characters))
    typed = _typed(outside, clock, generator)
    with ExitStack() as stack:
        screen = outside.screen(lambda: typed.line)
        typed.follow(screen)
        audience = _audience(options, clock)
        senses = Senses(_watch(options, outside, clock, typed, audience), EngagementEstimator(
            load_network(None)
        ))  # fmt: skip
        hooks.senses = senses
        state, talk, known = _acquainted(options, outside)
        voice = None
        if outside.voice is not None:
            voice = outside.voice(clock, TextSpeaker(screen, clock, _text_speed(options)))
        speaker = TextSpeaker(screen, clock, _text_speed(options), voice)
        stack.callback(speaker.close)
        ear = _ear(options, outside, clock, typed, generator)
        stack.callback(ear.close)
        parts = Parts(
            generator=generator,
            stories=Stories(characters, Draws(options.seed, 0).uniform("opening")),
            understanding=understanding,
            talk=talk,
            senses=senses,
            clock=clock,
            speaker=speaker,
            ear=ear,
            screen=screen,
            log=outside.log,
            memory=outside.memory,
            audience=audience,
            remarks=Remarks(generator.dialog.remarks),
            seconds=speaker.seconds,
        )
        settings = Settings(
            options.seed, options.turns, options.name, known, wall=outside.wall,
            breath=0.0 if _text_speed(options) == 0 else 0.4,
        )  # fmt: skip
        teller = Storyteller(parts, settings, state)
        stack.callback(senses.stop)
        senses.start()
        outside.log.write("header", **header(options, state, talk, outside, characters))
        check = stack.enter_context(interruptible(screen))
        stack.callback(screen.close)
        screen.start()
        hooks.frames += [check, screen.refresh, teller.frame]
        return teller.run()


def chosen(generator: Generator, names: Sequence[str]) -> list[Character]:
    """Return the characters of these names, all if none are named."""
    if not names:
        return generator.characters()
    found = {generator.character(name).entity.id: generator.character(name) for name in names}
    return list(found.values())


def header(
    options: Options,
    state: ConversationState,
    talk: TalkLearner,
    outside: Outside,
    characters: Sequence[Character],
) -> dict[str, Any]:
    """Return the first line of a session's log: all that is needed to run it again."""
    return {
        "log": KIND,
        "version": VERSION,
        "personage_lite": __version__,
        "when": outside.wall(),
        "name": options.name,
        "seed": options.seed,
        "x": talk.x,
        "learner": talk.learner.save(),
        "sensors": [name for name, _ in options.sensors],
        "listener": options.listener,
        "characters": [character.entity.id for character in characters],
        "told": {key: dict(counts) for key, counts in state.told.items()},
        "settings": {"speed": options.speed, "turns": options.turns, **options.settings},
    }


def _clock(options: Options) -> Clock:
    if options.listener is None:
        return SystemClock()
    return SystemClock(options.speed) if options.speed else SimulatedClock()


def _text_speed(options: Options) -> float:
    """Return how many times as fast text appears, by the session's own clock."""
    return options.speed if options.listener is None else 1.0


def _typed(outside: Outside, clock: Clock, generator: Generator) -> Typed:
    descriptor, keys = outside.typed
    words = {sense: generator.dialog.heard[sense][0] for sense in ANSWER_KEYS.values()}
    return Typed(descriptor, clock, words, keys=keys)


def _ear(
    options: Options, outside: Outside, clock: Clock, typed: Typed, generator: Generator
) -> Ear:
    if options.listener is not None:
        return Agreeable(clock, generator.dialog.heard["yes"][0], typed)
    return typed if outside.hears is None else outside.hears(clock, typed)


def _audience(options: Options, clock: Ticker) -> Audience | None:
    if options.listener is None:
        return None
    return Audience(
        listener(options.listener),
        lambda: clock.at,
        seed=options.seed,
        changes=options.changes,
        tastes=options.tastes,
    )


def _watch(
    options: Options, outside: Outside, clock: Ticker, typed: Typed, audience: Audience | None
) -> Watch | None:
    """Return the sensors, each with its supervisor; None for none."""
    if audience is not None:
        return Watch([Supervisor(lambda: audience, lambda: clock.at)])
    supervisors = []
    for name, given in options.sensors:
        make: Callable[[], Sensor]
        if name == "keyboard":
            make = _keyboard(typed, clock)
        else:
            kind = SENSORS[name]
            setup = Setup(lambda: clock.at, given, options.seed, outside.say)
            make = _maker(kind, setup)
        supervisors.append(Supervisor(make, lambda: clock.at))
    return Watch(supervisors) if supervisors else None


def _keyboard(typed: Typed, clock: Ticker) -> Callable[[], Sensor]:
    return lambda: Keyboard(typed, lambda: clock.at)


def _maker(kind: Callable[[Setup], Sensor], setup: Setup) -> Callable[[], Sensor]:
    """Return what makes a sensor anew; the first one is made at once, so that faults show."""
    made = [kind(setup)]
    return lambda: made.pop() if made else kind(setup)


def _acquainted(options: Options, outside: Outside) -> tuple[ConversationState, TalkLearner, bool]:
    """Return what is known of the listener: what they were told, a learner, whether they are known.

    Of a stranger nothing is; X begins at 0.
    """
    fresh = LEARNERS[options.learner](1)
    if fresh.name == "oracle" and options.listener is None:
        raise PersonageError("the oracle is told what a simulated listener likes; add --listener")
    if outside.memory is None or not options.name:
        return ConversationState(), TalkLearner(fresh, 0, options.seed), False
    from adaptation.memory.resuming import conversation, resumed

    when = outside.wall()
    known = outside.memory.begin(options.name, when)
    going_on = resumed(known, fresh, when)
    if going_on.note:
        outside.say(going_on.note)
    # As it was first given, whatever the case it is typed in now.
    options.name = known.name
    talk = TalkLearner(going_on.learner, going_on.x, options.seed)
    return conversation(known), talk, known.episodes > 1
