"""Proves that verbs, plurals, articles and stutters take their right forms.

Tables hold reviewed forms; lemminflect, where it is installed, is a second opinion on every verb
of the shipped data and on common nouns. The differences that are accepted stand here with why.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from personage_lite.realizer.grammar import Grammar, read_grammar
from personage_lite.realizer.morphology import (
    VerbForm,
    indefinite_article,
    inflect_verb,
    pluralize,
    stutter,
)
from personage_lite.yaml_reader import read_yaml

ROOT = Path(__file__).parents[2]
GRAMMAR: Grammar = read_grammar(read_yaml(ROOT / "lexicons" / "grammar.yaml"))

# lemma: third person, past, participle, gerund
VERBS = """
jump jumps jumped jumped jumping
love loves loved loved loving
like likes liked liked liking
try tries tried tried trying
play plays played played playing
watch watches watched watched watching
box boxes boxed boxed boxing
pass passes passed passed passing
wish wishes wished wished wishing
go goes went gone going
do does did done doing
woo woos wooed wooed wooing
echo echoes echoed echoed echoing
have has had had having
be is was been being
die dies died died dying
lie lies lay lain lying
see sees saw seen seeing
flee flees fled fled fleeing
dye dyes dyed dyed dyeing
tiptoe tiptoes tiptoed tiptoed tiptoeing
stop stops stopped stopped stopping
run runs ran run running
quit quits quit quit quitting
quiz quizzes quizzed quizzed quizzing
yap yaps yapped yapped yapping
chat chats chatted chatted chatting
fear fears feared feared fearing
open opens opened opened opening
visit visits visited visited visiting
admit admits admitted admitted admitting
prefer prefers preferred preferred preferring
travel travels travelled travelled travelling
whisper whispers whispered whispered whispering
snow snows snowed snowed snowing
fix fixes fixed fixed fixing
panic panics panicked panicked panicking
mimic mimics mimicked mimicked mimicking
mistake mistakes mistook mistaken mistaking
fall falls fell fallen falling
dwell dwells dwelt dwelt dwelling
shrink shrinks shrank shrunk shrinking
read reads read read reading
put puts put put putting
upset upsets upset upset upsetting
begin begins began begun beginning
forget forgets forgot forgotten forgetting
overhear overhears overheard overheard overhearing
bind binds bound bound binding
use uses used used using
agree agrees agreed agreed agreeing
argue argues argued argued arguing
"""
PLURALS = """
cat cats
queen queens
lory lories
day days
box boxes
duchess duchesses
watch watches
hedgehog hedgehogs
rabbit-hole rabbit-holes
mouse mice
dormouse dormice
goose geese
tooth teeth
foot feet
child children
grandchild grandchildren
man men
gentleman gentlemen
human humans
person people
knife knives
loaf loaves
roof roofs
chief chiefs
hero heroes
potato potatoes
piano pianos
dodo dodos
quiz quizzes
stomach stomachs
sheep sheep
fish fish
clothes clothes
passer-by passers-by
"""
ARTICLES = """
a cat
an egg
an old_cat
a unicorn
a uniform
a one-eyed_cat
a once-proud_queen
an onerous_task
an hour
an hourglass
a house
an honest_child
an heir
an umbrella
an usher
a useful_cat
a usual_day
a European
a ewe
an unimportant_child
an uninvited_guest
an unidentified_cat
a unique_cat
a united_court
an FBI_agent
an FBI
a UFO
an MP
a BBC_play
an X-ray
an x-ray
a T-shirt
a U-turn
an A
a B
an 8
an 80-page_book
an 11-year-old
a 110-page_book
an 1865_edition
a 10-page_book
an “Alice”
a “Queen”
an apple
a yellow_cat
a royal_trial
"""
STUTTERS = """
Alice 1 Al-Alice
Alice 2 Al-Al-Alice
Eve 1 Ev-Eve
Queen 1 Qu-Queen
White_Rabbit 1 Wh-White_Rabbit
Cheshire_Cat 2 Ch-Ch-Cheshire_Cat
Pat 1 P-Pat
Dinah 1 D-Dinah
Gryphon 1 Gr-Gryphon
Knave 1 Kn-Knave
Mr_Fox 1 M-Mr_Fox
A 1 A-A
K 1 K-K
Al 1 Al-Al
Audrey 1 Aud-Audrey
hair 1 h-hair
"""
FORMS: tuple[tuple[VerbForm, str], ...] = (
    ("third", "VBZ"),
    ("past", "VBD"),
    ("participle", "VBN"),
    ("gerund", "VBG"),
)


def _rows(table: str) -> list[list[str]]:
    return [
        [cell.replace("_", " ") for cell in line.split()] for line in table.strip().splitlines()
    ]


def _data_verbs() -> list[str]:
    """Return every verb of the facts and of the lexicon."""
    found: set[str] = set()
    for path in sorted((ROOT / "facts").rglob("*.yaml")):
        for fact in yaml.safe_load(path.read_text(encoding="utf-8")).get("facts", ()):
            if "predicate" in fact:
                found.add(fact["predicate"])
    concepts = yaml.safe_load((ROOT / "lexicons" / "verbs.yaml").read_text(encoding="utf-8"))
    for concept, entry in concepts.items():
        found.update(row[0].split()[0] for row in entry["words"])
        found.add(concept)
    return sorted(found)


@pytest.mark.parametrize("row", _rows(VERBS), ids=lambda row: row[0])
def test_verb(row: list[str]) -> None:
    """Third person, past, participle and gerund follow the rules and their exceptions."""
    lemma, *expected = row
    assert [inflect_verb(lemma, form, GRAMMAR) for form, _ in FORMS] == expected
    assert inflect_verb(lemma, "base", GRAMMAR) == lemma


@pytest.mark.parametrize("row", _rows(PLURALS), ids=lambda row: row[0])
def test_plural(row: list[str]) -> None:
    """Plurals follow the rules and their exceptions."""
    assert pluralize(row[0], GRAMMAR) == row[1]


def test_plural_of_a_phrase_is_that_of_its_head() -> None:
    """The last word changes, or the last one before a preposition."""
    assert pluralize("croquet ball", GRAMMAR) == "croquet balls"
    assert pluralize("little child", GRAMMAR) == "little children"
    assert pluralize("pack of cards", GRAMMAR) == "packs of cards"
    assert pluralize("man of honour", GRAMMAR) == "men of honour"


@pytest.mark.parametrize("row", [line.split() for line in ARTICLES.strip().splitlines()])
def test_article(row: list[str]) -> None:
    """The article goes by sound, not by letter."""
    assert indefinite_article(row[1].replace("_", " "), GRAMMAR) == row[0]


@pytest.mark.parametrize("row", _rows(STUTTERS), ids=lambda row: f"{row[0]}-{row[1]}")
def test_stutter(row: list[str]) -> None:
    """A stutter repeats the sounds before the first vowel, or the first syllable's beginning."""
    assert stutter(row[0], int(row[1])) == row[2]


# The second opinion

# Where lemminflect is not followed, and why ours is right.
ACCEPTED = {
    ("get", "participle"): "the British got beside the American gotten",
    ("broadcast", "past"): "unchanged in edited prose; broadcasted is a variant",
    ("forecast", "past"): "unchanged in edited prose; forecasted is a variant",
    ("lie", "participle"): "lain is of lying down; lied is of untruths",
    ("light", "participle"): "lit; lighted is a variant",
    ("spill", "participle"): "as the past, spilt, which lemminflect knows",
    ("sting", "gerund"): "lemminflect has sting, which is no gerund",
    ("ox", "plural"): "oxen is the only plural of dictionaries",
    ("person", "plural"): "people; persons is the lawyers' word",
}
NOUNS = [
    "cat",
    "girl",
    "child",
    "rabbit",
    "queen",
    "king",
    "knave",
    "sister",
    "hatter",
    "hare",
    "dormouse",
    "duchess",
    "cook",
    "caterpillar",
    "mouse",
    "lory",
    "lizard",
    "pigeon",
    "gryphon",
    "turtle",
    "executioner",
    "gardener",
    "eye",
    "hand",
    "ear",
    "voice",
    "courtier",
    "guest",
    "tart",
    "ball",
    "card",
    "glove",
    "fan",
    "watch",
    "foot",
    "tooth",
    "head",
    "hair",
    "knife",
    "wife",
    "wolf",
    "loaf",
    "leaf",
    "shelf",
    "half",
    "calf",
    "thief",
    "life",
    "hero",
    "potato",
    "tomato",
    "echo",
    "piano",
    "photo",
    "box",
    "fox",
    "bush",
    "church",
    "witch",
    "glass",
    "class",
    "bus",
    "city",
    "lady",
    "baby",
    "party",
    "story",
    "day",
    "key",
    "boy",
    "toy",
    "monkey",
    "man",
    "woman",
    "person",
    "goose",
    "ox",
    "servant",
    "house",
    "window",
    "chimney",
    "trumpet",
    "witness",
    "verdict",
    "jury",
    "pencil",
    "slate",
    "poem",
    "song",
    "book",
    "picture",
    "flower",
    "rose",
    "tree",
    "garden",
    "pool",
    "tear",
    "bottle",
    "cake",
    "pepper",
    "soup",
    "chin",
    "shoulder",
    "sheep",
    "deer",
    "invitation",
    "croquet",
    "inkstand",
    "tale",
    "prize",
    "thimble",
    "stomach",
    "monarch",
    "gentleman",
    "crisis",
    "roof",
    "belief",
]


def _opinion(lemma: str, tag: str) -> tuple[str, ...]:
    """Return the forms that lemminflect knows."""
    oracle: Any = pytest.importorskip("lemminflect")
    return tuple(oracle.getInflection(lemma, tag=tag))


@pytest.mark.parametrize(("form", "tag"), FORMS, ids=[form for form, _ in FORMS])
def test_every_verb_of_the_data_agrees_with_the_oracle(form: VerbForm, tag: str) -> None:
    """No verb that can be said has a form that lemminflect does not know."""
    verbs = _data_verbs()
    assert len(verbs) > 100
    odd = {
        lemma: (said, known)
        for lemma in verbs
        if (said := inflect_verb(lemma, form, GRAMMAR)) not in (known := _opinion(lemma, tag))
        and (lemma, form) not in ACCEPTED
    }
    assert odd == {}


def test_common_nouns_agree_with_the_oracle() -> None:
    """No common noun has a plural that lemminflect does not know."""
    odd = {
        noun: (said, known)
        for noun in NOUNS
        if (said := pluralize(noun, GRAMMAR)) not in (known := _opinion(noun, "NNS"))
        and (noun, "plural") not in ACCEPTED
    }
    assert odd == {}


def test_irregular_verbs_agree_with_the_oracle() -> None:
    """Every irregular verb of the grammar has a past and a participle that lemminflect knows."""
    odd = {
        (lemma, form): (said, known)
        for lemma in GRAMMAR.irregular_verbs
        for form, tag in FORMS
        if (said := inflect_verb(lemma, form, GRAMMAR)) not in (known := _opinion(lemma, tag))
        and (lemma, form) not in ACCEPTED
    }
    assert odd == {}
