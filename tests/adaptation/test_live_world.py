"""Listeners in real time: stream, 5 s average, sensor."""

from __future__ import annotations

import math

import numpy as np
import pytest

from adaptation.draws import Draws
from adaptation.experiment import Experiment
from adaptation.listeners.live import Live
from adaptation.live_world import WINDOW, LiveWorld, Sensor
from adaptation.problem import Floats, Outcome
from adaptation.world import Coins, Noise
from personage_lite.errors import PersonageError

STEPS = 4
NO_COINS = Coins(None, None)


def world(trials: int, sensor: Sensor, coins: Coins = NO_COINS) -> LiveWorld:
    fresh = np.random.default_rng(0).standard_normal((WINDOW + STEPS * 60, trials))
    return LiveWorld(Live(), trials, Noise(0.5, 0.5), coins, fresh, sensor)


def talk(subject: LiveWorld, xs: list[list[int]], preference: list[int]) -> list[Outcome]:
    return [subject.hear(step, np.array(x), np.array(preference)) for step, x in enumerate(xs)]


def relaxed(start: float, target: float, seconds: float) -> float:
    return target + (start - target) * math.exp(-seconds / 8)


def test_without_noise_the_stream_is_the_true_course() -> None:
    subject = world(2, Sensor(sigma=0))
    first, second = talk(subject, [[-2, 2], [-1, 1]], [-2, 1])
    assert first.duration is not None
    assert first.stream is not None
    assert first.duration.tolist() == [4, 12]
    assert first.stream.shape == (2, 60)
    for trial, (samples, target) in enumerate([(20, 2), (60, 1)]):
        path = [relaxed(0, target, 0.2 * (number + 1)) for number in range(samples)]
        assert first.stream[trial, :samples].tolist() == pytest.approx(path)
        assert np.isnan(first.stream[trial, samples:]).all()
    assert second.stream is not None
    assert second.stream[0, 0] == pytest.approx(relaxed(first.stream[0, 19], 1, 0.2))
    assert second.stream[1, 0] == pytest.approx(relaxed(first.stream[1, 59], 2, 0.2))


def test_the_five_second_average_of_a_short_utterance_holds_the_one_before() -> None:
    subject = world(1, Sensor(sigma=0))
    first, second = talk(subject, [[-1], [-2]], [0])
    assert first.stream is not None
    assert second.stream is not None
    # The first lasts 6 s, 30 samples, the second 4 s, 20: five of the average are of the first.
    assert first.engagement[0] == pytest.approx(first.stream[0, 5:30].mean())
    window = np.concatenate((first.stream[0, 25:30], second.stream[0, :20]))
    assert second.engagement[0] == pytest.approx(window.mean())
    assert second.reward[0] == pytest.approx(window.mean() - first.engagement[0])
    # And of a first short one, five from before the talk, when E was 0.
    (only,) = talk(world(1, Sensor(sigma=0)), [[-2]], [0])
    assert only.stream is not None
    assert only.engagement[0] == pytest.approx(only.stream[0, :20].sum() / 25)


def test_true_engagement_is_the_mean_over_the_utterance() -> None:
    subject = world(1, Sensor(sigma=0))
    (outcome,) = talk(subject, [[0]], [1])
    assert outcome.stream is not None
    assert subject.engagement[0] == pytest.approx(outcome.stream[0, :40].mean())


@pytest.mark.parametrize("memory", [0.0, 2.0])
def test_the_errors_spread_and_last_as_they_should(memory: float) -> None:
    sensor = Sensor(sigma=0.5, memory=memory)
    fresh = np.random.default_rng(1).standard_normal((4000, 200))
    errors = sensor.errors(sensor.sigma * fresh[0], fresh[1:])
    assert errors.std() == pytest.approx(0.5, abs=0.01)
    assert abs(errors.mean()) < 0.01
    for lag in (1, 10):
        expected = math.exp(-0.2 * lag / memory) if memory else 0
        found = np.corrcoef(errors[:-lag].ravel(), errors[lag:].ravel())[0, 1]
        assert found == pytest.approx(expected, abs=0.02)


def test_errors_go_on_from_one_utterance_to_the_next() -> None:
    # Of perfectly lasting errors all are the same: before, during and after short utterances.
    subject = world(300, Sensor(sigma=0.5, memory=1e12))
    first, second = talk(subject, [[-2] * 300, [2] * 300], [0] * 300)
    true = world(300, Sensor(sigma=0))
    without = talk(true, [[-2] * 300, [2] * 300], [0] * 300)
    assert first.stream is not None
    assert second.stream is not None
    errors = [
        (with_errors.stream - plain.stream)[:, 0]
        for with_errors, plain in zip((first, second), without, strict=True)
        if with_errors.stream is not None and plain.stream is not None
    ]
    assert errors[0] == pytest.approx(errors[1], abs=1e-4)
    assert errors[0].std() == pytest.approx(0.5, abs=0.06)


def _coin(fall: float, which: float) -> Floats:
    return np.tile(np.array([fall, which]).reshape(1, 2, 1), (STEPS, 1, 1))


def test_the_papers_coins() -> None:
    sensor = Sensor(sigma=0)
    (plain,) = talk(world(1, sensor), [[0]], [0])
    (shifted,) = talk(world(1, sensor, Coins(None, _coin(0.1, 0.9))), [[0]], [0])
    assert plain.stream is not None
    assert shifted.stream is not None
    assert (shifted.stream - plain.stream)[0, :40] == pytest.approx(1)
    # The listener answers as if it preferred the level that the draw stands for: here, 2.
    (other,) = talk(world(1, sensor, Coins(_coin(0.1, 0.99), None)), [[0]], [0])
    (meant,) = talk(world(1, sensor), [[0]], [2])
    assert other.stream is not None
    assert meant.stream is not None
    assert other.stream[0, :40].tolist() == meant.stream[0, :40].tolist()


def test_the_bonus_never_fires() -> None:
    experiment = Experiment(Live(), trials=200)
    subject = experiment.world(200, Draws(0))
    before = subject.sensed
    for step in range(30):
        outcome = subject.hear(step, np.zeros(200, dtype=np.int64), np.zeros(200, dtype=np.int64))
        assert (outcome.reward == outcome.engagement - before).all()
        before = outcome.engagement


@pytest.mark.parametrize(
    "settings", [{"sigma": -1}, {"sigma": math.nan}, {"memory": -0.1}, {"memory": math.inf}]
)
def test_an_impossible_sensor(settings: dict[str, float]) -> None:
    with pytest.raises(PersonageError, match=r"sensor: \w+ is .*; give a number from 0 up"):
        Sensor(**settings)
