"""Features that a specification may have: a misspelt one is an error as soon as it is written."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar, get_args

from personage_lite.errors import PersonageError, nearest, shown

T = TypeVar("T")


class SpecificationError(PersonageError):
    """A specification that cannot be said; `culprit` is the part at fault, where it is known."""

    def __init__(self, message: str, culprit: object = None) -> None:
        super().__init__(message)
        self.culprit = culprit


def checked(**choices: Any) -> Callable[[type[T]], type[T]]:
    """Return a class decorator that refuses unknown features, and values that are no choice.

    Each choice is a feature with the `Literal` type of its values.
    """

    def decorate(kind: type[T]) -> type[T]:
        made_by: Any = kind
        make, fields = made_by.__new__, made_by._fields
        checks = tuple((fields.index(name), get_args(type_)) for name, type_ in choices.items())
        names, first = frozenset(choices), min(index for index, _ in checks)

        @wraps(make)  # so that editors show the features
        def new(cls: type[T], *values: object, **features: object) -> Any:
            try:
                made = make(cls, *values, **features)
            except TypeError as error:
                raise SpecificationError(_misfit(kind, fields, features, error)) from None
            # Defaults are right: only what is given needs a look.
            if len(values) > first or not names.isdisjoint(features):
                for index, allowed in checks:
                    if made[index] not in allowed:
                        raise wrong_value(kind.__name__, fields[index], made[index], allowed)
            return made

        made_by.__new__ = new
        return kind

    return decorate


def wrong_value(
    kind: str, feature: str, value: object, allowed: tuple[object, ...]
) -> SpecificationError:
    """Return the error for a value that a feature cannot have."""
    remedy = nearest(str(value), map(str, allowed))
    return SpecificationError(f"{kind}: {feature} cannot be '{shown(str(value))}'; {remedy}")


def _misfit(
    kind: type, fields: tuple[str, ...], features: dict[str, object], error: TypeError
) -> str:
    """Return what is wrong with the features that a value was made with."""
    for name in features:
        if name not in fields:
            return f"{kind.__name__} has no feature '{shown(name)}'; {nearest(name, fields)}"
    return f"{kind.__name__}: {str(error).replace('<lambda>()', 'it').replace('__new__()', 'it')}"
