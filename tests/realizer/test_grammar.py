"""Proves that every fault in the realizer's four data files is named, and what its options do."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite import english
from personage_lite.data import data_folder
from personage_lite.errors import DataError, PersonageError
from personage_lite.realizer import (
    AdjectivePhrase,
    Clause,
    Coordination,
    Date,
    NounPhrase,
    Numeral,
    Realizer,
    Relative,
    Sentence,
)
from personage_lite.realizer.grammar import Grammar, load_grammar
from personage_lite.realizer.inflection import Dialect
from tests.mutation import check_message, spoilt
from tests.realizer.case_list import read_cases

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


@pytest.mark.parametrize(
    ("name", "old", "new", "message"),
    [
        ("grammar.yaml", "  copula: be\n", "", "'copula' is missing; add 'copula: …'"),
        ("grammar.yaml", "  copula: be", "  coppula: be", "'copula' is missing; add"),
        ("grammar.yaml", "  copula: be", "  copula: be\n  x: y", "unknown field 'x'; choose"),
        ("grammar.yaml", "  copula: be", "  copula: ~", "expected text, found nothing; write"),
        ("grammar.yaml", "  neuter:", "  neutral:", "'neuter' is missing; add"),
        ("grammar.yaml", "  third plural:", "  x: {a: b}\n  third plural:", "unknown field 'x'"),
        ("grammar.yaml", "reflexive: itself", "reflex: itself", "'reflexive' is missing; add"),
        ("grammar.yaml", "{subjective: I, ", "{subjective: I, x: y, ", "unknown field 'x'; choose"),
        ("grammar.yaml", "subjective: we", "subjective: no", "'no' is a truth value in YAML, not"),
        ("grammar.yaml", "present_third: is, ", "", "'present_third' is missing; add"),
        ("grammar.yaml", "be: {", "be: {future: will, ", "unknown field 'future'; choose from"),
        ("grammar.yaml", "  animate: {subject: who, ", "  animate: {", "'subject' is missing; add"),
        ("grammar.yaml", "  inanimate:", "  inanimat:", "'inanimate' is missing; add"),
        ("grammar.yaml", "  possessive: whose", "  possessive: [whose]", "expected a single value"),
        ("grammar.yaml", "  possessive: whose", "  x: y\n  possessive: whose", "unknown field 'x'"),
        ("grammar.yaml", '"no"]', "no]", "'no' is a truth value in YAML, not a word; put it in"),
        ("grammar.yaml", "let: {full: let us,", "let: {ful: let us,", "'full' is missing; add"),
        (
            "grammar.yaml",
            "{first: shall we,",
            "{third: x, first: shall we,",
            "unknown field 'third'",
        ),
        (
            "grammar.yaml",
            "these: {number: plural}",
            "these: {number: many}",
            "'many' is not possible",
        ),
        (
            "grammar.yaml",
            "this: {plural: these}",
            "this: {plurl: these}",
            "unknown field 'plurl'; ",
        ),
        ("grammar.yaml", "this: {plural: these}", "this: these", "expected 'key: value' pairs; "),
        (
            "grammar.yaml",
            "this: {plural: these}",
            "this: {plural: [these]}",
            "expected a single val",
        ),
        ("grammar.yaml", "{can: could, could", "{can: 7, could", "expected text, found '7'; write"),
        (
            "grammar.yaml",
            "negative_determiners: [little]",
            "negative_determiners: little",
            "a list",
        ),
        (
            "grammar.yaml",
            "approximators: [almost",
            "approximators: [7, almost",
            "expected text, fou",
        ),
        (
            "inflection.yaml",
            "  take took taken",
            "  take",
            "'take' has 1 words; write 2 to 3 words",
        ),
        ("inflection.yaml", "  take took taken", "  take a b c", "has 4 words; write 2 to 3 words"),
        (
            "inflection.yaml",
            "  take took taken",
            "  take took\n  take took",
            "'take' stands in 'irr",
        ),
        (
            "inflection.yaml",
            "burnt/burned",
            "burnt/",
            "a word beside each slash; write British/Amer",
        ),
        (
            "inflection.yaml",
            "burnt/burned",
            "burnt/b/c",
            "a word beside each slash; write British/A",
        ),
        ("inflection.yaml", "  mouse mice", "  mouse", "'mouse' has 1 words; write 2 words"),
        ("inflection.yaml", "  have has", "  have has had", "has 3 words; write 2 words"),
        ("inflection.yaml", "  martial court", "  martial", "'martial' has 1 words; write 2 to 99"),
        ("inflection.yaml", "  positive more most", "  comparative more most", "'positive'"),
        ("inflection.yaml", "third_person: |", "third_person:", "'third_person' is not a block of"),
        ("numerals.yaml", "zero one two", "one two", "'units' has 19 words; write 20, with blanks"),
        ("numerals.yaml", "tens: twenty", "tens: ten twenty", "'tens' has 9 words; write 8, with"),
        ("numerals.yaml", "zeroth first", "first", "'unit_ordinals' has 19 words; write 20, with"),
        ("numerals.yaml", "weekdays: Monday", "weekdays:", "'weekdays' has 6 words; write 7, with"),
        ("numerals.yaml", "  January ", "  ", "'months' has 11 words; write 12, with blanks"),
        ("numerals.yaml", '"{day} {month}"', '"{day}"', "is no pattern for 'figures'; write {day}"),
        (
            "numerals.yaml",
            '"{day} {month}"',
            '"{day} {moth}"',
            "is no pattern for 'figures'; write",
        ),
        ("numerals.yaml", '"{day} {month}"', '"{day} {month} {0}"', "is no pattern for 'figures'"),
        ("numerals.yaml", '"{day} {month}"', '"{day!x} {month}"', "is no pattern for 'figures'; "),
        ("numerals.yaml", "  month_year:", "  month_yer:", "'month_year' is missing; add"),
        ("numerals.yaml", "american:", "american:\n  x: y", "unknown field 'x'; choose from: and"),
        (
            "numerals.yaml",
            "minus: minus",
            "minus: ''",
            "the text is empty; write at least one word",
        ),
        ("articles.yaml", "  heir honest", "  heir heir", "'heir' stands twice; remove one of the"),
        ("articles.yaml", "  eu ew", "  eu ew heir", "'heir' stands twice; remove one of the two"),
        (
            "articles.yaml",
            "  heir honest",
            "  Heir honest",
            "'Heir' does not belong here; write two",
        ),
        ("articles.yaml", "  heir honest", "  h honest", "'h' does not belong here; write two or"),
        (
            "articles.yaml",
            "  UGLY UP",
            "  ugly UP",
            "'ugly' does not belong here; write two or mor",
        ),
        ("articles.yaml", 'eight: "8"', "eight: 8", "expected text, found '8'; write a text, in"),
        ("articles.yaml", "teens: 11 18", "teens: 11", "expected text, found '11'; write a text"),
    ],
)
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


# Options


@pytest.mark.parametrize(
    ("spec", "british", "american"),
    [
        (Clause("learn", "she", tense="past"), "She learnt.", "She learned."),
        (Clause("get", "she", perfect=True), "She has got.", "She has gotten."),
        (Clause("travel", "she", progressive=True), "She is travelling.", "She is traveling."),
        (Clause("quit", "she", tense="past"), "She quit.", "She quit."),
        (Numeral(101), "One hundred and one.", "One hundred one."),
        (Date(1862, 7, 4), "4 July 1862.", "July 4, 1862."),
        (Date(1862, 7, 4, style="iso"), "1862-07-04.", "1862-07-04."),
        (NounPhrase("herb", determiner="a"), "A herb.", "An herb."),
    ],
)
def test_dialects(spec: Any, british: str, american: str) -> None:
    assert english().realize(spec) == english("british").realize(spec) == british
    assert english("american").realize(spec) == american


@pytest.mark.parametrize("dialect", ["scots", "", "British", None, 7, "american "])
def test_an_unknown_dialect(dialect: Any) -> None:
    """It is refused: no one is silently given another."""
    with pytest.raises(PersonageError) as caught:
        english(dialect)
    check_message(caught.value)
    assert "american" in str(caught.value)


def test_commas_and_apostrophes() -> None:
    spec = Sentence(
        Clause("be", Coordination(("Al", "Bo", "Cy")), complement="late", contracted=True),
        tag="auto",
    )
    table: tuple[tuple[dict[str, Any], str], ...] = (
        ({}, "Al, Bo and Cy are late, aren't they?"),
        ({"oxford_comma": True}, "Al, Bo, and Cy are late, aren't they?"),
        ({"curly_apostrophes": True}, "Al, Bo and Cy are late, aren’t they?"),
        (
            {"oxford_comma": True, "curly_apostrophes": True},
            "Al, Bo, and Cy are late, aren’t they?",
        ),
    )
    for options, text in table:
        assert english(**options).realize(spec) == text
        assert english("american", **options).realize(spec) == text
    with pytest.raises(TypeError):
        english("british", True)  # type: ignore[call-arg]


def test_realizers_are_equal_and_independent() -> None:
    """Two of the same options share nothing that one could change for the other."""
    first, second = english(), english()
    assert first is not second
    assert first.grammar is not second.grammar
    assert first.grammar == second.grammar
    assert english("american").grammar != first.grammar
    assert english(oxford_comma=True).grammar == first.grammar._replace(oxford_comma=True)
    mouse = NounPhrase("mouse", number="plural")
    second.grammar.inflection.plurals["mouse"] = "meese"
    assert english().realize(mouse) == first.realize(mouse) == "Mice."
    assert first.grammar != second.grammar
    specs = [case.spec for case in read_cases()[::9] if not case.options]
    third = english()
    assert [first.realize(spec) for spec in specs] == [third.realize(spec) for spec in specs]


def test_a_realizer_is_never_changed_by_speaking() -> None:
    realizer = english()
    before = repr(realizer.grammar)
    for spec in CASES:
        realizer.realize(spec)
    assert repr(realizer.grammar) == before
    with pytest.raises(AttributeError):
        realizer.other = 1  # type: ignore[attr-defined]
    with pytest.raises(AttributeError):
        realizer.grammar.oxford_comma = True  # type: ignore[misc]


def test_the_folder_may_be_a_path_or_a_text() -> None:
    assert load_grammar(SHIPPED) == load_grammar(str(SHIPPED)) == english().grammar


def test_every_field_of_the_grammar_is_read() -> None:
    """Nothing is empty in the shipped files but what the options leave out."""
    grammar = load_grammar(SHIPPED, oxford_comma=True, curly_apostrophes=True)
    for name in Grammar._fields:
        assert getattr(grammar, name), name
    words = Clause(
        "be",
        NounPhrase("cat", relative=Relative(Clause("sleep"))),
        complement=AdjectivePhrase("kind", degree="comparative"),
    )
    assert Realizer(grammar).realize(words) == "Cat, which sleeps, is kinder."
