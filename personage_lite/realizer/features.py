"""Features that a specification may have: a misspelt one is an error as soon as it is written."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, get_args, get_origin

from personage_lite.errors import PersonageError, nearest, shown

T = TypeVar("T")

# What joins letters, or keeps them apart, in the scripts that need it: the only characters that
# cannot be seen and that a text may hold all the same.
JOINERS = "\u200c\u200d"
# What makes a value of a checked type. Compiled for each type, as a named tuple's own maker is:
# checking in a function around that one took a sixth of the time that a sentence takes.
_MAKER = """\
def __new__(_cls, {parameters}, **_unknown):
    if {wrong}:
        _refuse(_cls, _unknown, ({fields},))
    return _make(_cls, ({fields},))
"""


class SpecificationError(PersonageError):
    """A specification that cannot be said; `culprit` is the part at fault, where it is known."""

    def __init__(self, message: str, culprit: object = None) -> None:
        super().__init__(message)
        self.culprit = culprit


def checked(**choices: Any) -> Callable[[type[T]], type[T]]:
    """Return a class decorator that refuses unknown features, and values that are no choice.

    Each choice is a feature with the `Literal` type of its values, or of the items of its tuple.
    A feature of several values takes a tuple: a string there would be taken for its letters.
    """
    allowed: dict[str, tuple[Any, ...]] = {name: _values(type_) for name, type_ in choices.items()}

    def decorate(kind: type[T]) -> type[T]:
        made_by: Any = kind
        fields, defaults = made_by._fields, made_by._field_defaults
        several = [name for name in fields if "tuple[" in str(made_by.__annotations__[name])]
        wrong = ["_unknown", *(f"{name}.__class__ is not tuple" for name in several)]
        for name in allowed:
            test = f"{name} not in _{name}"
            wrong.append(
                f"({name} and not _{name}.issuperset({name}))" if name in several else test
            )

        def refuse(cls: type[T], unknown: dict[str, object], values: tuple[object, ...]) -> None:
            for name in unknown:
                what = f"{cls.__name__} has no feature '{shown(name)}'"
                raise SpecificationError(f"{what}; {nearest(name, fields)}")
            for name, value in zip(fields, values, strict=True):
                if name in several and not isinstance(value, tuple):
                    what = f"{cls.__name__}: {name} takes a tuple, not {value!r:.40}"
                    raise SpecificationError(f"{what}; write ({value!r:.40},)")
                for each in value if isinstance(value, tuple) else (value,):
                    if name in allowed and each not in allowed[name]:
                        what = f"{cls.__name__}: {name} cannot be '{shown(str(each))}'"
                        raise SpecificationError(
                            f"{what}; {nearest(str(each), map(str, allowed[name]))}"
                        )

        space: dict[str, Any] = {"_make": tuple.__new__, "_refuse": refuse}
        space |= {f"_{name}": values for name, values in allowed.items()}
        space |= {f"_{name}": frozenset(allowed[name]) for name in allowed if name in several}
        space |= {f"_default_{name}": default for name, default in defaults.items()}
        parameters = [f"{each}=_default_{each}" if each in defaults else each for each in fields]
        source = _MAKER.format(
            parameters=", ".join(parameters), wrong=" or ".join(wrong), fields=", ".join(fields)
        )
        exec(source, space)
        made_by.__new__ = space["__new__"]
        made_by.__new__.__qualname__ = f"{kind.__name__}.__new__"
        return kind

    return decorate


def unprintable(text: str) -> str:
    r"""Return the first sign that cannot be printed and is no blank or joiner; or nothing.

    >>> unprintable("a\x07b\n")
    '\x07'
    """
    if text.isprintable():
        return ""
    for sign in text:
        if not (sign.isprintable() or sign.isspace() or sign in JOINERS):
            return sign
    return ""


def _values(type_: Any) -> tuple[object, ...]:
    """Return the values of a `Literal` type, or of the items of a tuple of them."""
    return get_args(get_args(type_)[0] if get_origin(type_) is tuple else type_)
