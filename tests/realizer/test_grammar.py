"""Proves what the realizer's options do, and that realizers share nothing that can change."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from personage_lite import english
from personage_lite.data import data_folder
from personage_lite.errors import PersonageError
from personage_lite.realizer import (
    AdjectivePhrase,
    Clause,
    Coordination,
    Date,
    NounPhrase,
    Numeral,
    Realizer,
    Relative,
    Sentence,
)
from personage_lite.realizer.grammar import Grammar, load_grammar
from tests.mutation import check_message
from tests.realizer.case_list import read_cases

SHIPPED = Path(data_folder("lexicons"))
# Some of every phenomenon.
CASES = [case.spec for case in read_cases()[::25]]


@pytest.mark.parametrize(
    ("spec", "british", "american"),
    [
        (Clause("learn", "she", tense="past"), "She learnt.", "She learned."),
        (Clause("get", "she", perfect=True), "She has got.", "She has gotten."),
        (Clause("travel", "she", progressive=True), "She is travelling.", "She is traveling."),
        (Clause("quit", "she", tense="past"), "She quit.", "She quit."),
        (Numeral(101), "One hundred and one.", "One hundred one."),
        (Date(1862, 7, 4), "4 July 1862.", "July 4, 1862."),
        (Date(1862, 7, 4, style="iso"), "1862-07-04.", "1862-07-04."),
        (NounPhrase("herb", determiner="a"), "A herb.", "An herb."),
    ],
)
def test_dialects(spec: Any, british: str, american: str) -> None:
    assert english().realize(spec) == english("british").realize(spec) == british
    assert english("american").realize(spec) == american


@pytest.mark.parametrize("dialect", ["scots", "", "British", None, 7, "american "])
def test_an_unknown_dialect(dialect: Any) -> None:
    """It is refused: no one is silently given another."""
    with pytest.raises(PersonageError) as caught:
        english(dialect)
    check_message(caught.value)
    assert "american" in str(caught.value)


def test_commas_and_apostrophes() -> None:
    spec = Sentence(
        Clause("be", Coordination(("Al", "Bo", "Cy")), complement="late", contracted=True),
        tag="auto",
    )
    table: tuple[tuple[dict[str, Any], str], ...] = (
        ({}, "Al, Bo and Cy are late, aren't they?"),
        ({"oxford_comma": True}, "Al, Bo, and Cy are late, aren't they?"),
        ({"curly_apostrophes": True}, "Al, Bo and Cy are late, aren’t they?"),
        (
            {"oxford_comma": True, "curly_apostrophes": True},
            "Al, Bo, and Cy are late, aren’t they?",
        ),
    )
    for options, text in table:
        assert english(**options).realize(spec) == text
        assert english("american", **options).realize(spec) == text
    with pytest.raises(TypeError):
        english("british", True)  # type: ignore[call-arg]


def test_realizers_are_equal_and_independent() -> None:
    """Two of the same options share nothing that one could change for the other."""
    first, second = english(), english()
    assert first is not second
    assert first.grammar is not second.grammar
    assert first.grammar == second.grammar
    assert english("american").grammar != first.grammar
    assert english(oxford_comma=True).grammar == first.grammar._replace(oxford_comma=True)
    mouse = NounPhrase("mouse", number="plural")
    second.grammar.inflection.plurals["mouse"] = "meese"
    assert english().realize(mouse) == first.realize(mouse) == "Mice."
    assert first.grammar != second.grammar
    specs = [case.spec for case in read_cases()[::9] if not case.options]
    third = english()
    assert [first.realize(spec) for spec in specs] == [third.realize(spec) for spec in specs]


def test_a_realizer_is_never_changed_by_speaking() -> None:
    realizer = english()
    before = repr(realizer.grammar)
    for spec in CASES:
        realizer.realize(spec)
    assert repr(realizer.grammar) == before
    with pytest.raises(AttributeError):
        realizer.other = 1  # type: ignore[attr-defined]
    with pytest.raises(AttributeError):
        realizer.grammar.oxford_comma = True  # type: ignore[misc]


def test_the_folder_may_be_a_path_or_a_text() -> None:
    assert load_grammar(SHIPPED) == load_grammar(str(SHIPPED)) == english().grammar


def test_every_field_of_the_grammar_is_read() -> None:
    """Nothing is empty in the shipped files but what the options leave out."""
    grammar = load_grammar(SHIPPED, oxford_comma=True, curly_apostrophes=True)
    for name in Grammar._fields:
        assert getattr(grammar, name), name
    words = Clause(
        "be",
        NounPhrase("cat", relative=Relative(Clause("sleep"))),
        complement=AdjectivePhrase("kind", degree="comparative"),
    )
    assert Realizer(grammar).realize(words) == "Cat, which sleeps, is kinder."
