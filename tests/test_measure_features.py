"""lexicons/features.yaml: every fault is named, and what it names exists."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite.checks import check_path
from personage_lite.data import data_folder
from personage_lite.errors import DataError, PersonageError
from personage_lite.measure import load_features, measure
from personage_lite.measure.features import QUANTITIES
from tests.mutation import check_message, spoilt

SHIPPED = Path(data_folder("lexicons"))
CONTENT = (SHIPPED / "features.yaml").read_text("utf-8")


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the shipped lexicons, to be spoilt."""
    folder = tmp_path_factory.mktemp("data") / "lexicons"
    shutil.copytree(SHIPPED, folder)
    return folder


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("    label: words\n", "", "'label' is missing; add"),
        ("count: words\n", "count: wrods\n", "'wrods' is not possible here; choose from"),
        ("count: words\n", "words: [a]\n    count: words\n", "'words' counts two things; give"),
        ("    count: words\n", "", "'words' counts nothing; give"),
        ("per: utterance\n", "per: day\n", "'day' is not possible here; choose from"),
        ("per: utterance\n", "per: text\n", "'words' cannot be counted per text; write 100 words"),
        ("per: window", "per: word", "cannot be counted per word; write window"),
        ("direction: rises", "direction: up", "'up' is not possible here; choose from"),
        ("direction: rises", "direction: none", "has sources for the direction 'none'; give"),
        ("direction: none", "direction: falls", "has no sources for the direction 'falls'; give"),
        ("[scherer_1979,", "[scherrer_1979,", "no source 'scherrer_1979'; did you mean scherer"),
        ("contrary: [gill", "contrary: [bill", "no source 'bill_oberlander_2003'; did you mean"),
        ("markers: [informal_", "markers: [formal_", "no markers 'formal_softeners'; did you"),
        ("lean: introvert", "lean: shy", "'shy' is not possible here; choose from"),
        ("- friend*", "- fr*end*", "this is no word; write letters, with one * at an end"),
        ("- friend*", '- "*"', "this is no word; write letters"),
        ("- friend*", '- "!"', "this is no word; write letters"),
        ("place: joint", "place: knee", "'knee' is not possible here; choose from"),
        ('"no", not', "no, not", "'no' is a truth value in YAML, not a word"),
        ("    finding:", "    fiding:", "unknown field 'fiding'; did you mean finding"),
        ("  numbers: |", "  nmbers: |", "'numbers' is missing; add"),
        ("lists:\n", "lists:\n  more: a\n", "unknown field 'more'"),
        ("{adjective: true}", "{adjective: 1}", "expected true or false, found '1'"),
        ("{adjective: true}", "{after: a}", "unknown field 'after'"),
    ],
)
def test_faults(old: str, new: str, message: str, copy: Path) -> None:
    """Each names its file and line, and `check` says the same."""
    path = copy / "features.yaml"
    spoil = CONTENT.replace(old, new, 1)
    assert spoil != CONTENT
    path.write_text(spoil, "utf-8")
    with pytest.raises(DataError) as caught:
        load_features(copy)
    assert str(caught.value).startswith(f"{path}:{caught.value.line}: ")
    assert message in str(caught.value)
    assert check_path(copy).faults == [str(caught.value)]


@settings(max_examples=40, deadline=None)
@given(data=st.data())
def test_a_spoilt_file_is_a_fault_or_can_be_measured_with(data: st.DataObject, copy: Path) -> None:
    (copy / "features.yaml").write_bytes(data.draw(spoilt(CONTENT)))
    try:
        measure(["She is, like, kind, isn't she?", "Well… no!"], copy)
    except PersonageError as error:
        check_message(error)


def test_features_of_ones_own(copy: Path) -> None:
    own = "features:\n  cats: {label: cats, words: [cat*], per: 100 words, direction: none}\n"
    (copy / "features.yaml").write_text(CONTENT.replace("features:\n", own, 1), "utf-8")
    row = measure(["Cats like a cat."], copy).rows[0]
    assert (row.feature.name, row.values[0].value) == ("cats", 50.0)


def test_every_direction_says_what_was_found() -> None:
    features = load_features()
    named: set[str] = set()
    for feature in features.features:
        assert bool(feature.finding) == (feature.direction != "none"), feature.name
        named.update((*feature.sources, *feature.contrary))
    assert named == set(features.sources)
    assert {one.quantity for one in features.features if one.quantity} == set(QUANTITIES)


def test_without_the_file_everything_else_still_works(copy: Path) -> None:
    (copy / "features.yaml").unlink()
    assert check_path(copy).faults == []
    with pytest.raises(PersonageError, match=r"features\.yaml: cannot be read"):
        load_features(copy)
