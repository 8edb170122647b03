"""What the learners with a table share: states, the table of values, ε-greedy choice.

Their state is (E, X) as in the paper, section III-A, or X alone. With 30 utterances the state is
what holds them back, not the algorithm: of the 75 values of (E, X) few are met twice, of the 15
of X alone many are. So X alone is the default.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from adaptation.learners.base import BatchLearner, Setting, epsilon_greedy
from adaptation.learners.checks import checked_number, checked_word
from adaptation.learners.q_learning import state_of
from adaptation.problem import ACTIONS, LEVELS, LOWEST, Choice, Context, Floats, Ints, Outcome

# By the names of the setting `state`: how many states there are.
STATES = {"x": len(LEVELS), "ex": len(LEVELS) ** 2}


class StateLearner(BatchLearner):
    """A learner that knows states: `state` is "x" (X alone) or "ex" (E and X).

    `tau` is the listener's time constant in seconds where utterances have a duration: see
    `adaptation.learners.credit.credited`.
    """

    draws = 2

    def __init__(
        self, trials: int, *, state: str, epsilon: float, gamma: float, tau: float, **more: Setting
    ) -> None:
        super().__init__(trials, state=state, epsilon=epsilon, gamma=gamma, tau=tau, **more)
        self.state = checked_word(self.name, "state", state, tuple(STATES))
        self.states = STATES[self.state]
        self.epsilon = checked_number(self.name, "epsilon", epsilon, 0, 1)
        self.gamma = checked_number(self.name, "gamma", gamma, 0, 1)
        self.tau = checked_number(self.name, "tau", tau, 0)
        self._trials = np.arange(self.trials)

    def _before(self, context: Context) -> Ints:
        """Return the number of the state in which the robot chooses; (trials,)."""
        return self._number(context.engagement, context.x)

    def _after(self, outcome: Outcome) -> Ints:
        """Return the number of the state that the choice led to; (trials,)."""
        return self._number(outcome.engagement, outcome.x)

    def _number(self, engagement: Floats, x: Ints) -> Ints:
        return x - LOWEST if self.state == "x" else state_of(engagement, x)


class TableLearner(StateLearner):
    """A learner with a table of the value Q of each action in each state.

    With probability `epsilon` it takes any action, otherwise one with the highest value, drawn
    evenly among equal ones. `alpha` is the step size, `gamma` the discount. All values are
    `initial` at first; if rewards are mostly lower, what was not tried looks better than what was
    (Sutton & Barto, section 2.6).
    """

    memory: ClassVar[tuple[str, ...]] = ("table",)

    def __init__(
        self,
        trials: int,
        *,
        state: str,
        epsilon: float,
        alpha: float,
        gamma: float,
        initial: float,
        tau: float,
        **more: Setting,
    ) -> None:
        super().__init__(
            trials,
            state=state,
            epsilon=epsilon,
            alpha=alpha,
            gamma=gamma,
            initial=initial,
            tau=tau,
            **more,
        )
        self.alpha = checked_number(self.name, "alpha", alpha, 0, 1)
        self.initial = checked_number(self.name, "initial", initial, -10, 10)
        self.table: Floats = np.full((self.trials, self.states, len(ACTIONS)), self.initial)

    def _choose(self, context: Context, draws: Floats) -> Choice:
        return epsilon_greedy(self._values(self._before(context)), self.epsilon, draws)

    def _values(self, state: Ints) -> Floats:
        """Return the values of the actions in each trial's state, (3, trials)."""
        return np.ascontiguousarray(self.table[self._trials, state].T)

    def _learn_value(self, state: Ints, action: Ints, target: Floats) -> None:
        """Move the value of an action in a state towards the target, by the share `alpha`."""
        place = (self._trials, state, action + 1)
        value = self.table[place]
        self.table[place] = value + self.alpha * (target - value)
