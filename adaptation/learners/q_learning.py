"""Q-learning, the learner of the paper (section III-B), with its settings.

Source: Watkins, Learning from delayed rewards, 1989; Sutton & Barto, Reinforcement Learning,
section 6.5 (2nd edition, 2018).
"""

from __future__ import annotations

import numpy as np

from adaptation.learners.base import BatchLearner, epsilon_greedy
from adaptation.learners.checks import checked_number
from adaptation.problem import (
    ACTIONS,
    LEVELS,
    LOWEST,
    Choice,
    Context,
    Floats,
    Ints,
    Outcome,
    within,
)

_STATES = len(LEVELS) ** 2
# What makes the first state, E = X = -2, number 0.
_FIRST = -LOWEST * len(LEVELS) - LOWEST


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
        self.table: Floats = np.zeros((self.trials, _STATES, len(ACTIONS)))
        self._rows = np.arange(self.trials) * _STATES

    def _choose(self, context: Context, draws: Floats) -> Choice:
        row = self._rows + state_of(context.engagement, context.x)
        return epsilon_greedy(self._values(row), self.epsilon, draws)

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        row = self._rows + state_of(context.engagement, context.x)
        place = row * len(ACTIONS) + (choice.action + 1)
        following = self._rows + state_of(outcome.engagement, outcome.x)
        target = outcome.reward + self.gamma * np.maximum.reduce(self._values(following))
        flat = self.table.reshape(-1)
        value = flat.take(place)
        flat[place] = value + self.alpha * (target - value)

    def _values(self, row: Ints) -> Floats:
        """Return the values of the actions in each trial's row of the table; (3, trials)."""
        return np.ascontiguousarray(self.table.reshape(-1, len(ACTIONS)).take(row, axis=0).T)


def state_of(engagement: Floats, x: Ints) -> Ints:
    """Return the number of the state (E, X), from 0 to 24; E is rounded to the nearest level.

    >>> state_of(np.array([-2.0, 0.4, 2.0]), np.array([-2, 0, 2]))
    array([ 0, 12, 24])
    """
    number = within(engagement)
    np.rint(number, out=number)
    number *= len(LEVELS)
    number += _FIRST
    return number.astype(np.int64) + x
