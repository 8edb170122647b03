"""Strict YAML: every value keeps its line, and nothing that YAML would silently change gets in.

PyYAML turns `yes` and `no` into truth values and keeps the last of two equal keys; both are
refused here, because a word list that holds "no" must hold the word.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from os import PathLike
from typing import Any

import yaml

from personage_lite.errors import DataError, PersonageError, nearest, shown

# The C parser is several times faster; a machine without libyaml still works.
_Base: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_STR = "tag:yaml.org,2002:str"
_INT = "tag:yaml.org,2002:int"
_FLOAT = "tag:yaml.org,2002:float"
_BOOL = "tag:yaml.org,2002:bool"
_NULL = "tag:yaml.org,2002:null"
# The parser recurses, and the C one dies of what is nested too deep. A file with fewer of the
# characters that can nest anything than `_HARMLESS` need not be looked through for it.
_NESTING, _HARMLESS, _DEEPEST = "[{-?", 3000, 100


class _Loader(_Base):  # type: ignore[misc]
    """The safe loader without path resolvers, of which nobody uses any: a fifth faster."""

    def descend_resolver(self, current_node: object, current_index: object) -> None:
        """Nothing depends on where a value stands."""

    def ascend_resolver(self) -> None:
        """As above."""

    def resolve(self, kind: type, value: str, implicit: tuple[bool, bool]) -> str:
        """Return a value's tag by its looks, as YAML 1.1 says."""
        if kind is yaml.ScalarNode:
            if implicit[0]:
                for tag, looks in self.yaml_implicit_resolvers.get(value[:1], ()):
                    if looks.match(value):
                        return str(tag)
            return _STR
        return "tag:yaml.org,2002:seq" if kind is yaml.SequenceNode else "tag:yaml.org,2002:map"


class Node:
    """A YAML value that knows its file and line, read with checks instead of trust.

    Each reader names the file, the line and the remedy when the value is not of its kind.
    """

    __slots__ = ("_map", "_node", "_read", "file")

    def __init__(self, node: yaml.Node, file: str) -> None:
        self._node = node
        self.file = file
        self._map: dict[str, Node] | None = None
        self._read: set[str] = set()

    @property
    def line(self) -> int:
        """The line of the value in its file, from 1."""
        return int(self._node.start_mark.line) + 1

    def fault(self, what: str, remedy: str) -> DataError:
        """Return (not raise) the error that points at this value."""
        return DataError(self.file, self.line, what, remedy)

    # Mappings

    def mapping(self) -> dict[str, Node]:
        """Return the value as a mapping from text keys to nodes; equal keys are an error."""
        if self._map is None:
            if not isinstance(self._node, yaml.MappingNode):
                raise self.fault("expected 'key: value' pairs", "write one 'key: value' a line")
            found: dict[str, Node] = {}
            for key, value in self._node.value:
                if key.tag == _STR and isinstance(key, yaml.ScalarNode) and key.value:
                    name = str(key.value)
                else:
                    name = Node(key, self.file).text()
                if name in found:
                    raise DataError(
                        self.file,
                        int(key.start_mark.line) + 1,
                        f"the key '{name}' stands here a second time",
                        f"remove one of the two (the first is in line {found[name].line})",
                    )
                found[name] = Node(value, self.file)
            self._map = found
        return self._map

    def items(self) -> Iterator[tuple[str, Node]]:
        """Iterate over the pairs of a mapping."""
        return iter(self.mapping().items())

    def get(self, key: str) -> Node | None:
        """Return the value under `key`, or None, and note that `key` is known."""
        self._read.add(key)
        return self.mapping().get(key)

    def need(self, key: str) -> Node:
        """Return the value under `key`; it is an error if there is none."""
        found = self.get(key)
        if found is None:
            raise self.fault(f"'{key}' is missing", f"add '{key}: …'")
        return found

    def done(self) -> None:
        """Refuse every key that nobody asked for: a misspelt field is an error, not a surprise."""
        self.only(self._read)

    def only(self, known: Iterable[str]) -> None:
        """Refuse every key that is not among the known ones."""
        names = tuple(known)
        for key, value in self.mapping().items():
            if key not in names:
                raise value.fault(f"unknown field '{key}'", nearest(key, names))

    def text_of(self, key: str, default: str = "") -> str:
        """Return the text under `key`, or `default`."""
        found = self.get(key)
        return default if found is None else found.text()

    def flag_of(self, key: str) -> bool:
        """Return the truth value under `key`, or False."""
        found = self.get(key)
        return False if found is None else found.flag()

    def choice_of(self, key: str, choices: tuple[str, ...], default: str) -> str:
        """Return the text under `key`, which must be one of `choices`, or `default`."""
        found = self.get(key)
        return default if found is None else found.choice(choices)

    def texts_of(self, key: str) -> tuple[str, ...]:
        """Return the texts under `key`, or nothing."""
        found = self.get(key)
        return () if found is None else found.texts()

    def number_of(self, key: str, low: float, high: float, default: float) -> float:
        """Return the number under `key`, within `low` … `high`, or `default`."""
        found = self.get(key)
        return default if found is None else found.number(low, high)

    # Sequences

    def sequence(self) -> list[Node]:
        """Return the value as a list of nodes."""
        if not isinstance(self._node, yaml.SequenceNode):
            raise self.fault("expected a list", "write it as [a, b] or one '- item' a line")
        return [Node(item, self.file) for item in self._node.value]

    def texts(self) -> tuple[str, ...]:
        """Return the value as a list of at least one text."""
        found = tuple(item.text() for item in self.sequence())
        if not found:
            raise self.fault("the list is empty", "add at least one item, or remove the key")
        return found

    def is_mapping(self) -> bool:
        """Whether the value is made of keys and values."""
        return isinstance(self._node, yaml.MappingNode)

    def is_sequence(self) -> bool:
        """Whether the value is a list."""
        return isinstance(self._node, yaml.SequenceNode)

    # Scalars

    def is_text(self) -> bool:
        """Whether the value is a single text."""
        return isinstance(self._node, yaml.ScalarNode)

    def _scalar(self) -> tuple[str, str]:
        if not isinstance(self._node, yaml.ScalarNode):
            raise self.fault("expected a single value", "write one word, text or number here")
        return self._node.tag, str(self._node.value)

    def text(self, empty: bool = False) -> str:
        """Return the value as text; a number or a bare yes / no is an error, never a guess.

        With `empty`, "" is a text too.
        """
        tag, value = self._scalar()
        if tag == _BOOL:
            raise self.fault(
                f"'{value}' is a truth value in YAML, not a word", f'put it in quotes: "{value}"'
            )
        if tag != _STR:
            kind = "nothing" if tag == _NULL else f"'{shown(value)}'"
            raise self.fault(
                f"expected text, found {kind}", 'write a text, in "quotes" if in doubt'
            )
        if not (empty or value.strip()):
            raise self.fault("the text is empty", "write at least one word, or remove the key")
        return value

    def flag(self) -> bool:
        """Return the value as a truth value; only true and false count."""
        tag, value = self._scalar()
        if tag == _BOOL and value.lower() in ("true", "false"):
            return value.lower() == "true"
        raise self.fault(f"expected true or false, found '{shown(value)}'", "write true or false")

    def choice(self, choices: tuple[str, ...]) -> str:
        """Return the value, which must be one of `choices`."""
        value = self.text()
        if value not in choices:
            raise self.fault(
                f"'{shown(value)}' is not possible here", f"choose from: {', '.join(choices)}"
            )
        return value

    def number(self, low: float, high: float) -> float:
        """Return the value as a number within `low` … `high`."""
        tag, value = self._scalar()
        if tag not in (_INT, _FLOAT):
            raise self.fault(
                f"expected a number, found '{shown(value)}'", f"write {low:g} to {high:g}"
            )
        try:
            number = float(value.replace("_", ""))
        except ValueError:
            number = float("nan")
        if not low <= number <= high:
            raise self.fault(
                f"{shown(value)} is out of range", f"write a number from {low:g} to {high:g}"
            )
        return number

    def integer(self, low: int, high: int) -> int:
        """Return the value as a whole number within `low` … `high`."""
        number = self.number(low, high)
        if number != int(number):
            raise self.fault(f"expected a whole number, found {number:g}", "drop the decimals")
        return int(number)


def read_yaml(path: str | PathLike[str], shown: str | None = None) -> Node:
    """Parse one YAML file into a `Node`; `shown` is how error messages name the file.

    Raises `PersonageError` if the file cannot be read and `DataError` if it is not YAML.
    """
    name = shown or str(path)
    return parse_yaml(read_text(path, name), name)


def read_text(path: str | PathLike[str], name: str) -> str:
    """Return a file's text; `name` is how error messages call the file."""
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError as error:
        raise PersonageError(f"{name}: cannot be read ({error.strerror}); check the path") from None
    return decoded(content, name)


def decoded(content: bytes, name: str) -> str:
    """Return bytes as UTF-8 text; `name` is how error messages call where they are from."""
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        raise DataError(name, line, "this is not UTF-8 text", "save the file as UTF-8") from None


def parse_yaml(content: str, name: str) -> Node:
    """Parse YAML text into a `Node`; `name` is how error messages call it."""
    return Node(compose(content, name), name)


def compose(
    content: str, name: str, deepest: int = _DEEPEST, page: str = "docs/facts.md"
) -> yaml.Node:
    """Parse YAML text into PyYAML's nodes; more levels than `deepest` are refused.

    `page` is where the documentation tells what such a file holds.
    """
    try:
        if sum(content.count(mark) for mark in _NESTING) > _HARMLESS:
            _refuse_deep_nesting(content, name, deepest)
        node = yaml.compose(content, Loader=_Loader)
    except yaml.reader.ReaderError as error:  # A character that no YAML file can hold.
        line = content.encode().count(b"\n", 0, error.position) + 1
        raise DataError(name, line, f"not valid YAML ({error.reason})", "remove it") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = mark.line + 1 if mark else 1
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        raise DataError(name, line, f"not valid YAML ({problem})", "mend the syntax") from None
    if node is None:
        raise DataError(name, 1, "the file is empty", f"see {page} for what it holds")
    return node


def _refuse_deep_nesting(content: str, name: str, deepest: int) -> None:
    """Raise `DataError` at the first value that stands in too many others."""
    depth = 0
    for event in yaml.parse(content, Loader=_Loader):
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > deepest:
                mark = event.start_mark
                line = mark.line + 1 if mark else 1
                raise DataError(name, line, f"more than {deepest} levels deep", "nest less")
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1
