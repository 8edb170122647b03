"""Proves that every fault in the realizer's four data files is named with its line."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite.data import data_folder
from personage_lite.errors import DataError, PersonageError
from personage_lite.realizer import Realizer
from personage_lite.realizer.grammar import load_grammar
from personage_lite.realizer.inflection import Dialect
from tests.mutation import check_message, spoilt
from tests.realizer.case_list import read_cases
from tests.realizer.grammar_faults import FAULTS

SHIPPED = Path(data_folder("lexicons"))
NAMES = ("grammar.yaml", "inflection.yaml", "numerals.yaml", "articles.yaml")
FILES = {name: (SHIPPED / name).read_text("utf-8") for name in NAMES}
TABLES = {name: list(yaml.safe_load(content)) for name, content in FILES.items()}
DIALECTS: tuple[Dialect, ...] = ("british", "american")
ALL_TABLES = [(name, table) for name in NAMES for table in TABLES[name]]
# Some of every phenomenon, to speak with what loads in spite of a mistake.
CASES = [case.spec for case in read_cases()[::25]]


@pytest.fixture(scope="module")
def lexicons(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the four files, to be spoilt."""
    folder = tmp_path_factory.mktemp("grammar")
    for name in NAMES:
        shutil.copy(SHIPPED / name, folder)
    return folder


@pytest.fixture
def copy(lexicons: Path) -> Iterator[Path]:
    """Return the same folder, mended after the test."""
    yield lexicons
    for name, content in FILES.items():
        (lexicons / name).write_text(content, "utf-8")


def fault(folder: Path, name: str, content: str) -> DataError:
    """Return the error of a folder with a spoilt file."""
    assert content != FILES[name]
    (folder / name).write_text(content, "utf-8")
    with pytest.raises(DataError) as caught:
        load_grammar(folder)
    check_message(caught.value)
    assert str(caught.value).startswith(f"{folder / name}:{caught.value.line}: ")
    return caught.value


def line_of(content: str, start: str) -> int:
    """Return the number of the line that begins with a key, or that is all of a text."""
    starts = [
        line.startswith(start) if ":" in start else line == start for line in content.split("\n")
    ]
    return starts.index(True) + 1


def without(content: str, table: str) -> str:
    """Return a file's content without one of its tables."""
    cut = re.sub(rf"(?ms)^{re.escape(table)}:.*?(?=^\w|\Z)", "", content)
    assert cut != content
    return cut


@pytest.mark.parametrize(("name", "table"), ALL_TABLES, ids=[f"{n}-{t}" for n, t in ALL_TABLES])
def test_every_table_is_needed_and_known(name: str, table: str, copy: Path) -> None:
    """A missing, a misspelt, a doubled, an empty one and one of another kind are refused."""
    content = FILES[name]
    assert f"'{table}' is missing; add '{table}: …'" in str(
        fault(copy, name, without(content, table))
    )
    misspelt = re.sub(rf"(?m)^{re.escape(table)}:", f"{table}x:", content)
    said = str(fault(copy, name, misspelt))
    assert f"'{table}' is missing" in said
    doubled = f"{content}\n{table}: x\n"
    error = fault(copy, name, doubled)
    assert f"the key '{table}' stands here a second time; remove one" in str(error)
    assert error.line == line_of(doubled, f"{table}: x")
    number = line_of(content, f"{table}:")
    for value in ("", "no", "[]", "[[a]]", "{x: {y: z}}"):
        head, tail = content.split("\n")[: number - 1], without(content, table)
        wrong = f"{table}: {value}"
        spoil = "\n".join([*head, wrong, *tail.split("\n")[number - 1 :]])
        if _takes(name, table, value):
            continue
        error = fault(copy, name, spoil)
        # What stands at the end of its line is said to stand in the next one that holds anything.
        assert error.line >= number or not value, (value, str(error))
        assert error.line <= number or not value, (value, str(error))


def _takes(name: str, table: str, value: str) -> bool:
    """Whether a table may be nearly anything: one of words, with any words in it."""
    open_tables = {"modals", "contractions", "negative_contractions", "question_negatives"}
    open_tables |= {"tag_negatives", "fused_negatives", "correlatives", "adjective_order"}
    return value == "{}" and (table in open_tables or table == "determiners")


@pytest.mark.parametrize("name", NAMES)
def test_an_unknown_table(name: str, copy: Path) -> None:
    for key, remedy in (("x", "choose from: "), (TABLES[name][-1] + "s", "did you mean ")):
        error = fault(copy, name, f"{FILES[name]}\n{key}: [a]\n")
        assert f"unknown field '{key}'; {remedy}" in str(error)
        assert error.line == FILES[name].count("\n") + 2


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", ":1: the file is empty"),
        (b"[]", ":1: expected 'key: value' pairs"),
        (b"word", ":1: expected 'key: value' pairs"),
        (b"{}", ":1: '"),
        (b"a: b\nc: \xff", ":2: this is not UTF-8 text; save the file as UTF-8"),
        (b"a: [", ": not valid YAML"),
        (b"[" * 100_000, ":1: more than 100 levels deep; nest less"),
        (None, "cannot be read (No such file or directory); check the path"),
    ],
)
def test_whole_files(name: str, content: bytes | None, message: str, copy: Path) -> None:
    (copy / name).unlink()
    if content is not None:
        (copy / name).write_bytes(content)
    with pytest.raises(PersonageError) as caught:
        load_grammar(copy)
    check_message(caught.value)
    assert str(caught.value).startswith(str(copy / name))
    assert message in str(caught.value)


@pytest.mark.parametrize(("name", "old", "new", "message"), FAULTS)
def test_faults(name: str, old: str, new: str, message: str, copy: Path) -> None:
    """Each names its file and the very line."""
    assert old in FILES[name]
    spoil = FILES[name].replace(old, new, 1)
    error = fault(copy, name, spoil)
    assert message in str(error)
    with pytest.raises(DataError) as caught:
        load_grammar(copy, "american")
    assert str(caught.value) == str(error), "a fault is one in both dialects"
    at = FILES[name][: FILES[name].index(old)].count("\n") + 1
    lines = range(at - 25, at + new.count("\n") + 2)
    assert error.line in lines, f"{error} (line {at})"


def test_the_line_inside_a_block_is_told(copy: Path) -> None:
    """Also where comments or blank lines stand before or in it."""
    content = FILES["inflection.yaml"].replace("  take took taken", "  take")
    error = fault(copy, "inflection.yaml", content)
    assert error.line == line_of(content, "  take")
    for start in ("third_person: |\n", "third_person: |  # a comment\n", "third_person: |\n\n"):
        content = FILES["inflection.yaml"].replace("third_person: |\n", start)
        content = content.replace("  have has\n", "  have\n", 1)
        error = fault(copy, "inflection.yaml", content)
        assert error.line == line_of(content, "  have"), start


@pytest.mark.parametrize("name", NAMES)
@settings(max_examples=40, deadline=None)
@given(data=st.data())
def test_spoilt_files_are_read_or_refused(name: str, lexicons: Path, data: st.DataObject) -> None:
    """What loads in spite of a mistake never fails later, when it is spoken with."""
    (lexicons / name).write_bytes(data.draw(spoilt(FILES[name])))
    message, realizers = "", []
    try:
        realizers = [Realizer(load_grammar(lexicons, each)) for each in DIALECTS]
    except PersonageError as error:
        check_message(error)
        message = str(error)
    finally:
        (lexicons / name).write_text(FILES[name], "utf-8")
    assert not message or message.startswith(str(lexicons / name))
    for realizer in realizers:
        for spec in CASES:
            assert realizer.realize(spec)


@settings(max_examples=60, deadline=None)
@given(name=st.sampled_from(NAMES), content=st.binary(max_size=200))
def test_random_bytes_are_refused(name: str, content: bytes, lexicons: Path) -> None:
    (lexicons / name).write_bytes(content)
    try:
        with pytest.raises(PersonageError) as caught:
            load_grammar(lexicons)
        check_message(caught.value)
    finally:
        (lexicons / name).write_text(FILES[name], "utf-8")
