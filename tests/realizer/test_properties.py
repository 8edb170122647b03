"""Proves what holds of every sentence: any well-typed specification becomes clean written text.

Specifications are drawn at random, with marks inside their words where data may have them. The
text begins with a capital, ends in one end mark, doubles no mark or space, is the same each time,
and the specification is left as it was.
"""

from __future__ import annotations

import copy
import re

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from personage_lite import english
from personage_lite.realizer import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Embedded,
    Joined,
    NounPhrase,
    Opener,
    Phrase,
    Sentence,
    Subordinate,
    Text,
)

REALIZER = english()
DOUBLED = re.compile(r"[.,!?…]”?[.,]|[.,!?]”?[.,!?…]|……")
SPACED = re.compile(r" [.,!?…”]|  |^ | $|“ ")

_LONE = st.sampled_from(["um", "oh", "I suppose", "my friend", "you know", "honestly", "why not"])
_ADVERB = st.sampled_from(["really", "often", "never", "hardly ever", "always"])
_ADJECTIVE = st.sampled_from(["kind", "old", "honest", "hot-tempered", "8-page", "unique"])
_NOUN = st.sampled_from(
    ["Alice", "egg", "Queen of Hearts", "James", "child", "nobody", "hour", "UFO", "pack of cards"]
)
_WORDS = st.sampled_from(
    ["a cat", "to Bill", "nothing at all", "yes, no", "etc.", "I must say,", "Oh!", "why?", "so…"]
)
_VERB = st.sampled_from(["be", "have", "do", "run", "cry", "panic", "stand", "go", "echo", "shout"])
_MARK = st.sampled_from([".", "!", "?", "…"])
_QUOTATION = st.sampled_from(
    ["", "", "Off with her head!", "I am late.", "Run", "Who are you?", "Well…", "Oh,", "No..."]
)
_ADJECTIVES = st.builds(AdjectivePhrase, _ADJECTIVE, st.lists(_ADVERB, max_size=2).map(tuple))
_CASE = st.sampled_from(["subjective", "objective", "possessive", "reflexive"])


def _rarely(strategy: st.SearchStrategy[object], empty: object = None) -> st.SearchStrategy[object]:
    return st.just(empty) | st.just(empty) | strategy


def _nouns(depth: int) -> st.SearchStrategy[NounPhrase]:
    inner = depth > 0
    return st.builds(
        NounPhrase,
        noun=_NOUN,
        determiner=st.sampled_from(["", "a", "the", "no", "every"]),
        adjectives=st.lists(_ADJECTIVES, max_size=2).map(tuple),
        possessor=_rarely(_nouns(depth - 1)) if inner else st.none(),
        number=st.sampled_from(["singular", "plural"]),
        gender=st.sampled_from(["masculine", "feminine", "neuter"]),
        person=st.sampled_from([1, 2, 3]),
        animate=st.booleans(),
        pronoun=st.booleans(),
        relative=_rarely(_clauses(depth - 1)) if inner else st.none(),
        restrictive=st.booleans(),
        stutter=st.integers(0, 2),
        entity=st.sampled_from(["", "alice"]),
    )


def _texts(depth: int) -> st.SearchStrategy[Text]:
    mention = st.builds(Cased, _nouns(depth), _CASE)
    rest = st.lists(_WORDS | st.just(",") | mention, max_size=2)
    return st.builds(lambda first, more: Text((first, *more)), _WORDS | mention, rest)


def _phrases(depth: int) -> st.SearchStrategy[Phrase]:
    one = _ADJECTIVES | _nouns(depth) | _texts(depth)
    several = st.lists(one, min_size=1, max_size=3).map(tuple)
    return one | st.builds(Coordination, several, st.sampled_from(["and", "or", ","]))


def _subordinates(depth: int) -> st.SearchStrategy[tuple[Subordinate, ...]]:
    one = st.builds(
        Subordinate, st.sampled_from(["because", "although"]), _clauses(depth), st.booleans()
    )
    return st.lists(one, max_size=1).map(tuple)


def _clauses(depth: int) -> st.SearchStrategy[Clause]:
    phrase = _phrases(depth - 1)
    few = st.lists(phrase, max_size=1).map(tuple)
    return st.builds(
        Clause,
        verb=_VERB,
        subject=_nouns(depth - 1),
        particle=st.sampled_from(["", "", "up", "for"]),
        indirect_object=_rarely(phrase),
        object=_rarely(phrase),
        complement=_rarely(phrase),
        adverbials=few,
        asides=few,
        adverbs=st.lists(_ADVERB, max_size=1).map(tuple),
        emphasizers=st.lists(_ADVERB, max_size=1).map(tuple),
        interruption=st.sampled_from(["", "", "um"]),
        quotation=_QUOTATION,
        subordinates=_subordinates(depth - 1) if depth > 0 else st.just(()),
        tense=st.sampled_from(["present", "past", "future"]),
        modal=st.sampled_from(["", "", "can", "may", "should"]),
        perfect=st.booleans(),
        progressive=st.booleans(),
        passive=st.booleans(),
        negated=st.booleans(),
        negator=st.sampled_from(["not", "never"]),
        contracted=st.booleans(),
        truncated=st.booleans(),
        degree=st.booleans(),
    )


_CLAUSE = _clauses(1)
_EMBEDDED = st.builds(
    Embedded, _texts(0), _CLAUSE, st.sampled_from(["", "that"]), inner_tag=st.booleans()
)
_SENTENCE = st.builds(
    Sentence,
    body=_CLAUSE | _EMBEDDED | _texts(1),
    joined=st.lists(
        st.builds(Joined, st.sampled_from(["and", "but"]), _CLAUSE | _EMBEDDED, st.booleans()),
        max_size=1,
    ).map(tuple),
    openers=st.lists(
        st.builds(Opener, _LONE, st.sampled_from([",", "!", "?", "…", ".", ""])), max_size=2
    ).map(tuple),
    connective=st.sampled_from(["", "", "however"]),
    vocative=st.sampled_from(["", "", "buddy"]),
    afterthought=st.just("") | _LONE,
    tag=st.sampled_from(["", "", "auto", "right"]),
    terminal=_MARK,
    false_start=st.booleans(),
)


def check(text: str) -> None:
    """Refuse text that no editor would let through."""
    first = next(letter for letter in text if letter.isalnum())
    assert not first.isalpha() or first.isupper(), text
    assert text.rstrip("”")[-1] in ".!?…", text
    assert not DOUBLED.search(text.replace("...", "…")), text
    assert not SPACED.search(text), text
    assert "\x00" not in text


@settings(max_examples=300, deadline=None, suppress_health_check=list(HealthCheck))
@given(_SENTENCE)
def test_every_sentence_is_clean_text(sentence: Sentence) -> None:
    """Whatever is asked for, the text keeps the rules; asking again changes nothing."""
    before = copy.deepcopy(sentence)
    text = REALIZER.realize(sentence)
    check(text)
    assert REALIZER.realize(sentence) == text
    assert sentence == before


@settings(max_examples=100, deadline=None, suppress_health_check=list(HealthCheck))
@given(_CLAUSE)
def test_a_bare_clause_is_a_sentence(clause: Clause) -> None:
    """A clause alone is said as the sentence that holds nothing else."""
    text = REALIZER.realize(clause)
    check(text)
    assert text == REALIZER.realize(Sentence(clause))


@pytest.mark.parametrize(
    "wrong", ["a cat.", "A cat", "A cat..", "A cat , a dog.", "A  cat.", "A, ”cat.”", "A “b!”."]
)
def test_the_check_finds_what_is_wrong(wrong: str) -> None:
    """The rules that these tests hold text to are not empty."""
    with pytest.raises(AssertionError):
        check(wrong)
