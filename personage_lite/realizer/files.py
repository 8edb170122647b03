"""Files of specifications, YAML or JSON, and the sentences that they hold."""

from __future__ import annotations

import json
from typing import Any

import yaml

from personage_lite.errors import DataError, PersonageError, shown
from personage_lite.realizer import Phrase, Realizer, Sentence
from personage_lite.realizer.reader import MisreadError, Path, path_text, read_specification
from personage_lite.realizer.types import DEEPEST
from personage_lite.yaml_reader import compose, read_text

# What is nested deeper than this is not even parsed; up to it, errors can name the path.
_DEEPEST = 2500
_MERGE = "tag:yaml.org,2002:merge"
_SHARED, _SENTENCES = "shared", "sentences"


def realize_file(content: str, name: str, realizer: Realizer) -> list[str]:
    """Return the texts of a file: of one specification, a list, or a list under `sentences`.

    What stands under `shared` is for YAML's anchors and is not said. `name` is how errors call
    the file. Raises `PersonageError` with file, path and for YAML the line, before anything is
    said by halves.
    """
    data, node = _parse(content, name)
    try:
        return [
            _realized(read_specification(each, path), path, realizer)
            for path, each in _specifications(data)
        ]
    except MisreadError as error:
        line = _line(node, error.path)
        if line is None:
            raise PersonageError(f"{name}: {error}") from None
        what = str(error).removesuffix(f"; {error.remedy}")
        raise DataError(name, line, what, error.remedy) from None


def _specifications(data: Any) -> list[tuple[Path, Any]]:
    """Return each specification of a file's data with the path to it."""
    path: Path = ()
    if isinstance(data, dict) and _SENTENCES in data:
        for key in data:
            if key not in (_SHARED, _SENTENCES):
                what = f"unknown field '{shown(key)}' beside '{_SENTENCES}'"
                raise MisreadError((key,), what, f"put it under '{_SHARED}'")
        data, path = data[_SENTENCES], (_SENTENCES,)
    elif isinstance(data, dict) and _SHARED in data:
        what = f"'{_SHARED}' without '{_SENTENCES}'"
        raise MisreadError((_SHARED,), what, f"put what is to be said under '{_SENTENCES}'")
    if not isinstance(data, list):
        return [(path, data)]
    if not data:
        raise MisreadError(path, "no sentence to say", "add one")
    return [((*path, index), each) for index, each in enumerate(data)]


def _realized(spec: Sentence | Phrase, path: Path, realizer: Realizer) -> str:
    try:
        return realizer.realize(spec)
    except MisreadError as error:
        raise error.inside(path) from None


def read_data(path: str) -> Any:
    """Return the plain data of a YAML or JSON file."""
    return _parse(read_text(path, path), path)[0]


def _parse(content: str, name: str) -> tuple[Any, yaml.Node | None]:
    """Return a file's plain data, and for YAML the nodes that know the lines."""
    doubled = ""
    if content.lstrip()[:1] in ("{", "["):
        try:
            return json.loads(content, object_pairs_hook=_unique), None
        except _DoubledKeyError as error:
            doubled = str(error)
        except json.JSONDecodeError as error:
            if name.endswith(".json"):
                what = f"not valid JSON ({error.msg})"
                raise DataError(name, error.lineno, what, "mend the syntax") from None
        except ValueError:
            raise PersonageError(f"{name}: a number is too long; write it in quotes") from None
        except RecursionError:
            pass
        # YAML in flow style, or so deep that the path to it has to be found.
    node = compose(content, name, _DEEPEST, "docs/realizer.md")
    data = plain(node, name, (), {})
    if doubled:
        raise PersonageError(f"{name}: the key '{shown(doubled)}' stands twice; remove one")
    return data, node


class _DoubledKeyError(Exception):
    """A key that stands twice in one JSON object."""


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        raise _DoubledKeyError(next(name for name in names if names.count(name) > 1))
    return found


def plain(
    node: yaml.Node, name: str, path: Path, done: dict[int, Any], around: tuple[int, ...] = ()
) -> Any:
    """Return a YAML value as plain data; `<<` takes over the keys of another mapping.

    Words that YAML 1.1 takes for truth values (no, yes, on) stay words; only true and false are
    truth values. What is `done` is not made again, so that an anchor's value inside itself stays
    recognizable; `around` is what a value stands in.
    """
    if id(node) in done:
        return done[id(node)]
    if len(path) > 2 * DEEPEST:
        what = f"{path_text(path)}: more than {DEEPEST} levels deep"
        raise DataError(name, _line_of(node), what, "nest less")
    around = (*around, id(node))
    if isinstance(node, yaml.SequenceNode):
        items: list[Any] = []
        done[id(node)] = items
        for index, item in enumerate(node.value):
            items.append(plain(item, name, (*path, index), done, around))
        return items
    if not isinstance(node, yaml.MappingNode):
        return _scalar(node)
    found: dict[str, Any] = {}
    done[id(node)] = found
    merged: dict[str, Any] = {}
    for key, value in node.value:
        if not isinstance(key, yaml.ScalarNode):
            raise DataError(name, _line_of(key), "a key is no single word", "write 'key: value'")
        if key.tag == _MERGE:
            for one in value.value if isinstance(value, yaml.SequenceNode) else (value,):
                if id(one) in around:
                    what = f"{path_text((*path, '<<'))}: this contains itself"
                    raise DataError(name, _line_of(key), what, "write it out, or leave it out")
                taken = plain(one, name, (*path, "<<"), done, around)
                if not isinstance(taken, dict):
                    what = "'<<' takes over no mapping"
                    raise DataError(name, _line_of(key), what, "name one, as in '<<: *alice'")
                merged = {**taken, **merged}
        elif key.value in found:
            what = f"the key '{shown(key.value)}' stands here a second time"
            raise DataError(name, _line_of(key), what, "remove one of the two")
        else:
            found[key.value] = plain(value, name, (*path, key.value), done, around)
    for each, taken in merged.items():
        found.setdefault(each, taken)
    return found


def _scalar(node: yaml.Node) -> str | int | float | bool | None:
    value = str(node.value)
    kind = node.tag.rpartition(":")[2]
    if kind == "bool" and value.lower() in ("true", "false"):
        return value.lower() == "true"
    if kind == "null":
        return None
    try:
        if kind == "int":
            return int(value)
        if kind == "float":
            return float(value)
    except ValueError:
        pass  # 0x1F, 1:30: no number that a sentence would say
    return value


def _line(node: yaml.Node | None, path: Path) -> int | None:
    """Return the line of what a path leads to, or of the last thing on the way to it."""
    if node is None:
        return None
    line = _line_of(node)
    for step in path:
        inner: yaml.Node | None = None
        if isinstance(node, yaml.SequenceNode) and isinstance(step, int):
            inner = node.value[step]
        elif isinstance(node, yaml.MappingNode):
            inner = next((value for key, value in node.value if key.value == step), None)
        if inner is None:
            break
        node = inner
        line = _line_of(node)
    return line


def _line_of(node: yaml.Node) -> int:
    return int(node.start_mark.line) + 1
