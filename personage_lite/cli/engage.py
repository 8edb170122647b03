"""`engage`: watches a listener and shows how engaged they seem."""

from __future__ import annotations

import argparse
import os
import signal
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, TextIO

from personage_lite.cli.generate import whole_number
from personage_lite.errors import PersonageError, shown

if TYPE_CHECKING:
    from adaptation.engagement.estimator import EngagementEstimator
    from adaptation.sensing.cues import Sensor
    from adaptation.sensing.session import Recorder, Ticks, Watch
    from adaptation.sensing.view import Lines, Records, View

HELP = "watch a listener: social cues, and the engagement E that they speak of"
EXAMPLE = "personage-lite engage --sensor camera --record session.jsonl"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = command.add_argument
    add(
        "--sensor",
        action="append",
        required=True,
        metavar="NAME",
        help="camera, microphone, replay, stream, keyboard or simulated; can be repeated",
    )
    add(
        "--input",
        action="append",
        metavar="INPUT",
        help="a device's number, a file, an address (stream; - is standard input), or a listener "
        "(simulated); with several sensors one for each, in their order",
    )
    add("--network", metavar="FILE", help="your own network (default: the one that ships)")
    add("--record", metavar="FILE", help="write the cues as messages, one a line, for replay")
    add("--speed", default="1", metavar="N", help="how many times as fast files run (default 1)")
    add("--seconds", metavar="N", help="stop after so many seconds of the session")
    add("--seed", default="0", help="decides about the simulated listener's chance (default 0)")
    add("--format", choices=("text", "json"), default="text", help="a view, or JSON lines")
    add("--plain", action="store_true", help="lines instead of a view, also on a terminal")


def run(arguments: argparse.Namespace) -> None:
    """Watch until the source ends, the time is up, or someone presses Ctrl-C."""
    try:
        import numpy  # noqa: F401 - what all of it needs
    except ModuleNotFoundError:
        raise PersonageError(
            "engage needs numpy; pip install 'personage-lite[adaptation]'"
        ) from None
    from adaptation.engagement.estimator import EngagementEstimator
    from adaptation.engagement.network import load_network
    from adaptation.sensing.session import Recorder, Ticks

    speed = _number(arguments.speed, "--speed")
    seconds = None if arguments.seconds is None else _number(arguments.seconds, "--seconds")
    estimator = EngagementEstimator(load_network(arguments.network))
    ticks = Ticks(time.monotonic, time.sleep, speed=speed, seconds=seconds)
    with own_stderr() as say:
        watch = _watch(arguments, ticks, speed, say)
        # The record is opened last: a wrong option must leave no file behind.
        recorder = None if arguments.record is None else Recorder(arguments.record)
        try:
            with _ended_by_signals():
                _session(arguments, ticks, watch, estimator, recorder)
        finally:
            if recorder is not None:
                recorder.close()
        _account(watch, estimator, say)


def _session(
    arguments: argparse.Namespace,
    ticks: Ticks,
    watch: Watch,
    estimator: EngagementEstimator,
    recorder: Recorder | None,
) -> None:
    """Read, record, estimate and show, tick by tick."""
    view = None
    try:
        watch.start()
        view = _view(arguments)
        for now in ticks:
            reading = watch.read(now)
            if watch.ended:
                break
            if recorder is not None:
                recorder.write(reading)
            view.show(reading, estimator.update(reading), watch.fault)
    except KeyboardInterrupt:
        # To press Ctrl-C is how one ends a session, not a fault.
        pass
    finally:
        watch.stop()
        if view is not None:
            view.close()


def _watch(
    arguments: argparse.Namespace, ticks: Ticks, speed: float, say: Callable[[str], None]
) -> Watch:
    """Return the sensors asked for, each with its supervisor."""
    from adaptation.sensing import SENSORS, Setup
    from adaptation.sensing.session import Watch
    from adaptation.sensing.supervisor import Supervisor

    inputs: list[str | None] = list(arguments.input or ())
    names: list[str] = arguments.sensor
    if len(inputs) > len(names):
        raise PersonageError(f"--input is given {len(inputs)} times; give one for each --sensor")
    inputs += [None] * (len(names) - len(inputs))
    seed = whole_number(arguments.seed, "--seed", 0)
    supervisors = []
    for name, given in zip(names, inputs, strict=True):
        setup = Setup(lambda: ticks.now, given, seed, say)
        make = _maker(SENSORS[name], setup)
        if speed != 1 and getattr(make(), "live", True):
            raise PersonageError(f"{name} lives in real time; drop --speed {speed:g}")
        supervisors.append(Supervisor(make, lambda: ticks.now))
    return Watch(supervisors)


def _maker(kind: Callable[..., Sensor], setup: object) -> Callable[[], Sensor]:
    """Return what makes a sensor anew; the first one is made at once, so that faults show."""
    made = [kind(setup)]
    return lambda: made.pop() if made else kind(setup)


def _view(arguments: argparse.Namespace) -> View | Lines | Records:
    from adaptation.sensing.view import Lines, Records, View

    if arguments.format == "json":
        return Records(sys.stdout)
    if arguments.plain or not sys.stdout.isatty() or os.environ.get("TERM") == "dumb":
        return Lines(sys.stdout)
    return View(sys.stdout, colour="NO_COLOR" not in os.environ)


def _account(watch: Watch, estimator: EngagementEstimator, say: Callable[[str], None]) -> None:
    """Say at the end what was not as it should be."""
    counts = watch.counts
    parts = [
        f"{counts.missing} of {counts.present + counts.missing} ticks without cues",
        f"{counts.faults} faults ({counts.stalls} stalls), {counts.restarts} restarts",
    ]
    if counts.refused:
        parts.append(f"{counts.refused} readings refused")
    parts += [f"{number} × {name}" for name, number in estimator.counts.items()]
    if counts.faults or counts.refused or counts.missing or estimator.counts:
        say("; ".join(parts) + (f"; last: {watch.fault}" if watch.fault else ""))


def _number(text: str, option: str) -> float:
    """Return an option's value as a number above 0, at most a million."""
    try:
        number = float(text)
    except ValueError:
        number = 0.0
    if not 0 < number <= 1e6:
        raise PersonageError(f"{option} is '{shown(text)}'; give a number above 0, up to 1000000")
    return number


@contextmanager
def own_stderr() -> Iterator[Callable[[str], None]]:
    """Give what says a line on stderr, and keep libraries' chatter from it.

    mediapipe and OpenCV write to stderr past Python, in the middle of the view.
    """
    try:
        kept = os.dup(2)
    except OSError:
        yield lambda _line: None
        return
    out: TextIO = os.fdopen(kept, "w", encoding="utf-8", errors="replace", buffering=1)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    before, sys.stderr = sys.stderr, out
    os.dup2(nowhere, 2)
    os.close(nowhere)

    def say(line: str) -> None:
        with suppress(OSError):
            out.write(f"personage-lite: {line}\n")

    try:
        yield say
    finally:
        os.dup2(out.fileno(), 2)
        sys.stderr = before
        out.close()


@contextmanager
def _ended_by_signals() -> Iterator[None]:
    """Let a session that is told to end do so as with Ctrl-C: terminal and record stay whole."""

    def interrupt(_number: int, _frame: object) -> None:
        raise KeyboardInterrupt

    # A shell's background job ignores Ctrl-C; what is sent to it on purpose is still heard.
    signals = [signal.SIGTERM]
    if hasattr(signal, "SIGHUP"):
        signals.append(signal.SIGHUP)
    before = {number: signal.signal(number, interrupt) for number in signals}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
