"""Lexicons and styles: every fault is named, and what loads can be spoken with."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite import Generator
from personage_lite.checks import check_path
from personage_lite.data import data_folder
from personage_lite.errors import DataError, PersonageError
from personage_lite.generator import DEFAULT_STYLE
from personage_lite.lexicon import load_lexicon, load_style
from personage_lite.style import check_overrides, check_x
from tests.mutation import check_message, spoilt

SHIPPED = Path(data_folder("lexicons"))
STYLE = f"{DEFAULT_STYLE}.yaml"
FILES = {path.name: path.read_text("utf-8") for path in sorted(SHIPPED.glob("*.yaml"))}
del FILES["features.yaml"]  # Only `measure` reads it: tests/test_measure_features.py.


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the shipped lexicons, to be spoilt; each test mends what it spoils."""
    folder = tmp_path_factory.mktemp("data") / "lexicons"
    shutil.copytree(SHIPPED, folder)
    return folder


def test_the_shipped_lexicons_are_whole() -> None:
    assert check_path(SHIPPED).faults == []


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("markers.yaml", "expletives:", "near_expletives:", "stands here a second time; remove"),
        ("markers.yaml", "expletives:", "expletive:", "'expletives' is missing; add"),
        ("markers.yaml", "expletives:", "more: [a]\nexpletives:", "unknown field 'more'; choose"),
        ("markers.yaml", "{text: damn,", "{txt: damn,", "'text' is missing"),
        ("markers.yaml", "{text: damn,", "{text: no,", "'no' is a truth value in YAML, not a word"),
        ("markers.yaml", "{text: damn,", "{text: damn, size: 1,", "unknown field 'size'"),
        ("markers.yaml", "place: opener", "place: end", "'end' is not possible here; choose from"),
        ("markers.yaml", "lean: 0.5}", "lean: 5}", "5 is out of range; write a number from -1 to"),
        ("markers.yaml", "  - {text: kind of", "  {text: kind of", "not valid YAML"),
        ("templates.yaml", "lead: I think,", "", "'lead' is missing"),
        ("templates.yaml", "form: clause,", "form: claws,", "'claws' is not possible here"),
        ("templates.yaml", "{animate: someone, ", "{", "'animate' is missing"),
        ("verbs.yaml", "[admit, 0.6,", "[admit,", "3 values; write [word, frequency, strength"),
        ("verbs.yaml", "[admit, 0.6,", "[admit, 6,", "6 is out of range"),
        ("verbs.yaml", "[admit, 0.6, 0.5, 0.0]", "{admit: 1}", "this is no word; write a word"),
        ("grammar.yaml", "  copula: be", "", "'copula' is missing"),
        ("grammar.yaml", "  neuter:", "  neutral:", "'neuter' is missing"),
        ("grammar.yaml", "reflexive: itself,", "reflex: itself,", "'reflexive' is missing"),
        ("grammar.yaml", "present_third: is,", "", "'present_third' is missing"),
        ("grammar.yaml", "  animate: {", "  animated: {", "'animate' is missing"),
        ("grammar.yaml", '"no"]', "no]", "'no' is a truth value in YAML, not a word"),
        ("grammar.yaml", "  copula: be", "  copula: be\n  x: y", "unknown field 'x'"),
        (STYLE, "  verbosity:", "  verbose:", "'verbosity' is missing; add"),
        (STYLE, "noise: 0.02", "noise: 2", "2 is out of range; write a number from 0 to 1"),
        (STYLE, "name: ", "nam: ", "'name' is missing"),
        (STYLE, "direction: rises", "direction: falls", "the anchors do not go with 'falls'; mend"),
        (STYLE, "direction: rises", "direction: steady", "the anchors differ; write 'rises'"),
        (STYLE, "direction: rises", "direction: up", "'up' is not possible here; choose from"),
        (STYLE, "anchors: [", "anchors: [0, ", "6 anchors; give five, for X = -2, -1, 0, 1 and 2"),
    ],
)
def test_faults(file: str, old: str, new: str, message: str, copy: Path) -> None:
    """Each names its file and line, and `check` says the same."""
    spoil = FILES[file].replace(old, new, 1)
    assert spoil != FILES[file]
    _spoil(copy, file, spoil.encode())
    try:
        with pytest.raises(DataError) as caught:
            _ = Generator(lexicons=copy).dialog
        assert str(caught.value).startswith(f"{copy / file}:{caught.value.line}: ")
        assert caught.value.line > 1
        assert message in str(caught.value)
        assert check_path(copy).faults == [str(caught.value)]
    finally:
        _spoil(copy, file, FILES[file].encode())


@pytest.mark.parametrize("file", FILES)
@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", ":1: the file is empty"),
        (b"[]", ":1: expected 'key: value' pairs"),
        (b"{}", ":1: '"),
        (b"a: b\nc: \xff", ":2: this is not UTF-8 text; save the file as UTF-8"),
        (None, "cannot be read (No such file or directory); check the path"),
    ],
)
def test_faults_of_whole_files(file: str, content: bytes | None, message: str, copy: Path) -> None:
    if content == b"{}" and file in ("adjectives.yaml", "verbs.yaml"):
        pytest.skip("no concepts are no fault: every word is said as it is")
    (copy / file).unlink()
    if content is not None:
        _spoil(copy, file, content)
    try:
        with pytest.raises(PersonageError) as caught:
            _ = Generator(lexicons=copy).dialog
        assert str(caught.value).startswith(str(copy / file))
        assert message in str(caught.value)
    finally:
        _spoil(copy, file, FILES[file].encode())


def test_an_empty_word_list_is_refused(copy: Path) -> None:
    head, _, rest = FILES["markers.yaml"].partition("expletives:\n")
    rest = rest[rest.index("\n\n") :]
    concept = "kind: {words: []}\n"
    for file, content, message in (
        ("markers.yaml", f"{head}expletives: []\n{rest}", "'expletives' is empty; add at least"),
        ("adjectives.yaml", concept, "'kind' has no words; add at least one"),
        ("verbs.yaml", concept, "'kind' has no words; add at least one"),
        ("verbs.yaml", "be: {words: [be], antonyms: []}\n", "the list is empty; add at least one"),
    ):
        _spoil(copy, file, content.encode())
        with pytest.raises(DataError, match=message):
            load_lexicon(copy)
        _spoil(copy, file, FILES[file].encode())


@pytest.mark.parametrize("mark", ["", ",", "…"])
def test_a_connective_has_the_mark_of_its_entry(mark: str, copy: Path, tmp_path: Path) -> None:
    """The shipped "and" has none: "And she …", not "And, she …"."""
    entry = "{text: and, place: connective, "
    assert FILES["markers.yaml"].count(entry) == 1
    after = f'after: "{mark}", ' if mark else ""
    _spoil(copy, "markers.yaml", FILES["markers.yaml"].replace(entry, entry + after).encode())
    try:
        generator = Generator(facts=tmp_path, lexicons=copy)
    finally:
        _spoil(copy, "markers.yaml", FILES["markers.yaml"].encode())
    things = "".join(
        f"  - {{id: {thing}, predicate: have, object: a {thing}, topic: things}}\n"
        for thing in ("cat", "dog", "hat", "kite")
    )
    head = "about: ann\nentities: {ann: {name: Ann}}\nfacts:\n"
    (tmp_path / "ann.yaml").write_text(head + things, "utf-8")
    setting = {"also_cue_word": 1.0, "period": 0.0, "conjunction": 0.0, "merge": 0.0}
    setting["verbosity"] = 0.5
    said = [generator.generate("ann", 1, seed, overrides=setting).text for seed in range(50)]
    marks = [found for text in said for found in re.findall(r"[.!?] And([,…]?) ", text)]
    assert len(marks) > 5
    assert set(marks) == {mark}


@pytest.mark.parametrize("file", FILES)
@settings(max_examples=25, deadline=None)
@given(data=st.data())
def test_spoilt_lexicons_are_read_or_refused(file: str, copy: Path, data: st.DataObject) -> None:
    """What loads in spite of a mistake never fails later, when it is spoken with."""
    _spoil(copy, file, data.draw(spoilt(FILES[file])))
    try:
        generator = Generator(lexicons=copy)
    except PersonageError as error:
        check_message(error)
    else:
        for seed, x in enumerate((-2, 0, 2)):
            generator.generate("alice", x, seed)
    finally:
        _spoil(copy, file, FILES[file].encode())


@settings(max_examples=30, deadline=None)
@given(content=st.binary(max_size=200))
def test_random_bytes_are_refused(content: bytes, copy: Path) -> None:
    for file, load in (
        ("templates.yaml", load_lexicon),
        (STYLE, lambda folder: load_style(folder, DEFAULT_STYLE)),
    ):
        _spoil(copy, file, content)
        try:
            with pytest.raises(PersonageError):
                load(copy)
        finally:
            _spoil(copy, file, FILES[file].encode())


@pytest.mark.parametrize(
    ("x", "what"),
    [
        (2.001, "2.001"),
        (float("nan"), "nan"),
        (float("-inf"), "-inf"),
        (10**400, "1000"),
        ("", "empty"),
        ("much", "much"),
        ("9" * 10_000, f"{'9' * 40}…"),
        (None, "None"),
    ],
)
def test_x_is_a_number_from_minus_2_to_2(x: float, what: str) -> None:
    with pytest.raises(PersonageError, match=r"; give a number from -2 .* to 2 ") as caught:
        check_x(x)
    assert str(caught.value).startswith(f"X is {what}")


def test_overrides_are_known_and_within_0_and_1() -> None:
    style = load_style(SHIPPED, DEFAULT_STYLE)
    assert check_overrides(style, {"verbosity": 1, "mine": 0}, ["mine"]) == {
        "verbosity": 1,
        "mine": 0,
    }
    for overrides, message in (
        ({"verbosty": 0.5}, "no parameter 'verbosty'; did you mean verbosity"),
        ({"x" * 9999: 0.5}, f"no parameter '{'x' * 40}…'; choose from: "),
        ({"verbosity": 1.01}, "verbosity is 1.01; give a number from 0 to 1"),
        ({"verbosity": float("nan")}, "verbosity is nan; give"),
    ):
        with pytest.raises(PersonageError) as caught:
            check_overrides(style, overrides)
        assert str(caught.value).startswith(message)


def _spoil(folder: Path, file: str, content: bytes) -> None:
    (folder / file).write_bytes(content)
