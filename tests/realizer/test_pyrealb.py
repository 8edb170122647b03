"""Proves that each difference from pyrealb is reviewed, and that none is a fault of ours."""

from __future__ import annotations

import importlib.util

import pytest

if importlib.util.find_spec("pyrealb") is None:
    pytest.skip("pyrealb is not installed (pip install pyrealb==3.3.1)", allow_module_level=True)

from tests.realizer.pyrealb_comparison import WHO, Comparison, Review, compare, reviews


@pytest.fixture(scope="module")
def found() -> Comparison:
    return compare()


@pytest.fixture(scope="module")
def reviewed() -> dict[str, Review]:
    return reviews()


def test_every_difference_is_of_a_reviewed_class(
    found: Comparison, reviewed: dict[str, Review]
) -> None:
    """The rules turn what pyrealb says into what we say, and each rule's class is in the file."""
    assert found.unexplained == []
    assert set(found.classes) == set(reviewed)
    assert {row.who for row in reviewed.values()} <= set(WHO)


def test_no_difference_is_a_fault_of_ours(reviewed: dict[str, Review]) -> None:
    assert [name for name, row in reviewed.items() if row.who == "theirs"] == []


def test_every_class_still_occurs(found: Comparison) -> None:
    """A class that no pair is in any more must go: its rule could hide a new fault."""
    assert [name for name, members in found.classes.items() if not members] == []


def test_the_comparison_is_large_and_mostly_agrees(found: Comparison) -> None:
    """Thousands of pairs; a realizer or translation that fails everywhere would be seen."""
    assert len(found.pairs) > 10_000
    assert len(found.differing) < len(found.pairs) / 5
