"""Learners side by side: records and table."""

from __future__ import annotations

import json

import pytest

from adaptation.comparison import compare, table
from adaptation.experiment import Experiment
from adaptation.listeners import listener
from personage_lite.errors import PersonageError


def test_a_record_holds_what_its_run_gave() -> None:
    protocol = Experiment(listener("near"), trials=40, steps=6, seed=9, changes=(3,))
    (run,) = compare(["q-learning"], [0.25], protocol)
    record = json.loads(json.dumps(run.record(), allow_nan=False))
    assert record["learner"] == "q-learning"
    assert (record["noise"], record["listener_noise"], record["sensor_noise"]) == (0.25,) * 3
    assert (record["trials"], record["steps"], record["seed"]) == (40, 6, 9)
    assert (record["listener"], record["changes"], record["floor_bonus"]) == ("near", [3], True)
    for measure in ("reward", "match", "engagement"):
        curve = record[f"{measure}_by_step"]
        assert len(curve) == len(record[f"{measure}_by_step_ci95"]) == 6
        assert record[f"mean_{measure}"] == pytest.approx(sum(curve) / 6, abs=1e-5)
        assert record[f"mean_{measure}_ci95"] > 0
    assert all(0 <= share <= 1 for share in record["match_by_step"])


def test_one_trial_has_no_interval() -> None:
    (run,) = compare(["random"], [0.0], Experiment(listener("match"), trials=1))
    assert run.record()["mean_reward_ci95"] is None
    assert "± ?" in table([run])


def test_a_coin_can_be_fixed() -> None:
    runs = compare(["random"], [0.0, 0.5], Experiment(listener("match")), sensor_noise=0.1)
    records = [run.record() for run in runs]
    assert [record["listener_noise"] for record in records] == [0, 0.5]
    assert [record["sensor_noise"] for record in records] == [0.1, 0.1]


def test_faults_come_before_anything_is_run() -> None:
    with pytest.raises(PersonageError, match="no learner 'dice'"):
        compare(["random", "dice"], [0.0], Experiment(listener("match")))
    with pytest.raises(PersonageError, match="noise: 2"):
        compare(["random"], [0.0, 2], Experiment(listener("match")))


def test_the_table_lines_up() -> None:
    protocol = Experiment(listener("match"), trials=5)
    runs = list(compare(["random", "expected-sarsa"], [0.0, 0.25], protocol))
    shown = table(runs, compare(["oracle"], [0.0], protocol)).splitlines()
    head = shown[3]
    rows = [line for line in shown[4:] if "±" in line]
    assert len(rows) == 5
    assert {len(line) for line in rows} == {len(head)}
    assert rows[-1].startswith("oracle ")


def test_progress_over_all_runs() -> None:
    shares: list[float] = []
    list(
        compare(
            ["random", "oracle"], [0.0, 0.1], Experiment(listener("match")), progress=shares.append
        )
    )
    assert shares == sorted(shares)
    assert shares[0] < 0.1
    assert shares[-1] == 1
