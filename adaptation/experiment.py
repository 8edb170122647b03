"""The experiment of the paper, section III-B: a learner talks to simulated listeners.

As published: 30 trials of 30 utterances; X starts at 0, the preference is drawn at random, and
anew before the utterances 15 and 26; the same seed for each noise level. Trials run side by side,
in blocks, so that any number of them fits into memory.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol, cast, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from adaptation.draws import Draws
from adaptation.learners.base import Learner
from adaptation.listeners.base import Listener, LiveListener
from adaptation.live_world import WINDOW, LiveWorld, Sensor
from adaptation.problem import Context, Floats, Ints, moved
from adaptation.schedule import PUBLISHED_CHANGES, drawn_levels, preferences
from adaptation.tally import Result, Tally
from adaptation.world import Coins, Noise, StepWorld, World
from personage_lite.errors import PersonageError, shown

# The noise levels of the paper's figure 2.
PUBLISHED_NOISE = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
# How many trials run side by side: as many as the processor's cache holds.
BLOCK, LIVE_BLOCK = 4096, 512
# With more steps than these fewer trials run side by side, so that memory suffices.
BLOCK_STEPS, MOST_STEPS = 100, 100_000
# Called now and then with the share of the work that is done, from 0 to 1.
Progress = Callable[[float], None]


@runtime_checkable
class Revealed(Protocol):
    """A learner that is told the truth: only the oracle is."""

    def reveal(self, preference: Ints) -> None:
        """Take note of the preference in each trial, before the choice of X."""


class Block(NamedTuple):
    """What came of some trials, step by step; each of shape (steps, trials)."""

    reward: Floats
    match: NDArray[np.bool_]
    engagement: Floats
    x: NDArray[np.int8]


@dataclass(frozen=True)
class Experiment:
    """The protocol: its defaults are the published one.

    `changes` are the numbers of the utterances (the first is 1) before which the preference is
    drawn anew. `listener_noise` and `sensor_noise` are the probabilities of the two coins (see
    world.py). `sensor` is used with listeners in real time only.

    Raises `PersonageError` for what cannot be.

    >>> from adaptation.learners import LEARNERS
    >>> from adaptation.listeners import listener
    >>> result = Experiment(listener("match"), trials=10_000).run(LEARNERS["always-zero"])
    >>> result.mean("reward")
    Estimate(value=0.385, ci95=0.001)
    """

    listener: Listener | LiveListener
    trials: int = 30
    steps: int = 30
    seed: int = 0
    listener_noise: float = 0.0
    sensor_noise: float = 0.0
    changes: tuple[int, ...] = PUBLISHED_CHANGES
    floor_bonus: bool = True
    sensor: Sensor = field(default_factory=Sensor)

    def __post_init__(self) -> None:
        for name, lowest, highest in (
            ("trials", 1, None),
            ("steps", 1, MOST_STEPS),
            ("seed", 0, None),
        ):
            value = getattr(self, name)
            whole = isinstance(value, int) and not isinstance(value, bool)
            if not whole or value < lowest or (highest and value > highest):
                bounds = f"from {lowest} to {highest}" if highest else f"from {lowest} up"
                fault = f"{name}: {shown(str(value))}; give a whole number {bounds}"
                raise PersonageError(fault)
        for name in ("listener_noise", "sensor_noise"):
            value = getattr(self, name)
            if not (isinstance(value, int | float) and 0 <= value <= 1):
                plain = name.replace("_", " ")
                raise PersonageError(f"{plain}: {shown(str(value))}; give a number from 0 to 1")
        if list(self.changes) != sorted({change for change in self.changes if change > 1}):
            given = shown(", ".join(map(str, self.changes)))
            raise PersonageError(
                f"changes: {given}; give numbers of utterances, from 2, in rising order"
            )

    def run(self, learner: Callable[[int], Learner], progress: Progress | None = None) -> Result:
        """Return the means of all trials; `learner` makes a learner for a number of trials."""
        tally = Tally(self.steps)
        for block in self.blocks(learner, progress):
            tally.add(reward=block.reward, match=block.match, engagement=block.engagement)
        return tally.result()

    def blocks(
        self, learner: Callable[[int], Learner], progress: Progress | None = None
    ) -> Iterator[Block]:
        """Run the trials; yield what came of them, block by block."""
        draws = Draws(self.seed)
        largest = LIVE_BLOCK if is_live(self.listener) else BLOCK
        size = max(1, min(largest, largest * BLOCK_STEPS // self.steps))
        count = -(-self.trials // size)
        for number in range(count):
            trials = min(size, self.trials - number * size)

            def report(share: float, number: int = number) -> None:
                if progress:
                    progress((number + share) / count)

            yield self._block(learner(trials), trials, draws, report)

    def _block(self, learner: Learner, trials: int, draws: Draws, progress: Progress) -> Block:
        preference = self.preference(trials, draws)
        chances = draws.uniform("learner", trials, self.steps, learner.draws)
        world = self.world(trials, draws)
        x: Ints = np.zeros(trials, dtype=np.int64)
        shape = (self.steps, trials)
        block = Block(
            np.empty(shape), np.empty(shape, bool), np.empty(shape), np.empty(shape, np.int8)
        )
        reveal = learner.reveal if isinstance(learner, Revealed) else None
        for step in range(self.steps):
            if reveal:
                reveal(preference[step])
            context = Context(step, x, world.sensed)
            choice = learner.choose(context, chances[step])
            x = moved(x, choice.action)
            outcome = world.hear(step, x, preference[step])
            learner.learn(context, choice, outcome)
            block.reward[step] = outcome.reward
            block.match[step] = x == preference[step]
            block.engagement[step] = world.engagement
            block.x[step] = x
            progress((step + 1) / self.steps)
        return block

    def preference(self, trials: int, draws: Draws) -> Ints:
        """Return what the next trials' listeners prefer, shape (steps, trials)."""
        count = drawn_levels(self.changes, self.steps)
        levels = draws.uniform("preference", trials, count, 1)
        return preferences(levels[:, 0], self.steps, self.changes)

    def world(self, trials: int, draws: Draws) -> World:
        """Return the next trials' listeners with their noise and sensors."""
        steps = self.steps
        coins = Coins(
            draws.uniform("listener", trials, steps, 2) if self.listener_noise else None,
            draws.uniform("sensor", trials, steps, 2) if self.sensor_noise else None,
        )
        noise = Noise(self.listener_noise, self.sensor_noise)
        if is_live(self.listener):
            live = cast("LiveListener", self.listener)
            fresh = draws.normal("stream", trials, WINDOW + steps * live.longest)
            return LiveWorld(live, trials, noise, coins, fresh, self.sensor, self.floor_bonus)
        listener = cast("Listener", self.listener)
        responses = draws.uniform("response", trials, steps, listener.draws)
        return StepWorld(listener, trials, noise, coins, responses, self.floor_bonus)


def is_live(listener: Listener | LiveListener) -> bool:
    """Whether a listener answers while the utterance lasts."""
    return hasattr(listener, "listen")
