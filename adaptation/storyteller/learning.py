"""The learner of one live talk: a batch of one, its draws made turn by turn.

Source: the paper, sections III-A and IV-A (X = 0 at first; the reward is ΔE over an utterance).
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from adaptation.experiment import Revealed
from adaptation.learners.base import Learner
from adaptation.learners.bayes import Bayes
from adaptation.problem import (
    HIGHEST,
    LOWEST,
    SAMPLE_SECONDS,
    Choice,
    Context,
    Floats,
    Outcome,
    moved,
)
from adaptation.storyteller.senses import Sensed
from adaptation.world import rewarded
from personage_lite.randomness import Draws

# Log-odds of being engaged for one level of E: so the levels -1 … 1 of simulated listeners, whose
# cues the network reads, are about one apart. No probability is taken to be nearer to 0 or 1.
STEEPNESS, LEAST = 1.2, 0.01


class Move(NamedTuple):
    """How X moved before an utterance: the action, its probability, and the X that came of it.

    `learned` is false for the first X of a talk, which nobody chose.
    """

    context: Context
    action: int
    probability: float
    x: int
    learned: bool


class TalkLearner:
    """Chooses X before each utterance and learns after it.

    The first utterance is said at `x`: 0 with a stranger; with somebody known what pleased last.
    The numbers that a learner chooses with hang on `seed` and the step alone.
    """

    def __init__(self, learner: Learner, x: int, seed: int) -> None:
        self.learner = learner
        self.x = x
        self._seed = seed
        self.step = 0

    def choose(self, engagement: float | None, preference: int | None = None) -> Move:
        """Return the move before the next utterance.

        `engagement` is E now (None: not known); `preference` the truth, for the oracle alone.
        """
        context = Context(self.step, np.array([self.x]), np.array([engagement or 0.0]))
        if preference is not None and isinstance(self.learner, Revealed):
            self.learner.reveal(np.array([preference]))
        if self.step == 0:
            return Move(context, 0, 1.0, self.x, False)
        choice = self.learner.choose(context, draws(self._seed, self.step, self.learner.draws))
        x = int(moved(context.x, choice.action)[0])
        return Move(context, int(choice.action[0]), float(choice.probability[0]), x, True)

    def learn(self, move: Move, sensed: Sensed, duration: float) -> float | None:
        """Learn from what an utterance of so many seconds did; returns the reward, if any."""
        self.step += 1
        self.x = move.x
        outcome = outcome_of(move.x, sensed, duration)
        if outcome is None:
            return None
        self.learner.learn(move.context, choice_of(move), outcome)
        return float(outcome.reward[0])


def draws(seed: int, step: int, count: int) -> Any:
    """Return the uniform numbers for a step, shape (`count`, 1)."""
    return np.array(Draws(seed, step).numbers("learner", count)).reshape(count, 1)


def choice_of(move: Move) -> Choice:
    """Return a move as the learners have it."""
    return Choice(np.array([move.action]), np.array([move.probability]))


def outcome_of(x: int, sensed: Sensed, duration: float) -> Outcome | None:
    """Return what the learners are told of an utterance; None if nothing was sensed."""
    if sensed.before is None or sensed.after is None or not sensed.stream or duration <= 0:
        return None
    before, after = np.array([sensed.before]), np.array([sensed.after])
    return Outcome(
        rewarded(after, before, True),
        np.array([x]),
        after,
        evened(np.array([sensed.stream])),
        np.array([max(duration, SAMPLE_SECONDS)]),
    )


def evened(stream: Floats) -> Floats:
    """Return E as the learners read it: by the log-odds of being engaged, not the probability.

    Near -2 and 2 a probability hardly moves, however much the cues say; log-odds move alike
    everywhere, so that the sensor's errors are as large everywhere, as learners expect. With what
    each way brings, see docs/live.md.

    >>> evened(np.array([-1.8, -1.0, 0.0, 1.0, 2.0])).round(2).tolist()
    [-2.45, -0.92, 0.0, 0.92, 3.83]
    """
    engaged = np.clip((stream - LOWEST) / (HIGHEST - LOWEST), LEAST, 1 - LEAST)
    odds: Floats = np.log(engaged / (1 - engaged)) / STEEPNESS
    return odds


def belief(learner: Learner) -> dict[str, Any] | None:
    """Return what a learner believes, ready for JSON; None for one that has no beliefs.

    `preference` holds the probabilities of X = -2 … 2 to be what the listener likes.
    """
    if not isinstance(learner, Bayes):
        return None
    found = learner.belief()
    tastes = {name: round(float(value[0]), 4) for name, value in found.tastes.items()}
    return {
        "preference": [round(float(value), 4) for value in found.preference[:, 0]],
        "tastes": tastes,
        "noise": round(float(found.noise[0]), 4),
    }
