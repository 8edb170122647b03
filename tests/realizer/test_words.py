"""Proves that words take their right forms: verbs, plurals, degrees, countability and spelling.

Tables hold reviewed forms, a slash between British and American. lemminflect is a second opinion
on its whole vocabulary, see `lemminflect_comparison`.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from personage_lite.errors import DataError
from personage_lite.realizer.inflection import Dialect, Inflection, read_inflection
from personage_lite.realizer.words import (
    Degree,
    VerbForm,
    countability,
    inflect_adjective,
    inflect_verb,
    pluralize,
    spell,
)
from personage_lite.yaml_reader import parse_yaml, read_yaml
from tests.realizer.lemminflect_comparison import DIALECTS, EXPLANATIONS, PARTS, compare, explain

FILE = Path(__file__).parents[2] / "lexicons" / "inflection.yaml"
INFLECTIONS: dict[Dialect, Inflection] = {
    dialect: read_inflection(read_yaml(FILE), dialect) for dialect in DIALECTS
}
BRITISH, AMERICAN = INFLECTIONS["british"], INFLECTIONS["american"]
FORMS: tuple[VerbForm, ...] = ("third", "past", "participle", "gerund")
DEGREES: tuple[Degree, ...] = ("comparative", "superlative")

# The rule, then lemma, third person, past, participle, gerund
VERBS = """
regular jump jumps jumped jumped jumping
regular whisper whispers whispered whispered whispering
silent_e love loves loved loved loving
silent_e argue argues argued argued arguing
silent_e use uses used used using
other_e agree agrees agreed agreed agreeing
other_e dye dyes dyed dyed dyeing
other_e tiptoe tiptoes tiptoed tiptoed tiptoeing
other_e singe singes singed singed singeing
other_e age ages aged aged ageing/aging
ie die dies died died dying
y try tries tried tried trying
y play plays played played playing
y soliloquy soliloquies soliloquied soliloquied soliloquying
hiss watch watches watched watched watching
hiss box boxes boxed boxed boxing
hiss pass passes passed passed passing
hiss waltz waltzes waltzed waltzed waltzing
hiss stomach stomachs stomached stomached stomaching
o echo echoes echoed echoed echoing
o go goes went gone going
o undergo undergoes underwent undergone undergoing
o woo woos wooed wooed wooing
o radio radios radioed radioed radioing
c panic panics panicked panicked panicking
c bivouac bivouacs bivouacked bivouacked bivouacking
doubling stop stops stopped stopped stopping
doubling quiz quizzes quizzed quizzed quizzing
doubling yap yaps yapped yapped yapping
doubling up ups upped upped upping
doubling fix fixes fixed fixed fixing
doubling snow snows snowed snowed snowing
doubling rain rains rained rained raining
doubling kayak kayaks kayaked kayaked kayaking
stress visit visits visited visited visiting
stress open opens opened opened opening
stress offer offers offered offered offering
stress prefer prefers preferred preferred preferring
stress occur occurs occurred occurred occurring
stress admit admits admitted admitted admitting
stress limit limits limited limited limiting
stress kidnap kidnaps kidnapped kidnapped kidnapping
stress overlap overlaps overlapped overlapped overlapping
stress unplug unplugs unplugged unplugged unplugging
stress reckon reckons reckoned reckoned reckoning
stress interpret interprets interpreted interpreted interpreting
l travel travels travelled/traveled travelled/traveled travelling/traveling
l cancel cancels cancelled/canceled cancelled/canceled cancelling/canceling
l dial dials dialled/dialed dialled/dialed dialling/dialing
l fuel fuels fuelled/fueled fuelled/fueled fuelling/fueling
l equal equals equalled/equaled equalled/equaled equalling/equaling
l control controls controlled controlled controlling
l compel compels compelled compelled compelling
l parallel parallels paralleled paralleled paralleling
l reveal reveals revealed revealed revealing
irregular be is was been being
irregular have has had had having
irregular do does did done doing
irregular lie lies lay lain lying
irregular read reads read read reading
irregular put puts put put putting
irregular begin begins began begun beginning
irregular run runs ran run running
irregular flee flees fled fled fleeing
dialect learn learns learnt/learned learnt/learned learning
dialect burn burns burnt/burned burnt/burned burning
dialect get gets got got/gotten getting
dialect dive dives dived/dove dived diving
dialect fit fits fitted/fit fitted/fit fitting
dialect prove proves proved proved/proven proving
prefix overtake overtakes overtook overtaken overtaking
prefix rewrite rewrites rewrote rewritten rewriting
prefix misunderstand misunderstands misunderstood misunderstood misunderstanding
prefix withdraw withdraws withdrew withdrawn withdrawing
prefix forgive forgives forgave forgiven forgiving
prefix foresee foresees foresaw foreseen foreseeing
prefix forget forgets forgot forgotten forgetting
no_prefix relay relays relayed relayed relaying
no_prefix behave behaves behaved behaved behaving
no_prefix reread rereads reread reread rereading
no_prefix remind reminds reminded reminded reminding
parts give_up gives_up gave_up given_up giving_up
parts baby-sit baby-sits baby-sat baby-sat baby-sitting
parts re-do re-does re-did re-done re-doing
parts OK OK's OK'd OK'd OK'ing
unknown blorp blorps blorped blorped blorping
unknown zib zibs zibbed zibbed zibbing
unknown frobnicate frobnicates frobnicated frobnicated frobnicating
"""
# The rule, then singular, plural
PLURALS = """
regular cat cats
regular rabbit-hole rabbit-holes
hiss box boxes
hiss duchess duchesses
hiss watch watches
hiss fez fezzes
hiss quiz quizzes
hiss waltz waltzes
hiss stomach stomachs
hiss monarch monarchs
y day days
y city cities
y soliloquy soliloquies
y standby standbys
o hero heroes
o potato potatoes
o piano pianos
o dodo dodos
f roof roofs
f chief chiefs
f scarf scarves
f dwarf dwarfs
is crisis crises
is axis axes
is iris irises
is chassis chassis
man policeman policemen
man charwoman charwomen
man human humans
man German Germans
man talisman talismans
man Frenchman Frenchmen
man Frenchwoman Frenchwomen
man Freeman Freemans
compound dormouse dormice
compound mongoose mongooses
compound eyetooth eyeteeth
compound grandchild grandchildren
compound penknife penknives
compound midwife midwives
compound afterlife afterlives
compound bookshelf bookshelves
compound cloverleaf cloverleaves
compound werewolf werewolves
compound blouse blouses
compound belief beliefs
irregular mouse mice
irregular ox oxen
irregular person people
latin larva larvae
latin stimulus stimuli
latin genius geniuses
latin criterion criteria
latin bacterium bacteria
latin museum museums
latin index indexes
latin appendix appendices
dialect bureau bureaux/bureaus
same sheep sheep
same furniture furniture
same news news
same physics physics
same bronchitis bronchitis
same clothes clothes
same scissors scissors
name Mary Marys
name Bach Bachs
name Dormouse Dormice
name Mouse Mice
name Tory Tories
name Chinese Chinese
name Jones Joneses
name Liz Lizes
letters MP MPs
letters 1860 1860s
phrase croquet_ball croquet_balls
phrase little_child little_children
phrase pack_of_cards packs_of_cards
phrase man_of_honour men_of_honour
phrase cat_on_the_mat cats_on_the_mat
phrase polar_opposite polar_opposites
phrase attorney_general attorneys_general
phrase major_general major_generals
phrase court_martial courts_martial
phrase president_elect presidents_elect
phrase head_of_state heads_of_state
phrase White_Rabbit White_Rabbits
hyphens mother-in-law mothers-in-law
hyphens passer-by passers-by
hyphens looker-on lookers-on
hyphens man-of-war men-of-war
hyphens aide-de-camp aides-de-camp
hyphens check-in check-ins
hyphens merry-go-round merry-go-rounds
hyphens Fish-Footman Fish-Footmen
unknown wug wugs
unknown snarkman snarkmen
"""
# The rule, then positive, comparative, superlative
ADJECTIVES = """
short kind kinder kindest
short brave braver bravest
short free freer freest
short big bigger biggest
short grey greyer greyest
short wet wetter wettest
short quick quicker quickest
y happy happier happiest
y unhappy unhappier unhappiest
y dry drier driest
y shy shyer shyest
y pricey pricier priciest
y friendly friendlier friendliest
le simple simpler simplest
le gentle gentler gentlest
ow narrow narrower narrowest
two clever cleverer cleverest
two quiet quieter quietest
two cruel crueller/crueler cruellest/cruelest
long curious more_curious most_curious
long careful more_careful most_careful
long beautiful more_beautiful most_beautiful
long available more_available most_available
long foolish more_foolish most_foolish
more real more_real most_real
more fun more_fun most_fun
more tired more_tired most_tired
more loving more_loving most_loving
more loyal more_loyal most_loyal
more hot-tempered more_hot-tempered most_hot-tempered
more French more_French most_French
irregular good better best
irregular bad worse worst
irregular little less least
irregular far further/farther furthest/farthest
adverb fast faster fastest
adverb well better best
adverb badly worse worst
adverb early earlier earliest
adverb quickly more_quickly most_quickly
adverb easily more_easily most_easily
unknown blig bligger bliggest
unknown zorpful more_zorpful most_zorpful
"""
COUNTABILITIES = """
countable cat cats child idea witness mechanism critic pack_of_cards blorp
uncountable furniture advice news information luggage physics happiness tourism water
uncountable white_bread bronchitis
plural_only clothes thanks cattle outskirts old_clothes
pair scissors trousers spectacles tweezers bellows new_scissors
"""
# The word as it comes: British, American
SPELLINGS = """
color colour color
colour colour color
center centre center
favourite favourite favorite
organize organise organize
organise organise organize
organization organisation organization
organizer organiser organizer
analyse analyse analyze
realize realise realize
advise advise advise
size size size
prize prize prize
promise promise promise
tyre tyre tire
tire tire tire
meter meter meter
metre metre meter
check check check
cheque cheque check
Gray Gray Gray
gray grey gray
hatter hatter hatter
"""


def _rows(table: str) -> list[list[str]]:
    return [
        [cell.replace("_", " ") for cell in line.split()] for line in table.strip().splitlines()
    ]


def _sides(cells: list[str]) -> tuple[list[str], list[str]]:
    """Return the British and the American cells."""
    return [cell.split("/")[0] for cell in cells], [cell.split("/")[-1] for cell in cells]


# Reviewed tables


@pytest.mark.parametrize("row", _rows(VERBS), ids="-".join)
def test_verb(row: list[str]) -> None:
    """Third person, past, participle and gerund, in both dialects."""
    _, lemma, *cells = row
    for inflection, expected in zip((BRITISH, AMERICAN), _sides(cells), strict=True):
        assert [inflect_verb(lemma, form, inflection) for form in FORMS] == expected
        assert inflect_verb(lemma, "base", inflection) == lemma


@pytest.mark.parametrize("row", _rows(PLURALS), ids="-".join)
def test_plural(row: list[str]) -> None:
    """Plurals of words, compounds, names and phrases, in both dialects."""
    _, noun, plural = row
    british, american = _sides([plural])
    assert [pluralize(noun, BRITISH)] == british
    assert [pluralize(noun, AMERICAN)] == american


@pytest.mark.parametrize("row", _rows(ADJECTIVES), ids="-".join)
def test_degrees(row: list[str]) -> None:
    """Comparatives and superlatives of adjectives and adverbs, in both dialects."""
    _, positive, *cells = row
    for inflection, expected in zip((BRITISH, AMERICAN), _sides(cells), strict=True):
        assert [inflect_adjective(positive, degree, inflection) for degree in DEGREES] == expected
        assert inflect_adjective(positive, "positive", inflection) == positive


@pytest.mark.parametrize("row", _rows(COUNTABILITIES), ids="-".join)
def test_countability(row: list[str]) -> None:
    """Nouns without plural, only plural and in pairs; a phrase goes by its head."""
    expected, *nouns = row
    expected = expected.replace(" ", "_")
    assert {noun: countability(noun, BRITISH) for noun in nouns} == dict.fromkeys(nouns, expected)


@pytest.mark.parametrize("row", _rows(SPELLINGS), ids="-".join)
def test_spelling(row: list[str]) -> None:
    """A word is spelt as the dialect has it, whichever way it came."""
    word, british, american = row
    assert spell(word, BRITISH) == british
    assert spell(word, AMERICAN) == american


def test_nothing_stays_nothing() -> None:
    assert pluralize("", BRITISH) == ""
    assert spell("", BRITISH) == ""
    assert [inflect_verb("", form, BRITISH) for form in FORMS] == [""] * 4
    assert [inflect_adjective("", degree, BRITISH) for degree in DEGREES] == ["", ""]
    assert countability("", BRITISH) == "countable"


# What holds of every word

WORDS = st.text(st.characters(min_codepoint=32, max_codepoint=126), min_size=1, max_size=12)
LETTERS = st.text("abcdefghijklmnopqrstuvwxyz", min_size=2, max_size=12)
OF_BOTH = st.sampled_from((BRITISH, AMERICAN))


@given(WORDS, OF_BOTH)
def test_any_word_has_every_form(word: str, inflection: Inflection) -> None:
    """No text is too odd to be inflected."""
    assert all(inflect_verb(word, form, inflection) for form in FORMS)
    assert all(inflect_adjective(word, degree, inflection) for degree in DEGREES)
    assert pluralize(word, inflection)
    assert spell(word, inflection)
    assert countability(word, inflection)


@given(LETTERS, OF_BOTH)
def test_forms_have_their_endings(word: str, inflection: Inflection) -> None:
    """What no table holds ends in -s, -ed, -ing and -er, and keeps its beginning."""
    start = word[:-2]
    assert inflect_verb(word, "gerund", inflection).endswith("ing")
    assert inflect_verb(word, "third", inflection).startswith(start)
    assert inflect_verb(word, "third", inflection).endswith("s")
    past = inflect_verb(word, "past", inflection)
    if word not in inflection.verbs and not word.startswith(inflection.verb_prefixes):
        assert past.endswith("ed")
        assert past.startswith(start)
        assert inflect_verb(word, "participle", inflection) == past
    plural = pluralize(word, inflection)
    if word not in inflection.plurals and not word.endswith(inflection.compound_ends):
        assert plural.startswith(start)
        assert plural.endswith("s")
    if word not in inflection.degrees:
        comparative = inflect_adjective(word, "comparative", inflection)
        assert comparative == f"more {word}" or comparative.endswith("er")


# The data


def test_spelling_is_settled_at_once() -> None:
    """A word spelt once is spelt: no pair leads to another."""
    for inflection in INFLECTIONS.values():
        for word in (*inflection.spellings, *inflection.spellings.values()):
            once = spell(word, inflection)
            assert spell(once, inflection) == once


def _verb_forms(lemma: str, inflection: Inflection) -> list[str]:
    return [inflect_verb(lemma, form, inflection) for form in FORMS]


def _plurals(noun: str, inflection: Inflection) -> list[str]:
    return [pluralize(noun, inflection), pluralize(noun[0].upper() + noun[1:], inflection)]


def _degrees(word: str, inflection: Inflection) -> list[str]:
    return [inflect_adjective(word, degree, inflection) for degree in DEGREES]


# The table, and what it serves
SERVES: dict[str, Callable[[str, Inflection], list[str]]] = {
    "verbs": _verb_forms,
    "third_person": _verb_forms,
    "gerunds": _verb_forms,
    "doubling": _verb_forms,
    "not_doubling": _verb_forms,
    "o_es": lambda word, inflection: [
        *_verb_forms(word, inflection),
        pluralize(word, inflection),
    ],
    "plurals": _plurals,
    "degrees": _degrees,
    "with_er": _degrees,
    "with_more": _degrees,
    "countability": lambda word, inflection: [countability(word, inflection)],
}


@pytest.mark.parametrize("table", SERVES)
def test_no_entry_is_idle(table: str) -> None:
    """What the rules would give anyway, in both dialects, has no place in the tables."""
    forms = SERVES[table]
    idle = []
    for word in getattr(BRITISH, table):
        if table == "countability" and BRITISH.countability[word] != "countable":
            continue  # it serves the plural too
        if all(
            forms(word, each) == forms(word, _without(word, table, each))
            for each in INFLECTIONS.values()
        ):
            idle.append(word)
    # What is uncountable, or a compound's last part, has its place elsewhere.
    named = BRITISH.countability.keys() | BRITISH.compounds.keys()
    assert [word for word in idle if table != "plurals" or word not in named] == []


def _without(word: str, table: str, inflection: Inflection) -> Inflection:
    entries: Any = getattr(inflection, table)
    if isinstance(entries, frozenset):
        less: Any = entries - {word}
    else:
        less = {key: value for key, value in entries.items() if key != word}
    changed: dict[str, Any] = {table: less}
    return inflection._replace(**changed)


def _line_of(text: str, start: str) -> int:
    return text[: text.index(start)].count("\n") + 1


# What is replaced, by what, the line that the message names (by its beginning), and the message
FAULTS = (
    ("  take took taken\n", "  take\n", "  take\n", "'take' has 1 words; write 2 to 3 words"),
    ("  take took taken\n", "  take a b c\n", "  take a", "'take a b c' has 4 words; write 2 to 3"),
    ("  ox oxen\n", "  ox oxen s\n", "  ox oxen s", "'ox oxen s' has 3 words; write 2 words"),
    (
        "  ox oxen\n",
        "  ox oxen/\n",
        "  ox oxen/",
        "has more or less than a word beside each slash; write British/Am",
    ),
    (
        "  ox oxen\n",
        "  ox oxen\n  ox oxes\n",
        "  ox oxes",
        "'ox' stands in 'irregular_plurals' twice",
    ),
    (
        "third_person: |\n",
        "third_persons: |\n",
        "irregular_verbs",
        "'third_person' is missing; add",
    ),
    ("pairs: |\n", "twins: |\n", "irregular_verbs", "'pairs' is missing; add 'pairs: …'"),
    ("with_er: |\n", "with: |\n  x\nwith_er: |\n", "with: |", "unknown field 'with'; did you mean"),
    ("  be is\n", "", None, None),
)


@pytest.mark.parametrize(("old", "new", "place", "message"), FAULTS)
def test_fault_names_its_line(old: str, new: str, place: str | None, message: str | None) -> None:
    """A bad line is named with its own number and a remedy."""
    text = FILE.read_text(encoding="utf-8")
    assert old in text
    text = text.replace(old, new)
    if place is None:
        read_inflection(parse_yaml(text, "x.yaml"))
        return
    with pytest.raises(DataError) as caught:
        read_inflection(parse_yaml(text, "x.yaml"))
    assert str(message) in str(caught.value)
    assert caught.value.line == _line_of(text, place)


def test_table_that_is_no_block() -> None:
    """A table on one line would be read as one entry."""
    text = FILE.read_text(encoding="utf-8")
    start = text.index("gerunds: |")
    end = text.index("\n\n", start)
    text = text[:start] + "gerunds: age ageing" + text[end:]
    with pytest.raises(DataError, match=r"'gerunds' is not a block of lines; write"):
        read_inflection(parse_yaml(text, "x.yaml"))


# The second opinion


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
