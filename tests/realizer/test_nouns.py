"""Proves that nouns take their right plurals, and which of them can be counted.

The tables hold reviewed forms, a slash between British and American.
"""

from __future__ import annotations

import pytest

from personage_lite.realizer.words import countability, pluralize
from tests.realizer.word_helpers import AMERICAN, BRITISH, rows, sides

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
COUNTABILITIES = """
countable cat cats child idea witness mechanism critic pack_of_cards blorp
uncountable furniture advice news information luggage physics happiness tourism water
uncountable white_bread bronchitis
plural_only clothes thanks cattle outskirts old_clothes
pair scissors trousers spectacles tweezers bellows new_scissors
"""


@pytest.mark.parametrize("row", rows(PLURALS), ids="-".join)
def test_plural(row: list[str]) -> None:
    """Plurals of words, compounds, names and phrases, in both dialects."""
    _, noun, plural = row
    british, american = sides([plural])
    assert [pluralize(noun, BRITISH)] == british
    assert [pluralize(noun, AMERICAN)] == american


@pytest.mark.parametrize("row", rows(COUNTABILITIES), ids="-".join)
def test_countability(row: list[str]) -> None:
    """Nouns without plural, only plural and in pairs; a phrase goes by its head."""
    expected, *nouns = row
    expected = expected.replace(" ", "_")
    assert {noun: countability(noun, BRITISH) for noun in nouns} == dict.fromkeys(nouns, expected)
