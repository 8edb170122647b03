"""Talks to learners, step by step: what their tests share."""

from __future__ import annotations

import numpy as np

from adaptation.learners.base import Learner
from adaptation.problem import Choice, Context, Floats, Ints, Outcome, moved


def hear(
    learner: Learner,
    before: int,
    after: int,
    reward: float,
    engagement: tuple[float, float] = (0, 0),
) -> None:
    """Let a learner of one trial learn of one utterance: X before and after, the reward, E."""
    context = Context(0, np.array([before]), np.array([engagement[0]], dtype=float))
    choice = Choice(np.array([np.sign(after - before)]), np.ones(1))
    x, sensed = np.array([after]), np.array([engagement[1]], dtype=float)
    learner.learn(context, choice, Outcome(np.array([reward], dtype=float), x, sensed))


def choices(learner: Learner, x: int, draws: Floats, engagement: float = 0.0) -> list[int]:
    """Return what a learner of one trial chooses at X, for each column of draws."""
    context = Context(0, np.array([x]), np.array([engagement]))
    return [int(learner.choose(context, column[:, None]).action[0]) for column in draws.T]


def talk(learner: Learner, preference: Ints, draws: Floats, x: Ints, step: int) -> Ints:
    """Take a step with an easy listener, who rewards the preference with 1, all else with -1."""
    context = Context(step, x, np.zeros(len(x)))
    choice = learner.choose(context, draws)
    after = moved(x, choice.action)
    reward = np.where(after == preference, 1.0, -1.0)
    learner.learn(context, choice, Outcome(reward, after, np.zeros(len(x))))
    return after
