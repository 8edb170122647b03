"""The JSON Schema of specification files, made from the specification's own types."""

from __future__ import annotations

import json
from inspect import getdoc
from types import NoneType
from typing import Any

from personage_lite.realizer.specification import Text
from personage_lite.realizer.types import (
    FIELDS,
    MARKS,
    SPOKEN,
    choices,
    item_type,
    options,
    required,
)

_DRAFT = "https://json-schema.org/draft/2020-12/schema"
_PLAIN = {str: "string", bool: "boolean", int: "integer", float: "number", NoneType: "null"}
_WORDS, _PARTS = "Words", FIELDS[Text]["parts"]


def schema_text() -> str:
    """Return the schema as indented JSON."""
    return json.dumps(schema(), indent=2, ensure_ascii=False)


def schema() -> dict[str, Any]:
    """Return the schema of a specification file: a specification, a list, or a named list."""
    spoken = _type(SPOKEN)
    listed = {"type": "array", "items": spoken, "minItems": 1}
    named = {
        "type": "object",
        "properties": {"shared": {}, "sentences": {"anyOf": [listed, spoken]}},
        "required": ["sentences"],
        "additionalProperties": False,
    }
    return {
        "$schema": _DRAFT,
        "title": "What `personage-lite realize` says",
        "anyOf": [named, listed, spoken],
        "$defs": {
            **{kind.__name__: _object(kind) for kind in MARKS},
            # Fixed words: a string, or a list of words and phrases.
            _WORDS: {
                "anyOf": [_reference(Text), {"type": "string"}, {**_type(_PARTS), "minItems": 1}]
            },
        },
    }


def _object(kind: Any) -> dict[str, Any]:
    """Return the schema of one type as a mapping."""
    made: dict[str, Any] = {
        "type": "object",
        "description": " ".join((getdoc(kind) or "").split("\n\n", 1)[0].split()),
        "properties": {name: _field(kind, name) for name in FIELDS[kind]},
        "additionalProperties": False,
    }
    if required(kind):
        made["required"] = list(required(kind))
    elif len(MARKS[kind]) > 1:
        made["anyOf"] = [{"required": [mark]} for mark in MARKS[kind]]
    return made


def _field(kind: Any, name: str) -> dict[str, Any]:
    found = _type(FIELDS[kind][name])
    default = kind._field_defaults.get(name)
    if default is not None and default != ():
        found = {**found, "default": default}
    return found


def _type(hint: Any) -> dict[str, Any]:
    """Return the schema of a value of a type."""
    able = [_option(option) for option in options(hint)]
    flat = [each for option in able for each in option.get("anyOf", [option])]
    unique = [each for index, each in enumerate(flat) if each not in flat[:index]]
    return unique[0] if len(unique) == 1 else {"anyOf": unique}


def _option(option: Any) -> dict[str, Any]:
    if choices(option):
        return {"enum": list(choices(option))}
    item = item_type(option)
    if item is not None:
        return {"type": "array", "items": _type(item)}
    if option is Text:
        return {"$ref": f"#/$defs/{_WORDS}"}
    if option in _PLAIN:
        return {"type": _PLAIN[option]}
    return _reference(option)


def _reference(kind: Any) -> dict[str, Any]:
    return {"$ref": f"#/$defs/{kind.__name__}"}
