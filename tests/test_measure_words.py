"""Taking texts apart: sentences, words, quotations and stutters (personage_lite.measure.words)."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from personage_lite.measure.features import load_features
from personage_lite.measure.words import Passage, take_apart, words_of

LISTS = load_features().lists


def apart(text: str) -> Passage:
    return take_apart(text, LISTS)


def sentences(text: str) -> list[str]:
    """Return each sentence's words and its last mark."""
    return [
        " ".join(word.text for word in sentence.words) + sentence.end
        for sentence in apart(text).sentences
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("She is kind. He isn't!", ["she is kind.", "he isn't!"]),
        ("What?! No…", ["what?", "no…"]),
        # A mark of hesitation after a word or two holds up, after more it ends.
        ("Well… Alice is kind.", ["well alice is kind."]),
        ("Let's see… Alice, you say?", ["let's see alice you say?"]),
        ("She... is kind.", ["she is kind."]),
        ("The cat vanished quite slowly… Then it came back.", 2),
        # A quotation inside a sentence ends none.
        ("He says, “Oh dear! I shall be late!” She waits.", 2),
        ("She shouts, “Off with his head!”", ["she shouts off with his head"]),
        ('"Off with her head!" Alice said. Then she ran.', 2),
        ("“Curiouser and curiouser!” cried Alice.", ["curiouser and curiouser cried alice."]),
        # One that stands for itself is made of its own sentences.
        ("“Oh dear! I shall be late!”", ["oh dear!", "i shall be late!"]),
        ("“Who are you?” “I am Alice.”", ["who are you?", "i am alice."]),
        # No sentence ends after an abbreviation, an initial or in a number.
        ("Mr. Rabbit ran.", ["mr rabbit ran."]),
        ("C. S. Lewis, e.g., wrote 3.5 books.", 1),
        ("It is 7 a.m. now. Go.", ["it is 7 a m now.", "go."]),
        # Marks in brackets and before them
        ("(She ran.) He ran (fast).", ["she ran.", "he ran fast."]),
        # Inscriptions and titles
        ("She drinks from a bottle marked DRINK ME. She shrinks.", 2),
        ("One paragraph\n\nand the next", ["one paragraph", "and the next"]),
        ("wrapped\nlines are one.", ["wrapped lines are one."]),
        ("no mark", ["no mark"]),
        ("😊 She is kind! 🎉", ["she is kind!"]),
        ("", []),
        ("… !? ”", []),
        # Quotation marks without a partner are passed over.
        ('5" tall. Really.', ["5 tall.", "really."]),
        ("“Oh. She ran.", ["oh.", "she ran."]),
    ],
)
def test_sentences(text: str, expected: list[str] | int) -> None:
    found = sentences(text)
    assert (len(found) if isinstance(expected, int) else found) == expected


def test_words() -> None:
    assert words_of("She’s at the tea-party; mother-in-law's 10,000 O'Clock") == (
        *("she's", "at", "the", "tea-party", "mother-in-law's", "10,000", "o'clock"),
    )


def test_the_marks_around_words() -> None:
    (sentence,) = apart("Alice, um, “runs” (fast)!").sentences
    assert [(word.before, word.after) for word in sentence.words] == [
        ("", ","),
        (",", ",“"),
        (",“", "”("),
        ("”(", ")!"),
    ]


def test_stems_and_clitics() -> None:
    (sentence,) = apart("She's here, isn't she, and I'd go").sentences
    found = {word.text: (word.stem, word.clitic) for word in sentence.words}
    assert found["she's"] == ("she", "'s")
    assert found["isn't"] == ("isn't", "")
    assert found["i'd"] == ("i", "'d")


@pytest.mark.parametrize(
    ("text", "quoted"),
    [
        ("He says, “Oh dear!” now.", ["oh", "dear"]),
        ("“Oh dear!”", []),
        ("“Oh!” she says.", ["oh"]),
        ("A bottle marked DRINK ME.", ["drink", "me"]),
        ("DRINK ME NOW.", []),
        ("The BBC is on.", []),
    ],
)
def test_what_is_quoted_inside_a_sentence(text: str, quoted: list[str]) -> None:
    words = [word for sentence in apart(text).sentences for word in sentence.words]
    assert [word.text for word in words if word.quoted] == quoted


@pytest.mark.parametrize(
    ("text", "stutters", "left"),
    [
        ("Al-Al-Alice is kind", 1, "alice is kind"),
        ("Qu-Queen", 1, "queen"),
        ("W-w-what is b-but this", 2, "what is but this"),
        ("Re-Rebecca", 1, "rebecca"),
        ("re-read the no-nonsense note and Re-read it", 0, None),
        ("a tea-party in a flower-pot, bye-bye", 0, None),
    ],
)
def test_stutters(text: str, stutters: int, left: str | None) -> None:
    passage = apart(text)
    assert passage.stutters == stutters
    assert sentences(text) == [left or " ".join(words_of(text))]


@given(st.text(max_size=200))
def test_any_text_can_be_taken_apart(text: str) -> None:
    for sentence in apart(text).sentences:
        assert sentence.words
        assert sentence.end in ("", ".", "!", "?", "…")


@given(st.lists(st.sampled_from(["She is kind.", "Oh no!", "Is he?", "He ran off."]), min_size=1))
def test_paragraphs_are_taken_apart_each_alone(parts: list[str]) -> None:
    together = apart("\n\n".join(parts)).sentences
    assert together == tuple(one for part in parts for one in apart(part).sentences)


@pytest.mark.parametrize(
    "text",
    ["ab-" * 40_000, "!" * 100_000 + "a", '"a." b ' * 10_000, "“" * 50_000, "a b. " * 20_000],
)
def test_long_texts_take_no_time_that_grows_with_their_square(text: str) -> None:
    # Without a clock: what was quadratic took minutes, and the suite would show it.
    assert apart(text)
