"""SARSA: learns what actions are worth, given what it really does next.

Source: Rummery & Niranjan, On-line Q-learning using connectionist systems, 1994; Sutton & Barto,
Reinforcement Learning, section 6.4 (2nd edition, 2018). As a social robot's learner: the paper,
section II (Gordon et al.).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Self

import numpy as np

from adaptation.learners.base import epsilon_greedy
from adaptation.learners.credit import TAU, credited
from adaptation.learners.table import TableLearner
from adaptation.problem import ACTIONS, Choice, Context, Floats, Ints, Outcome
from personage_lite.errors import PersonageError

# Before the first step: no state.
_NONE = -1


class Sarsa(TableLearner):
    """Q moves towards the reward plus `gamma` times the value of the action that is taken next.

    So each step is learned from when the action of the one after it is known. Until then only a
    repetition of it is judged by it: the action counts in its state as much as it would if it
    were taken again. Otherwise the robot would, in the same state, do once more what has just
    displeased, as what it chooses from is one step old (match without noise .42, not .48).

    Defaults: chosen as for `ExpectedSarsa`.

    >>> learner = Sarsa(trials=1, alpha=0.5, gamma=0.5, initial=1.0)
    >>> context = Context(0, np.array([0]), np.zeros(1))
    >>> keep = Choice(np.array([0]), np.ones(1))
    >>> outcome = Outcome(reward=np.array([-1.0]), x=np.array([0]), engagement=np.array([-1.0]))
    >>> learner.learn(context, keep, outcome)
    >>> learner.table[0, 2]  # nothing yet
    array([1., 1., 1.])
    >>> learner.learn(context, keep, outcome)
    >>> learner.table[0, 2]  # 1 + 0.5 · (-1 + 0.5 · 1 - 1)
    array([1.  , 0.25, 1.  ])
    """

    name = "sarsa"
    memory = ("table", "last_state", "last_action", "last_reward")

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
        # The step that is still to be learned from.
        self.last_state: Ints = np.full(self.trials, _NONE)
        self.last_action: Ints = np.zeros(self.trials, dtype=np.int64)
        self.last_reward: Floats = np.zeros(self.trials)

    def _choose(self, context: Context, draws: Floats) -> Choice:
        state = self._before(context)
        values = self._values(state)
        place = (self.last_action + 1, self._trials)
        value = values[place]
        repeated = value + self.alpha * (self.last_reward + self.gamma * value - value)
        values[place] = np.where(state == self.last_state, repeated, value)
        return epsilon_greedy(values, self.epsilon, draws)

    def _learn(self, context: Context, choice: Choice, outcome: Outcome) -> None:
        state = self._before(context)
        following = self.table[self._trials, state, choice.action + 1]
        if (self.last_state != _NONE).all():
            target = self.last_reward + self.gamma * following
            self._learn_value(self.last_state, self.last_action, target)
        self.last_state, self.last_action = state, choice.action
        self.last_reward = credited(context, outcome, self.tau)

    @classmethod
    def restore(cls, saved: Mapping[str, Any]) -> Self:
        """Return a learner that goes on as the saved one would have; see `BatchLearner`."""
        learner = super().restore(saved)
        states = learner.last_state
        steps = states.min() >= _NONE and states.max() < learner.states
        steps &= (states == _NONE).all() or (states != _NONE).all()
        if not (steps and np.isin(learner.last_action, ACTIONS).all()):
            raise PersonageError(f"{cls.name}: what was saved holds no such step; start afresh")
        return learner
