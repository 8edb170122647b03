"""The content planner: chooses what to say and in which order (Reiter & Dale 2000, ch. 4).

New facts come before old ones; the chosen facts cohere by relation and topic; parameters tilt
the choice. Source: Mairesse & Walker 2011, section 4.1; the paper, section IV-C.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import groupby, pairwise
from math import floor
from typing import Final, get_args

from personage_lite.fact_choice import FactChoice
from personage_lite.facts import (
    OPPOSING_KINDS,
    TELLING_KINDS,
    Character,
    Fact,
    Relation,
    RelationKind,
)
from personage_lite.operators import Turn
from personage_lite.plan import STATES, ContentPlan, Decision, Link, Made, Message, Role, Status
from personage_lite.realizer.specification import AdjectivePhrase

STAGE: Final = "content_planning"
# The most facts that verbosity adds to the first one.
_MOST_MORE: Final = 6.0
# Who is less verbose than this stops where it falls, in the middle of a thought.
_TERSE: Final = 0.06
# How many facts back somebody still has in mind what was told.
_LATELY: Final = 8
# What is drawn for once a turn, in the order of the numbers of one row of draws.
_DRAWN: Final = (
    *("verbosity", "positive_content_first", "recall", "repetitions", "restatements"),
    *("request_confirmation", "initial_rejection", "competence_mitigation"),
)
_SAID_AGAIN: Final[tuple[tuple[str, Role], ...]] = (
    ("repetitions", "repetition"),
    ("restatements", "restatement"),
)
# What holds between facts without a relation, and between a fact and itself.
_NOTHING: Final = Link("none")
_SAME_SUBJECT: Final = Link("infer")
_AGAIN: Final = Link("restatement")
# What a relation can make of two facts, by its kind, `satellite_first` and `fixed_order`: looking
# one up takes a quarter of the time that making one takes.
_LINKS: Final[dict[tuple[RelationKind, bool, bool], Link]] = {
    (kind, first, fixed): Link(kind, first, fixed)
    for kind in get_args(RelationKind)
    for first in (False, True)
    for fixed in (False, True)
}


class _Planner:
    """One turn's planning after the choice: links, order, stress and what is said again."""

    def __init__(self, character: Character, turn: Turn) -> None:
        self.character = character
        self.turn = turn
        self.told = turn.state.told_of(character.entity.id)
        self.decisions: list[Made] = []
        row = turn.draws.numbers(STAGE, len(_DRAWN))
        self._row = dict(zip(_DRAWN, row, strict=True))

    def decide(self, name: str) -> bool:
        """Draw for a planning decision and note it; a rare one has no place in the row."""
        probability = self.turn.probability(name)
        draw = self._row[name] if name in self._row else self.turn.draws.uniform(name)
        applied = draw < probability
        status: Status = "applied" if applied else "not_drawn"
        self.decisions.append((name, STAGE, probability, draw, status, "", "", ""))
        return applied

    def _amend(self, target: str, status: Status = "applied") -> None:
        """Note what came of the last decision."""
        last = Decision(*self.decisions[-1])
        self.decisions[-1] = last._replace(target=target, status=status)

    def chosen(self) -> list[Fact]:
        """Return the facts of this turn in the order of choice."""
        state = self.turn.state
        verbosity, draw = self.turn.parameters["verbosity"], self._row["verbosity"]
        count = 1 + floor(_MOST_MORE * verbosity + draw)
        last = None
        if state.topic == self.character.entity.id:
            last = self.character.by_id.get(state.last_fact)
        choice = FactChoice(self.character, self.turn)
        facts: list[Fact] = []
        terse = verbosity < _TERSE
        while len(facts) < count or not (terse or _finished(facts, count, choice)):
            fact = choice.take(last, len(facts))
            if fact is None:
                break
            # Nobody begins another topic in the same breath, but by what ties the two.
            elsewhere = bool(facts) and fact.topic != facts[-1].topic
            if elsewhere and self.link(facts[-1], fact).kind == "none":
                break
            facts.append(fact)
            last = fact
        target = f"{len(facts)} fact{'s' * (len(facts) != 1)}"
        self.decisions.append(("verbosity", STAGE, verbosity, draw, "applied", target, "", ""))
        return facts

    def link(self, left: Fact, right: Fact) -> Link:
        """Return what holds between two facts told one after the other."""
        first, second = left.id, right.id
        found: Relation | None = None
        for relation in self.character.related.get(first, ()):
            kind, nucleus, satellite, _ = relation
            if kind == "restatement" or second not in (nucleus, satellite):
                continue
            if found is None or kind in TELLING_KINDS:
                found = relation
        if found is not None:
            fixed = first in self.character.prerequisites.get(second, ())
            return _LINKS[found.kind, found.satellite == first, fixed]
        places = self.character.places
        near = right.topic == left.topic and abs(places[right.id] - places[left.id]) == 1
        # What does not stand side by side in the file is no pair: it is told in two sentences.
        return _SAME_SUBJECT if near and left.about == right.about else _NOTHING

    def linked(self, left: Message, right: Message) -> Link:
        """Return what holds between two messages."""
        if right.role == "recall":
            return _NOTHING
        return self.link(left.fact, right.fact) if right.role == "assertion" else _AGAIN

    def stress(self, links: list[Link], messages: list[Message]) -> list[Link]:
        """Make the good side of a concession its nucleus, if drawn: the stress falls there.

        Only where one side is good and the other bad: both are said either way, and each
        concedes the other.
        """
        stressed = []
        for link, left, right in zip(links, messages, messages[1:], strict=False):
            opposed = {left.fact.polarity, right.fact.polarity} == {"good", "bad"}
            # Deeds have an order in time that would be lost.
            opposed = opposed and left.fact.clause.verb == right.fact.clause.verb == "be"
            if link.kind == "concession" and opposed and self.decide("concession_polarity"):
                link = link._replace(satellite_first=left.fact.polarity == "bad")
            stressed.append(link)
        return stressed

    def order(self, facts: list[Fact]) -> list[Fact]:
        """Put good news of a topic first, if drawn, moving linked facts together.

        Stories keep their order, and who it is stays in front.
        """
        if len(facts) < 2 or not self.decide("positive_content_first"):
            return facts
        fresh = not self.told
        units: list[list[Fact]] = [[facts[0]]]
        for left, right in pairwise(facts):
            if self.link(left, right).kind == "none":
                units.append([right])
            else:
                units[-1].append(right)
        value = {"good": 0, "neutral": 1, "bad": 2}
        ordered = units.pop(0) if fresh else []
        for topic, run in groupby(units, key=lambda unit: unit[0].topic):
            told = list(run)
            if not self.character.topics[topic].in_order:
                told.sort(key=lambda unit: sum(value[fact.polarity] for fact in unit) / len(unit))
            ordered += [fact for unit in told for fact in unit]
        place = {fact.id: index for index, fact in enumerate(ordered)}
        for fact in ordered:
            for first in self.character.prerequisites.get(fact.id, ()):
                if place.get(first, -1) > place[fact.id]:
                    return facts
        return ordered

    def recall(self, messages: list[Message]) -> None:
        """Take up what was told in an earlier turn, if drawn: it explains or opposes what comes."""
        told = self.told
        if not told:
            return
        able = [
            (index, other)
            for index, message in enumerate(messages)
            for other in self._recallable(messages, index, told)
        ]
        if not able or not self.decide("recall"):
            return
        index, other = self.turn.draws.choose("recall/which", able, [1.0] * len(able))
        messages.insert(index, Message(self.character.by_id[other], "recall"))
        self._amend(other)

    def _recallable(
        self, messages: list[Message], index: int, told: Mapping[str, int]
    ) -> Iterator[str]:
        """Yield the facts told before that a message can be said to follow from or to oppose."""
        fact = messages[index].fact
        if told.get(fact.id) or (
            index and self.link(messages[index - 1].fact, fact).kind != "none"
        ):
            return
        here = {message.fact.id for message in messages}
        lately = list(told)[-_LATELY:]
        for relation in self.character.related.get(fact.id, ()):
            other = relation.satellite if relation.nucleus == fact.id else relation.nucleus
            known = told.get(other) and other not in here and other not in lately
            spoken = self.character.by_id[other].clause.quotation  # no "but" could follow that
            # The reason and what is conceded come first; a contrast goes both ways.
            before = other == relation.satellite or relation.kind == "contrast"
            if relation.kind in TELLING_KINDS and known and before and not spoken:
                yield other

    def say_again(self, messages: list[Message]) -> None:
        """Put a repetition and a restatement after messages that allow one."""
        for name, role in _SAID_AGAIN:
            if not self.decide(name):
                continue
            able = [index for index, message in enumerate(messages) if _repeatable(messages, index)]
            if not able:
                self._amend("", "not_applicable")
                continue
            liking = self.turn.parameters["repetition_polarity"]
            weight = {"good": liking + 0.02, "neutral": 0.5, "bad": 1.02 - liking}
            weights = [weight[messages[index].fact.polarity] for index in able]
            index = self.turn.draws.choose(f"{name}/which", able, weights)
            fact = messages[index].fact
            messages.insert(index + 1, Message(fact, role))
            self._amend(fact.id)


def _finished(facts: list[Fact], count: int, choice: FactChoice) -> bool:
    """Whether one can stop after `count` facts or more, without a thought left unsaid.

    One goes on, by a fact, rather than leave a topic's last one to stand alone afterwards, and by
    two for the sake of what the last one explains or opposes.
    """
    last, more = facts[-1], len(facts) - count
    return not ((not more and choice.leaves_one(last)) or (more <= 1 and choice.unfinished(last)))


def _repeatable(messages: list[Message], index: int) -> bool:
    """Only an attribute, affirmed, not yet said again, can be: "curious, really curious"."""
    fact = messages[index].fact
    return (
        messages[index].role == "assertion"
        and isinstance(fact.clause.complement, AdjectivePhrase)
        and not fact.clause.negated
        and fact.strength != "somewhat"
        and sum(1 for message in messages if message.fact is fact) == 1
    )


def plan_content(character: Character, turn: Turn) -> tuple[ContentPlan, list[Made]]:
    """Choose and order the messages of one turn.

    Returns the content plan and the decisions that led to it. Every fact is told once before
    any is told again; what elaborates or follows another fact waits for it.
    """
    planner = _Planner(character, turn)
    facts = planner.order(planner.chosen())
    # Made directly, here and elsewhere: a named tuple's own maker takes twice as long.
    messages = [tuple.__new__(Message, (fact, "assertion")) for fact in facts]
    planner.recall(messages)
    planner.say_again(messages)
    links = [planner.linked(left, right) for left, right in pairwise(messages)]
    if links:
        links = planner.stress(links, messages)
    new_topic = turn.state.topic != character.entity.id
    confirmation = new_topic and planner.decide("request_confirmation")
    recalls = messages[0].role == "recall"
    first = messages[0].fact
    story = character.topics[first.topic].in_order and first.clause.verb not in STATES
    # Nobody disclaims a plain neutral fact, a view of somebody, or the next step of a story.
    view = isinstance(first.clause.complement, AdjectivePhrase)
    doubtful = first.polarity != "neutral" and not (confirmation or recalls or story or view)
    # Not "I might be wrong, but he might …", nor "I might be wrong, but …, but …".
    opposed = bool(links) and links[0].kind in OPPOSING_KINDS
    doubtful = doubtful and not (first.clause.modal or opposed)
    rejection = doubtful and planner.decide("initial_rejection")
    # Nor "let me tell you about her! You probably know this, but …".
    known = not (rejection or recalls or opposed or confirmation)
    mitigation = known and planner.decide("competence_mitigation")
    said = (tuple(messages), tuple(links), confirmation, rejection, mitigation)
    return tuple.__new__(ContentPlan, said), planner.decisions
