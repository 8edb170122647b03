"""The learners of values, SARSA to Kalman temporal differences, worked out by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from adaptation.learners.expected_sarsa import ExpectedSarsa
from adaptation.learners.ktd import KTD
from adaptation.learners.qv_learning import QVLearning
from adaptation.learners.sarsa import Sarsa
from tests.adaptation.learner_talk import choices, hear

# Explore or not, and which of equal actions.
THIRDS = np.array([[0.99, 0.99, 0.99], [0.1, 0.5, 0.9]])


def test_sarsa_by_hand() -> None:
    learner = Sarsa(trials=1, epsilon=0.0, alpha=0.5, gamma=0.5, initial=0.0)
    hear(learner, 0, 1, 1.0)
    assert not learner.table.any()
    hear(learner, 1, 1, -1.0)
    # Q(0, up) = 0.5 · (1 + 0.5 · Q(1, keep)), with Q(1, keep) still 0.
    assert learner.table[0, 2].tolist() == [0, 0, 0.5]
    hear(learner, 1, 0, 0.5)
    # Q(1, keep) = 0.5 · (-1 + 0.5 · Q(1, down)), with 0 again.
    assert learner.table[0, 3].tolist() == [0, -0.5, 0]
    hear(learner, 0, 1, 1.0)
    # Q(1, down) = 0.5 · (0.5 + 0.5 · Q(0, up)), with 0.5.
    assert learner.table[0, 3].tolist() == [0.375, -0.5, 0]


def test_sarsa_does_not_repeat_what_has_just_displeased() -> None:
    learner = Sarsa(trials=1, epsilon=0.0, alpha=0.5, gamma=0.5, initial=0.0)
    hear(learner, 0, 0, -1.0)
    assert choices(learner, 0, THIRDS) == [-1, 1, 1]
    # In another state that says nothing.
    assert choices(learner, 1, THIRDS) == [-1, 0, 1]


def test_expected_sarsa_by_hand() -> None:
    learner = ExpectedSarsa(trials=1, epsilon=0.3, alpha=0.5, gamma=0.5, initial=0.0)
    hear(learner, 0, 1, 1.0)
    assert learner.table[0, 2].tolist() == [0, 0, 0.5]
    hear(learner, 1, 0, -1.0)
    # What is next in X = 0 is worth 0.7 · 0.5 + 0.3 · 0.5 / 3 = 0.4.
    assert learner.table[0, 3] == pytest.approx([0.5 * (-1 + 0.5 * 0.4), 0, 0])


def test_qv_learning_by_hand() -> None:
    learner = QVLearning(trials=1, epsilon=0.0, alpha=0.5, beta=0.2, gamma=0.5, initial=0.0)
    hear(learner, 0, 1, 1.0)
    assert learner.worth[0] == pytest.approx([0, 0, 0.2, 0, 0])
    assert learner.table[0, 2].tolist() == [0, 0, 0.5]
    hear(learner, 1, 0, -1.0)
    # Both go towards -1 + 0.5 · 0.2.
    assert learner.worth[0] == pytest.approx([0, 0, 0.2, 0.2 * -0.9, 0])
    assert learner.table[0, 3] == pytest.approx([0.5 * -0.9, 0, 0])
    hear(learner, 0, 0, 0.0)
    # V of the state itself is that of before: towards 0.5 · 0.2.
    assert learner.worth[0, 2] == pytest.approx(0.2 + 0.2 * (0.1 - 0.2))
    assert learner.table[0, 2] == pytest.approx([0, 0.5 * 0.1, 0.5])


def test_ktd_without_a_future_is_a_kalman_filter() -> None:
    learner = KTD(trials=1, gamma=0.0, initial=0.0, variance=1.0, noise=0.5, drift=0.25)
    hear(learner, 0, 1, 1.0)
    # Variance 1 + 0.25, gain 1.25 / 1.75.
    gain = 1.25 / 1.75
    variance = 1.25 * (1 - gain)
    assert learner.mean[0, 8] == pytest.approx(gain)
    assert learner.covariance[0, 8, 8] == pytest.approx(variance)
    hear(learner, 0, 1, 1.0)
    second = (variance + 0.25) / (variance + 0.75)
    assert learner.mean[0, 8] == pytest.approx(gain + second * (1 - gain))
    others = np.delete(learner.mean[0], 8)
    assert np.abs(others).max() < 1e-12


def test_ktd_of_what_is_certain_takes_the_maximum() -> None:
    """With three next values far apart the maximum is linear, and the filter exact."""
    learner = KTD(trials=1, gamma=0.5, initial=0.0, variance=0.01, noise=0.01, drift=0.0)
    learner.mean[0, 9:12] = [0.0, 2.0, -3.0]
    hear(learner, 0, 1, 1.0)
    # Reward = Q(0, up) - 0.5 · Q(1, keep): variance 0.01 · (1 + 0.25) + 0.01, 1 - (-1) is amiss.
    share = 0.01 / 0.0225
    assert learner.mean[0, 8] == pytest.approx(share * 2)
    assert learner.mean[0, 10] == pytest.approx(2 - 0.5 * share * 2)
    assert learner.mean[0, [9, 11]] == pytest.approx([0, -3])
    assert learner.covariance[0, 8, 10] == pytest.approx(0.01 * share / 2)


def test_ktd_takes_the_mean_of_the_maximum() -> None:
    """The sigma points of three equal values lie at ± √n times their deviation, one by one."""
    learner = KTD(trials=1, gamma=1.0, initial=0.0, variance=1.0, noise=1.0, drift=0.0)
    hear(learner, 0, 1, 0.0)
    # Each of 30 points: Q(0, up) ± √15 cancel out; each next value adds + √15 once.
    expected = -3 * math.sqrt(15) / 30
    up_down = [15.0, 15.0, *[15.0] * 3]
    variance = sum(up_down) / 30 - expected**2 + 1
    assert learner.mean[0, 8] == pytest.approx(-expected * 1 / variance)


@pytest.mark.parametrize("kind", [Sarsa, ExpectedSarsa, QVLearning])
def test_with_e_in_the_state_what_was_learned_elsewhere_is_not_known(
    kind: type[Sarsa | ExpectedSarsa | QVLearning],
) -> None:
    learner = kind(trials=1, state="ex", epsilon=0.0, initial=0.0)
    for _ in range(3):
        hear(learner, 0, 0, -1.0, engagement=(1, 1))
    assert choices(learner, 0, THIRDS, engagement=1.0) == [-1, 1, 1]
    assert choices(learner, 0, THIRDS, engagement=0.0) == [-1, 0, 1]
    assert learner.table.shape == (1, 25, 3)
    assert kind(trials=1, state="x").table.shape == (1, 5, 3)


def test_ktd_with_e_in_the_state() -> None:
    learner = KTD(trials=1, state="ex", epsilon=0.0, initial=0.0)
    for _ in range(3):
        hear(learner, 0, 0, -1.0, engagement=(1, 1))
    assert 0 not in choices(learner, 0, THIRDS, engagement=1.0)
    assert choices(learner, 0, THIRDS, engagement=0.0) == [-1, 0, 1]
    assert learner.covariance.shape == (1, 75, 75)
