"""The experiment and its Q-learner once more, as plain loops over lists: to compare with.

Everything is said again here, as one reads it in the paper, section III-B: no numpy but for the
random numbers, which are the very same ones, nothing from `adaptation` but those and the
constants. One trial is run after the other.
"""

from __future__ import annotations

from typing import NamedTuple

from adaptation.draws import Draws

LOWEST, HIGHEST = -2, 2
EPSILON, ALPHA, GAMMA = 0.2, 0.5, 0.9


class Numbers(NamedTuple):
    """A trial's uniform random numbers: of the preference, and pairs for each step."""

    preference: list[float]
    listener: list[list[float]]
    sensor: list[list[float]]
    learner: list[list[float]]


class Trial(NamedTuple):
    """What came of a trial, step by step."""

    reward: list[float]
    match: list[bool]
    engagement: list[float]


def numbers(seed: int, trials: int, steps: int, changes: tuple[int, ...]) -> list[Numbers]:
    """Return each trial's random numbers, the same that the vectorised experiment draws."""
    draws = Draws(seed)
    redrawn = 1 + sum(change <= steps for change in changes)
    preference = draws.uniform("preference", trials, redrawn, 1)[:, 0].T
    pairs = [
        draws.uniform(name, trials, steps, 2).transpose(2, 0, 1)
        for name in ("listener", "sensor", "learner")
    ]
    lists = (part.tolist() for part in (preference, *pairs))
    return [Numbers(*own) for own in zip(*lists, strict=True)]


def run_trial(
    given: Numbers, steps: int, changes: tuple[int, ...], noise: float, floor_bonus: bool
) -> Trial:
    """Run one trial of Q-learning with the listener `match`."""
    table = {
        (e, x): [0.0, 0.0, 0.0]
        for e in range(LOWEST, HIGHEST + 1)
        for x in range(LOWEST, HIGHEST + 1)
    }
    preferences = iter(given.preference)
    preference = level(next(preferences))
    engagement = sensed = x = 0
    trial = Trial([], [], [])
    for step in range(steps):
        if step + 1 in changes:
            preference = level(next(preferences))

        # The learner chooses: with probability ε any action, otherwise a best one.
        values = table[sensed, x]
        coin, which = given.learner[step]
        if coin < EPSILON:
            action = int(which * 3)
        else:
            best = max(values)
            ties = [index for index in range(3) if values[index] == best]
            action = ties[int(which * len(ties))]
        new_x = clipped(x + action - 1)

        # The listener hears an utterance with this X.
        change = 1 if new_x == preference else -1
        coin, which = given.listener[step]
        if coin < noise:
            change = int(which * 3) - 1
        engagement = clipped(engagement + change)

        # The sensor reads the engagement.
        new_sensed = engagement
        coin, which = given.sensor[step]
        if coin < noise:
            new_sensed = clipped(engagement + (-1 if which < 0.5 else 1))
        reward: float = new_sensed - sensed
        if reward == 0 and (floor_bonus or new_sensed > LOWEST):
            reward = 0.5

        # The learner learns.
        target = reward + GAMMA * max(table[new_sensed, new_x])
        values[action] += ALPHA * (target - values[action])

        x, sensed = new_x, new_sensed
        trial.reward.append(reward)
        trial.match.append(x == preference)
        trial.engagement.append(engagement)
    return trial


def level(draw: float) -> int:
    """Return the level that a uniform number stands for."""
    return int(draw * 5) + LOWEST


def clipped(value: int) -> int:
    """Return a level kept within the scale."""
    return max(LOWEST, min(HIGHEST, value))
