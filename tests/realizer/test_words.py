"""Proves that words take their degrees and spelling, and that no word is too odd for any form.

The tables hold reviewed forms, a slash between British and American.
"""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from personage_lite.realizer.inflection import Inflection
from personage_lite.realizer.words import (
    countability,
    inflect_adjective,
    inflect_verb,
    pluralize,
    spell,
)
from tests.realizer.word_helpers import AMERICAN, BRITISH, DEGREES, FORMS, rows, sides

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


@pytest.mark.parametrize("row", rows(ADJECTIVES), ids="-".join)
def test_degrees(row: list[str]) -> None:
    """Comparatives and superlatives of adjectives and adverbs, in both dialects."""
    _, positive, *cells = row
    for inflection, expected in zip((BRITISH, AMERICAN), sides(cells), strict=True):
        assert [inflect_adjective(positive, degree, inflection) for degree in DEGREES] == expected
        assert inflect_adjective(positive, "positive", inflection) == positive


@pytest.mark.parametrize("row", rows(SPELLINGS), ids="-".join)
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
