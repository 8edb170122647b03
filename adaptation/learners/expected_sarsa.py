"""Expected SARSA: as SARSA, but it learns from the mean over the next action, not from one.

Source: van Seijen, van Hasselt, Whiteson & Wiering, A theoretical and empirical analysis of
expected Sarsa, IEEE Symposium on Adaptive Dynamic Programming and Reinforcement Learning, 2009;
Sutton & Barto, Reinforcement Learning, section 6.6 (2nd edition, 2018).
"""

from __future__ import annotations

from adaptation.learners.credit import TAU, credited
from adaptation.learners.table import TableLearner
from adaptation.problem import Choice, Context, Outcome


class ExpectedSarsa(TableLearner):
    """Q moves towards the reward plus `gamma` times the mean value of what it would do next.

    It would take an action of the highest value or, with probability `epsilon`, any.

    Defaults: the highest match on the listeners `match` (noise 0, .2, .5; no floor bonus) and
    `live`, added up, of 200 settings drawn at random, 4,000 trials each, seed 31001. An `epsilon`
    of 0 fits the simulated listeners as well, as disappointment drives the learner on; a little
    is kept for others.

    >>> import numpy as np
    >>> learner = ExpectedSarsa(trials=1, epsilon=0.3, alpha=0.5, gamma=0.5, initial=0.0)
    >>> learner.table[0, 3] = [0.0, 1.0, 0.5]
    >>> context = Context(0, np.array([0]), np.zeros(1))
    >>> outcome = Outcome(reward=np.array([-1.0]), x=np.array([1]), engagement=np.array([-1.0]))
    >>> learner.learn(context, Choice(np.array([1]), np.ones(1)), outcome)
    >>> learner.table[0, 2]  # 0.5 · (-1 + 0.5 · (0.7 · 1 + 0.3 · 0.5)) in the last place
    array([ 0.    ,  0.    , -0.2875])
    """

    name = "expected-sarsa"

    def __init__(
        self,
        trials: int,
        *,
        state: str = "x",
        epsilon: float = 0.01,
        alpha: float = 0.2,
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
        )

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        values = self._values(self._after(outcome))
        expected = (1 - self.epsilon) * values.max(axis=0) + self.epsilon * values.mean(axis=0)
        target = credited(context, outcome, self.tau) + self.gamma * expected
        self._learn_value(self._before(context), choice.action, target)
