"""Discounted UCB: UCB that forgets bit by bit, for a taste that changes.

Source: Garivier & Moulines, On upper-confidence bound policies for switching bandit problems,
Algorithmic Learning Theory, 2011.
"""

from __future__ import annotations

from adaptation.learners.bandit import CountingBandit, nearest_best
from adaptation.learners.checks import checked_number
from adaptation.learners.credit import TAU
from adaptation.learners.ucb import upper_bounds
from adaptation.problem import Floats, Ints


class DiscountedUCB(CountingBandit):
    """Aims as UCB does, with counts and sums that fade by `discount` at each utterance.

    The source's bound is 2 B √(ξ ln n / N) with counts that fade: `exploration` is 2 B √ξ. With
    a `weight` of 0 a level never tried comes first.

    Defaults: chosen as for `UCB`.

    >>> import numpy as np
    >>> bandit = DiscountedUCB(trials=1, discount=0.5)
    >>> for arm, reward in ((0, 1.0), (1, 0.5), (0, 0.0)):
    ...     bandit._credit(np.array([arm]), np.array([reward]))
    >>> bandit.counts, bandit.sums
    (array([[1.25, 0.5 , 0.  , 0.  , 0.  ]]), array([[0.25, 0.25, 0.  , 0.  , 0.  ]]))
    """

    name = "discounted-ucb"

    def __init__(
        self,
        trials: int,
        *,
        discount: float = 0.7,
        exploration: float = 0.1,
        prior: float = 0.0,
        weight: float = 0.3,
        tau: float = TAU,
    ) -> None:
        super().__init__(
            trials,
            discount=discount,
            exploration=exploration,
            prior=prior,
            weight=weight,
            tau=tau,
        )
        self.exploration = checked_number(self.name, "exploration", exploration, 0)

    def _chances(self, x: Ints) -> Floats:
        counts, means = self._means()
        return nearest_best(upper_bounds(counts, means, self.exploration), x)
