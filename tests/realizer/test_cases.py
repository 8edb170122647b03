"""Proves that the realizer says each reviewed specification of `cases.yaml` letter by letter."""

from __future__ import annotations

import pytest

from personage_lite import english
from tests.realizer.cases import Case, read_cases

CASES = read_cases()
REALIZER = english()


@pytest.mark.parametrize("case", CASES, ids=[f"{case.group}-{case.name}" for case in CASES])
def test_case(case: Case) -> None:
    """The text is exactly the reviewed one."""
    assert REALIZER.realize(case.spec) == case.text


def test_there_are_enough_cases_and_no_two_share_a_name() -> None:
    """The file covers what it says it covers, and every failure can be found by its name."""
    assert len(CASES) >= 150
    names = [(case.group, case.name) for case in CASES]
    assert len(set(names)) == len(names)
