"""What all learners of the paper's related work have in common."""

from __future__ import annotations

import copy
import json
import math
from typing import Any

import numpy as np
import pytest

from adaptation.experiment import Experiment
from adaptation.learners import LEARNERS
from adaptation.listeners import listener
from adaptation.problem import LEVELS, Choice, Context, Floats, Ints, Outcome
from personage_lite.errors import PersonageError
from tests.adaptation.learner_talk import talk

BANDITS = ("epsilon-greedy", "ucb", "sliding-window-ucb", "discounted-ucb", "thompson")
VALUES = ("sarsa", "expected-sarsa", "qv-learning", "ktd")
ALL = (*BANDITS, *VALUES, "pgrl")
TRIALS, STEPS = 25, 30


def _draws(name: str, trials: int = TRIALS) -> Floats:
    return np.random.default_rng(5).random((STEPS, LEARNERS[name].draws, trials))


@pytest.mark.parametrize("name", ALL)
def test_it_finds_what_an_easy_listener_likes(name: str) -> None:
    preference = np.repeat(LEVELS, 40)
    learner = LEARNERS[name](len(preference))
    x: Ints = np.zeros(len(preference), dtype=np.int64)
    draws = _draws(name, len(preference))
    late = []
    for step in range(STEPS):
        x = talk(learner, preference, draws[step], x, step)
        late.append(x == preference)
    # The policy gradient never stops to look to either side.
    assert np.mean(late[-10:]) > (0.5 if name == "pgrl" else 0.8)


@pytest.mark.parametrize("name", ALL)
def test_restored_in_the_middle_it_goes_on_identically(name: str) -> None:
    preference = np.tile(LEVELS, TRIALS // 5)
    draws = _draws(name)
    learner = LEARNERS[name](TRIALS)
    x: Ints = np.zeros(TRIALS, dtype=np.int64)
    for step in range(11):
        x = talk(learner, preference, draws[step], x, step)
    restored = LEARNERS[name].restore(json.loads(json.dumps(learner.save(), allow_nan=False)))
    other = x
    for step in range(11, STEPS):
        x = talk(learner, preference, draws[step], x, step)
        other = talk(restored, preference, draws[step], other, step)
        assert (x == other).all()
    assert restored.save() == learner.save()


@pytest.mark.parametrize("name", ALL)
def test_a_batch_learns_what_its_trials_learn_alone(name: str) -> None:
    preference = np.tile(LEVELS, TRIALS // 5)
    draws = _draws(name)
    batch = LEARNERS[name](TRIALS)
    singles = [LEARNERS[name](1) for _ in range(TRIALS)]
    x: Ints = np.zeros(TRIALS, dtype=np.int64)
    alone = [np.zeros(1, dtype=np.int64) for _ in singles]
    for step in range(STEPS):
        x = talk(batch, preference, draws[step], x, step)
        for i, single in enumerate(singles):
            part = draws[step][:, i : i + 1]
            alone[i] = talk(single, preference[i : i + 1], part, alone[i], step)
        assert (x == np.concatenate(alone)).all()
    state = batch.save()["state"]
    for i, single in enumerate(singles):
        for key, values in single.save()["state"].items():
            np.testing.assert_allclose(state[key][i], values[0], rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize("name", ALL)
def test_what_is_no_number_is_refused(name: str) -> None:
    learner = LEARNERS[name](2)
    before = learner.save()
    still = np.zeros(2, dtype=np.int64)
    context, choice = Context(0, still, np.zeros(2)), Choice(still, np.ones(2))
    fair = Outcome(np.zeros(2), still, np.zeros(2), duration=np.full(2, 6.0))
    for field in ("reward", "engagement", "duration"):
        for bad in (math.nan, math.inf):
            outcome = fair._replace(**{field: np.array([0.0, bad])})
            with pytest.raises(PersonageError, match=f"{name}: {field} is .* in trial 2"):
                learner.learn(context, choice, outcome)
    assert learner.save() == before


@pytest.mark.parametrize("name", [name for name in ALL if name != "pgrl"])
@pytest.mark.parametrize("x", [-1, 0, 1])
def test_at_first_it_may_do_anything(name: str, x: int) -> None:
    """Of equal values none is preferred: the bandits stay then, as the way costs utterances."""
    draws = np.random.default_rng(1).random((LEARNERS[name].draws, 2000))
    learner = LEARNERS[name](2000)
    zero = np.zeros(2000)
    action = learner.choose(Context(0, np.full(2000, x), zero), draws).action
    shares = [(action == a).mean() for a in (-1, 0, 1)]
    if name in VALUES:
        assert shares == pytest.approx([1 / 3] * 3, abs=0.03)
    elif name == "thompson":
        assert shares == pytest.approx([(x + 2) / 5, 1 / 5, (2 - x) / 5], abs=0.03)
    else:
        assert shares[1] > 0.95


@pytest.mark.parametrize("name", ALL)
def test_the_probability_is_how_often_it_acts_so(name: str) -> None:
    trials = 4000
    learner = LEARNERS[name](trials)
    preference = np.ones(trials, dtype=np.int64)
    one = np.random.default_rng(3).random((4, learner.draws, 1))
    x: Ints = np.zeros(trials, dtype=np.int64)
    for step in range(4):
        x = talk(learner, preference, np.repeat(one[step], trials, axis=1), x, step)
    draws = np.random.default_rng(4).random((learner.draws, trials))
    choice = learner.choose(Context(4, x, np.zeros(trials)), draws)
    for action in (-1, 0, 1):
        share = (choice.action == action).mean()
        if share:
            probability = choice.probability[choice.action == action]
            assert probability == pytest.approx(np.full(len(probability), share), abs=0.03)


@pytest.mark.parametrize(
    ("setting", "value"),
    [
        ("epsilon", 1.5),
        ("alpha", -0.1),
        ("beta", math.nan),
        ("gamma", "much"),
        ("state", "e"),
        ("initial", math.inf),
        ("exploration", -1),
        ("weight", -0.5),
        ("prior", 3),
        ("discount", 1.01),
        ("window", 0),
        ("window", 2.5),
        ("deviation", 0),
        ("evaluations", 0),
        ("variance", 0),
        ("noise", 0),
        ("drift", -1),
        ("tau", -8),
        ("tau", True),
    ],
)
def test_settings_out_of_range_are_refused(setting: str, value: Any) -> None:
    known = [name for name in ALL if setting in LEARNERS[name](1).save()["settings"]]
    assert known
    for name in known:
        with pytest.raises(PersonageError, match=f"{name}: {setting} is "):
            LEARNERS[name](1, **{setting: value})
    for name in set(ALL) - set(known):
        with pytest.raises(TypeError, match=setting):
            LEARNERS[name](1, **{setting: value})


@pytest.mark.parametrize(
    ("name", "part", "value"),
    [
        ("discounted-ucb", "counts", [[-1.0, 0, 0, 0, 0]]),
        ("thompson", "counts", [[0, 0, 0, 0, -0.1]]),
        ("sliding-window-ucb", "arms", [[-1, -1, -1, 0, 1, 5]]),
        ("sliding-window-ucb", "arms", [[-2, -1, -1, 0, 1, 4]]),
        ("sarsa", "last_state", [5]),
        ("sarsa", "last_action", [2]),
        ("pgrl", "centre", [3]),
        ("pgrl", "counts", [[1.0, 3.0, 1.0]]),
        ("pgrl", "counts", [[-1.0, 0.0, 0.0]]),
        ("ktd", "covariance", np.zeros((1, 15, 15)).tolist()),
        ("qv-learning", "worth", [[0.0] * 4]),
        ("epsilon-greedy", "values", [[0.0, 0, 0, 0, math.nan]]),
    ],
)
def test_a_state_that_cannot_be_is_not_restored(name: str, part: str, value: Any) -> None:
    saved = copy.deepcopy(LEARNERS[name](1).save())
    assert LEARNERS[name].restore(saved).save() == saved
    saved["state"][part] = value
    with pytest.raises(PersonageError, match=f"{name}.*start afresh"):
        LEARNERS[name].restore(saved)


# Reward and match on the listener `match` without floor bonus, at noise 0, .2 and .5 (measured
# at 10,000 trials; the table is docs/adaptation.md's), and match on the listener `live`.
MEASURED: dict[str, tuple[tuple[float, float], tuple[float, float], tuple[float, float], float]] = {
    "sarsa": ((0.121, 0.488), (0.082, 0.389), (0.076, 0.286), 0.408),
    "expected-sarsa": ((0.122, 0.489), (0.082, 0.389), (0.077, 0.286), 0.409),
    "qv-learning": ((0.124, 0.498), (0.083, 0.396), (0.077, 0.290), 0.413),
    "ktd": ((0.128, 0.502), (0.084, 0.396), (0.078, 0.292), 0.416),
    "epsilon-greedy": ((0.270, 0.731), (0.139, 0.515), (0.094, 0.346), 0.527),
    "ucb": ((0.192, 0.639), (0.138, 0.533), (0.099, 0.372), 0.476),
    "sliding-window-ucb": ((0.290, 0.747), (0.154, 0.545), (0.098, 0.359), 0.580),
    "discounted-ucb": ((0.288, 0.746), (0.150, 0.532), (0.096, 0.352), 0.585),
    "thompson": ((0.253, 0.692), (0.145, 0.518), (0.096, 0.350), 0.542),
    "pgrl": ((0.017, 0.350), (0.043, 0.307), (0.068, 0.250), 0.307),
}


@pytest.mark.parametrize("name", ALL)
def test_it_does_as_well_as_was_measured(name: str) -> None:
    for noise, (reward, match) in zip((0.0, 0.2, 0.5), MEASURED[name][:3], strict=True):
        experiment = Experiment(
            listener("match"),
            trials=2000,
            seed=77,
            listener_noise=noise,
            sensor_noise=noise,
            floor_bonus=False,
        )
        result = experiment.run(LEARNERS[name])
        assert result.mean("reward").value == pytest.approx(reward, abs=0.02)
        assert result.mean("match").value == pytest.approx(match, abs=0.02)
    live = Experiment(listener("live"), trials=500, seed=77).run(LEARNERS[name])
    assert live.mean("match").value == pytest.approx(MEASURED[name][3], abs=0.04)
