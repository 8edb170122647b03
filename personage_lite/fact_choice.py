"""The choice of the next fact: what is new, near to the last one and to the speaker's taste.

Source: Mairesse & Walker 2011, section 4.1; Reiter & Dale 2000, section 4.3 (coherence).
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable
from typing import Final

from personage_lite.facts import OPPOSING_KINDS, TELLING_KINDS, Character, Fact
from personage_lite.operators import Turn
from personage_lite.randomness import pick

# How much likelier a fact is that has a relation to the last one, by kind of relation.
_RELATED: Final = {
    "elaboration": 60.0,
    "justification": 60.0,
    "sequence": 30.0,
    "restatement": 0.1,
    "concession": 60.0,
    "contrast": 60.0,
}
# A description stays with its topic, and a story once begun comes first; a new topic is rather
# the next of the file's order.
_SAME_TOPIC: Final = 30.0
_NEXT_TOPIC: Final = 5.0
_STORY: Final = 400.0
# How much likelier the next facts of the topic in the file's order are than those further on.
_LOCAL: Final = (8.0, 4.0, 2.0)
# Within one utterance the very next fact is likelier still: it was written to follow.
_GOES_ON: Final = 3.0
_OTHER_SUBJECT_FIRST: Final = 0.3
# A story is hardly ever begun before the stories that stand before it in the file.
_STORY_BEFORE_ITS_TIME: Final = 0.05


class FactChoice:
    """The facts that can be told next in one turn; lives no longer than the turn."""

    def __init__(self, character: Character, turn: Turn) -> None:
        self._character = character
        self._turn = turn
        told = turn.state.told_of(character.entity.id)
        self._table = table = _weights(turn.parameters)
        # A weight for each fact in the order of the file; 0 for what cannot be told now.
        self._weights = [table[kind] for kind in character.openings]
        # What has been told, in this turn or more often than the rest.
        self._closed: set[str] = set()
        self._fresh = not told
        if told:
            counts = [told.get(key, 0) for key in character.by_id]
            fewest = min(counts)
            for place, (key, count) in enumerate(zip(character.by_id, counts, strict=True)):
                if count != fewest:
                    self._closed.add(key)
                    self._weights[place] = 0.0
            self._unlock(character.prerequisites)

    def _ready(self, key: str) -> bool:
        """Whether a fact is open and all that must be told before it has been told."""
        before = self._character.prerequisites.get(key, ())
        return key not in self._closed and self._closed.issuperset(before)

    def take(self, last: Fact | None, index: int) -> Fact | None:
        """Return the fact to tell after `last`, drawn by weight; None when nothing is open.

        `index` is its place in this utterance: the first one should be about the character.
        """
        character, own = self._character, self._weights
        if len(self._closed) == len(own):
            return None
        draw = self._turn.draws.uniform(f"fact/{index}")
        near, factor = self._near(last)
        if last is None and self._fresh and near:
            fact = self._first(near, factor, draw)
        else:
            fact = pick(draw, character.facts, self._readiness(last, index, near, factor))
        self._closed.add(fact.id)
        own[character.places[fact.id]] = 0.0
        # What waited for this fact alone can now be told.
        self._unlock(character.unlocks.get(fact.id, ()))
        return fact

    def _first(self, near: list[int], factor: float, draw: float) -> Fact:
        """Return the very first fact: who it is comes before all else."""
        facts, about = self._character.facts, self._character.entity.id
        weights = [self._weights[place] * factor for place in near]
        for index, nearness in enumerate(_LOCAL[: len(near)]):
            weights[index] *= nearness
        for index, place in enumerate(near):
            if facts[place].about != about:
                weights[index] *= _OTHER_SUBJECT_FIRST
        return facts[pick(draw, near, weights)]

    def _readiness(
        self, last: Fact | None, index: int, near: list[int], factor: float
    ) -> list[float]:
        """Return a weight for each fact in the order of the file."""
        character, own = self._character, self._weights
        weights = own.copy()
        for place in near:
            weights[place] = own[place] * factor
        for place, nearness in zip(near, _LOCAL, strict=False):
            weights[place] *= nearness
        if index and near:
            weights[near[0]] *= _GOES_ON
        for place in self._later_stories():
            weights[place] *= _STORY_BEFORE_ITS_TIME
        if last is not None and last.id in character.related:
            for key, nearness in self._related(last).items():
                weights[character.places[key]] *= nearness
        if not index:
            for place in character.by_others:
                weights[place] *= _OTHER_SUBJECT_FIRST
        return weights

    def leaves_one(self, last: Fact) -> bool:
        """Whether just one fact of the topic is left."""
        return len(self._left(last.topic)) == 1

    def unfinished(self, last: Fact) -> bool:
        """Whether a fact is left that the last explains or opposes."""
        own, places = self._weights, self._character.places
        return any(
            kind in TELLING_KINDS and own[places[satellite if nucleus == last.id else nucleus]]
            for kind, nucleus, satellite, _ in self._character.related.get(last.id, ())
        )

    def _near(self, last: Fact | None) -> tuple[list[int], float]:
        """Return the facts of the topic that comes next, and how strongly they are preferred.

        That is the last fact's, else a story once begun, else the first that is left. What stands
        after the last fact comes before what was passed over.
        """
        character = self._character
        if last is not None:
            left = self._left(last.topic)
            if left:
                after = bisect_left(left, character.places[last.id])
                story = character.topics[last.topic].in_order
                return left[after:] + left[:after], _STORY if story else _SAME_TOPIC
        if self._closed:  # else none can have begun
            for name in character.stories:
                left = self._left(name)
                if left and left[0] != character.by_topic[name][0]:
                    return left, _STORY
        for name in character.topics:
            left = self._left(name)
            if left:
                return left, _NEXT_TOPIC
        return [], _NEXT_TOPIC

    def _later_stories(self) -> list[int]:
        """Return the places where stories open that come after one that is not told to its end."""
        places: list[int] = []
        waiting = False
        for name in self._character.stories:
            left = self._left(name)
            if waiting:
                places += left
            elif left:
                waiting = True
        return places

    def _left(self, topic: str) -> list[int]:
        """Return the places of a topic's facts that can be told now."""
        weights = self._weights
        return [place for place in self._character.by_topic.get(topic, ()) if weights[place]]

    def _unlock(self, keys: Iterable[str]) -> None:
        """Give those facts their weights that wait for nothing any more."""
        for key in keys:
            if self._ready(key):
                place = self._character.places[key]
                self._weights[place] = self._table[self._character.kinds[place]]

    def _related(self, last: Fact) -> dict[str, float]:
        factors: dict[str, float] = {}
        concessions = 2 * self._turn.parameters["concessions"]
        for kind, nucleus, satellite, _ in self._character.related[last.id]:
            other = satellite if nucleus == last.id else nucleus
            factor = _RELATED[kind]
            if kind in OPPOSING_KINDS:
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
