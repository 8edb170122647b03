"""UCB1: the level of X whose mean reward could be the highest, given how little is known of it.

Source: Auer, Cesa-Bianchi & Fischer, Finite-time analysis of the multiarmed bandit problem,
Machine Learning 47, 2002. Bandits as social robots' learners: the paper, section II (Leite et al.).
"""

from __future__ import annotations

import numpy as np

from adaptation.learners.bandit import CountingBandit, nearest_best
from adaptation.learners.checks import checked_number
from adaptation.learners.credit import TAU
from adaptation.problem import Floats, Ints


class UCB(CountingBandit):
    """Aims at the level with the highest mean + `exploration` · √(ln t / n).

    n is how often the level was heard and t how often any was, with what stands for them at first
    (`prior`, `weight`: see `CountingBandit`). For rewards from 0 to 1 the source has an
    `exploration` of √2 and a `weight` of 0. It never forgets, so a changed taste is found late.

    Defaults: the highest match on the listeners `match` (noise 0, .2, .5; no floor bonus) and
    `live`, added up, of 90 settings drawn at random, 3,000 trials each, seed 31001.

    >>> from adaptation.problem import Choice, Context, Outcome
    >>> bandit = UCB(trials=1)
    >>> context = Context(0, np.array([0]), np.zeros(1))
    >>> bandit.choose(context, np.array([[0.5]])).action  # none is better: it stays
    array([0])
    >>> outcome = Outcome(reward=np.array([-1.0]), x=np.array([0]), engagement=np.array([-1.0]))
    >>> bandit.learn(context, Choice(np.array([0]), np.ones(1)), outcome)
    >>> bandit.choose(context, np.array([[0.5]]))
    Choice(action=array([1]), probability=array([0.5]))
    """

    name = "ucb"

    def __init__(
        self,
        trials: int,
        *,
        exploration: float = 0.3,
        prior: float = 0.0,
        weight: float = 1.0,
        tau: float = TAU,
    ) -> None:
        super().__init__(trials, exploration=exploration, prior=prior, weight=weight, tau=tau)
        self.exploration = checked_number(self.name, "exploration", exploration, 0)

    def _chances(self, x: Ints) -> Floats:
        counts, means = self._means()
        return nearest_best(upper_bounds(counts, means, self.exploration), x)


def upper_bounds(counts: Floats, means: Floats, exploration: float) -> Floats:
    """Return how high each mean could be, mean + exploration · √(ln t / n); shape (5, trials).

    t is the sum of the counts n. What counts nothing has an infinite mean.

    >>> counts, means = np.array([[2.0], [1], [1], [1], [1]]), np.array([[0.25], [0.5], [0], [0], [-1]])
    >>> upper_bounds(counts, means, 1.0).round(2).T  # √(ln 6 / 2) = 0.95, √(ln 6) = 1.34
    array([[1.2 , 1.84, 1.34, 1.34, 0.34]])
    """  # noqa: E501
    heard = np.maximum(np.add.reduce(counts), 1.0)
    bounds: Floats = means + exploration * np.sqrt(np.log(heard) / np.where(counts, counts, 1.0))
    return bounds
