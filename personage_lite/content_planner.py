"""The content planner: chooses what to say and in which order (Reiter & Dale 2000, ch. 4).

New facts come before old ones; the chosen facts cohere by relation and topic; parameters tilt
the choice. Source: Mairesse & Walker 2011, section 4.1; the paper, section IV-C.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from math import floor

from personage_lite.facts import Character, Fact, Relation
from personage_lite.operators import Turn
from personage_lite.plan import ContentPlan, Decision, Link, Message, Role, Status, decided
from personage_lite.randomness import pick
from personage_lite.realizer.specification import AdjectivePhrase

STAGE = "content_planning"
# The most facts that verbosity adds to the first one.
_MOST_MORE = 6.0
# How much likelier a fact is that has a relation to the last one, by kind of relation.
_RELATED = {
    "elaboration": 9.0,
    "justification": 9.0,
    "sequence": 6.0,
    "restatement": 0.1,
    "concession": 10.0,
    "contrast": 10.0,
}
_OPPOSING = ("concession", "contrast")
# Of two relations between the same facts, one of these is what is said.
_TELLING = (*_OPPOSING, "justification")
_SAME_TOPIC = 3.0
_OTHER_SUBJECT_FIRST = 0.3
_SAID_AGAIN: tuple[tuple[str, Role], ...] = (
    ("repetitions", "repetition"),
    ("restatements", "restatement"),
)
# What holds between facts without a relation, and between a fact and itself.
_NOTHING, _SAME_SUBJECT, _AGAIN = Link("none"), Link("infer"), Link("restatement")


class _Choice:
    """The facts that can be told next in one turn; lives no longer than the turn."""

    def __init__(self, character: Character, turn: Turn) -> None:
        self._character = character
        self._turn = turn
        told = turn.state.told_of(character.entity.id)
        self._table = table = _weights(turn.parameters)
        # A weight for each fact in the order of the file; 0 for what cannot be told now.
        self._weights = [table[kind] for kind in character.openings]
        self._open = set(character.by_id)
        if told:
            counts = [told.get(key, 0) for key in character.by_id]
            fewest = min(counts)
            for place, (key, count) in enumerate(zip(character.by_id, counts, strict=True)):
                if count != fewest:
                    self._open.discard(key)
                    self._weights[place] = 0.0
            self._unlock(character.prerequisites)

    def _ready(self, key: str) -> bool:
        """Whether a fact is open and all that must be told before it has been told."""
        before = self._character.prerequisites.get(key)
        return key in self._open and (before is None or self._open.isdisjoint(before))

    def take(self, last: Fact | None, index: int) -> Fact | None:
        """Return the fact to tell after `last`, drawn by weight; None when nothing is open.

        `index` is its place in this utterance: the first one should be about the character.
        """
        if not self._open:
            return None
        character, weights = self._character, self._weights.copy()
        places = character.places
        if last is not None:
            for place in character.by_topic[last.topic]:
                weights[place] *= _SAME_TOPIC
            if last.id in character.related:
                for key, factor in self._related(last).items():
                    weights[places[key]] *= factor
        if not index:
            for place in character.by_others:
                weights[place] *= _OTHER_SUBJECT_FIRST
        fact = pick(self._turn.draws.uniform(f"fact/{index}"), character.facts, weights)
        self._open.discard(fact.id)
        self._weights[places[fact.id]] = 0.0
        # What waited for this fact alone can now be told.
        self._unlock(character.unlocks.get(fact.id, ()))
        return fact

    def _unlock(self, keys: Iterable[str]) -> None:
        """Give those facts their weights that wait for nothing any more."""
        for key in keys:
            if self._ready(key):
                place = self._character.places[key]
                self._weights[place] = self._table[self._character.kinds[place]]

    def _related(self, last: Fact) -> dict[str, float]:
        factors: dict[str, float] = {}
        concessions = 2 * self._turn.parameters["concessions"]
        for relation in self._character.related[last.id]:
            other = relation.satellite if relation.nucleus == last.id else relation.nucleus
            factor = _RELATED[relation.kind]
            if relation.kind in _OPPOSING:
                factor = 1.0 + (factor - 1.0) * concessions
            factors[other] = max(factor, factors.get(other, 0.0))
        return factors


def _weights(parameters: dict[str, float]) -> list[float]:
    """Return how readily a fact is told, by its kind: polarity, then strength; 0 if it waits."""
    liking, extreme = parameters["content_polarity"], parameters["polarization"]
    good, bad = 2 * liking + 0.05, 2 * (1 - liking) + 0.05
    extremely, somewhat = 2 * extreme + 0.05, 2 * (1 - extreme) + 0.05
    # In the order of POLARITIES and STRENGTHS; what waits comes last.
    return [
        *(good * somewhat, good, good * extremely),
        *(somewhat, 1.0, extremely),
        *(bad * somewhat, bad, bad * extremely),
        0.0,
    ]


class _Planner:
    """One turn's planning after the choice: links, order, stress and what is said again."""

    def __init__(self, character: Character, turn: Turn) -> None:
        self.character = character
        self.turn = turn
        self.decisions: list[Decision] = []

    def decide(self, name: str) -> bool:
        """Draw for a planning decision and note it."""
        probability = self.turn.probability(name)
        draw = self.turn.draws.uniform(name)
        applied = draw < probability
        status: Status = "applied" if applied else "not_drawn"
        self.decisions.append(decided(name, STAGE, probability, draw, status))
        return applied

    def chosen(self) -> list[Fact]:
        """Return the facts of this turn in the order of choice."""
        state, draws = self.turn.state, self.turn.draws
        verbosity, draw = self.turn.parameters["verbosity"], draws.uniform("verbosity")
        count = 1 + floor(_MOST_MORE * verbosity + draw)
        last = None
        if state.topic == self.character.entity.id:
            last = self.character.by_id.get(state.last_fact)
        choice = _Choice(self.character, self.turn)
        facts: list[Fact] = []
        while len(facts) < count:
            fact = choice.take(last, len(facts))
            if fact is None:
                break
            facts.append(fact)
            last = fact
        target = f"{len(facts)} fact{'s' * (len(facts) != 1)}"
        self.decisions.append(decided("verbosity", STAGE, verbosity, draw, "applied", target))
        return facts

    def link(self, left: Fact, right: Fact) -> Link:
        """Return what holds between two facts told one after the other."""
        found: Relation | None = None
        for relation in self.character.related.get(left.id, ()):
            between = right.id in (relation.nucleus, relation.satellite)
            if not between or relation.kind == "restatement":
                continue
            if found is None or relation.kind in _TELLING:
                found = relation
        if found is not None:
            return Link(
                found.kind,
                satellite_first=found.satellite == left.id,
                fixed_order=left.id in self.character.prerequisites.get(right.id, ()),
            )
        return _SAME_SUBJECT if left.about == right.about else _NOTHING

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
        """Put good news first, if drawn, moving linked facts together and never out of order."""
        if len(facts) < 2 or not self.decide("positive_content_first"):
            return facts
        units: list[list[Fact]] = [[facts[0]]]
        for left, right in pairwise(facts):
            if self.link(left, right).kind in ("infer", "none"):
                units.append([right])
            else:
                units[-1].append(right)
        value = {"good": 0, "neutral": 1, "bad": 2}
        units.sort(key=lambda unit: sum(value[fact.polarity] for fact in unit) / len(unit))
        ordered = [fact for unit in units for fact in unit]
        place = {fact.id: index for index, fact in enumerate(ordered)}
        for fact in ordered:
            for first in self.character.prerequisites.get(fact.id, ()):
                if place.get(first, -1) > place[fact.id]:
                    return facts
        return ordered

    def say_again(self, messages: list[Message]) -> None:
        """Put a repetition and a restatement after messages that allow one."""
        for name, role in _SAID_AGAIN:
            if not self.decide(name):
                continue
            able = [index for index, message in enumerate(messages) if _repeatable(messages, index)]
            if not able:
                self.decisions[-1] = self.decisions[-1]._replace(status="not_applicable")
                continue
            liking = self.turn.parameters["repetition_polarity"]
            weight = {"good": liking + 0.02, "neutral": 0.5, "bad": 1.02 - liking}
            weights = [weight[messages[index].fact.polarity] for index in able]
            index = self.turn.draws.choose(f"{name}/which", able, weights)
            fact = messages[index].fact
            messages.insert(index + 1, Message(fact, role))
            self.decisions[-1] = self.decisions[-1]._replace(target=fact.id)


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


def plan_content(character: Character, turn: Turn) -> tuple[ContentPlan, list[Decision]]:
    """Choose and order the messages of one turn.

    Returns the content plan and the decisions that led to it. Every fact is told once before
    any is told again; what elaborates or follows another fact waits for it.
    """
    planner = _Planner(character, turn)
    messages = [Message(fact) for fact in planner.order(planner.chosen())]
    planner.say_again(messages)
    links = [
        planner.link(left.fact, right.fact) if right.role == "assertion" else _AGAIN
        for left, right in pairwise(messages)
    ]
    if links:
        links = planner.stress(links, messages)
    new_topic = turn.state.topic != character.entity.id
    confirmation = new_topic and planner.decide("request_confirmation")
    # Nobody disclaims a plain neutral fact.
    doubtful = not confirmation and messages[0].fact.polarity != "neutral"
    rejection = doubtful and planner.decide("initial_rejection")
    mitigation = not rejection and planner.decide("competence_mitigation")
    plan = ContentPlan(tuple(messages), tuple(links), confirmation, rejection, mitigation)
    return plan, planner.decisions
