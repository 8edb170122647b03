"""Reads `cases.yaml`: specifications written as YAML tags that mirror the realizer's types.

`!Clause {verb: be}` gives the fields by name, `!Clause [be, *alice]` in their order, and
`!Text a cat` the only one; `<<: *alice` takes over the fields of another value.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from personage_lite.realizer import Clause, Sentence, specification

_TYPES = {
    "!Adjective": specification.AdjectivePhrase,
    "!Cased": specification.Cased,
    "!Clause": specification.Clause,
    "!Coordination": specification.Coordination,
    "!Embedded": specification.Embedded,
    "!Joined": specification.Joined,
    "!Noun": specification.NounPhrase,
    "!Opener": specification.Opener,
    "!Sentence": specification.Sentence,
    "!Subordinate": specification.Subordinate,
    "!Text": specification.Text,
}


class Case(NamedTuple):
    """One reviewed case: what is realized, and the only text that is right."""

    group: str
    name: str
    spec: Sentence | Clause
    text: str


class _Loader(yaml.SafeLoader):
    """Safe YAML with lists as tuples and the realizer's types as tags."""


def _sequence(loader: _Loader, node: yaml.SequenceNode) -> tuple[Any, ...]:
    return tuple(loader.construct_sequence(node, deep=True))


def _typed(kind: Any, loader: _Loader, node: yaml.Node) -> object:
    if isinstance(node, yaml.MappingNode):
        fields = loader.construct_mapping(node, deep=True)
        return kind(**{str(name): value for name, value in fields.items()})
    if isinstance(node, yaml.SequenceNode):
        values = _sequence(loader, node)
    else:
        assert isinstance(node, yaml.ScalarNode)
        values = (loader.construct_scalar(node),)
    return kind(values) if kind is specification.Text else kind(*values)


_Loader.add_constructor("tag:yaml.org,2002:seq", _sequence)
for _tag, _kind in _TYPES.items():
    _Loader.add_constructor(_tag, partial(_typed, _kind))


def read_cases() -> list[Case]:
    """Return every case of the file in its order."""
    path = Path(__file__).with_name("cases.yaml")
    groups = yaml.load(path.read_text(encoding="utf-8"), Loader=_Loader)["groups"]
    return [
        Case(group, row["name"], row["spec"], row["text"])
        for group, rows in groups.items()
        for row in rows
    ]
