"""Checks of what learners are given: nothing that is no number is learned from."""

from __future__ import annotations

import math

import numpy as np

from adaptation.problem import HIGHEST, LOWEST, Context, Floats, Ints, Outcome
from personage_lite.errors import PersonageError, shown


def check_context(learner: str, context: Context, trials: int) -> None:
    """Raise `PersonageError` where X is no level, or the sensed E no number, in some trial."""
    _check_levels(learner, "X", context.x, trials)
    _check_numbers(learner, "engagement", context.engagement, trials)


def check_outcome(learner: str, outcome: Outcome, trials: int) -> None:
    """Raise `PersonageError` for a reward, X, E, stream or duration that cannot be learned from.

    In the stream NaN is allowed: nothing was sensed then.
    """
    _check_numbers(learner, "reward", outcome.reward, trials)
    _check_levels(learner, "X", outcome.x, trials)
    _check_numbers(learner, "engagement", outcome.engagement, trials)
    if outcome.duration is not None:
        _check_numbers(learner, "duration", outcome.duration, trials)
        if (outcome.duration <= 0).any():
            raise PersonageError(f"{learner}: an utterance of no duration; give seconds above 0")
    if outcome.stream is not None:
        stream = outcome.stream
        if stream.ndim != 2 or len(stream) != trials:
            raise PersonageError(
                f"{learner}: a stream of shape {stream.shape}; give {trials} rows of samples"
            )
        if np.isinf(stream).any():
            raise PersonageError(f"{learner}: infinite values in the stream; give numbers, or NaN")


def _check_numbers(learner: str, what: str, values: Floats, trials: int) -> None:
    if values.shape != (trials,):
        raise PersonageError(f"{learner}: {what} of shape {values.shape}; give {(trials,)}")
    if not np.isfinite(values).all():
        place = int(np.flatnonzero(~np.isfinite(values))[0])
        raise PersonageError(
            f"{learner}: {what} is {values[place]} in trial {place + 1}; give a finite number"
        )


def _check_levels(learner: str, what: str, values: Ints, trials: int) -> None:
    if values.shape != (trials,) or values.dtype.kind != "i":
        raise PersonageError(f"{learner}: {what} must be {trials} whole numbers")
    if values.min() < LOWEST or values.max() > HIGHEST:
        raise PersonageError(f"{learner}: {what} outside {LOWEST} to {HIGHEST}; keep to the levels")


def checked_number(
    learner: str, setting: str, value: object, lowest: float, highest: float = math.inf
) -> float:
    """Return a setting as a number from `lowest` to `highest`, or raise `PersonageError`.

    >>> checked_number("q-learning", "epsilon", 1.2, 0, 1)
    Traceback (most recent call last):
    personage_lite.errors.PersonageError: q-learning: epsilon is 1.2; give a number from 0 to 1
    """
    number = math.nan
    if isinstance(value, int | float) and not isinstance(value, bool):
        number = float(value)
    if not (lowest <= number <= highest and math.isfinite(number)):
        bounds = f"from {lowest:g} to {highest:g}" if highest < math.inf else f"from {lowest:g} up"
        raise PersonageError(f"{learner}: {setting} is {shown(str(value))}; give a number {bounds}")
    return number


def checked_whole(learner: str, setting: str, value: object, lowest: int) -> int:
    """Return a setting as a whole number from `lowest` up, or raise `PersonageError`."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < lowest:
        raise PersonageError(
            f"{learner}: {setting} is {shown(str(value))}; give a whole number from {lowest} up"
        )
    return int(value)


def checked_word(learner: str, setting: str, value: object, words: tuple[str, ...]) -> str:
    """Return a setting that is one of some words, or raise `PersonageError`."""
    if not isinstance(value, str) or value not in words:
        raise PersonageError(
            f"{learner}: {setting} is '{shown(str(value))}'; choose from: {', '.join(words)}"
        )
    return value
