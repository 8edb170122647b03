"""Proves that lemminflect, as a second opinion, agrees on its whole vocabulary or is explained.

See `lemminflect_comparison`.
"""

from __future__ import annotations

import importlib.util

import pytest

from personage_lite.realizer.inflection import Dialect
from tests.realizer.lemminflect_comparison import DIALECTS, EXPLANATIONS, PARTS, compare, explain


@pytest.mark.skipif(importlib.util.find_spec("lemminflect") is None, reason="needs lemminflect")
@pytest.mark.parametrize("dialect", DIALECTS)
def test_whole_vocabulary_agrees_or_is_explained(dialect: Dialect) -> None:
    """Every form that lemminflect does not list is in a class that was looked at."""
    least = {"verb": 99.4, "noun": 99.5, "adj": 98.0, "adv": 98.5}
    found = compare(dialect)
    assert found.keys() == set(PARTS)
    for part, comparison in found.items():
        _, rest = explain(comparison.differences)
        assert rest == []
        assert comparison.compared > 4000
        assert comparison.agreement > least[part]


@pytest.mark.skipif(importlib.util.find_spec("lemminflect") is None, reason="needs lemminflect")
def test_no_explanation_is_idle() -> None:
    """Each class still explains something."""
    used = set()
    for dialect in DIALECTS:
        for part, comparison in compare(dialect).items():
            classes, _ = explain(comparison.differences)
            used |= {(part, why) for why in classes}
    assert {(explanation.part, explanation.why) for explanation in EXPLANATIONS} == used
