"""What an operator is, and the runner that owns probabilities, draws, order and trace.

An operator is a pure function from a plan to a rewritten plan, or None where its constraint
does not hold. It never sees its own probability. Source: Mairesse & Walker 2011, section 4.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence, Set
from math import exp, log
from typing import Final, NamedTuple, Protocol, TypeVar

from personage_lite.lexicon import Lexicon, Marker, Rating
from personage_lite.plan import Made, SentencePlan
from personage_lite.randomness import SCALE, Draws, pick
from personage_lite.state import ConversationState, damping

T = TypeVar("T")
# How strongly X pulls the choice of a word towards its lean: a factor e^(lean * X * pull).
_PULL = 2.2
# Words whose weight at an X is less are not said there at all.
_LEAST_WEIGHT = 0.45
_LEAST_LEAN = log(_LEAST_WEIGHT) / _PULL
# Who is neither introvert nor extravert rather leaves the words of both ends to them: a word
# whose lean is beyond this, or beyond what X adds to it, loses weight by a factor e^(-excess * 8).
_MOST_LEAN: Final = 0.45
_EXCESS: Final = -8.0
# What is left of a word's weight for each of the last turns that used it.
_WORN: Final = 0.25


class OperatorDraws:
    """The random numbers of one operator at one place, and weighted choices with them.

    Its choices weigh X and the conversation: words suit the speaker and are not worn out.
    """

    __slots__ = ("_scope", "_turn", "_used")

    def __init__(self, turn: Turn, scope: str, used: Set[str]) -> None:
        self._turn = turn
        self._scope = scope
        self._used = used

    @property
    def rating(self) -> Rating:
        """Which expletives are allowed."""
        return self._turn.rating

    @property
    def announced(self) -> bool:
        """Whether the utterance has announced something already: "Wait till you hear this!"."""
        return not self._turn.lexicon.attention.texts.isdisjoint(self._used)

    def has_said(self, word: str) -> bool:
        """Whether the utterance so far has this marker word."""
        return word in self._used

    def parameter(self, name: str) -> float:
        """Return the value of a style parameter in this utterance."""
        return self._turn.parameters[name]

    def uniform(self, name: str) -> float:
        """Return the number in [0, 1) of this operator, place and `name`."""
        return self._turn.draws.uniform(f"{self._scope}/{name}")

    def choose(self, name: str, options: Sequence[T], weights: Sequence[float]) -> T:
        """Return one of `options` by weight."""
        return pick(self.uniform(name), options, weights)

    def sounds_right(self, marker: Marker) -> bool:
        """Whether a speaker of this X would ever say it."""
        return marker.lean * self._turn.x >= _LEAST_LEAN

    def marker(self, markers: Sequence[Marker]) -> Marker | None:
        """Return a marker that suits X, rather a fresh one; None if this utterance has used all."""
        used, lexicon = self._used, self._turn.lexicon
        # As in `sounds_right`, without a call for each.
        x, least = self._turn.x, _LEAST_LEAN
        able = [m for m in markers if m.text not in used and m.lean * x >= least]
        if used:
            groups = (lexicon.attention, lexicon.doubts)
            said = [group for group in groups if not group.texts.isdisjoint(used)]
            for group in said:
                able = [m for m in able if m.text not in group.texts]
            if any(m.after for m in able):
                # Nor does one begin twice with the same word: "Oh, …! Oh, and …".
                begun = {text.partition(" ")[0].rstrip(",") for text in used if text}
                for group in said:
                    begun |= group.beginnings
                able = [m for m in able if not (m.after and m.text.partition(" ")[0] in begun)]
        if len(able) < 2:
            return able[0] if able else None
        return pick(self.uniform("marker"), able, self.weights(able))

    def weights(self, markers: Sequence[Marker]) -> list[float]:
        """Return how readily each marker is chosen at this X, less if it was used lately."""
        pull, worn = _PULL * self._turn.x, self._turn.worn
        weights = [marker.weight * exp(marker.lean * pull) for marker in markers]
        most = _MOST_LEAN + abs(self._turn.x) / 2
        if most < 1.0:
            for index, marker in enumerate(markers):
                excess = abs(marker.lean) - most
                if excess > 0.0:
                    weights[index] *= exp(excess * _EXCESS)
        if worn:
            for index, marker in enumerate(markers):
                if marker.text in worn:
                    weights[index] *= _WORN ** worn[marker.text]
        return weights


class Turn:
    """What one turn is generated with, besides its facts.

    `show`, if given, turns a sentence plan into text, for the trace.
    """

    # No named tuple: Python finds these in half the time, and they are asked for everywhere.
    __slots__ = ("draws", "lexicon", "parameters", "rating", "show", "state", "worn", "x")

    def __init__(
        self,
        parameters: dict[str, float],
        draws: Draws,
        x: float,
        state: ConversationState,
        rating: Rating,
        lexicon: Lexicon,
        show: Callable[[SentencePlan], str] | None = None,
    ) -> None:
        self.parameters = parameters
        self.draws = draws
        self.x = x
        self.state = state
        self.worn = state.worn
        self.rating = rating
        self.lexicon = lexicon
        self.show = show

    def rng(self, scope: str, used: Set[str] = frozenset()) -> OperatorDraws:
        """Return the draws of one operator at one place; it chooses none of the words `used`."""
        return OperatorDraws(self, scope, used)

    def probability(self, operator: str) -> float:
        """Return an operator's probability: its parameter, damped if it was used lately."""
        value = self.parameters.get(operator, 0.0)
        if not self.worn or value >= 1.0:
            return value
        return value * damping(self.state, operator)


class SentenceRewrite(Protocol):
    """The signature of an operator on one sentence; None where its constraint does not hold."""

    def __call__(
        self, plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
    ) -> SentencePlan | None:
        """Return the rewritten plan, or None."""


class Operator(NamedTuple):
    """A named rewrite of sentences, and how often one utterance may carry it.

    `name` is at once the style parameter that holds its probability and its name in traces.
    `limit` is the most sentences of one utterance that it may change.
    """

    name: str
    apply: SentenceRewrite
    limit: int = 1


def _leads(sentences: list[SentencePlan]) -> Iterator[str]:
    """Yield the words of the frames that clauses are said in: "as far as I know"."""
    for sentence in sentences:
        for clause in sentence.clauses:
            if clause.frame is not None and clause.frame.lead is not None:
                first = clause.frame.lead.parts[0]
                if isinstance(first, str):
                    yield first.rstrip(",")


def run_operators(
    sentences: list[SentencePlan], operators: Sequence[Operator], stage: str, turn: Turn
) -> list[Made]:
    """Offer each sentence to each operator in order, each with a draw of its own.

    One that has reached its limit, or whose probability is 0, is not drawn any more; one that is
    drawn for no sentence gives a single decision, with the lowest of its draws. Replaces the
    sentences that were changed and returns the decisions.
    """
    decisions: list[Made] = []
    count = len(sentences)
    targets = [f"sentence {index + 1}" for index in range(count)]
    everywhere = f"sentences 1 to {count}" if count > 1 else "sentence 1"
    words = {word for sentence in sentences for word in sentence.words}
    words.update(_leads(sentences))
    draws, lexicon = turn.draws, turn.lexicon
    parameters, worn = turn.parameters, turn.worn
    for name, apply, limit in operators:
        # Asked first for what most turns need: nothing has been worn yet.
        probability = turn.probability(name) if worn else parameters.get(name, 0.0)
        if probability <= 0.0:
            continue
        row = draws.whole_numbers(name, count)
        lowest = min(row) * SCALE
        if lowest >= probability:
            decisions.append((name, stage, probability, lowest, "not_drawn", everywhere, "", ""))
            continue
        used = 0
        for index, number in enumerate(row):
            draw, target = number * SCALE, targets[index]
            if draw >= probability:
                decisions.append((name, stage, probability, draw, "not_drawn", target, "", ""))
                continue
            sentence = sentences[index]
            rng = OperatorDraws(turn, f"{name}/{index}", words)
            changed = apply(sentence, rng=rng, lexicon=lexicon)
            if changed is None:
                decisions.append((name, stage, probability, draw, "not_applicable", target, "", ""))
                continue
            before = after = ""
            if turn.show is not None:
                before, after = turn.show(sentence), turn.show(changed)
            decisions.append((name, stage, probability, draw, "applied", target, before, after))
            words.update(changed.words)
            sentences[index] = changed
            used += 1
            if used >= limit:
                break
    return decisions
