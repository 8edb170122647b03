"""What an operator is, and the runner that owns probabilities, draws, order and trace.

An operator is a pure function from a plan to a rewritten plan, or None where its constraint
does not hold. It never sees its own probability. Source: Mairesse & Walker 2011, section 4.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import exp
from typing import Protocol, TypeVar

from personage_lite.lexicon import Lexicon, Marker, Rating
from personage_lite.plan import Decision, SentencePlan, Status
from personage_lite.randomness import Draws
from personage_lite.state import ConversationState, damping

T = TypeVar("T")
# How strongly X pulls the choice of a word towards its lean: a factor e^(lean * X * pull).
_PULL = 1.8
# What is left of a word's weight for each of the last turns that used it.
_WORN = 0.25


class OperatorDraws:
    """The random numbers of one operator at one place, and weighted choices with them.

    It knows X and the conversation so that words suit the speaker and are not worn out.
    """

    __slots__ = ("_draws", "_scope", "_state", "_used", "rating", "x")

    def __init__(
        self,
        draws: Draws,
        scope: str,
        x: float,
        state: ConversationState,
        rating: Rating,
        used: frozenset[str],
    ) -> None:
        self._draws = draws
        self._scope = scope
        self._state = state
        self._used = used
        self.x = x
        self.rating = rating

    def uniform(self, name: str) -> float:
        """Return the number in [0, 1) of this operator, place and `name`."""
        return self._draws.uniform(f"{self._scope}/{name}")

    def choose(self, name: str, options: Sequence[T], weights: Sequence[float]) -> T:
        """Return one of `options` by weight."""
        return self._draws.choose(f"{self._scope}/{name}", options, weights)

    def marker(self, markers: Sequence[Marker]) -> Marker | None:
        """Return a marker that suits X, rather a fresh one; None if this utterance has used all."""
        able = [marker for marker in markers if marker.text not in self._used]
        if len(able) < 2:
            return able[0] if able else None
        pull, state = _PULL * self.x, self._state
        weights = [
            marker.weight * exp(marker.lean * pull) * _WORN ** state.times_recent(marker.text)
            for marker in able
        ]
        return self.choose("marker", able, weights)


@dataclass(frozen=True, slots=True)
class Turn:
    """What one turn is generated with, besides its facts.

    `show`, if given, turns a sentence plan into text, for the trace.
    """

    parameters: dict[str, float]
    draws: Draws
    x: float
    state: ConversationState
    rating: Rating
    lexicon: Lexicon
    show: Callable[[SentencePlan], str] | None = None

    def rng(self, scope: str, used: frozenset[str] = frozenset()) -> OperatorDraws:
        """Return the draws of one operator at one place; it chooses none of the words `used`."""
        return OperatorDraws(self.draws, scope, self.x, self.state, self.rating, used)

    def probability(self, operator: str) -> float:
        """Return an operator's probability: its parameter, damped if it was used lately."""
        value = self.parameters.get(operator, 0.0)
        if value >= 1.0:
            return 1.0
        return round(value * damping(self.state, operator), 4)


class SentenceRewrite(Protocol):
    """The signature of an operator on one sentence; None where its constraint does not hold."""

    def __call__(
        self, plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
    ) -> SentencePlan | None: ...


@dataclass(frozen=True, slots=True)
class Operator:
    """A named rewrite of sentences, and how often one utterance may carry it.

    `name` is at once the style parameter that holds its probability and its name in traces.
    `limit` is the most sentences of one utterance that it may change; `repeatable` are marker
    words that one utterance may hold more than once.
    """

    name: str
    apply: SentenceRewrite
    limit: int = 1
    repeatable: frozenset[str] = frozenset()


def run_operators(
    sentences: list[SentencePlan], operators: Sequence[Operator], stage: str, turn: Turn
) -> list[Decision]:
    """Offer each sentence to each operator in order, each with a draw of its own.

    Replaces the sentences that were changed and returns the decisions.
    """
    decisions: list[Decision] = []
    for operator in operators:
        name = operator.name
        probability = turn.probability(name)
        used = 0
        for index, sentence in enumerate(sentences):
            scope = f"{name}/{index}"
            draw = turn.draws.uniform(scope)
            before = after = ""
            status: Status = "not_drawn"
            if draw < probability:
                status = "not_applicable"
                if used < operator.limit:
                    words = frozenset(word for item in sentences for word in item.words)
                    rng = turn.rng(scope, words - operator.repeatable)
                    changed = operator.apply(sentence, rng=rng, lexicon=turn.lexicon)
                    if changed is not None:
                        status = "applied"
                        used += 1
                        if turn.show is not None:
                            before, after = turn.show(sentence), turn.show(changed)
                        sentences[index] = changed
            target = f"sentence {index + 1}"
            decisions.append(
                Decision(name, stage, probability, draw, status, target, before, after)
            )
    return decisions
