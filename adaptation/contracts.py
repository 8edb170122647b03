"""What every listener and every learner promises, as checks that users can run on their own.

>>> from adaptation.learners import LEARNERS
>>> from adaptation.listeners import listener
>>> check_listener(listener("live")) + check_learner(LEARNERS["q-learning"])
[]
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator
from typing import Any, cast

import numpy as np

from adaptation.experiment import Revealed, is_live
from adaptation.learners.base import Learner
from adaptation.listeners.base import Listener, LiveListener
from adaptation.listeners.live import Live
from adaptation.problem import (
    ACTIONS,
    HIGHEST,
    LEVELS,
    LOWEST,
    SAMPLE_SECONDS,
    Choice,
    Context,
    Floats,
    Ints,
    Outcome,
    moved,
)
from personage_lite.errors import PersonageError

_TRIALS, _STEPS = 40, 30


def check_listener(listener: Listener | LiveListener) -> list[str]:
    """Return how a listener breaks its contract; an empty list if it does not.

    It is tried with all X and preferences: E must be numbers from -2 to 2 of the right shape, the
    same for the same arguments, the same alone as in a batch, and no argument may be changed.
    """
    name = getattr(listener, "name", None)
    if not isinstance(name, str):
        return [f'{type(listener).__name__} has no name; give it `name = "…"`']
    try:
        return [f"{name}: {fault}" for fault in _listener_faults(listener)]
    except Exception as error:  # whatever a user's listener raises is its fault
        return [f"{name}: {type(error).__name__}: {error}"]


def _listener_faults(listener: Listener | LiveListener) -> Iterator[str]:
    random = np.random.default_rng(0)
    trials = len(LEVELS) ** 3
    x, before, preference = (part.ravel() for part in np.meshgrid(LEVELS, LEVELS, LEVELS))
    engagement = listener.start(trials)
    yield from _engagement_faults("start", engagement, trials)
    if is_live(listener):
        yield from _live_faults(cast("LiveListener", listener), engagement, x, preference)
        return
    listener = cast("Listener", listener)
    for _ in range(_STEPS):
        draws = random.random((listener.draws, trials))
        given = (engagement, x, before, preference, draws)
        kept: list[Any] = [part.copy() for part in given]
        after = listener.respond(*given)
        if any((part != copy).any() for part, copy in zip(given, kept, strict=True)):
            yield "respond changes its arguments; make new arrays"
            return
        faults = list(_engagement_faults("respond", after, trials))
        yield from faults
        if faults:
            return
        if (listener.respond(*kept) != after).any():
            yield "respond does not return the same for the same arguments; use `draws` for chance"
            return
        parts: list[Any] = [[part[..., i : i + 1] for part in kept] for i in range(trials)]
        single = [listener.respond(*part)[0] for part in parts]
        if (np.array(single) != after).any():
            yield "respond gives a trial another E in a batch than alone; keep trials apart"
            return
        engagement = after


def _live_faults(
    listener: LiveListener, engagement: Floats, x: Ints, preference: Ints
) -> Iterator[str]:
    trials = len(x)
    kept: list[Any] = [part.copy() for part in (engagement, x, preference)]
    path, samples = listener.listen(engagement, x, preference)
    if any((p != k).any() for p, k in zip((engagement, x, preference), kept, strict=True)):
        yield "listen changes its arguments; make new arrays"
    if path.shape != (listener.longest, trials):
        yield f"listen: a path of shape {path.shape}; give {(listener.longest, trials)}"
        return
    if samples.shape != (trials,) or samples.min() < 1 or samples.max() > listener.longest:
        yield f"listen: samples must be {trials} whole numbers from 1 to {listener.longest}"
        return
    within = np.arange(listener.longest)[:, None] < samples
    if not (np.abs(path[within]) <= HIGHEST).all():
        yield f"listen: E is not always a number from {LOWEST} to {HIGHEST}"
    again = listener.listen(*kept)
    if (again.path[within] != path[within]).any() or (again.samples != samples).any():
        yield "listen does not return the same for the same arguments"


def _engagement_faults(where: str, engagement: Floats, trials: int) -> Iterator[str]:
    if engagement.shape != (trials,):
        yield f"{where}: E of shape {engagement.shape}; give {(trials,)}"
    elif not (np.abs(engagement) <= HIGHEST).all():
        yield f"{where}: E is not always a number from {LOWEST} to {HIGHEST}"


def check_learner(make: Callable[[int], Learner]) -> list[str]:
    """Return how a learner breaks its contract; an empty list if it does not.

    `make` returns a learner for a number of trials. The same draws must give the same choices;
    actions are -1, 0 or 1, with probabilities above 0 and up to 1; what is saved survives JSON
    and goes on identically; a batch chooses as its trials alone would; rewards that are NaN or
    infinite are refused and nothing is learned from them. Rewards are tried whole and real, with
    a stream and without.
    """
    try:
        name = make(1).name
    except Exception as error:  # whatever a user's learner raises is its fault
        return [f"{type(error).__name__}: {error}"]
    faults = []
    for live in (False, True):
        kind = "in real time" if live else "in steps"
        try:
            faults += [f"{name}, {kind}: {fault}" for fault in _learner_faults(make, live)]
        except Exception as error:  # as above
            faults.append(f"{name}, {kind}: {type(error).__name__}: {error}")
    return faults


def _learner_faults(make: Callable[[int], Learner], live: bool) -> Iterator[str]:
    draws = make(1).draws
    numbers = np.random.default_rng(1)
    chances = numbers.random((_STEPS, draws, _TRIALS))
    whole = _Talk(make(_TRIALS), live, np.arange(_TRIALS))
    choices = [whole.step(step, chances[step]) for step in range(_STEPS)]
    for choice in choices:
        if not np.isin(choice.action, ACTIONS).all():
            yield "an action is not -1, 0 or 1"
            return
        if not ((choice.probability > 0) & (choice.probability <= 1)).all():
            yield "a probability is not above 0 and up to 1"
            return
    again = _Talk(make(_TRIALS), live, np.arange(_TRIALS))
    for step, choice in enumerate(choices):
        if step == _STEPS // 2:
            saved = json.loads(json.dumps(again.learner.save(), allow_nan=False))
            restored = _Talk(type(again.learner).restore(saved), live, np.arange(_TRIALS), again)
        same = again.step(step, chances[step])
        if _differ(choice, same):
            yield "the same draws do not give the same choices; take all chance from `draws`"
            return
        if step >= _STEPS // 2 and _differ(choice, restored.step(step, chances[step])):
            yield "a restored learner does not go on as the saved one"
            return
    for trial in (0, _TRIALS - 1):
        single = _Talk(make(1), live, np.array([trial]))
        for step, choice in enumerate(choices):
            alone = single.step(step, chances[step][:, trial : trial + 1])
            if alone.action[0] != choice.action[trial]:
                yield "a trial goes otherwise in a batch than alone; keep trials apart"
                return
    yield from _not_refused(make(_TRIALS))


def _not_refused(learner: Learner) -> Iterator[str]:
    zero, still = np.zeros(_TRIALS), np.zeros(_TRIALS, dtype=np.int64)
    context = Context(0, still, zero)
    if isinstance(learner, Revealed):
        learner.reveal(still)
    choice = learner.choose(context, np.full((learner.draws, _TRIALS), 0.5))
    x = moved(still, choice.action)
    before = learner.save()
    for bad in (math.nan, math.inf, -math.inf):
        reward = zero.copy()
        reward[3] = bad
        try:
            learner.learn(context, choice, Outcome(reward, x, zero))
        except PersonageError:
            if learner.save() != before:
                yield f"a reward of {bad} is refused, but changes what was learned"
        else:
            yield f"a reward of {bad} is learned from; refuse it with a PersonageError"


def _differ(one: Choice, other: Choice) -> bool:
    return bool((one.action != other.action).any() or (one.probability != other.probability).any())


class _Talk:
    """A learner and what answers it: trial number i always the same, whatever the batch."""

    def __init__(
        self, learner: Learner, live: bool, trials: Ints, after: _Talk | None = None
    ) -> None:
        self.learner = learner
        self._trials = trials
        self._listener = Live() if live else None
        self._x: Ints = after._x if after else np.zeros(len(trials), dtype=np.int64)
        self._sensed: Floats = after._sensed if after else np.zeros(len(trials))

    def step(self, step: int, chances: Floats) -> Choice:
        if isinstance(self.learner, Revealed):
            self.learner.reveal(self._preference())
        context = Context(step, self._x, self._sensed)
        choice = self.learner.choose(context, chances)
        x = moved(self._x, np.asarray(choice.action).clip(-1, 1))
        outcome = self._heard(step, x)
        self.learner.learn(context, choice, outcome)
        self._x, self._sensed = x, outcome.engagement
        return choice

    def _preference(self) -> Ints:
        return self._trials % len(LEVELS) + LOWEST

    def _heard(self, step: int, x: Ints) -> Outcome:
        # Something like noise that hangs on trial and step alone.
        error = ((self._trials * 7 + step * 3) % 5 - 2) / 4
        if self._listener is None:
            change = np.where(x == self._preference(), 1.0, -1.0) + np.rint(error)
            sensed: Floats = np.clip(self._sensed + change, LOWEST, HIGHEST)
            return Outcome(sensed - self._sensed + 0.5 * (sensed == self._sensed), x, sensed)
        path, samples = self._listener.listen(self._sensed, x, self._preference())
        stream: Any = (path + error).T
        stream[np.arange(self._listener.longest) >= samples[:, None]] = math.nan
        sensed = np.clip(np.nanmean(stream, axis=1), LOWEST, HIGHEST)
        return Outcome(
            sensed - self._sensed, x, sensed, stream, (samples * SAMPLE_SECONDS).astype(np.float64)
        )
