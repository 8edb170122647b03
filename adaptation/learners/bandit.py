"""What the n-armed bandits share: their arms are the five levels of X.

X moves by at most one level with each utterance, so a bandit names the level that it aims at and
the action is a step towards it. Credit goes to the X that was spoken with, not to the aim: what
is passed on the way is learned about, too.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from typing import Any, ClassVar, Self

import numpy as np

from adaptation.learners.base import BatchLearner, Setting
from adaptation.learners.checks import checked_number
from adaptation.learners.credit import credited
from adaptation.problem import LEVELS, LOWEST, Choice, Context, Floats, Ints, Outcome
from personage_lite.errors import PersonageError

ARMS = len(LEVELS)


class LevelBandit(BatchLearner):
    """A bandit over the levels of X; a subclass gives the chances of each, and takes the credit.

    `tau` is the listener's time constant in seconds where utterances have a duration: see
    `credited`.
    """

    draws = 1

    def __init__(self, trials: int, *, tau: float, **settings: Setting) -> None:
        super().__init__(trials, tau=tau, **settings)
        self.tau = checked_number(self.name, "tau", tau, 0)

    @abstractmethod
    def _chances(self, x: Ints) -> Floats:
        """Return the probability that each level is aimed at, shape (5, trials); `x` in force."""

    @abstractmethod
    def _credit(self, arm: Ints, value: Floats) -> None:
        """Learn what a level is worth, from one utterance; `arm` is its index, from 0 to 4."""

    def _choose(self, context: Context, draws: Floats) -> Choice:
        return step_towards(self._chances(context.x), context.x, draws[0])

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        self._credit(outcome.x - LOWEST, credited(context, outcome, self.tau))


class CountingBandit(LevelBandit):
    """A bandit that keeps, of each level, how much it has heard and the sum of its rewards.

    Before anything was heard a level counts as heard `weight` times with the mean reward `prior`;
    so a level never tried is not infinitely attractive, for which 30 steps have no time. A
    `weight` of 0 gives the published algorithms, which try each arm once before anything else.
    With each utterance counts and sums fade by the factor `discount`, if a subclass has that
    setting.
    """

    memory: ClassVar[tuple[str, ...]] = ("counts", "sums")

    def __init__(
        self,
        trials: int,
        *,
        prior: float,
        weight: float,
        tau: float,
        **settings: Setting,
    ) -> None:
        super().__init__(trials, prior=prior, weight=weight, tau=tau, **settings)
        self.prior = checked_number(self.name, "prior", prior, -2, 2)
        self.weight = checked_number(self.name, "weight", weight, 0)
        discount = settings.get("discount", 1.0)
        self.discount = checked_number(self.name, "discount", discount, 0, 1)
        self.counts: Floats = np.zeros((self.trials, ARMS))
        self.sums: Floats = np.zeros((self.trials, ARMS))
        self._trials = np.arange(self.trials)

    def _credit(self, arm: Ints, value: Floats) -> None:
        self.counts *= self.discount
        self.sums *= self.discount
        self.counts[self._trials, arm] += 1
        self.sums[self._trials, arm] += value

    def _means(self) -> tuple[Floats, Floats]:
        """Return counts and mean rewards with what stands for them at first, (5, trials) each.

        The mean of what counts nothing is infinite.
        """
        counts = np.ascontiguousarray(self.counts.T) + self.weight
        sums = np.ascontiguousarray(self.sums.T) + self.weight * self.prior
        unheard = counts == 0
        means = sums / np.where(unheard, 1.0, counts)
        means[unheard] = np.inf
        return counts, means

    @classmethod
    def restore(cls, saved: Mapping[str, Any]) -> Self:
        """Return a learner that goes on as the saved one would have; see `BatchLearner`."""
        learner = super().restore(saved)
        if learner.counts.min() < 0:
            raise PersonageError(f"{cls.name}: what was saved holds a count below 0; start afresh")
        return learner


def nearest_best(values: Floats, x: Ints) -> Floats:
    """Return the chances of each level to be aimed at: the highest value's is.

    `values` has shape (5, trials), a row a level. Among equal values the nearest to X is aimed
    at, as the way costs utterances; of two as near, either.

    >>> values = np.array([[1.0, 1], [0, 0], [1, 0], [0, 1], [1, 1]])
    >>> nearest_best(values, np.array([2, -1])).T
    array([[0., 0., 0., 0., 1.],
           [1., 0., 0., 0., 0.]])
    >>> nearest_best(values, np.array([1, 1])).T
    array([[0. , 0. , 0.5, 0. , 0.5],
           [0. , 0. , 0. , 1. , 0. ]])
    """
    distance = np.abs(LEVELS[:, None] - x)
    distance[values < np.maximum.reduce(values)] = ARMS
    nearest = distance == np.minimum.reduce(distance)
    chances: Floats = nearest / np.add.reduce(nearest, dtype=np.int64)
    return chances


def step_towards(chances: Floats, x: Ints, draws: Floats) -> Choice:
    """Draw the level to aim at, and return the step towards it and that step's probability.

    `chances` has shape (5, trials) and adds up to 1 in each trial, `draws` (trials,).

    >>> chances = np.array([[0.5, 0], [0.25, 0], [0, 0], [0, 0], [0.25, 1]])
    >>> step_towards(chances, np.array([-1, 2]), np.array([0.4, 0.9]))
    Choice(action=array([-1,  0]), probability=array([0.5, 1. ]))
    """
    heaped = np.cumsum(chances, axis=0)
    index = (heaped <= draws * heaped[-1]).sum(axis=0)
    # Rounding must not lead past the last level that has a chance.
    index = np.minimum(index, (heaped < heaped[-1]).sum(axis=0))
    action = np.sign(LEVELS[index] - x)
    same = np.sign(LEVELS[:, None] - x) == action
    probability = (chances * same).sum(axis=0) / chances.sum(axis=0)
    return Choice(action, np.minimum(probability, 1.0))
