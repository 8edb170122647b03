"""YAML is read strictly: every fault names file, line and remedy, and nothing else is raised."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite import yaml_reader
from personage_lite.errors import DataError, PersonageError
from personage_lite.yaml_reader import Node, parse_yaml, read_yaml
from tests.mutation import check_message

DEEP = 100_000


def _read_all(node: Node) -> None:
    """Read a value in every way that there is."""
    readers: tuple[Callable[[], object], ...] = (
        node.text,
        node.texts,
        node.flag,
        node.mapping,
        lambda: node.number(0, 1),
        lambda: node.integer(0, 9),
        lambda: node.choice(("a", "b")),
        lambda: node.need("a"),
        node.done,
    )
    for read in readers:
        try:
            read()
        except DataError as error:
            check_message(error)


@pytest.mark.parametrize(
    ("content", "read", "line", "message"),
    [
        ("a: 1\nb: 2\na: 3\n", Node.mapping, 3, "the key 'a' stands here a second time; remove"),
        ("- yes", lambda node: node.texts(), 1, "'yes' is a truth value in YAML, not a word; put"),
        ("\n- No", lambda node: node.texts(), 2, "'No' is a truth value in YAML"),
        ("- 7", lambda node: node.texts(), 1, "expected text, found '7'"),
        ("- ~", lambda node: node.texts(), 1, "expected text, found nothing"),
        ("- ' '", lambda node: node.texts(), 1, "the text is empty; write at least one word"),
        ("[]", lambda node: node.texts(), 1, "the list is empty; add at least one item"),
        ("a: b", lambda node: node.texts(), 1, "expected a list; write it as [a, b]"),
        ("[a]", Node.mapping, 1, "expected 'key: value' pairs; write one"),
        ("[a]", Node.text, 1, "expected a single value"),
        ("yes", Node.flag, 1, "expected true or false, found 'yes'; write true or false"),
        ("{a: b}", lambda node: node.need("c"), 1, "'c' is missing; add 'c: …'"),
        ("{a: b}", lambda node: node.only(("ab",)), 1, "unknown field 'a'; did you mean ab?"),
        ("{[a]: b}", Node.mapping, 1, "expected a single value"),
        ("c", lambda node: node.choice(("a", "b")), 1, "'c' is not possible here; choose from: a"),
        ("one", lambda node: node.number(0, 1), 1, "expected a number, found 'one'; write 0 to 1"),
        ("1.5", lambda node: node.number(0, 1), 1, "1.5 is out of range; write a number from 0"),
        (".nan", lambda node: node.number(0, 1), 1, ".nan is out of range"),
        (".inf", lambda node: node.number(0, 1), 1, ".inf is out of range"),
        ("!!int x", lambda node: node.number(0, 1), 1, "x is out of range"),
        ("0.5", lambda node: node.integer(0, 1), 1, "expected a whole number, found 0.5"),
        (f"'{'x' * 9999}'", lambda node: node.number(0, 1), 1, f"found '{'x' * 40}…'"),
        ('"a\\nb"', lambda node: node.choice(("a",)), 1, "'a b' is not possible here"),
    ],
)
def test_faults_of_values(
    content: str, read: Callable[[Node], object], line: int, message: str
) -> None:
    with pytest.raises(DataError) as caught:
        read(parse_yaml(content, "a.yaml"))
    assert str(caught.value).startswith(f"a.yaml:{line}: ")
    assert message in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize(
    ("content", "line", "message"),
    [
        (b"", 1, "the file is empty"),
        (b"# no more than this\n", 1, "the file is empty"),
        (b"a: [b\n", 2, "not valid YAML"),
        (b"a: b\n c: d\n", 2, "not valid YAML"),
        (b"a: *b\n", 1, "not valid YAML (found undefined alias"),
        (b"a: b\n---\nc: d\n", 2, "not valid YAML"),
        (b"a: b\nc: d\x07\n", 2, "not valid YAML"),
        ("ä: b\nc: d\n\ne: \x01".encode(), 4, "not valid YAML"),
        (b"a: b\nc: \xff\n", 2, "this is not UTF-8 text; save the file as UTF-8"),
        ("a: ä".encode("utf-16"), 1, "this is not UTF-8 text"),
    ],
)
def test_faults_of_files(content: bytes, line: int, message: str, tmp_path: Path) -> None:
    path = tmp_path / "a.yaml"
    path.write_bytes(content)
    with pytest.raises(DataError) as caught:
        read_yaml(path)
    assert str(caught.value).startswith(f"{path}:{line}: ")
    assert message in str(caught.value)


def test_a_file_that_cannot_be_opened(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "none.yaml", tmp_path / ("x" * 5000)):
        with pytest.raises(PersonageError, match=r"cannot be read \(.*\); check the path"):
            read_yaml(path)


def test_a_byte_order_mark_is_harmless(tmp_path: Path) -> None:
    path = tmp_path / "a.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: b\n")
    assert read_yaml(path).need("a").text() == "b"


@pytest.mark.parametrize("content", ["[" * DEEP, "- " * DEEP, "{a: " * DEEP, "? " * DEEP])
def test_deep_nesting_is_refused(content: str) -> None:
    """The C parser would die of it."""
    with pytest.raises(DataError, match="more than 100 levels deep; nest less"):
        parse_yaml(content, "a.yaml")


def test_a_long_file_is_not_deep() -> None:
    assert len(parse_yaml("- [{a: b-c}]\n" * 5000, "a.yaml").sequence()) == 5000


@settings(max_examples=100, deadline=None)
@given(st.one_of(st.text(), st.text("[]{}:,-&*!|>?'\"#%@~ \n\tab1.", max_size=40)))
def test_any_text_is_read_or_refused(content: str) -> None:
    try:
        node = parse_yaml(content, "a.yaml")
    except DataError as error:
        check_message(error)
    else:
        _read_all(node)


@settings(max_examples=60, deadline=None)
@given(st.text("[]{}:,-&*!|>?'\"#%@~ \n\tab1.\x00é", max_size=40))
def test_the_slow_parser_refuses_as_well(content: str) -> None:
    """Without libyaml, the parser is PyYAML's own."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(yaml_reader, "_Loader", yaml.SafeLoader)
        try:
            node = parse_yaml(content, "a.yaml")
        except DataError:
            return
    _read_all(node)
