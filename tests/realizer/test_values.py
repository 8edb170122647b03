"""Proves that specifications are values: they cannot be changed, and copies of them are equal.

They and the errors about them can be pickled; a copy with another value is checked like a new one.
"""

from __future__ import annotations

import copy
import pickle
from typing import Any

import pytest

from personage_lite.errors import PersonageError
from personage_lite.realizer import (
    AdjectivePhrase,
    Clause,
    NounPhrase,
    Sentence,
    SpecificationError,
)
from personage_lite.realizer.types import FIELDS
from tests.mutation import check_message
from tests.realizer.case_list import read_cases
from tests.realizer.random_specs import RandomSpecs
from tests.realizer.reader_helpers import KINDS, REALIZER, data_of, made, say


def specimens() -> list[Any]:
    """Return a value of every type, and some whole specifications."""
    found = {type(part): part for seed in range(300) for part in _parts(_random(seed))}
    assert set(found) >= set(KINDS), set(KINDS) - set(found)
    return [found[kind] for kind in KINDS] + [_random(seed) for seed in range(20)]


def _random(seed: int) -> Sentence:
    return RandomSpecs(seed).sentence()


def _parts(spec: Any) -> list[Any]:
    if not isinstance(spec, tuple):
        return []
    own = [spec] if type(spec) in FIELDS else []
    return own + [part for each in spec for part in _parts(each)]


@pytest.mark.parametrize("spec", specimens(), ids=lambda spec: type(spec).__name__)
def test_specifications_are_values(spec: Any) -> None:
    """They cannot be changed, can be hashed, copied and pickled, and are then equal."""
    with pytest.raises(AttributeError):
        setattr(spec, spec._fields[0], "b")
    with pytest.raises(AttributeError):
        spec.brand_new = 1
    with pytest.raises(AttributeError):
        delattr(spec, spec._fields[0])
    with pytest.raises(TypeError):
        spec[0] = "b"
    assert hash(spec) == hash(copy.deepcopy(spec))
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(spec, protocol))
        assert type(again) is type(spec)
        assert again == spec
        assert repr(again) == repr(spec)
    for again in (copy.copy(spec), copy.deepcopy(spec), type(spec)(*spec), spec._replace()):
        assert type(again) is type(spec)
        assert again == spec
    assert type(spec)(**spec._asdict()) == spec


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: str(kind.__name__))
def test_replace(kind: Any) -> None:
    """Another value is a copy's; a feature that does not exist is an error."""
    least, embed, _ = data_of(kind)
    spec = next(part for part in _parts(made(embed(least))) if type(part) is kind)
    first = kind._fields[0]
    assert getattr(spec._replace(**{first: "other"}), first) == "other"
    assert getattr(spec, first) != "other"
    for wrong in ("zz", f"{first}x", "_fields", ""):
        with pytest.raises((ValueError, SpecificationError)):
            spec._replace(**{wrong: 1})


def test_no_copy_has_a_value_that_a_feature_cannot_have() -> None:
    """It is refused when the copy is made, or at the latest when it is said."""
    wrong: list[tuple[Any, str, str]] = [
        (NounPhrase("cat"), "number", "many"),
        (Clause("go", "a"), "mood", "asking"),
        (Clause("go", "a"), "tense", "pst"),
        (AdjectivePhrase("big"), "degree", "more"),
        (Clause("go", "a"), "form", "going"),
    ]
    said = []
    for spec, name, value in wrong:
        try:
            said.append(REALIZER.realize(spec._replace(**{name: value})))
        except SpecificationError as error:
            check_message(error)
    assert not said


def test_every_case_is_a_value() -> None:
    for case in read_cases()[::7]:
        assert pickle.loads(pickle.dumps(case.spec)) == case.spec
        assert isinstance(hash(case.spec), int)


@pytest.mark.parametrize(
    "content", ["noun: 7", "noun: [", "{verb: go}"], ids=["reading", "syntax", "realizing"]
)
def test_errors_can_be_pickled(content: str) -> None:
    """A pool of processes sends them home; one that cannot be sent leaves the caller waiting."""
    with pytest.raises(PersonageError) as caught:
        say(content)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    with pytest.raises(SpecificationError) as misread:
        REALIZER.realize(Clause("go"))
    assert str(pickle.loads(pickle.dumps(misread.value))) == str(misread.value)
