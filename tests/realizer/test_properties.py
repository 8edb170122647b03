"""Proves what holds of every sentence: any well-typed specification becomes clean written text.

The text begins with a capital, ends in one end mark, doubles no mark or space, is the same each
time and in every thread, and the specification is left as it was. Negation, question and answer
agree as the clause they come from does.
"""

from __future__ import annotations

import copy
import re
from concurrent.futures import ThreadPoolExecutor

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite import english
from personage_lite.realizer import Clause, NounPhrase, Phrase, Sentence
from tests.realizer.case_list import read_cases
from tests.realizer.random_specs import RandomSpecs

REALIZER = english()
AMERICAN = english("american", oxford_comma=True)
DOUBLED = re.compile(r"[.,!?…][”’]*[.,]|[.,!?][”’]*[.,!?…]|……")
SPACED = re.compile(r" [.,!?…”]|  |^ | $|“ |^,")
ABBREVIATED = re.compile(r"(?i)\b(etc|a\.m)\.(?=[”’]*[,?!…])")
SEEDS = range(2000)


def check(text: str) -> None:
    """Refuse text that no editor would let through."""
    first = next(letter for letter in text if letter.isalnum())
    assert not first.isalpha() or first.isupper(), text
    assert text.rstrip("”’")[-1] in ".!?…", text
    # A question about what was shouted keeps both marks: “Off with her head!”?
    assert not DOUBLED.search(
        ABBREVIATED.sub("etc", text.replace("...", "…").replace("!”?", "”?").replace("!’?", "’?"))
    ), text
    assert not SPACED.search(text), text
    assert "\x00" not in text


def test_every_sentence_is_clean_text() -> None:
    """Whatever is asked for, the text keeps the rules; asking again changes nothing."""
    for seed in SEEDS:
        sentence = RandomSpecs(seed).sentence()
        before = copy.deepcopy(sentence)
        text = REALIZER.realize(sentence)
        check(text)
        assert REALIZER.realize(sentence) == text
        assert sentence == before
        check(AMERICAN.realize(sentence))


def test_a_bare_clause_or_phrase_is_a_sentence() -> None:
    """A clause or another phrase alone is said as the sentence that holds nothing else."""
    for seed in SEEDS:
        phrase = RandomSpecs(seed).phrase(2)
        text = REALIZER.realize(phrase)
        check(text)
        assert text == REALIZER.realize(Sentence(phrase))


_PRONOUNS = st.fixed_dictionaries(
    {
        "noun": st.just("one"),
        "pronoun": st.just(True),
        "person": st.sampled_from([1, 2, 3]),
        "number": st.sampled_from(["singular", "plural"]),
        "gender": st.sampled_from(["masculine", "feminine", "neuter"]),
    }
).map(lambda features: NounPhrase(**features))  # type: ignore[arg-type]
_SIMPLE = st.fixed_dictionaries(
    {
        "verb": st.sampled_from(["be", "have", "do", "run", "cry"]),
        "subject": _PRONOUNS,
        "complement": st.just("here"),
        "tense": st.sampled_from(["present", "past", "future"]),
        "modal": st.sampled_from(
            ["", "", "can", "may", "must", "should", "ought to", "have to", "be going to"]
        ),
        "perfect": st.booleans(),
        "progressive": st.booleans(),
        "passive": st.booleans(),
        "negated": st.booleans(),
    }
).map(lambda features: Clause(**features))  # type: ignore[arg-type]


def _words(spec: Sentence | Phrase) -> list[str]:
    return re.findall(r"[\w’']+", REALIZER.realize(spec).lower())


@settings(max_examples=300, deadline=None)
@given(_SIMPLE)
def test_negating_twice_and_asking_and_answering_keep_agreement(clause: Clause) -> None:
    """The question, its answer and its tag have the auxiliary that the negation has."""
    negative = clause._replace(negated=True)
    assert negative._replace(negated=clause.negated) == clause
    positive = clause._replace(negated=False)
    asked = _words(positive._replace(mood="interrogative"))
    denied = _words(negative)
    subject = denied[0]
    auxiliary = "can" if denied[1] == "cannot" else denied[1]
    assert asked[:2] == [auxiliary, subject]
    answer = _words(Sentence(positive._replace(ellipsis=("predicate",), complement=None)))
    kept = ["to"] if clause.modal == "ought to" else []
    assert answer == [subject, auxiliary, *kept]
    tag = _words(Sentence(negative, tag="auto"))[-2:]
    assert tag == [auxiliary, subject]
    # What the question and the statement share beside the auxiliary is the same.
    rest = [word for word in denied[2:] if word != "not"]
    assert asked[2:] == rest


@settings(max_examples=100, deadline=None)
@given(_SIMPLE)
def test_contracting_changes_no_word(clause: Clause) -> None:
    """A contraction says the same words, only shorter."""
    long = REALIZER.realize(clause)
    short = REALIZER.realize(clause._replace(contracted=True))
    assert len(short) <= len(long)
    assert short.split()[-1] == long.split()[-1]


def test_threads_share_a_realizer() -> None:
    """Many threads at once get the texts that one gets."""
    specs = [case.spec for case in read_cases() if not case.options]
    alone = [REALIZER.realize(spec) for spec in specs]
    with ThreadPoolExecutor(8) as pool:
        for texts in pool.map(lambda _: [REALIZER.realize(spec) for spec in specs], range(8)):
            assert texts == alone


@pytest.mark.parametrize(
    "wrong",
    ["a cat.", "A cat", "A cat..", "A cat , a dog.", "A  cat.", "A, ”cat.”", "A “b!”.", ", A."],
)
def test_the_check_finds_what_is_wrong(wrong: str) -> None:
    """The rules that these tests hold text to are not empty."""
    with pytest.raises(AssertionError):
        check(wrong)
