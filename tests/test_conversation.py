"""Conversations: every fact once before any returns, fresh markers, names where they are needed."""

from __future__ import annotations

import copy
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from statistics import fmean
from typing import NamedTuple

import pytest

from personage_lite import ConversationState, Generator
from personage_lite.facts import ORDERED_KINDS
from personage_lite.plan import Utterance
from personage_lite.realizer.specification import (
    Cased,
    Clause,
    Coordination,
    Embedded,
    NounPhrase,
    Phrase,
    Sentence,
    Text,
)

CHARACTERS = ("alice", "white_rabbit", "queen_of_hearts")
GENERATOR = Generator()
# Files with many attributes, where every operator finds its place soon.
ATTRIBUTES = Generator(facts=Path(__file__).parent / "facts")


def rounds(character: str, x: float, seed: int, count: int) -> list[list[str]]:
    """Return all facts in the order in which `count` times everything is told."""
    size = len(GENERATOR.character(character).facts)
    found: list[list[str]] = []
    told: list[str] = []
    state = ConversationState()
    while len(found) < count:
        said = GENERATOR.generate(character, x, seed, state=state)
        assert said.facts, "a turn that says nothing"
        state = said.state
        told += said.facts
        while len(told) >= size and len(found) < count:
            found.append(told[:size])
            told = told[size:]
    return found


@pytest.mark.parametrize("x", [-2, 0, 2])
@pytest.mark.parametrize("character", CHARACTERS)
class TestEverythingIsTold:
    """What repeated turns about one character say."""

    def test_every_fact_once_before_any_returns(self, character: str, x: int) -> None:
        """And again after that: three times round."""
        every = sorted(GENERATOR.character(character).by_id)
        for seed in range(2):
            for told in rounds(character, x, seed, 3):
                assert sorted(told) == every

    def test_no_satellite_before_its_nucleus(self, character: str, x: int) -> None:
        """What elaborates or follows another fact waits for it, in each round."""
        ordered = [
            (relation.nucleus, relation.satellite)
            for relation in GENERATOR.character(character).relations
            if relation.kind in ORDERED_KINDS
        ]
        assert ordered
        for seed in range(4):
            for told in rounds(character, x, seed, 2):
                place = {fact: index for index, fact in enumerate(told)}
                for nucleus, satellite in ordered:
                    assert place[nucleus] < place[satellite], (seed, nucleus, satellite)

    def test_turns_count_and_go_on(self, character: str, x: int) -> None:
        """`turns` is the same as passing the state by hand; no two turns are alike."""
        turns = list(GENERATOR.turns(character, x, 3, count=12))
        state = ConversationState()
        for number, said in enumerate(turns):
            assert said.turn == number
            assert said == GENERATOR.generate(character, x, 3, state=state)
            state = said.state
        assert len({said.text for said in turns}) == len(turns)


def test_telling_stops_in_time_at_full_verbosity() -> None:
    """The last turn of a round is as short as it must be; the next begins a new one."""
    for character in CHARACTERS:
        size = len(GENERATOR.character(character).facts)
        told: Counter[str] = Counter()
        for said in GENERATOR.turns(character, 0, 1, count=30, overrides={"verbosity": 1.0}):
            assert len(set(said.facts)) == len(said.facts)
            told.update(said.facts)
            assert max(told.values()) - min(told[fact] for fact in told) <= 1
            if max(told.values()) > 1:
                assert len(told) == size


# The state


def test_the_state_is_immutable() -> None:
    """Generation changes no state that it is given, and nobody can assign to one."""
    state = ConversationState()
    for said in GENERATOR.turns("alice", 2, 4, count=5):
        before = copy.deepcopy(said.state._replace(told={}, worn={}))
        told = {key: dict(counts) for key, counts in said.state.told.items()}
        worn = dict(said.state.worn)
        for character in CHARACTERS:
            GENERATOR.generate(character, -1, 9, state=said.state)
        assert said.state._replace(told={}, worn={}) == before
        assert {key: dict(counts) for key, counts in said.state.told.items()} == told
        assert dict(said.state.worn) == worn
    assert state == ConversationState()
    for name in ConversationState._fields:
        with pytest.raises(AttributeError):
            setattr(state, name, None)


def test_the_states_mappings_are_read_only() -> None:
    """What a turn returns is as immutable as what a conversation starts with."""
    for state in (ConversationState(), GENERATOR.generate("alice", 2, 4).state):
        for mapping in (state.told, state.told_of("alice"), state.worn):
            with pytest.raises(TypeError):
                mapping["alice"] = 1  # type: ignore[index]


def test_the_same_state_gives_the_same_turn() -> None:
    """A conversation can be taken up at any point, any number of times."""
    for seed in range(20):
        *_, last = GENERATOR.turns("queen_of_hearts", 1, seed, count=4)
        one = GENERATOR.generate("queen_of_hearts", 1, seed, state=last.state)
        GENERATOR.generate("alice", -2, seed, state=last.state)
        assert GENERATOR.generate("queen_of_hearts", 1, seed, state=last.state) == one


# Recent markers


def marked(said: Utterance, operator: str) -> bool:
    """Whether an utterance shows an operator's mark."""
    if operator == "exclamation":
        return any(sentence.terminal == "!" for sentence in said.sentences)
    name = {"tag_question": "tag", "in_group_marker": "vocative", "object_ellipsis": "false_start"}
    return any(getattr(sentence, name[operator]) for sentence in said.sentences)


@pytest.mark.parametrize(
    "operator", ["tag_question", "in_group_marker", "exclamation", "object_ellipsis"]
)
def test_recent_markers_are_damped(operator: str) -> None:
    """Right after a turn that used an operator it is likelier not to be drawn again."""
    after: dict[bool, list[float]] = {True: [], False: []}
    overrides = {operator: 0.9, "verbosity": 0.0}
    for seed in range(300):
        talk = ATTRIBUTES.turns(CHARACTERS[seed % 3], 0, seed, count=4, overrides=overrides)
        *_, first, second = talk
        chances = [d.probability for d in second.decisions if d.operator == operator]
        after[marked(first, operator)] += chances
    assert fmean(after[True]) < 0.95 * fmean(after[False])


def test_damping_wears_off() -> None:
    """Four turns later it is as frequent as ever."""
    overrides = {"in_group_marker": 0.5, "verbosity": 0.0}
    once: list[bool] = []
    fresh: list[bool] = []
    for seed in range(500):
        turns = list(GENERATOR.turns("alice", 0, seed, count=5, overrides=overrides))
        marks = [marked(said, "in_group_marker") for said in turns]
        fresh.append(marks[0])
        if not any(marks[1:4]):
            once.append(marks[4])
    assert abs(fmean(once) - fmean(fresh)) < 0.15


def test_worn_words_give_way() -> None:
    """The acknowledgment of the last turn is rarely the next one's."""
    overrides = {"acknowledgments": 1.0, "verbosity": 0.0}
    same = [
        one.sentences[0].openers == other.sentences[0].openers
        for seed in range(300)
        for one, other in [GENERATOR.turns("alice", 0, seed, count=2, overrides=overrides)]
        if one.sentences[0].openers and other.sentences[0].openers
    ]
    assert len(same) > 200
    # There are six of them here, so chance alone would make it a sixth and more.
    assert fmean(same) < 0.12


# Who is meant


class Mention(NamedTuple):
    """A noun phrase that stands for an entity, where it is heard.

    `clause_subject` is whom its own clause is about, if that was said already, and
    `subject_before` whom the clause before was about; an `argument` is all of its verb's object.
    """

    phrase: NounPhrase
    case: str
    is_subject: bool
    clause_subject: str
    subject_before: str
    argument: bool = False

    @property
    def entity(self) -> str:
        """Whom it stands for."""
        return self.phrase.entity

    @property
    def kind(self) -> str:
        """Which pronoun it has."""
        return "plural" if self.phrase.number == "plural" else self.phrase.gender


class Listener:
    """Reads sentences in order, as they are heard, and says which pronouns are unclear."""

    def __init__(self) -> None:
        self.sentence: list[Mention] = []
        self.sentence_before: list[Mention] = []
        # Whom the last clause was about.
        self.about = ""
        self.everybody: list[Mention] = []
        self.faults: list[str] = []

    def hear(self, said: Utterance) -> None:
        """Read a turn."""
        for sentence in said.sentences:
            earlier, before = self.sentence_before, self.sentence
            self.sentence_before, self.sentence = self.sentence, []
            self._sentence(sentence)
            if isinstance(sentence.body, Text) and not self.sentence:
                # A cry such as "Wait till you hear this!" turns nobody's mind elsewhere.
                self.sentence_before, self.sentence = earlier, before

    def _sentence(self, sentence: Sentence) -> None:
        subject = ""
        bodies = [(sentence.body, False)]
        bodies += [(joined.body, joined.shared_subject) for joined in sentence.joined]
        for body, shared in bodies:
            if isinstance(body, Embedded):
                self._phrase(body.lead, "", self.about)
                for part in body.lead.parts:
                    if isinstance(part, Cased):
                        self.about = part.phrase.entity  # "one thing to know about Alice is …"
                subject = self._clause(body.clause)
            elif isinstance(body, Clause):
                subject = self._clause(body, shared=subject if shared else "")
            else:
                self._phrase(body, "", self.about)

    def _clause(self, clause: Clause, shared: str = "") -> str:
        """Read a clause; returns whom it is about."""
        for below in clause.subordinates:
            if below.fronted:
                self._clause(below.clause)
        for phrase in clause.preposed:
            self._phrase(phrase, "", self.about)
        before, subject, owner = self.about, clause.subject, shared
        if clause.mood == "exclamative" and clause.complement is not None:
            self._phrase(clause.complement, owner, before)
        if isinstance(subject, NounPhrase) and not shared:
            if isinstance(subject.possessor, NounPhrase):
                owner = subject.possessor.entity
                self._mention(subject.possessor, "possessive", False, "", before)
            else:
                owner = subject.entity
                self._mention(subject, "subjective", True, "", before)
            self.about = owner or before
            self._relative(subject, owner, before)
        self._predicate(clause, owner, before)
        self.about = owner or before
        for below in clause.subordinates:
            if not below.fronted:
                self._clause(below.clause)
        return owner

    def _predicate(self, clause: Clause, owner: str, before: str) -> None:
        complement = None if clause.mood == "exclamative" else clause.complement
        phrases = [clause.indirect_object, clause.object, complement]
        for phrase in (*phrases, *clause.adverbials, *clause.asides):
            alone = isinstance(phrase, Text) and len(phrase.parts) == 1
            if phrase is not None:
                self._phrase(phrase, owner, before, alone and phrase in phrases[:2])

    def _relative(self, phrase: NounPhrase, owner: str, before: str) -> None:
        if phrase.relative is not None and isinstance(phrase.relative.clause, Clause):
            self._predicate(phrase.relative.clause, owner, before)

    def _phrase(self, phrase: Phrase, owner: str, before: str, argument: bool = False) -> None:
        if isinstance(phrase, Coordination):
            for item in phrase.items:
                self._phrase(item, owner, before)
        elif isinstance(phrase, NounPhrase):
            self._relative(phrase, owner, before)
        elif isinstance(phrase, Text):
            for part in phrase.parts:
                if isinstance(part, Cased):
                    subject = part.case == "subjective"
                    argument = argument and part.case == "objective"
                    self._mention(part.phrase, part.case, subject, owner, before, argument)
                    if part.phrase.relative is not None:
                        self._relative(part.phrase, part.phrase.entity, owner)
                        self.about = part.phrase.entity

    def _mention(
        self,
        phrase: NounPhrase,
        case: str,
        is_subject: bool,
        owner: str,
        before: str,
        argument: bool = False,
    ) -> None:
        if not phrase.entity or case == "reflexive":
            return
        mention = Mention(phrase, case, is_subject, owner, before, argument)
        if phrase.pronoun and not self._clear(mention):
            self.faults.append(f"{mention.kind} pronoun for {mention.entity}")
        self.sentence.append(mention)
        self.everybody.append(mention)

    def _clear(self, mention: Mention) -> bool:
        """Whether a pronoun can only be understood as it is meant."""
        if mention.clause_subject == mention.entity:
            return True
        lately = [*self.sentence_before, *self.sentence]
        if mention.entity not in {other.entity for other in lately}:
            return False
        if mention.is_subject and mention.subject_before == mention.entity:
            return True
        # Who has been named in this sentence is nearer than all of the sentence before.
        named = mention.entity in {other.entity for other in self.sentence}
        near = self.sentence if named else lately
        rivals = {other.entity for other in near if other.kind == mention.kind}
        if mention.argument or mention.entity == mention.subject_before:
            rivals.discard(mention.clause_subject)  # that would be "herself"
        return rivals == {mention.entity}


def conversation(seed: int, x: float, changing: bool, count: int = 5) -> Iterator[Utterance]:
    """Yield a conversation about one character, or about another one every turn or two."""
    state = ConversationState()
    for turn in range(count):
        shift = (turn * (1 + seed % 2) + 1) // 2 if changing else 0
        character = CHARACTERS[(seed + shift) % 3]
        said = GENERATOR.generate(character, x, seed, state=state)
        state = said.state
        yield said


@pytest.mark.parametrize("changing", [False, True])
@pytest.mark.parametrize("x", [-2, -1, 0, 1, 2])
def test_pronouns_are_unambiguous(x: int, changing: bool) -> None:
    """Read in order, every pronoun's meaning is plain, across turns and topics too."""
    found = []
    for seed in range(180):
        listener = Listener()
        heard: list[str] = []
        for said in conversation(seed, x, changing):
            heard.append(said.text)
            listener.hear(said)
            if listener.faults:
                found.append((seed, said.turn, listener.faults, heard[-2:]))
                break
    assert not found, (len(found), found[:3])


@pytest.mark.parametrize("pronominalization", [0.0, 1.0])
def test_pronouns_are_unambiguous_in_long_turns(pronominalization: float) -> None:
    """The same where everybody who can be a pronoun is one, in turns of six facts."""
    overrides = {"verbosity": 0.9, "pronominalization": pronominalization}
    found = []
    for character in CHARACTERS:
        for seed in range(50):
            listener = Listener()
            for said in GENERATOR.turns(character, 1, seed, count=3, overrides=overrides):
                listener.hear(said)
                if listener.faults:
                    found.append((character, seed, said.turn, listener.faults, said.text))
                    break
    assert not found, (len(found), found[:3])


def _alice(pronoun: bool) -> NounPhrase:
    return GENERATOR.character("alice").entity.phrase._replace(pronoun=pronoun)


def test_the_listener_notices() -> None:
    """ "Alice sees Dinah. Dinah sees her. She …": a checker that cannot fail proves nothing."""
    about = GENERATOR.character("alice")
    dinah = about.entities["dinah"].phrase
    she_sees = Clause("see", _alice(True), object=Text((Cased(dinah),)))
    told = GENERATOR.generate("alice", 0, 0)

    def faults(*clauses: Clause) -> list[str]:
        listener = Listener()
        listener.hear(told._replace(sentences=tuple(Sentence(clause) for clause in clauses)))
        return listener.faults

    named = she_sees._replace(subject=_alice(False))
    assert faults(she_sees)
    assert not faults(named, she_sees)
    dinah_sees = Clause("see", dinah, object=Text((Cased(_alice(True)),)))
    assert not faults(named, dinah_sees)  # "herself" if it were Dinah
    dinah_sits = Clause("sit", dinah, adverbials=(Text(("beside", Cased(_alice(True)))),))
    assert not faults(named, dinah_sits)  # who was talked about, and again not "herself"
    seen = Clause("see", dinah, object=Text((Cased(_alice(False)),)))
    assert faults(seen, dinah_sits)
    assert faults(named, seen, she_sees)
    bound = Clause("see", dinah, object=Text((Cased(dinah._replace(pronoun=True), "possessive"),)))
    assert not faults(named, bound)
    gap = Clause("rain", NounPhrase("it"))
    assert faults(named, gap, she_sees)


@pytest.mark.parametrize("x", [-2, 0, 2])
def test_a_changed_topic_is_introduced_by_name(x: int) -> None:
    """Whoever was talked about before, a new character's first mention is no pronoun."""
    found = []
    for seed in range(150):
        before = ""
        for said in conversation(seed, x, changing=True):
            if said.character != before:
                listener = Listener()
                listener.hear(said)
                mine = [m for m in listener.everybody if m.entity == said.character]
                if mine and mine[0].phrase.pronoun:
                    found.append((seed, said.turn, said.text))
            before = said.character
    assert not found, (len(found), found[:3])
