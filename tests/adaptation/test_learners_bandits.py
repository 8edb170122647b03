"""The bandits over the levels of X, worked out by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from adaptation.learners.bandit import nearest_best, step_towards
from adaptation.learners.credit import credited
from adaptation.learners.discounted_ucb import DiscountedUCB
from adaptation.learners.epsilon_greedy import EpsilonGreedy
from adaptation.learners.sliding_window_ucb import SlidingWindowUCB
from adaptation.learners.thompson import Thompson, chances_of_best
from adaptation.learners.ucb import UCB, upper_bounds
from adaptation.problem import Context, Floats, Outcome
from tests.adaptation.learner_talk import choices, hear

HALVES = np.array([[0.1, 0.4, 0.6, 0.9]])


def test_ucb_by_hand() -> None:
    bandit = UCB(trials=1, exploration=0.5, prior=0.0, weight=1.0)
    hear(bandit, 0, 0, -1)
    hear(bandit, 0, 1, 1)
    hear(bandit, 1, 1, 0.5)
    assert bandit.counts.tolist() == [[0, 0, 1, 2, 0]]
    assert bandit.sums.tolist() == [[0, 0, -1, 1.5, 0]]
    counts, means = bandit._means()
    assert counts.T.tolist() == [[1, 1, 2, 3, 1]]
    assert means.T.tolist() == [[0, 0, -0.5, 0.5, 0]]
    # t = 1 + 1 + 2 + 3 + 1 = 8.
    fresh = 0.5 * math.sqrt(math.log(8))
    bounds = [fresh, fresh, -0.5 + fresh / math.sqrt(2), 0.5 + fresh / math.sqrt(3), fresh]
    assert upper_bounds(counts, means, 0.5)[:, 0] == pytest.approx(bounds)
    # 0.92 at X = 1, 0.72 at levels not heard yet.
    assert choices(bandit, 1, HALVES) == [0, 0, 0, 0]
    hear(bandit, 1, 1, -1)
    hear(bandit, 1, 1, -1)
    # Now X = 2 is the nearest of those not heard yet.
    assert choices(bandit, 1, HALVES) == [1, 1, 1, 1]


def test_ucb_as_published_tries_each_level_first() -> None:
    bandit = UCB(trials=1, weight=0.0, exploration=math.sqrt(2))
    x, way = 0, []
    for step in range(8):
        action = choices(bandit, x, np.array([[0.6]]))[0]
        hear(bandit, x, x + action, 1.0 if step == 0 else 0.0)
        x += action
        way.append(x)
    # Each level once; then -2, 0 + √2 · √ln 7, seems better than 0, 1/2 + √2 · √(ln 7 / 2).
    assert way == [0, 1, 2, 1, 0, -1, -2, -2]


def test_discounted_ucb_by_hand() -> None:
    bandit = DiscountedUCB(trials=1, discount=0.5, exploration=1.0, prior=0.0, weight=0.0)
    hear(bandit, 0, -1, 1)
    hear(bandit, -1, -1, -1)
    hear(bandit, -1, 0, 0.5)
    # Heard two and three utterances ago: 1/2 and 1/4 of it are left.
    assert bandit.counts.tolist() == [[0, 0.75, 1, 0, 0]]
    assert bandit.sums.tolist() == [[0, 0.25 - 0.5, 0.5, 0, 0]]
    counts, means = bandit._means()
    log = math.log(1.75)
    bounds = [math.inf, -1 / 3 + math.sqrt(log / 0.75), 0.5 + math.sqrt(log), math.inf, math.inf]
    assert upper_bounds(counts, means, 1.0)[:, 0] == pytest.approx(bounds)


def test_sliding_window_ucb_by_hand() -> None:
    bandit = SlidingWindowUCB(trials=1, window=2, exploration=1.0, prior=0.5, weight=1.0)
    for before, after, reward in ((0, 0, 1.0), (0, 1, -1.0), (1, 1, 0.5)):
        hear(bandit, before, after, reward)
    assert bandit.counts.tolist() == [[0, 0, 0, 2, 0]]
    assert bandit.sums.tolist() == [[0, 0, 0, -0.5, 0]]
    counts, means = bandit._means()
    # (-1 + 0.5 + 1 · 0.5) / 3, and t = 2 + 5 · 1.
    root = math.sqrt(math.log(7))
    bounds = [0.5 + root, 0.5 + root, 0.5 + root, root / math.sqrt(3), 0.5 + root]
    assert upper_bounds(counts, means, 1.0)[:, 0] == pytest.approx(bounds)


def test_epsilon_greedy_by_hand() -> None:
    bandit = EpsilonGreedy(trials=1, epsilon=0.25, alpha=0.5, initial=0.0)
    hear(bandit, 0, 1, 1)
    hear(bandit, 1, 1, 0)
    hear(bandit, 1, 0, -1)
    assert bandit.values.tolist() == [[0, 0, -0.5, 0.25, 0]]
    # From X = 0 to the best level, 1, with 3/4 + 1/4 · 2/5, as X = 2 is that way, too.
    context = Context(0, np.array([0]), np.zeros(1))
    chosen = [bandit.choose(context, np.array([[draw]])) for draw in (0.05, 0.11, 0.5, 0.99)]
    assert [int(choice.action[0]) for choice in chosen] == [-1, 0, 1, 1]
    assert [float(c.probability[0]) for c in chosen] == pytest.approx([0.1, 0.05, 0.85, 0.85])


def test_thompson_by_hand() -> None:
    bandit = Thompson(trials=1, deviation=1.0, prior=0.0, weight=1.0, discount=0.5)
    hear(bandit, 0, 0, 1)
    hear(bandit, 0, 1, 2)
    # Means (1/2) / (1 + 1/2) and 2 / (1 + 1), variances 1 / (1 + 1/2) and 1 / (1 + 1).
    counts, means = bandit._means()
    assert means.T.tolist() == [[0, 0, pytest.approx(1 / 3), 1, 0]]
    assert (1 / counts).T.tolist() == [[1, 1, pytest.approx(2 / 3), 0.5, 1]]
    drawn = np.random.default_rng(2).normal(means, np.sqrt(1 / counts), (5, 200_000)).argmax(axis=0)
    shares = np.bincount(drawn, minlength=5) / 200_000
    assert bandit._chances(np.array([0]))[:, 0] == pytest.approx(shares, abs=0.005)


@pytest.mark.parametrize("seed", range(5))
def test_the_chances_of_being_best(seed: int) -> None:
    random = np.random.default_rng(seed)
    means, deviations = random.normal(0, 0.1, (5, 1)), random.uniform(0.03, 0.1, (5, 1))
    drawn = random.normal(means, deviations, (5, 200_000)).argmax(axis=0)
    shares = np.bincount(drawn, minlength=5) / 200_000
    chances = chances_of_best(means, deviations)
    assert chances[:, 0] == pytest.approx(shares, abs=0.008)
    assert chances.sum() == pytest.approx(1)


def test_of_two_levels_as_near_either_is_drawn() -> None:
    values = np.array([[0.0], [1], [0], [1], [0]])
    chances = nearest_best(values, np.array([0]))
    actions = [
        int(step_towards(chances, np.array([0]), np.array([d])).action[0]) for d in HALVES[0]
    ]
    assert actions == [-1, -1, 1, 1]
    assert nearest_best(values, np.array([-2])).T.tolist() == [[0, 1, 0, 0, 0]]


@pytest.mark.parametrize("draw", [0.0, 0.5, 1 - 2**-53])
def test_a_level_without_a_chance_is_never_drawn(draw: float) -> None:
    tenths: Floats = np.array([[0.0], [0.1], [0.7], [0.2], [0.0]])
    choice = step_towards(tenths, np.array([-1]), np.array([draw]))
    assert choice.action[0] in (0, 1)
    assert 0 < choice.probability[0] <= 1


def test_credit_in_real_time() -> None:
    """From 0.5 E went to 0.9 in 4 s: 1 - exp(-4/8) = 39 % of the way to 1.517, that less 1."""
    context = Context(0, np.array([0]), np.array([0.5]))
    outcome = Outcome(np.array([0.4]), np.array([0]), np.array([0.9]), duration=np.array([4.0]))
    level = 0.5 + 0.4 / (1 - math.exp(-0.5))
    assert credited(context, outcome, tau=8)[0] == pytest.approx(level - 1)
    assert credited(context, outcome, tau=0)[0] == pytest.approx(-0.1)
    assert credited(context, outcome._replace(duration=None), tau=8)[0] == 0.4
    # No level lies beyond 2.
    sudden = outcome._replace(duration=np.array([0.2]))
    assert credited(context, sudden, tau=8)[0] == 1


def test_a_bandit_takes_the_credit_of_what_was_spoken() -> None:
    bandit = EpsilonGreedy(trials=1, alpha=1.0, initial=0.0)
    context = Context(0, np.array([0]), np.array([0.0]))
    choice = bandit.choose(context, np.array([[0.5]]))
    outcome = Outcome(np.zeros(1), np.array([1]), np.array([1.2]), duration=np.array([8.0]))
    bandit.learn(context, choice, outcome)
    expected = 1.2 / (1 - math.exp(-1)) - 1
    assert bandit.values[0] == pytest.approx([0, 0, 0, expected, 0])
