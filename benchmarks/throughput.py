"""Sentences and utterances a second: warm processes that take turns, slice by slice."""

from __future__ import annotations

import sys
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory, TemporaryFile
from typing import Any

import jvm
from realizers import MODULES, PACKAGES
from report import COMPILED, JVM, OURS, PYREALB, Rate, RealizerRate, Spread
from sentences import SENTENCES
from subjects import MIXED, XS
from workers import HERE, BenchmarkError, Worker

STYLED = (*(f"styled, X = {x}" for x in XS), MIXED)
JVM_WARM_UP_SECONDS = 10.0  # Until its just-in-time compiler is done.


@dataclass
class Realizer:
    """A realizer's process and what it says."""

    worker: Worker
    version: str
    warm_up: float = 0.0
    says: dict[str, str] = field(default_factory=dict)

    def right(self) -> list[str]:
        """Return the names of the sentences that it says word for word."""
        return [name for name, text in SENTENCES.items() if self.says.get(name) == text]

    def wrong(self) -> dict[str, str | None]:
        """Return what it says instead of the others."""
        right = self.right()
        return {name: self.says.get(name) for name in SENTENCES if name not in right}


@dataclass(eq=False)
class Subject:
    """What one slice makes: a request to a process; it keeps its answers, one a round."""

    worker: Worker
    names: tuple[str, ...] = ()
    warm_up: float = 0.0
    slices: list[dict[str, Any]] = field(default_factory=list)

    def run(self, seconds: float) -> dict[str, Any]:
        """Return the counts of one slice."""
        return self.worker.ask(" ".join((str(seconds), *self.names)))

    def per_second(self, what: str) -> list[float]:
        """Return a figure a round."""
        return [answer[what] / answer["seconds"] for answer in self.slices]


@dataclass(frozen=True)
class Measured:
    """What the turns have shown; `left_out` says why a realizer is missing."""

    throughput: dict[str, Rate]
    realizers: dict[str, RealizerRate]
    left_out: dict[str, str]


@dataclass(frozen=True)
class Plan:
    """What is measured, how often and how long."""

    rounds: int
    seconds: float
    quick: bool
    styled: bool
    jar: Path | None
    compiled: Path | None


def measure(plan: Plan) -> Measured:
    """Measure all subjects in turns; a first round warms up and is not counted."""
    with ExitStack() as stack:

        def start(*command: str, package: Path | None = None) -> Worker:
            errors = stack.enter_context(TemporaryFile("w+", encoding="utf-8"))
            worker = Worker(command, errors, package)
            stack.callback(worker.stop)
            return worker

        folder = Path(stack.enter_context(TemporaryDirectory()))
        realizers, left_out = _realizers(plan, folder, start)
        styled: dict[str, Subject] = {}
        if plan.styled:
            worker = str(HERE / "worker.py")
            for name in STYLED:
                command = (sys.executable, worker, name)
                styled[name] = Subject(start(*command))
                if plan.compiled:
                    styled[name + COMPILED] = Subject(start(*command, package=plan.compiled))
        alone, pairs = _subjects(realizers)
        turns = list(styled.values())
        for name, subject in alone.items():
            # Each peer's slice is followed by ours over the same sentences.
            turns.extend(dict.fromkeys((subject, *pairs.get(name, ()))))
        for turn in turns:
            turn.run(plan.seconds if plan.quick else max(plan.seconds, turn.warm_up))
        for _ in range(plan.rounds):
            for turn in turns:
                turn.slices.append(turn.run(plan.seconds))
        for name, realizer in realizers.items():
            if realizer.worker.ask("say") != realizer.says:
                raise BenchmarkError(f"{name} does not say afterwards what it said before")
    return Measured(_rates(styled, alone), _realizer_rates(realizers, alone, pairs), left_out)


def _realizers(
    plan: Plan, folder: Path, start: Callable[..., Worker]
) -> tuple[dict[str, Realizer], dict[str, str]]:
    """Return the realizers that are there, and why others are not."""
    realizers: dict[str, Realizer] = {}
    left_out: dict[str, str] = {}
    for name in MODULES:
        package = PACKAGES.get(name)
        if package and find_spec(package) is None:
            left_out[name] = f"{package} is missing: pip install personage-lite[benchmarks]"
        else:
            worker = start(sys.executable, str(HERE / "realizer_worker.py"), name)
            realizers[name] = Realizer(worker, _version(package or name))
    if plan.compiled:
        command = (sys.executable, str(HERE / "realizer_worker.py"), OURS)
        worker = start(*command, package=plan.compiled)
        realizers[OURS + COMPILED] = Realizer(worker, _version(OURS))
    try:
        java, found = jvm.prepare(plan.jar, folder, download=not plan.quick)
        realizers[JVM] = Realizer(start(*java), found, JVM_WARM_UP_SECONDS)
    except jvm.MissingError as error:
        left_out[JVM] = str(error)
    for name, reason in left_out.items():
        print(f"{name} is left out: {reason}", file=sys.stderr)
    for name, realizer in realizers.items():
        realizer.says = realizer.worker.ask("say")
        if not realizer.right():
            raise BenchmarkError(f"{name} says no sentence as expected: nothing was timed")
    return realizers, left_out


def _subjects(
    realizers: dict[str, Realizer],
) -> tuple[dict[str, Subject], dict[str, tuple[Subject, Subject]]]:
    """Return each realizer over all that it says, and with ours over what both say."""
    ours = realizers[OURS]
    alone, pairs = {}, {}
    for name, realizer in realizers.items():
        names = tuple(realizer.right())
        common = tuple(key for key in ours.right() if key in names)
        its = alone[name] = Subject(realizer.worker, names, realizer.warm_up)
        if name != OURS and common:
            if common != names:
                its = Subject(realizer.worker, common)
            pairs[name] = (its, Subject(ours.worker, common))
    return alone, pairs


def _rates(styled: dict[str, Subject], alone: dict[str, Subject]) -> dict[str, Rate]:
    found = {}
    for name, subject in styled.items():
        made = sum(answer["texts"] for answer in subject.slices)
        texts = subject.per_second("texts")
        found[name] = Rate(
            texts_per_second=Spread.of(texts),
            sentences_per_second=Spread.of(subject.per_second("sentences")),
            sentences_per_text=sum(answer["sentences"] for answer in subject.slices) / made,
            words_per_text=sum(answer["words"] for answer in subject.slices) / made,
            to_pyrealb=Spread.of_ratios(texts, alone[PYREALB].per_second("sentences")),
        )
    return found


def _realizer_rates(
    realizers: dict[str, Realizer],
    alone: dict[str, Subject],
    pairs: dict[str, tuple[Subject, Subject]],
) -> dict[str, RealizerRate]:
    found = {}
    pyrealb = alone[PYREALB].per_second("sentences")
    for name, realizer in realizers.items():
        rate = alone[name].per_second("sentences")
        its, ours = pairs.get(name, (None, None))
        ratio = None
        if its and ours:
            ratio = Spread.of_ratios(ours.per_second("sentences"), its.per_second("sentences"))
        found[name] = RealizerRate(
            version=realizer.version,
            says=len(alone[name].names),
            wrong=realizer.wrong(),
            sentences_per_second=Spread.of(rate),
            to_pyrealb=Spread.of_ratios(rate, pyrealb),
            common=len(its.names) if its else 0,
            ours_to_it=ratio,
        )
    return found


def _version(package: str) -> str:
    if package == OURS:
        from personage_lite import __version__

        return __version__
    try:
        return version(package)
    except PackageNotFoundError:
        return ""
