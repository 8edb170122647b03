"""What is counted in a text, against counts made by hand, and against textstat and VADER."""

from __future__ import annotations

from collections import Counter
from math import floor

import pytest
import textstat
from hypothesis import given
from hypothesis import strategies as st

from personage_lite.measure import load_features
from personage_lite.measure.counting import FeatureCounter, grade, reading_ease, value_of
from personage_lite.measure.extras import emotions

FEATURES = load_features()
COUNTER = FeatureCounter(FEATURES)
BY_NAME = {feature.name: feature for feature in FEATURES.features}


def totals(text: str) -> Counter[str]:
    return Counter(dict(COUNTER.count(text).totals))


def value(name: str, text: str) -> float | None:
    return value_of(BY_NAME[name], totals(text))


# "Alice's Adventures in Wonderland", chapter 1, counted by hand.
CHAPTER_1 = (
    "There was nothing so very remarkable in that; nor did Alice think it so very much out of the "
    "way to hear the Rabbit say to itself, “Oh dear! Oh dear! I shall be late!” (when she thought "
    "it over afterwards, it occurred to her that she ought to have wondered at this, but at the "
    "time it all seemed quite natural)."
)
# Said by the program at X = 2, and counted by hand.
LIVELY = (
    "I see! So you want to hear about Alice? Yeah, I love how kind she is, mate! She, like, "
    "doesn't cry… She's really brave, really brave, isn't she? Oh my god, she is a bit shy, "
    "you know, and pretty clever."
)


@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("sentences", 1),
        ("words", 62),
        ("negations", 2),  # nothing, nor
        ("third_person", 3),  # she, her, she: "itself" is no person
        ("first_person_singular", 0),  # "I shall be late" is the Rabbit's
        ("exclamations", 0),
        ("articles", 3),
        ("coordinators", 1),  # but
        ("softeners", 1),  # quite natural
        ("emphasizers", 4),  # so very, so very
        ("contractions", 0),
        ("acknowledgments", 0),
        ("social_words", 1),  # say
        ("long_words", 7),  # nothing remarkable thought afterwards occurred wondered natural
    ],
)
def test_a_sentence_of_the_novel(name: str, count: int) -> None:
    assert totals(CHAPTER_1)[name] == count


@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("sentences", 6),
        ("words", 41),
        ("first_person_singular", 3),  # I see, I love, my god
        ("second_person", 2),
        ("third_person", 4),  # but not the tag's
        ("confirmations", 1),
        ("acknowledgments", 2),  # I see, Yeah
        ("in_group", 1),
        ("fillers", 2),  # like, you know
        ("informal_softeners", 1),  # like, pretty
        ("emphasizers", 2),  # really, really
        ("expletives", 1),  # oh my god
        ("tag_questions", 1),
        ("questions", 1),
        ("exclamations", 2),
        ("negations", 1),  # doesn't: the tag's is none
        ("contractions", 3),  # doesn't, she's, isn't
        ("repetitions", 2),  # really brave
        ("coordinators", 1),
    ],
)
def test_a_lively_utterance(name: str, count: int) -> None:
    assert totals(LIVELY)[name] == count


@pytest.mark.parametrize(
    ("name", "text", "count"),
    [
        # like
        ("fillers", "She is, like, pink.", 1),
        ("fillers", "She likes tea, like you do. They like it.", 0),
        # so: a degree, a conjunction, or neither
        ("emphasizers", "She is so kind, so very kind.", 3),
        ("emphasizers", "So she ran, so Alice ran, and so did he.", 0),
        ("coordinators", "She's kind, so she hides them.", 1),
        ("coordinators", "She is kind, so kind.", 0),
        # well
        ("acknowledgments", "Well, she falls well.", 1),
        ("acknowledgments", "She is well. A deep well, a dry well.", 0),
        ("hesitations", "Well… she runs.", 1),
        ("hesitations", "Well, she runs.", 0),
        ("hesitations", "Alice… err, she runs. Err… she doesn't sit. She, err, runs.", 3),
        # right
        ("acknowledgments", "Right, she ran right home, right?", 1),
        ("tag_questions", "She is right, right?", 1),
        ("tag_questions", "Is she right?", 0),
        # quite, rather
        ("softeners", "It's quite messy and rather cold.", 2),
        ("softeners", "She would rather go. I'd rather run than quite the opposite.", 0),
        # pretty, a little, kind of, sort of
        ("informal_softeners", "She's pretty clever and kind of shy.", 2),
        ("informal_softeners", "A pretty girl and a kind of rabbit.", 0),
        ("softeners", "She is a little shy and sort of curious.", 2),
        ("softeners", "A little girl with a little bottle is some sort of rabbit.", 0),
        # I think, I believe
        ("softeners", "I think that she ran. She ran, I suppose. I think she's late.", 3),
        ("softeners", "I think of her. I believe in rabbits.", 0),
        ("softeners", "It seems she ran.", 1),
        ("softeners", "She has around 30 cats around the house.", 1),
        # just
        ("emphasizers", "She just loves tea.", 1),
        ("emphasizers", "A just king, just before tea.", 0),
        # you know
        ("fillers", "She is, you know, late.", 1),
        ("fillers", "You know her. She ran, you know?", 0),
        ("tag_questions", "She ran, you know?", 1),
        ("emphasizers", "Believe it or not, she ran.", 1),
        ("emphasizers", "You know what she ate.", 0),
        # address
        ("in_group", "She ran, mate. Buddy, she did!", 2),
        ("in_group", "My friend ran to her mate.", 0),
        ("social_words", "My friend ran to her friends.", 2),
        ("social_words", "She ran, mate!", 0),
        # tags
        ("tag_questions", "She ran, didn't she? He can't, can he, pal? It won't, will it?", 3),
        ("tag_questions", "Is she not late, is she not? They're late, aren't they, Alice?", 2),
        ("tag_questions", "When she ran, did she fall? Alice, is she late?", 0),
        ("questions", "When she ran, did she fall? She fell, didn't she?", 1),
        # said again
        ("repetitions", "She's so shy, really shy. It's really, really cold.", 2),
        ("repetitions", "Half lion and half eagle. The Mock Turtle is a turtle.", 0),
        ("repetitions", "Mars's dust is… Mars's dust is red, isn't it? He, he says, ran.", 0),
        # others
        ("initial_rejections", "I might be wrong, but she ran.", 1),
        ("competence_mitigation", "As everybody knows, she ran.", 1),
        ("confirmations", "You want to know about Alice? Let's see… Alice.", 2),
        ("confirmations", "Oh, Pluto! The White Rabbit, pal? Okay, the King of Hearts?", 3),
        ("confirmations", "Oh, she runs! Help! Alice ran! Hello, Alice! The Moon. I? Oh boy!", 0),
        ("first_person_plural", "Let's go; we're late, and it's our tea.", 3),
        ("contractions", "Alice's a child. Alice's cat isn't hers. Let's go. That's it.", 4),
        ("negations", "No, I can't, never, and she won't.", 4),
        ("stutters", "Al-Al-Alice and B-Bill.", 2),
        ("subordinators", "Although she ran, he, who was late, waited.", 2),
        # feelings: not of names, markers or quotations
        ("positive_emotion", "She is kind and happy.", 2),
        ("positive_emotion", "She is, like, pretty late. “I love you,” said the Nice Cat.", 0),
        ("negative_emotion", "The Mock Turtle hates sad songs.", 2),
    ],
)
def test_ambiguous_words(name: str, text: str, count: int) -> None:
    assert totals(text)[name] == count


def test_rates() -> None:
    text = "She is kind. She isn't late!"
    assert value("words", text) == 6
    assert value("words_per_sentence", text) == 3
    assert value("negations", text) == pytest.approx(100 / 6)
    assert value("exclamations", text) == 50
    assert value("word_length", text) == pytest.approx((3 + 2 + 4 + 3 + 4 + 4) / 6)


def test_what_has_no_words_has_no_rates() -> None:
    assert value("words", "😊") == 0
    assert value("negations", "😊") is None
    assert value("flesch_reading_ease", "😊") is None
    assert value("words_per_sentence", "") is None


def test_the_flesch_scores_are_those_of_the_literature() -> None:
    # "The cat sat on the mat.": 6 words, 6 syllables.
    assert value("flesch_reading_ease", "The cat sat on the mat.") == pytest.approx(116.145)
    assert value("flesch_kincaid_grade", "The cat sat on the mat.") == pytest.approx(-1.45)


@pytest.mark.parametrize(
    "text",
    [
        "Alice was beginning to get very tired of sitting by her sister on the bank.",
        "She had peeped into the book her sister was reading. It had no pictures in it.",
        "The Queen turned crimson with fury. The executioner argued about the Cat's head.",
    ],
)
def test_the_flesch_scores_agree_with_textstat_but_for_its_rounding(text: str) -> None:
    found = totals(text)
    assert found["words"] == textstat.lexicon_count(text)
    assert found["sentences"] == textstat.sentence_count(text)
    assert found["syllables"] == textstat.syllable_count(text)
    # textstat rounds both means to one decimal before it goes on.
    length = found["words"] / found["sentences"]
    syllables = found["syllables"] / found["words"]
    length, syllables = floor(length * 10 + 0.5) / 10, floor(syllables * 10 + 0.5) / 10
    near = reading_ease(length, syllables)
    assert textstat.flesch_reading_ease(text) == pytest.approx(near, abs=0.011)
    assert value("flesch_reading_ease", text) == pytest.approx(near, abs=84.6 * 0.05 + 0.06)
    near = grade(length, syllables)
    assert textstat.flesch_kincaid_grade(text) == pytest.approx(near, abs=0.06)


def test_the_emotions_are_vaders() -> None:
    assert emotions()["love"] > 0 > emotions()["hate"]


@given(st.text(max_size=120), st.text(max_size=120))
def test_the_counts_of_paragraphs_add_up(first: str, second: str) -> None:
    # Quotation marks without a partner, and marks of hesitation, look no further than a paragraph.
    together = totals(f"{first}\n\n{second}")
    apart = totals(first) + totals(second)
    together["utterances"], apart["utterances"] = 2, 2
    assert +together == +apart


@given(st.text(alphabet=st.characters(), max_size=300))
def test_no_text_is_too_strange(text: str) -> None:
    found = totals(text)
    assert found["long_words"] <= found["words"]
    for feature in FEATURES.features:
        if feature.per != "window":
            value_of(feature, found)


def test_a_line_of_10_kb() -> None:
    assert totals("she runs, " * 1000)["words"] == 2000
    assert totals("she" * 3400)["words"] == 1
