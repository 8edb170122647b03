"""Proves that verbs take their right forms, in both dialects.

The table holds reviewed forms, a slash between British and American.
"""

from __future__ import annotations

import pytest

from personage_lite.realizer.words import inflect_verb
from tests.realizer.word_helpers import AMERICAN, BRITISH, FORMS, rows, sides

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


@pytest.mark.parametrize("row", rows(VERBS), ids="-".join)
def test_verb(row: list[str]) -> None:
    """Third person, past, participle and gerund, in both dialects."""
    _, lemma, *cells = row
    for inflection, expected in zip((BRITISH, AMERICAN), sides(cells), strict=True):
        assert [inflect_verb(lemma, form, inflection) for form in FORMS] == expected
        assert inflect_verb(lemma, "base", inflection) == lemma
