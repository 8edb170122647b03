"""Listeners in real time as the robot meets them: a sensed value each 200 ms, its 5 s average.

The paper, section IV-B: engagement is estimated by a dynamic Bayesian network, "sent every 200 ms",
and smoothed by "a moving average with a five seconds window". E before and after an utterance,
and so the reward, are read off that average. It is a real number that errors can push beyond -2
and 2; that it stays exactly the same, and so earns the bonus, never happens.
"""

from __future__ import annotations

import math

import numpy as np

from adaptation.listeners.base import LiveListener
from adaptation.problem import LEVELS, SAMPLE_SECONDS, Floats, Ints, Outcome
from adaptation.world import Coins, Noise, offset, rewarded
from personage_lite.errors import PersonageError

WINDOW = round(5.0 / SAMPLE_SECONDS)


class Sensor:
    """How a sensed value comes from the true E: Gaussian errors that last for a while.

    `sigma` is the standard deviation of the error of one value. Errors of successive values are
    alike, as those of an estimator that smooths over time are: their correlation falls to 1/e
    within `memory` seconds (0: each error is drawn afresh). The paper gives neither. With 0.5 and
    2 s, the published learner keeps the mean true E at .59 and matches in .25 of the steps; with
    independent errors, which the 5 s average all but removes, it would be .73 and .29.
    """

    def __init__(self, sigma: float = 0.5, memory: float = 2.0) -> None:
        for name, value in (("sigma", sigma), ("memory", memory)):
            if not (0 <= value < math.inf):
                raise PersonageError(f"sensor: {name} is {value}; give a number from 0 up")
        self.sigma = sigma
        self.memory = memory

    def errors(self, last: Floats, fresh: Floats) -> Floats:
        """Return the next errors of values sensed after one with the error `last`.

        `fresh` are numbers of mean 0 and deviation 1, shape (samples, trials); so is the result.
        """
        kept = math.exp(-SAMPLE_SECONDS / self.memory) if self.memory else 0.0
        errors: Floats = fresh * (self.sigma * math.sqrt(1 - kept * kept))
        for number in range(len(errors)):
            last = errors[number] = kept * last + errors[number]
        return errors


class LiveWorld:
    """Listeners that answer while the utterance lasts, seen through a sensor.

    `fresh` are the sensor's random numbers, shape (`WINDOW` + steps · `listener.longest`, trials);
    `engagement` is the mean of the true E over the last utterance.

    The paper's coins, if they are to fall: the listener's makes it answer as if it preferred
    another level, drawn evenly; the sensor's shifts all that is sensed during an utterance by 1.
    """

    def __init__(
        self,
        listener: LiveListener,
        trials: int,
        noise: Noise,
        coins: Coins,
        fresh: Floats,
        sensor: Sensor,
        floor_bonus: bool = True,
    ) -> None:
        self._listener = listener
        self._noise = noise
        self._coins = coins
        self._fresh = fresh
        self._sensor = sensor
        self._floor_bonus = floor_bonus
        self._trials = np.arange(trials)
        self._true = self.engagement = listener.start(trials)
        # Until the first utterance the sensor has watched for as long as its average reaches.
        first = sensor.sigma * fresh[:1]
        errors = np.concatenate((first, sensor.errors(first[0], fresh[1:WINDOW])))
        self._errors: Floats = errors[-1]
        self._window: Floats = self._true + errors
        self.sensed: Floats = self._window.mean(axis=0)

    def hear(self, step: int, x: Ints, preference: Ints) -> Outcome:
        """Let the listeners hear an utterance; returns reward, sensed E, stream and duration."""
        if self._coins.listener is not None:
            coin, which = self._coins.listener[step]
            anyhow = LEVELS[(which * len(LEVELS)).astype(np.int64)]
            preference = np.where(coin < self._noise.listener, anyhow, preference)
        path, samples = self._listener.listen(self._true, x, preference)
        longest = self._listener.longest
        start = WINDOW + step * longest
        errors = self._sensor.errors(self._errors, self._fresh[start : start + longest])
        stream: Floats = path + errors
        if self._coins.sensor is not None:
            stream += offset(self._coins.sensor[step], self._noise.sensor)
        lasting = np.arange(longest)[:, None] < samples
        heard = np.concatenate((self._window, stream))
        # The last values until each utterance's own end: of a short one, some of before it.
        self._window = heard[samples + np.arange(WINDOW)[:, None], self._trials]
        sensed: Floats = self._window.mean(axis=0)
        reward = rewarded(sensed, self.sensed, self._floor_bonus)
        self.engagement = np.where(lasting, path, 0).sum(axis=0) / samples
        self._true = path[samples - 1, self._trials]
        self._errors = errors[samples - 1, self._trials]
        self.sensed = sensed
        stream[~lasting] = np.nan
        return Outcome(reward, x, sensed, stream.T, (samples * SAMPLE_SECONDS).astype(np.float64))
