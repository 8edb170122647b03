"""The ε-greedy bandit: mostly the level of X that seems best, now and then any.

Source: Sutton & Barto, Reinforcement Learning, sections 2.2 to 2.6 (2nd edition, 2018): action
values, a constant step size for problems that change, optimistic initial values. Bandits as
social robots' learners: the paper, section II (Leite et al.).
"""

from __future__ import annotations

import numpy as np

from adaptation.learners.bandit import ARMS, LevelBandit, nearest_best
from adaptation.learners.checks import checked_number
from adaptation.learners.credit import TAU
from adaptation.problem import Floats, Ints


class EpsilonGreedy(LevelBandit):
    """Aims at the level of the highest value or, with probability `epsilon`, at any.

    The values start at `initial` and move by the share `alpha` towards each reward of their level.

    Defaults: chosen as for `UCB`, but for `epsilon`: 0 would fit the simulated listeners best,
    whose disappointment drives the learner on. A little is kept for others.

    >>> bandit = EpsilonGreedy(trials=1, alpha=0.5, initial=0.0)
    >>> for reward in (1.0, 0.0):
    ...     bandit._credit(np.array([3]), np.array([reward]))
    >>> bandit.values
    array([[0.  , 0.  , 0.  , 0.25, 0.  ]])
    """

    name = "epsilon-greedy"
    memory = ("values",)

    def __init__(
        self,
        trials: int,
        *,
        epsilon: float = 0.01,
        alpha: float = 0.3,
        initial: float = 0.15,
        tau: float = TAU,
    ) -> None:
        super().__init__(trials, epsilon=epsilon, alpha=alpha, initial=initial, tau=tau)
        self.epsilon = checked_number(self.name, "epsilon", epsilon, 0, 1)
        self.alpha = checked_number(self.name, "alpha", alpha, 0, 1)
        initial = checked_number(self.name, "initial", initial, -2, 2)
        self.values: Floats = np.full((self.trials, ARMS), initial)
        self._trials = np.arange(self.trials)

    def _chances(self, x: Ints) -> Floats:
        best = nearest_best(np.ascontiguousarray(self.values.T), x)
        return (1 - self.epsilon) * best + self.epsilon / ARMS

    def _credit(self, arm: Ints, value: Floats) -> None:
        place = (self._trials, arm)
        self.values[place] += self.alpha * (value - self.values[place])
