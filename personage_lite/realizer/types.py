"""The specification's types as data, for what reads, checks or describes specifications."""

from __future__ import annotations

from types import NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

from personage_lite.realizer import specification
from personage_lite.realizer.numerals import Date
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Embedded,
    Joined,
    NounPhrase,
    Numeral,
    Opener,
    PrepositionalPhrase,
    Question,
    Quotation,
    Relative,
    Sentence,
    Subordinate,
    Text,
)

# Each type with the fields of which one must stand in a mapping that is meant to be it, where
# several types are possible.
MARKS: dict[Any, tuple[str, ...]] = {
    Sentence: ("body",),
    Clause: ("verb",),
    NounPhrase: ("noun",),
    AdjectivePhrase: ("adjective",),
    PrepositionalPhrase: ("preposition",),
    Coordination: ("items",),
    Embedded: ("lead",),
    Cased: ("phrase",),
    Text: ("parts",),
    Numeral: ("value",),
    Date: ("year", "month", "day"),
    Quotation: ("speech",),
    Question: ("phrase",),
    Relative: ("clause",),
    Subordinate: ("conjunction",),
    Joined: ("conjunction",),
    Opener: ("text",),
}
# Each type's fields with their types.
FIELDS: dict[Any, dict[str, Any]] = {
    kind: get_type_hints(kind, vars(specification)) for kind in MARKS
}
# What can be realized: a sentence, or what can be the body of one.
SPOKEN = Sentence | FIELDS[Sentence]["body"]
# How deep a specification may be nested: more is a mistake, and would break the realizer.
DEEPEST = 64


def required(kind: Any) -> tuple[str, ...]:
    """Return the fields that a type cannot do without.

    >>> required(Clause)
    ('verb',)
    """
    return tuple(name for name in kind._fields if name not in kind._field_defaults)


def options(hint: Any) -> tuple[Any, ...]:
    """Return the types that a field may have, one by one.

    >>> options(int | None)
    (<class 'int'>, <class 'NoneType'>)
    """
    if get_origin(hint) in (Union, UnionType):
        return tuple(option for each in get_args(hint) for option in options(each))
    return (hint,)


def choices(hint: Any) -> tuple[Any, ...]:
    """Return the values of a `Literal` type, or nothing for another one."""
    return get_args(hint) if get_origin(hint) is Literal else ()


def item_type(hint: Any) -> Any:
    """Return the type of the items of a tuple type, or None for another one."""
    return get_args(hint)[0] if get_origin(hint) is tuple else None


def described(able: tuple[Any, ...]) -> str:
    """Return what a field of these types takes, in a user's words.

    >>> described(options(tuple[str, ...] | None))
    'a list'
    """
    words = []
    for option in able:
        if option is NoneType:
            continue
        if choices(option):
            words.append(" or ".join(str(choice) for choice in choices(option)))
        elif item_type(option):
            words.append("a list")
        else:
            words.append(_PLAIN.get(option) or f"a {option.__name__}")
    if len(words) > 4:
        return "a phrase"
    return " or ".join(dict.fromkeys(words))


_PLAIN = {
    str: "a text",
    bool: "true or false",
    int: "a whole number",
    float: "a number",
    Text: "a text",
}
