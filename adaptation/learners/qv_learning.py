"""QV-learning: learns what a state is worth, and from that what its actions are worth.

Source: Wiering, QV(λ)-learning: a new on-policy reinforcement learning algorithm, European
Workshop on Reinforcement Learning, 2005; here with λ = 0. As a social robot's learner: the paper,
section II (Liu et al.).
"""

from __future__ import annotations

import numpy as np

from adaptation.learners.checks import checked_number
from adaptation.learners.credit import TAU, credited
from adaptation.learners.table import TableLearner
from adaptation.problem import Choice, Context, Floats, Outcome


class QVLearning(TableLearner):
    """Q and V both move towards the reward plus `gamma` times V of the next state.

    V moves by the share `beta`, Q by the share `alpha`.

    Defaults: chosen as for `ExpectedSarsa`.

    >>> learner = QVLearning(trials=1, alpha=0.5, beta=0.25, gamma=0.5, initial=1.0)
    >>> context = Context(0, np.array([0]), np.zeros(1))
    >>> outcome = Outcome(reward=np.array([-1.0]), x=np.array([1]), engagement=np.array([-1.0]))
    >>> learner.learn(context, Choice(np.array([1]), np.ones(1)), outcome)
    >>> learner.worth[0], learner.table[0, 2]  # both towards -1 + 0.5 · 1
    (array([1.   , 1.   , 0.625, 1.   , 1.   ]), array([1.  , 1.  , 0.25]))
    """

    name = "qv-learning"
    memory = ("table", "worth")

    def __init__(
        self,
        trials: int,
        *,
        state: str = "x",
        epsilon: float = 0.01,
        alpha: float = 0.2,
        beta: float = 0.6,
        gamma: float = 0.6,
        initial: float = 1.0,
        tau: float = TAU,
    ) -> None:
        super().__init__(
            trials,
            state=state,
            epsilon=epsilon,
            alpha=alpha,
            gamma=gamma,
            initial=initial,
            tau=tau,
            beta=beta,
        )
        self.beta = checked_number(self.name, "beta", beta, 0, 1)
        # V, what each state is worth.
        self.worth: Floats = np.full((self.trials, self.states), self.initial)

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        before = (self._trials, self._before(context))
        following = self.worth[self._trials, self._after(outcome)]
        target = credited(context, outcome, self.tau) + self.gamma * following
        self.worth[before] += self.beta * (target - self.worth[before])
        self._learn_value(before[1], choice.action, target)
