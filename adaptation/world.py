"""Simulated listeners as the robot meets them: true engagement, noise, and what is sensed of it.

The noise of the paper (section III-B) is "random changes in user engagement as well as deviations
of the sensed from the real E value". Two independent coins fall in each step. The listener's: the
change of E is replaced by one drawn evenly from -1, 0 and 1. The sensor's: the sensed E is off by
1, up or down, but never leaves -2 to 2. With these two the paper's figure 2 comes out.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np

from adaptation.listeners.base import Listener
from adaptation.problem import LOWEST, Floats, Ints, Outcome, within

FLOOR_BONUS = 0.5


class Noise(NamedTuple):
    """The probabilities of the two coins, from 0 to 1."""

    listener: float
    sensor: float


class Coins(NamedTuple):
    """Uniform numbers for each coin: whether it falls, and what then; shape (steps, 2, trials).

    None where a coin never falls.
    """

    listener: Floats | None
    sensor: Floats | None


class World(Protocol):
    """A batch of listeners that hear one utterance after the other.

    `sensed` is the sensed E, `engagement` the true E that counts for the step: both (trials,).
    """

    sensed: Floats
    engagement: Floats

    def hear(self, step: int, x: Ints, preference: Ints) -> Outcome:
        """Let the listeners hear an utterance with `x`, in the step of that number (from 0)."""


class StepWorld:
    """Listeners that answer once for each utterance.

    `coins` and `responses` (steps, `listener.draws`, trials) are their random numbers.
    """

    def __init__(
        self,
        listener: Listener,
        trials: int,
        noise: Noise,
        coins: Coins,
        responses: Floats,
        floor_bonus: bool = True,
    ) -> None:
        self._listener = listener
        self._noise = noise
        self._coins = coins
        self._responses = responses
        self._floor_bonus = floor_bonus
        self._before: Ints = np.zeros(trials, dtype=np.int64)
        self.engagement = listener.start(trials)
        self.sensed = self.engagement

    def hear(self, step: int, x: Ints, preference: Ints) -> Outcome:
        """Let the listeners hear an utterance; returns the reward and what is sensed of E."""
        heard = self._listener.respond(
            self.engagement, x, self._before, preference, self._responses[step]
        )
        if self._coins.listener is not None:
            heard = self._moody(heard, self._coins.listener[step])
        sensed = heard
        if self._coins.sensor is not None:
            sensed = misread(heard, self._coins.sensor[step], self._noise.sensor)
        reward = rewarded(sensed, self.sensed, self._floor_bonus)
        self.engagement, self.sensed, self._before = heard, sensed, x
        return Outcome(reward, x, sensed)

    def _moody(self, heard: Floats, coin: Floats) -> Floats:
        """Return E with its change replaced wherever the listener's coin falls."""
        anyhow = within(self.engagement + (np.floor(coin[1] * 3) - 1))
        return np.where(coin[0] < self._noise.listener, anyhow, heard)


def misread(engagement: Floats, coin: Floats, noise: float) -> Floats:
    """Return E as it is sensed: off by 1, up or down, wherever the sensor's coin falls.

    >>> coin = np.array([[0.1, 0.1, 0.9], [0.7, 0.2, 0.2]])
    >>> misread(np.array([2.0, 0.0, 0.0]), coin, noise=0.5)
    array([ 2., -1.,  0.])
    """
    return within(engagement + offset(coin, noise))


def offset(coin: Floats, noise: float) -> Floats:
    """Return by how much the sensor's coin shifts what is sensed: -1, 0 or 1."""
    return np.where(coin[0] < noise, np.where(coin[1] < 0.5, -1.0, 1.0), 0.0)


def rewarded(sensed: Floats, before: Floats, floor_bonus: bool) -> Floats:
    """Return the reward: ΔE as sensed, but 0.5 where E stays the same.

    Source: the paper, section III-B ("For ΔE = 0, the robot gets a small reward +0.5 for
    preventing a decrease of engagement"). Taken literally, that pays for a listener whose E is at
    its floor of -2, too, and cannot fall; without `floor_bonus` it does not.

    >>> rewarded(np.array([1.0, 0.0, -2.0]), np.array([0.0, 0.0, -2.0]), floor_bonus=False)
    array([1. , 0.5, 0. ])
    """
    change = sensed - before
    stays = change == 0
    if not floor_bonus:
        stays &= sensed > LOWEST
    return np.where(stays, FLOOR_BONUS, change)
