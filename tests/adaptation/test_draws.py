"""Random numbers: the same everywhere, and a trial's own."""

from __future__ import annotations

import numpy as np
import pytest

from adaptation.draws import STREAMS, Draws


@pytest.mark.parametrize("blocks", [(1000,), (1, 999), (128, 128, 744), (500, 500)])
@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_trials_numbers_do_not_depend_on_how_many_there_are(
    blocks: tuple[int, ...], count: int
) -> None:
    whole = Draws(3).uniform("listener", 1000, 7, count)
    draws = Draws(3)
    parts = [draws.uniform("listener", trials, 7, count) for trials in blocks]
    assert (np.concatenate(parts, axis=2) == whole).all()


@pytest.mark.parametrize("blocks", [(300,), (1, 299), (128, 172)])
def test_the_same_of_normal_numbers(blocks: tuple[int, ...]) -> None:
    whole = Draws(3).normal("stream", 300, 11)
    draws = Draws(3)
    parts = [draws.normal("stream", trials, 11) for trials in blocks]
    assert (np.concatenate(parts, axis=1) == whole).all()


def test_the_numbers_are_these_on_every_machine() -> None:
    # Philox with this seed and stream: whoever changes them changes every published figure.
    first = Draws(0).uniform("learner", 2, 1, 2)
    assert first.shape == (1, 2, 2)
    assert (first * 2**32 - 0.5).astype(int).ravel().tolist() == [
        3892482491,
        4149437614,
        2247643693,
        2764105933,
    ]


def test_they_are_even_and_never_at_the_ends() -> None:
    numbers = Draws(1).uniform("sensor", 10_000, 10, 2)
    assert 0 < numbers.min() < numbers.max() < 1
    counts, _ = np.histogram(numbers, bins=20, range=(0, 1))
    assert np.abs(counts / numbers.size - 0.05).max() < 0.002


def test_streams_and_seeds_differ() -> None:
    draws = [Draws(seed).uniform(name, 5, 5, 1) for seed in (0, 1, 2**63 - 1) for name in STREAMS]
    assert len({numbers.tobytes() for numbers in draws}) == len(draws)


def test_no_numbers_at_all() -> None:
    assert Draws(0).uniform("learner", 4, 3, 0).shape == (3, 0, 4)
