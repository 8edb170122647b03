"""Remarks are understood by the words of the lexicon, and count as evidence."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from adaptation.belief.remarked import KINDS, by_preference
from adaptation.learners import LEARNERS
from adaptation.learners.base import Learner
from adaptation.learners.bayes import Bayes
from adaptation.problem import LEVELS, Choice, Context, Outcome, moved
from adaptation.storyteller.remarks import Remark, Remarks, heed
from personage_lite import Generator
from personage_lite.data import data_folder
from personage_lite.dialog_words import load_dialog_words
from personage_lite.errors import PersonageError

REMARKS = Remarks(Generator().dialog.remarks)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("less of that", Remark("less", of_that=True)),
        ("More of that!!", Remark("more", of_that=True)),
        ("calm down", Remark("less")),
        ("CALM DOWN, please.", Remark("less")),
        ("that's great", Remark("praise")),
        ("That’s great", Remark("praise")),
        ("boring", Remark("blame")),
        ("this is so boring…", Remark("blame")),
        ("it isn't boring", Remark("praise")),
        ("I like it", Remark("praise")),
        ("I don't like it: I hate it", Remark("blame")),
        ("I don't like it", Remark("blame")),
        ("I don’t like it", Remark("blame")),
        ("I really love it", Remark("praise")),
        ("I don't like that", Remark("less", of_that=True)),
        ("too loud", Remark("less")),
        ("that was not too loud", None),
        ("no more of that", Remark("less", of_that=True)),
        ("not great", Remark("blame")),
        ("not bad", Remark("praise")),
        ("lovely, but calm down", Remark("less")),
        ("boring… well, now I like it", Remark("praise")),
        ("speak up, I can't hear you", Remark("more")),
        ("the White Rabbit", None),
        ("yes", None),
        ("no", None),
        ("greatness", None),
        ("", None),
        ("\0" * 10_000, None),
        ("boring " * 10_000, Remark("blame")),
    ],
)
def test_what_is_understood(text: str, expected: Remark | None) -> None:
    assert REMARKS.understood(text) == expected


def test_every_phrase_of_the_lexicon_means_what_it_stands_under() -> None:
    for kind, phrases in Generator().dialog.remarks.items():
        if kind == "negation":
            continue
        for phrase in phrases:
            expected = Remark(kind.removesuffix("_of_that"), "of_that" in kind)  # type: ignore[arg-type]
            assert REMARKS.understood(f"Well, {phrase}!") == expected, phrase


def test_a_phrase_in_two_places_is_named_with_its_line(tmp_path: Path) -> None:
    shutil.copytree(data_folder("lexicons"), tmp_path / "words")
    path = tmp_path / "words" / "dialog.yaml"
    path.write_text(path.read_text("utf-8").replace("blame: [boring", "blame: [great, boring"))
    with pytest.raises(PersonageError, match=r"dialog.yaml:\d+: 'great' is praise as well; keep"):
        load_dialog_words(tmp_path / "words")


def remarked(learner: Learner, taste: int, steps: int, start: int = 0) -> list[int]:
    """Let a listener whom nothing senses say whether X should be less, more, or is right."""
    chance, x, xs = np.random.default_rng(0), np.array([start]), []
    for step in range(steps):
        context = Context(step, x, np.zeros(1))
        x = moved(x, learner.choose(context, chance.random((learner.draws, 1))).action)
        xs.append(int(x[0]))
        said = "praise" if x[0] == taste else "less" if x[0] > taste else "more"
        heed(learner, Remark(said), int(x[0]))  # type: ignore[arg-type]
    return xs


@pytest.mark.parametrize("taste", LEVELS.tolist())
def test_remarks_alone_move_x_to_the_taste(taste: int) -> None:
    xs = remarked(Bayes(1), taste, 12)
    assert xs[4:] == [taste] * 8


@pytest.mark.parametrize("taste", LEVELS.tolist())
@pytest.mark.parametrize(
    "name", ["q-learning", "sarsa", "expected-sarsa", "qv-learning", "ktd", "ucb", "discounted-ucb"]
)
def test_remarks_alone_teach_others_by_reward(name: str, taste: int) -> None:
    xs = remarked(LEARNERS[name](1), taste, 20)
    assert xs[10:].count(taste) >= 7


@pytest.mark.parametrize("name", ["always-zero", "random", "oracle"])
def test_who_learns_nothing_says_so(name: str) -> None:
    assert not heed(LEARNERS[name](1), Remark("less"), 0)
    assert not heed(Bayes(1), Remark("less"), None)


def preference(learner: Bayes) -> list[float]:
    return [float(value) for value in learner.belief().preference[:, 0]]


def shown(learner: Bayes, x: int, heads: float, utterances: int = 1) -> Bayes:
    """Let the sensor show a listener whose E heads for a level while X is spoken with."""
    for step in range(utterances):
        stream = heads * (1 - np.exp(-0.2 / 8 * np.arange(1, 61)))
        stream = stream + np.random.default_rng(step).normal(0, 0.4, 60)
        now = np.array([x])
        outcome = Outcome(np.ones(1), now, stream[-1:], stream[None], np.array([12.0]))
        learner.learn(
            Context(step, now, np.zeros(1)), Choice(np.zeros(1, int), np.ones(1)), outcome
        )
    return learner


def test_remarks_and_signals_are_weighed() -> None:
    signal = preference(shown(Bayes(1), 2, heads=2.0))
    assert max(signal) == signal[4]
    agreed, doubted = shown(Bayes(1), 2, heads=2.0), shown(Bayes(1), 2, heads=2.0)
    agreed.heed("praise", 2)
    doubted.heed("less", 2)
    assert preference(doubted)[4] < signal[4] < preference(agreed)[4]
    # Said again and again it outweighs what was sensed once …
    for _ in range(3):
        doubted.heed("less", 2)
    assert preference(doubted)[4] < 0.05
    # … and what is sensed again and again outweighs what was said once: that it must be less than
    # 2 may still be, if 1 is liked and 2 is near enough to please.
    often = Bayes(1)
    often.heed("less", 2)
    assert sum(preference(often)[:3]) > 0.7
    shown(often, 2, heads=2.0, utterances=3)
    assert sum(preference(often)[:3]) < 0.05


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("x", LEVELS.tolist())
def test_belief_stays_a_belief_and_follows_bayes_rule(kind: str, x: int) -> None:
    learner = shown(Bayes(1), 0, heads=1.0)
    before = learner.belief().preference[:, 0]
    learner.heed(kind, x)  # type: ignore[arg-type]
    expected = before * by_preference(kind, x)  # type: ignore[arg-type]
    assert learner.belief().preference[:, 0] == pytest.approx(expected / expected.sum())
    Bayes.restore(learner.save())


def test_what_is_hardly_heard_hardly_counts() -> None:
    sure, unsure, unheard = Bayes(1), Bayes(1), Bayes(1)
    sure.heed("less", 0)
    unsure.heed("less", 0, 0.3)
    unheard.heed("less", 0, 0.0)
    below = [sum(preference(learner)[:2]) for learner in (unheard, unsure, sure)]
    assert below == sorted(below)
    assert below[0] == pytest.approx(0.4)
    for kind, x, weight in (("loud", 0, 1), ("less", 3, 1), ("less", 0, 2), ("less", 0.5, 1)):
        with pytest.raises(PersonageError):
            sure.heed(kind, x, weight)  # type: ignore[arg-type]
