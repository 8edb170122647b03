"""Means and confidence intervals, against numpy and tables."""

from __future__ import annotations

import math

import numpy as np
import pytest

from adaptation.tally import Tally, student95


def test_means_and_intervals_do_not_depend_on_the_blocks() -> None:
    values = np.random.default_rng(0).normal(3, 2, (5, 1000))
    tally = Tally(5)
    for part in np.split(values, [1, 10, 600], axis=1):
        tally.add(reward=part, match=part > 3)
    result = tally.result()
    assert result.trials == 1000
    own = values.mean(axis=0)
    mean = result.mean("reward")
    assert mean.value == pytest.approx(own.mean())
    assert mean.ci95 == pytest.approx(student95(999) * own.std(ddof=1) / math.sqrt(1000))
    curve = result.curve("reward")
    assert curve.value == pytest.approx(values.mean(axis=1))
    expected = student95(999) * values.std(axis=1, ddof=1) / math.sqrt(1000)
    assert curve.ci95 == pytest.approx(expected)
    assert result.mean("match").value == pytest.approx((values > 3).mean())


def test_a_single_trial_has_no_interval() -> None:
    tally = Tally(2)
    tally.add(reward=np.ones((2, 1)))
    assert tally.result().mean("reward").value == 1
    assert math.isnan(tally.result().mean("reward").ci95)


def test_equal_trials_have_an_interval_of_none() -> None:
    tally = Tally(1)
    tally.add(reward=np.full((1, 30), 0.1))
    assert tally.result().mean("reward").ci95 == pytest.approx(0, abs=1e-9)


def test_intervals_hold_the_truth_95_times_in_100() -> None:
    random = np.random.default_rng(1)
    held = 0
    for _ in range(2000):
        tally = Tally(1)
        tally.add(reward=random.normal(0, 1, (1, 5)))
        mean = tally.result().mean("reward")
        held += abs(mean.value) <= mean.ci95
    assert held / 2000 == pytest.approx(0.95, abs=0.015)


@pytest.mark.parametrize(
    ("freedom", "t"),
    # A table of Student's t, two-sided 95 %.
    [
        (1, 12.706),
        (2, 4.303),
        (3, 3.182),
        (4, 2.776),
        (5, 2.571),
        (10, 2.228),
        (29, 2.045),
        (1000, 1.962),
    ],
)
def test_students_t(freedom: int, t: float) -> None:
    assert student95(freedom) == pytest.approx(t, abs=0.001)
