"""Why a specification could not be realized: the path to its fault, looked for only then."""

from __future__ import annotations

from typing import Any

from personage_lite.errors import PersonageError, nearest, shown
from personage_lite.realizer.reader import MisreadError, Path, found
from personage_lite.realizer.specification import Sentence
from personage_lite.realizer.types import (
    DEEPEST,
    FIELDS,
    SPOKEN,
    choices,
    described,
    item_type,
    options,
)


def diagnosed(sentence: object, error: Exception) -> MisreadError:
    """Return the error to raise for what went wrong in realizing a sentence.

    >>> from personage_lite.realizer import Clause, NounPhrase, Sentence
    >>> spec = Sentence(Clause("run", NounPhrase(12)))
    >>> str(diagnosed(spec, TypeError("…")))
    "body.subject.noun: expected a text, found '12'; see docs/realizer.md"
    """
    fault = _fault(sentence, Sentence if isinstance(sentence, Sentence) else SPOKEN, ())
    if fault is not None:
        return fault
    if isinstance(error, PersonageError):
        culprit = getattr(error, "culprit", None)
        path = _path_to(sentence, culprit) if culprit is not None else ()
        what, _, remedy = str(error).partition("; ")
        return MisreadError(path, what, remedy)
    what = " ".join(str(error).split()) or type(error).__name__
    return MisreadError((), f"this cannot be said ({what})", "see docs/realizer.md")


def _fault(value: Any, hint: Any, path: Path) -> MisreadError | None:
    """Return the first value of a wrong type, or what is nested too deep."""
    if len(path) > 2 * DEEPEST:
        return MisreadError(path, f"more than {DEEPEST} levels deep", "nest less")
    able = options(hint)
    kind = type(value)
    if kind in FIELDS and kind in able:
        for name, field in FIELDS[kind].items():
            fault = _fault(getattr(value, name), field, (*path, name))
            if fault is not None:
                return fault
        return None
    for option in able:
        if choices(option):
            if value in choices(option):
                return None
            if len(able) == 1:
                what = f"value cannot be '{shown(str(value))}'"
                return MisreadError(path, what, nearest(str(value), map(str, choices(option))))
        elif item_type(option) is not None and isinstance(value, tuple) and kind not in FIELDS:
            for index, item in enumerate(value):
                fault = _fault(item, item_type(option), (*path, index))
                if fault is not None:
                    return fault
            return None
        elif kind is option or (option is float and kind is int):
            return None
    what = f"expected {described(able)}, found {found(value)}"
    return MisreadError(path, what, "see docs/realizer.md")


def _path_to(value: Any, culprit: object, path: Path = ()) -> Path:
    """Return the path to a part of a specification, or none if it is no part of it."""
    if value is culprit:
        return path
    if isinstance(value, tuple):
        names = getattr(value, "_fields", range(len(value)))
        for name, part in zip(names, value, strict=True):
            found = _path_to(part, culprit, (*path, name))
            if found:
                return found
    return ()
