"""Proves that the realizer says each reviewed specification of `cases/` letter by letter."""

from __future__ import annotations

import pytest

from personage_lite import english
from personage_lite.realizer import Realizer
from tests.realizer.case_list import Case, read_cases

CASES = read_cases()
REALIZERS: dict[tuple[tuple[str, object], ...], Realizer] = {
    options: english(**dict(options)) for options in {case.options for case in CASES}
}


@pytest.mark.parametrize(
    "case", CASES, ids=[f"{case.phenomenon}-{case.group}-{case.name}" for case in CASES]
)
def test_case(case: Case) -> None:
    """The text is exactly the reviewed one, and asking again changes nothing."""
    realizer = REALIZERS[case.options]
    assert realizer.realize(case.spec) == case.text
    assert realizer.realize(case.spec) == case.text


def test_there_are_enough_cases_and_no_two_share_a_name() -> None:
    """The files cover what they say they cover, and every failure can be found by its name."""
    assert len(CASES) >= 600
    names = [(case.phenomenon, case.group, case.name) for case in CASES]
    assert len(set(names)) == len(names)
