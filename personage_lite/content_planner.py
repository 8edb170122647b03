"""The content planner: chooses what to say and in which order (Reiter & Dale 2000, ch. 4).

New facts come before old ones; the chosen facts cohere by relation and topic; parameters tilt
the choice. Source: Mairesse & Walker 2011, section 4.1; the paper, section IV-C.
"""

from __future__ import annotations

from dataclasses import replace
from math import floor, log

from personage_lite.facts import Character, Fact, Relation
from personage_lite.plan import ContentPlan, Decision, Link, Message, Role, Status
from personage_lite.realizer.specification import AdjectivePhrase
from personage_lite.operators import Turn

# The most facts that verbosity adds to the first one.
_MOST_MORE = 6.0
# How much likelier a fact is that has a relation to the last one, by kind of relation.
_RELATED = {
    "elaboration": 9.0,
    "justification": 9.0,
    "sequence": 6.0,
    "restatement": 0.6,
    "concession": 10.0,
    "contrast": 10.0,
}
_OPPOSING = ("concession", "contrast")
_SAME_TOPIC = 3.0
_OTHER_SUBJECT_FIRST = 0.3
_NOTHING = Link("none")


class _Planner:
    """One turn's content planning; lives no longer than the turn."""

    def __init__(self, character: Character, turn: Turn) -> None:
        self.character = character
        self.turn = turn
        self.parameters = turn.parameters
        self.draws = draws = turn.draws
        self.state = state = turn.state
        self.decisions: list[Decision] = []
        told = {fact.id: state.times_told(character.entity.id, fact.id) for fact in character.facts}
        fewest = min(told.values())
        self.fresh = [fact for fact in character.facts if told[fact.id] == fewest]
        self.open = {fact.id for fact in self.fresh}
        self.weights = {fact.id: self._weight(fact) for fact in self.fresh}
        self.races = {fact.id: -log(draws.uniform(f"fact/{fact.id}") + 1e-12) for fact in self.fresh}

    def decide(self, name: str) -> bool:
        """Draw for a planning decision and note it."""
        probability = self.turn.probability(name)
        draw = self.draws.uniform(name)
        status: Status = "applied" if draw < probability else "not_drawn"
        self.note(name, probability, draw, status)
        return draw < probability

    def note(
        self, name: str, probability: float, draw: float, status: Status, target: str = ""
    ) -> None:
        """Record a decision of this stage."""
        self.decisions.append(
            Decision(name, "content_planning", probability, draw, status, target)
        )

    def _weight(self, fact: Fact) -> float:
        """How readily a fact is told, by its polarity and strength."""
        liking = self.parameters["content_polarity"]
        extreme = self.parameters["polarization"]
        weight = 1.0
        if fact.polarity != "neutral":
            weight = 2 * (liking if fact.polarity == "good" else 1 - liking) + 0.05
        if fact.strength != "plainly":
            weight *= 2 * (extreme if fact.strength == "extremely" else 1 - extreme) + 0.05
        return weight

    def choose(self, last: Fact | None, spoken: bool) -> Fact | None:
        """Return the fact to tell after `last`: the winner of a weighted race.

        `spoken` says that `last` is in this utterance, not in the one before.
        """
        related = self._related(last) if last is not None else {}
        entity = self.character.entity.id
        best, best_time = None, float("inf")
        for fact in self.fresh:
            key = fact.id
            if key not in self.open or not self._ready(key):
                continue
            weight = self.weights[key]
            if last is None or not spoken:
                if fact.clause.subject is not None and fact.clause.subject.entity != entity:
                    weight *= _OTHER_SUBJECT_FIRST
            if last is not None and fact.topic == last.topic:
                weight *= _SAME_TOPIC
            weight *= related.get(key, 1.0)
            time = self.races[key] / weight
            if time < best_time:
                best, best_time = fact, time
        if best is not None:
            self.open.discard(best.id)
        return best

    def _ready(self, key: str) -> bool:
        """Whether all that must be told before a fact has been told."""
        return not any(first in self.open for first in self.character.prerequisites.get(key, ()))

    def _related(self, last: Fact) -> dict[str, float]:
        factors: dict[str, float] = {}
        concessions = 2 * self.parameters["concessions"]
        for relation in self.character.related.get(last.id, ()):
            other = relation.satellite if relation.nucleus == last.id else relation.nucleus
            factor = _RELATED[relation.kind]
            if relation.kind in _OPPOSING:
                factor = 1.0 + (factor - 1.0) * concessions
            factors[other] = max(factor, factors.get(other, 0.0))
        return factors

    def chosen(self) -> list[Fact]:
        """Return the facts of this turn in the order of choice."""
        verbosity, draw = self.parameters["verbosity"], self.draws.uniform("verbosity")
        count = 1 + floor(_MOST_MORE * verbosity + draw)
        self.note("verbosity", verbosity, draw, "applied", f"{count} facts")
        last = None
        if self.state.topic == self.character.entity.id:
            last = self.character.by_id.get(self.state.last_fact)
        facts: list[Fact] = []
        while len(facts) < count:
            fact = self.choose(last, spoken=bool(facts))
            if fact is None:
                break
            facts.append(fact)
            last = fact
        return facts

    def link(self, left: Fact, right: Fact) -> Link:
        """Return what holds between two facts told one after the other."""
        found: Relation | None = None
        for relation in self.character.related.get(left.id, ()):
            if right.id in (relation.nucleus, relation.satellite) and relation.kind != "restatement":
                if found is None or relation.kind in ("justification", *_OPPOSING):
                    found = relation
        if found is not None:
            return Link(
                found.kind,
                satellite_first=found.satellite == left.id,
                fixed_order=left.id in self.character.prerequisites.get(right.id, ()),
            )
        same = left.clause.subject is not None and left.clause.subject == right.clause.subject
        return Link("infer") if same else _NOTHING

    def stress(self, links: list[Link], messages: list[Message]) -> list[Link]:
        """Make the good side of a concession its nucleus, if drawn: the stress falls there.

        Only where one side is good and the other bad: both are said either way, and each
        concedes the other.
        """
        stressed = []
        for link, left, right in zip(links, messages, messages[1:], strict=False):
            polarities = (left.fact.polarity, right.fact.polarity)
            opposed = sorted(polarities) == ["bad", "good"]
            if link.kind == "concession" and opposed and self.decide("concession_polarity"):
                link = replace(link, satellite_first=left.fact.polarity == "bad")
            stressed.append(link)
        return stressed

    def order(self, facts: list[Fact]) -> list[Fact]:
        """Put good news first, if drawn, moving linked facts together and never out of order."""
        if len(facts) < 2 or not self.decide("positive_content_first"):
            return facts
        units: list[list[Fact]] = [[facts[0]]]
        for left, right in zip(facts, facts[1:], strict=False):
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

    def say_again(self, messages: list[Message]) -> list[Message]:
        """Put a repetition and a restatement after messages that allow one."""
        liking = self.parameters["repetition_polarity"]
        kinds: tuple[tuple[str, Role], ...] = (
            ("repetitions", "repetition"),
            ("restatements", "restatement"),
        )
        for name, role in kinds:
            probability, draw = self.parameters[name], self.draws.uniform(name)
            if draw >= probability:
                self.note(name, probability, draw, "not_drawn")
                continue
            able = [index for index, message in enumerate(messages) if _repeatable(messages, index)]
            weights = [
                {"good": liking, "neutral": 0.5, "bad": 1 - liking}[messages[i].fact.polarity] + 0.02
                for i in able
            ]
            if not able:
                self.note(name, probability, draw, "not_applicable")
                continue
            index = self.draws.choose(f"{name}/which", able, weights)
            messages.insert(index + 1, Message(messages[index].fact, role))
            self.note(name, probability, draw, "applied", messages[index].fact.id)
        return messages


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
    facts = planner.order(planner.chosen())
    messages = planner.say_again([Message(fact) for fact in facts])
    links: list[Link] = []
    for left, right in zip(messages, messages[1:], strict=False):
        if right.role == "assertion":
            links.append(planner.link(left.fact, right.fact))
        else:
            links.append(Link("restatement"))
    links = planner.stress(links, messages)
    fresh_topic = turn.state.topic != character.entity.id
    confirmation = fresh_topic and planner.decide("request_confirmation")
    rejection = not confirmation and planner.decide("initial_rejection")
    mitigation = not rejection and planner.decide("competence_mitigation")
    plan = ContentPlan(tuple(messages), tuple(links), confirmation, rejection, mitigation)
    return plan, planner.decisions
