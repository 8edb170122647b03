"""Plain data (from YAML or JSON) to a specification; every fault names the path to its place."""

from __future__ import annotations

from types import NoneType
from typing import Any, NamedTuple

from personage_lite.errors import nearest, shown
from personage_lite.realizer.features import SpecificationError, unprintable
from personage_lite.realizer.specification import Phrase, Sentence, Text
from personage_lite.realizer.types import (
    DEEPEST,
    FIELDS,
    MARKS,
    SPOKEN,
    choices,
    described,
    item_type,
    options,
    required,
)

Path = tuple[str | int, ...]
# An anchor of anchors can stand for more values than there is memory for.
_MOST_VALUES = 100_000


def path_text(path: Path) -> str:
    """Return a path as a message shows it; the middle of a long one is left out.

    >>> path_text(("subject", "adjectives", 0))
    'subject.adjectives[0]'
    """
    if len(path) > 12:
        return f"{path_text(path[:6])}…{path_text(path[-3:])}"
    text = ""
    for step in path:
        text += f"[{step}]" if isinstance(step, int) else f".{shown(step)}"
    return text.removeprefix(".")


class MisreadError(SpecificationError):
    """A fault in plain data; `path` leads to its place.

    >>> str(MisreadError(("subject", "adjectives", 0), "nothing here", "write a text"))
    'subject.adjectives[0]: nothing here; write a text'
    """

    def __init__(self, path: Path, what: str, remedy: str) -> None:
        place = f"{path_text(path)}: " if path else ""
        super().__init__(f"{place}{what}; {remedy}")
        self.path, self.what, self.remedy = path, what, remedy

    def __reduce__(self) -> tuple[object, ...]:
        return MisreadError, (self.path, self.what, self.remedy)

    def inside(self, path: Path) -> MisreadError:
        """Return the same fault, with the path to what holds the specification before its own."""
        return MisreadError((*path, *self.path), self.what, self.remedy)


def read_specification(data: object, path: Path = ()) -> Sentence | Phrase:
    """Read a sentence, a clause or any other phrase from plain data.

    A mapping is of the type whose field stands in it: `noun` of a noun phrase, `verb` of a
    clause, `body` of a sentence; a string is fixed words, a list is fixed words and phrases.
    Raises `MisreadError` for an unknown field, a wrong type and what is nested too deep.

    >>> from personage_lite import english
    >>> run = {"verb": "run", "subject": {"noun": "rabbit", "determiner": "a"}, "tense": "past"}
    >>> english().realize(read_specification(run))
    'A rabbit ran.'
    """
    found: Sentence | Phrase = _read(data, SPOKEN, path, _Around((), [_MOST_VALUES]))
    return found


class _Around(NamedTuple):
    """The identities of the values that a value stands in, and how many more may be read."""

    values: tuple[int, ...]
    left: list[int]


def _read(data: Any, hint: Any, path: Path, around: _Around) -> Any:
    """Read a value of a type."""
    if isinstance(data, dict | list):
        if id(data) in around.values:
            raise MisreadError(path, "this contains itself", "write it out, or leave it out")
        if len(around.values) >= DEEPEST:
            raise MisreadError(path, f"more than {DEEPEST} levels deep", "nest less")
        around.left[0] -= 1
        if around.left[0] < 0:
            raise MisreadError(path, f"more than {_MOST_VALUES:,} values", "say less at once")
        around = around._replace(values=(*around.values, id(data)))
    able = options(hint)
    if isinstance(data, dict):
        return _mapping(data, able, path, around)
    if isinstance(data, list):
        return _list(data, able, path, around)
    return _scalar(data, able, path)


def _mapping(data: dict[Any, Any], able: tuple[Any, ...], path: Path, around: _Around) -> Any:
    kinds = [kind for kind in able if kind in MARKS]
    if not kinds:
        raise _unfit(data, able, path)
    if len(kinds) == 1:
        kind = kinds[0]
    else:
        fitting = [kind for kind in kinds if any(mark in data for mark in MARKS[kind])]
        if not fitting:
            names = sorted(mark for kind in kinds for mark in MARKS[kind])
            raise MisreadError(
                path, "nothing says what this is", f"give it one of: {', '.join(names)}"
            )
        # Of several that it may be meant to be, the one that knows most of what is given.
        kind = max(fitting, key=lambda each: sum(name in FIELDS[each] for name in data))
    fields = FIELDS[kind]
    values = {}
    for name, value in data.items():
        if name not in fields:
            remedy = nearest(str(name), fields)
            what = f"{kind.__name__} has no field '{shown(str(name))}'"
            raise MisreadError((*path, str(name)), what, remedy)
        values[name] = _read(value, fields[name], (*path, name), around)
    for name in required(kind):
        if name not in values:
            raise MisreadError(path, f"'{name}' is missing", f"add '{name}: …'")
    return kind(**values)


def _list(data: list[Any], able: tuple[Any, ...], path: Path, around: _Around) -> Any:
    for option in able:
        # A list of phrases and words where a phrase is wanted is a text.
        inner = FIELDS[Text]["parts"] if option is Text else option
        item = item_type(inner)
        if item is not None:
            items = tuple(
                _read(each, item, (*path, index), around) for index, each in enumerate(data)
            )
            if option is not Text:
                return items
            if not items:
                raise MisreadError(path, "the list is empty", "add words, or remove the field")
            return Text(items)
    raise _unfit(data, able, path)


def _scalar(data: Any, able: tuple[Any, ...], path: Path) -> Any:
    strange = unprintable(data) if isinstance(data, str) else ""
    if strange:
        raise MisreadError(path, f"{strange!a} cannot be printed", "leave it out")
    for option in able:
        allowed = choices(option)
        if allowed:
            if any(data == each and type(data) is type(each) for each in allowed):
                return data
            if len(able) == 1:
                what = f"{found(data)} is not possible here"
                raise MisreadError(path, what, nearest(str(data), map(str, allowed)))
        elif option is Text and isinstance(data, str):
            return Text((data,))
        elif type(data) is option or (option is float and type(data) is int):
            return data
    raise _unfit(data, able, path)


def _unfit(data: Any, able: tuple[Any, ...], path: Path) -> MisreadError:
    expected = described(able)
    quoted = str in able and isinstance(data, bool | int | float)
    remedy = "put it in quotes" if quoted else "see docs/realizer.md"
    if any(item_type(option) for option in able):
        remedy = "write it as a list, [ … ]"
    return MisreadError(path, f"expected {expected}, found {found(data)}", remedy)


def found(data: object) -> str:
    """Return what a message calls a value that does not belong where it stands.

    >>> found(True), found([1])
    ("'true'", 'a list')
    """
    if isinstance(data, bool):
        return f"'{str(data).lower()}'"
    if isinstance(data, str | int | float):
        return f"'{shown(str(data))}'"
    names = {dict: "a mapping", list: "a list", tuple: "a tuple", NoneType: "nothing"}
    return names.get(type(data)) or f"a value of type {type(data).__name__}"
