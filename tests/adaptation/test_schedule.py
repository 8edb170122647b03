"""What the listener prefers, step by step."""

from __future__ import annotations

import numpy as np

from adaptation.draws import Draws
from adaptation.experiment import Experiment
from adaptation.listeners import listener
from adaptation.schedule import drawn_levels, preferences


def test_it_changes_before_the_named_utterances_only() -> None:
    experiment = Experiment(listener("match"), trials=2000)
    preference = experiment.preference(2000, Draws(0))
    assert preference.shape == (30, 2000)
    changed = np.flatnonzero((np.diff(preference, axis=0) != 0).any(axis=1))
    # The rows are numbered from 0: a change before utterance 15 stands between rows 13 and 14.
    assert (changed + 2).tolist() == [15, 26]


def test_all_levels_are_as_likely_and_may_return() -> None:
    experiment = Experiment(listener("match"), trials=20_000)
    preference = experiment.preference(20_000, Draws(0))
    for row in (0, 14, 25):
        assert np.abs(np.bincount(preference[row] + 2) / 20_000 - 0.2).max() < 0.01
    assert abs((preference[13] == preference[14]).mean() - 0.2) < 0.01


def test_changes_after_the_end_never_come() -> None:
    assert drawn_levels((15, 26), steps=20) == 2
    draws = np.array([[0.1], [0.9]])
    assert preferences(draws, 20, (15, 26))[:, 0].tolist() == [-2] * 14 + [2] * 6
    assert preferences(draws[:1], 3, ()).tolist() == [[-2]] * 3
