"""Q-learning, the learner of the paper (section III-B), with its settings.

Source: Watkins, Learning from delayed rewards, 1989; Sutton & Barto, Reinforcement Learning,
section 6.5 (2nd edition, 2018).
"""

from __future__ import annotations

import numpy as np

from adaptation.learners.base import BatchLearner, epsilon_greedy
from adaptation.learners.checks import checked_number
from adaptation.problem import (
    HIGHEST,
    LEVELS,
    LOWEST,
    Choice,
    Context,
    Floats,
    Ints,
    Outcome,
)

_STATES = len(LEVELS) ** 2


class QLearning(BatchLearner):
    """Learns the value Q of each action in each state (E, X): a table of 5 · 5 · 3 numbers.

    With probability `epsilon` it takes any action, otherwise one with the highest value, drawn
    evenly among equal ones. After each step Q moves by the share `alpha` towards the reward plus
    `gamma` times the highest value in the next state. `epsilon` and `alpha` are the paper's; it
    gives no discount: with 30 steps `gamma` barely matters (mean reward without noise .283 at 0,
    .287 at 0.9). The table starts empty, all 0. A sensed E that is not whole is rounded.

    >>> learner = QLearning(trials=1)
    >>> zero = np.zeros(1)
    >>> context = Context(0, np.array([0]), zero)
    >>> choice = Choice(np.array([1]), np.ones(1))
    >>> learner.learn(context, choice, Outcome(reward=zero - 1, x=np.array([1]), engagement=zero - 1))
    >>> learner.table[0, 12]  # of the state E = 0, X = 0
    array([ 0. ,  0. , -0.5])
    """  # noqa: E501

    name = "q-learning"
    draws = 2
    memory = ("table",)

    def __init__(
        self, trials: int, *, epsilon: float = 0.2, alpha: float = 0.5, gamma: float = 0.9
    ) -> None:
        super().__init__(trials, epsilon=epsilon, alpha=alpha, gamma=gamma)
        self.epsilon = checked_number(self.name, "epsilon", epsilon, 0, 1)
        self.alpha = checked_number(self.name, "alpha", alpha, 0, 1)
        self.gamma = checked_number(self.name, "gamma", gamma, 0, 1)
        # A row for each state, a column for each action.
        self.table: Floats = np.zeros((self.trials, _STATES, 3))
        self._trials = np.arange(self.trials)

    def _choose(self, context: Context, draws: Floats) -> Choice:
        state = state_of(context.engagement, context.x)
        return epsilon_greedy(self.table[self._trials, state].T, self.epsilon, draws)

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        place = (self._trials, state_of(context.engagement, context.x), choice.action + 1)
        following = self.table[self._trials, state_of(outcome.engagement, outcome.x)].max(axis=1)
        target = outcome.reward + self.gamma * following
        self.table[place] += self.alpha * (target - self.table[place])


def state_of(engagement: Floats, x: Ints) -> Ints:
    """Return the number of the state (E, X), from 0 to 24; E is rounded to the nearest level.

    >>> state_of(np.array([-2.0, 0.4, 2.0]), np.array([-2, 0, 2]))
    array([ 0, 12, 24])
    """
    level = np.rint(np.clip(engagement, LOWEST, HIGHEST)).astype(np.int64)
    return (level - LOWEST) * len(LEVELS) + (x - LOWEST)
