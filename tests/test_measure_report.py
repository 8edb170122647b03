"""The report: statistics, groups, trends, verdicts, richness, and reading what is measured."""

from __future__ import annotations

import statistics
import sys
from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from personage_lite import Generator
from personage_lite.errors import PersonageError
from personage_lite.measure import Report, Said, Value, measure, read_utterances
from personage_lite.measure import statistics as own
from personage_lite.measure.table import records, table
from tests.mutation import check_message


def values(report: Report, name: str) -> tuple[Value, ...]:
    return next(row.values for row in report.rows if row.feature.name == name)


# Statistics


def test_spearman() -> None:
    first = [1.0, 2, 2, 3, 4, 5, 6, 7, 8, 9]
    assert own.rank_correlation(first, first) == pytest.approx(1)
    assert own.rank_correlation(first, [-x for x in first]) == pytest.approx(-1)
    assert own.rank_correlation(first, [1.0] * 10) is None
    assert own.rank_correlation(first[:9], first[:9]) is None
    swapped = [2.0, 1, 4, 3, 6, 5, 8, 7, 10, 9]
    # Without ties: 1 - 6 * sum(d^2) / (n (n^2 - 1)) with all d = 1.
    assert own.rank_correlation([*range(1, 11)], swapped) == pytest.approx(1 - 6 * 10 / 990)


def test_a_certain_trend() -> None:
    assert own.is_certain(1.0, 10)
    assert own.is_certain(-0.3, 100)
    assert not own.is_certain(0.2, 100)


@given(st.lists(st.integers(0, 9), min_size=2, max_size=30))
def test_the_jackknife_of_a_mean_is_its_standard_error(counts: list[int]) -> None:
    parts = [Counter(words=count, utterances=1) for count in counts]
    error = own.jackknife(
        parts, ("words", "utterances"), lambda totals: totals["words"] / totals["utterances"]
    )
    expected = statistics.stdev(counts) / len(counts) ** 0.5
    assert error == pytest.approx(expected)
    assert own.standard_error(counts) == pytest.approx(expected)


@given(st.lists(st.sampled_from("abcdefgh"), min_size=50, max_size=130))
def test_the_moving_ratio_is_the_mean_of_its_windows(words: list[str]) -> None:
    windows = [words[start : start + 50] for start in range(len(words) - 49)]
    expected = statistics.fmean(len(set(window)) / 50 for window in windows)
    assert own.moving_ratio(words) == pytest.approx(expected)
    assert own.moving_ratio(words[:49]) is None


# Groups, trends and verdicts


def test_rates_are_of_all_words_together() -> None:
    report = measure([Said("Very very kind.", 1), Said("She is late and he is not here.", 1)])
    # 2 of 11 words, not the mean of 2 of 3 and 0 of 8.
    assert values(report, "emphasizers")[0].value == pytest.approx(200 / 11)
    assert report.groups[0] == (1, 2, 11, 2)


def test_a_trend_and_its_verdicts() -> None:
    said = [Said("She is kind. " * (x + 3), x) for x in range(-2, 3) for _ in range(4)]
    rows = {row.feature.name: row for row in measure(said).rows}
    assert rows["words"].trend == rows["sentences"].trend == pytest.approx(1)
    assert (rows["words"].verdict, rows["sentences"].verdict) == ("agrees", "")
    assert (rows["negations"].trend, rows["negations"].verdict) == (None, "no trend")
    assert [value.value for value in rows["words"].values] == [3, 6, 9, 12, 15]
    fewer = [Said(one.text, -(one.x or 0)) for one in said]
    rows = {row.feature.name: row for row in measure(fewer).rows}
    assert rows["words"].verdict == "disagrees"


def test_texts_without_x_are_one_group() -> None:
    report = measure(["She is kind.", "She isn't."])
    assert [group.x for group in report.groups] == [None]
    assert {row.verdict for row in report.rows} == {""}
    assert {row.trend for row in report.rows} == {None}


def test_many_x_are_grouped_by_whole_numbers() -> None:
    report = measure([Said("She is kind.", x / 10) for x in range(-20, 21)])
    assert [group.x for group in report.groups] == [-2, -1, 0, 1, 2]
    assert report.rounded
    assert "X is rounded to whole numbers" in table(report)
    assert not measure([Said("She is kind.", 0.5)]).rounded


@pytest.mark.parametrize(
    ("said", "message"),
    [
        ([], "there is nothing to measure; give"),
        ([Said("a", 1), Said("b")], "some have none; measure them apart"),
        ([Said("a", x) for x in range(12)], "there are 12 whole numbers as X; give at most 11"),
    ],
)
def test_what_cannot_be_measured(said: list[Said], message: str) -> None:
    with pytest.raises(PersonageError) as caught:
        measure(said)
    check_message(caught.value)
    assert message in str(caught.value)


def test_what_the_generator_says_can_be_measured() -> None:
    generator = Generator()
    said = [turn for x in (-2, 2) for turn in generator.turns("alice", x, seed=1, count=90)]
    verdicts = {row.feature.name: row.verdict for row in measure(said).rows}
    for name in ("words", "exclamations", "hesitations"):
        assert verdicts[name] == "agrees", name


def test_the_same_text_measures_the_same() -> None:
    text = ["She is kind.", "Isn't she, mate?"]
    assert records(measure(text), True) == records(measure(text), True)


@pytest.mark.parametrize("module", ["textstat", "vaderSentiment.vaderSentiment"])
def test_a_missing_package(module: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(PersonageError) as caught:
        measure(["She is kind."])
    check_message(caught.value)
    assert module.partition(".")[0] in str(caught.value)
    assert "run: pip install 'personage-lite[measure]'" in str(caught.value)


# Richness

TALK = [
    "You want to know about Alice? She is kind.",
    "You want to know about Bill? He is kind of late.",
    "You want to hear this? Well, the Mock Turtle knows.",
]


def test_richness() -> None:
    (found,) = measure(TALK).richness
    assert found.words == 9 + 11 + 10
    assert found.distinct_1 == 20 / 30
    # 5, 2, 5, 4, 4 and 4 pairs, of which five (you want, want to) and two come again.
    assert found.distinct_2 == 17 / 24
    assert found.repeated_openings == 1
    # "you want to know about" is in two, and too much like it.
    assert found.worn == (("you want to", 3),)


def test_pairs_end_with_their_sentence() -> None:
    (found,) = measure(["A b. A b.", "A b."]).richness
    assert found.distinct_2 == 1 / 3
    assert found.distinct_1 == 2 / 6
    assert found.worn == ()


def test_richness_is_over_as_many_words_at_each_x() -> None:
    one, two = measure([Said("a b c d.", -1), Said("a a a a a a b c d e f.", 1)]).richness
    assert (one.words, two.words) == (4, 4)
    assert (one.distinct_1, two.distinct_1) == (1, 0.25)


def test_worn_phrases_hold_no_names() -> None:
    said = ["The Mad Hatter takes some tea.", "Then the Mad Hatter takes some tea."] * 2
    (found,) = measure(said).richness
    assert [one.phrase for one in found.worn] == ["takes some tea"]


# Reading


def test_lines_paragraphs_and_records() -> None:
    assert read_utterances("One.\n Two.\r\n", "a") == [Said("One."), Said("Two.")]
    assert read_utterances("One,\ntwo.\n\nThree.", "a") == [Said("One,\ntwo."), Said("Three.")]
    assert read_utterances('{"text": "One.", "x": -2}\n\n{"text": "", "x": 1.5}', "a") == [
        Said("One.", -2.0),
        Said("", 1.5),
    ]
    assert read_utterances('\ufeff{"text": "a\u2028b"}', "a") == [Said("a\u2028b")]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "a.txt holds no text; give"),
        (" \n \n", "a.txt holds no text; give"),
        ("{", "a.txt:1: this is no JSON record: {; give one record a line"),
        ('{"text": "a"}\n[1]', "a.txt:2: this record has no 'text'; write"),
        ('{"text": 1}', "a.txt:1: this record has no 'text'; write"),
        ('{"text": "a"}{"text": "b"}', "a.txt:1: this is no JSON record"),
        ('{"text": "a", "x": "1"}', "a.txt:1: X is \"1\"; give a number, or no 'x'"),
        ('{"text": "a", "x": true}', "a.txt:1: X is true; give"),
        ('{"text": "a", "x": [1]}', "a.txt:1: X is [1]; give"),
        ('{"text": "a", "x": NaN}', "a.txt:1: X is NaN; give"),
        ('{"text": "a", "x": 1' + "0" * 400 + "}", "a.txt:1: X is 1000000"),
        ('{"text": "a", "x": 1}\n{"text": "b"}', "a.txt:2: this record has no 'x' and the records"),
        ('{"text": "a"}\n{"text": "b", "x": 1}', "a.txt:2: this record has an 'x' and the records"),
        ("{" * 50_000, "a.txt:1: this is no JSON record"),
    ],
)
def test_what_cannot_be_read(content: str, message: str) -> None:
    with pytest.raises(PersonageError) as caught:
        read_utterances(content, "a.txt")
    check_message(caught.value)
    assert message in str(caught.value)


@given(st.text(max_size=100))
def test_any_text_is_read_or_refused(content: str) -> None:
    try:
        assert read_utterances(content, "a.txt")
    except PersonageError as error:
        check_message(error)
