"""The policy gradient, worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from adaptation.learners.pgrl import PGRL
from tests.adaptation.learner_talk import choices, hear

HALVES = np.array([[0.1, 0.4, 0.6, 0.9]])


def test_a_round_by_hand() -> None:
    learner = PGRL(trials=1, evaluations=2)
    # First twice at the centre, whatever is drawn.
    assert choices(learner, 0, HALVES) == [0, 0, 0, 0]
    hear(learner, 0, 0, -1.0)
    assert choices(learner, 0, HALVES) == [0, 0, 0, 0]
    hear(learner, 0, 0, 0.0)
    # Then to either side.
    assert choices(learner, 0, HALVES) == [-1, -1, 1, 1]
    hear(learner, 0, -1, -0.75)
    # And to the other, by way of the centre, which is heard once more.
    assert choices(learner, -1, HALVES) == [1, 1, 1, 1]
    hear(learner, -1, 0, -1.0)
    assert learner.counts.tolist() == [[1, 3, 0]]
    assert learner.sums.tolist() == [[-0.75, -2, 0]]
    hear(learner, 0, 1, -0.5)
    # -0.5 above is more than -0.75 below and -0.67 at the centre.
    assert learner.centre.tolist() == [1]
    assert learner.counts.tolist() == [[0, 0, 0]]
    assert learner.sums.tolist() == [[0, 0, 0]]


@pytest.mark.parametrize(
    ("rewards", "order", "centre"),
    [
        ({0: 1.0, -1: 0.5, 1: 0.5}, (0, -1, 1), 0),
        ({0: 1.0, -1: 1.5, 1: 1.25}, (0, -1, 1), -1),
        ({0: 0.0, -1: 0.0, 1: 0.5}, (0, -1, 1), 1),
        # Neither side is better: on to the one heard last.
        ({0: 0.0, -1: 0.0, 1: 0.0}, (0, -1, 1), 1),
        ({0: 0.0, -1: 0.0, 1: 0.0}, (0, 1, -1), -1),
        ({0: -1.0, -1: 0.0, 1: 0.0}, (0, 1, -1), -1),
    ],
)
def test_where_a_round_leads(
    rewards: dict[int, float], order: tuple[int, ...], centre: int
) -> None:
    learner = PGRL(trials=1, evaluations=1)
    for x in order:
        hear(learner, 0, x, rewards[x])
    assert learner.centre.tolist() == [centre]


def test_at_the_end_of_the_scale_there_is_one_side() -> None:
    learner = PGRL(trials=1, evaluations=1)
    learner.centre[:] = 2
    hear(learner, 2, 2, 0.0)
    assert choices(learner, 2, HALVES) == [-1, -1, -1, -1]
    hear(learner, 2, 1, -1.0)
    assert learner.centre.tolist() == [2]
    hear(learner, 2, 2, 0.0)
    hear(learner, 2, 1, 0.5)
    assert learner.centre.tolist() == [1]


def test_what_is_far_off_counts_for_nothing() -> None:
    learner = PGRL(trials=1)
    hear(learner, 2, 2, 1.0)
    assert learner.counts.tolist() == [[0, 0, 0]]
    assert choices(learner, 2, HALVES) == [-1, -1, -1, -1]
