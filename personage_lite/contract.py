"""What every operator promises, as a check that users can run on their own.

An operator takes a sentence plan and returns a rewritten one or None. It must leave its input
as it is, return the same for the same draws, keep every fact and its truth, and give a plan that
realizes to the same text each time.
"""

from __future__ import annotations

from collections.abc import Iterable

from personage_lite.generator import Generator
from personage_lite.lexicon import Lexicon
from personage_lite.operators import Operator, OperatorDraws
from personage_lite.plan import SentencePlan
from personage_lite.truth import truth_faults

# How many turns of a talk an operator is tried on: what comes first is much alike.
_TURNS = 4


class _Watched:
    """An operator that notes what breaks the contract while it is used."""

    def __init__(self, operator: Operator, faults: list[str]) -> None:
        self._operator = operator
        self._faults = faults
        self.applied = 0

    def __call__(
        self, plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
    ) -> SentencePlan | None:
        name, apply = self._operator.name, self._operator.apply
        before = repr(plan)
        changed = apply(plan, rng=rng, lexicon=lexicon)
        if repr(plan) != before:
            self._faults.append(f"{name} changed its input: {before}")
        if apply(plan, rng=rng, lexicon=lexicon) != changed:
            self._faults.append(f"{name} does not return the same for the same draws: {before}")
        if changed is None:
            return None
        self.applied += 1
        if _facts(changed) != _facts(plan):
            self._faults.append(f"{name} changed the facts: {_facts(plan)} to {_facts(changed)}")
        return changed


def check_operator(
    operator: Operator,
    generator: Generator | None = None,
    characters: Iterable[str] = ("alice", "white_rabbit", "queen_of_hearts"),
    seeds: Iterable[int] = range(8),
) -> list[str]:
    """Return how an operator breaks the contract; an empty list if it does not.

    The operator is tried on real sentences, with probability 1, alone and at every X. That it is
    never applicable is a fault too: then nothing was checked.

    >>> from personage_lite.sentence_planner import PRAGMATIC_MARKERS
    >>> check_operator(PRAGMATIC_MARKERS[-1], seeds=range(3))
    []
    """
    base = generator or Generator()
    faults: list[str] = []
    watched = _Watched(operator, faults)
    subject = base.with_operators((operator._replace(apply=watched),))
    for name in characters:
        character = subject.character(name)
        for x in (-2, -1, 0, 1, 2):
            for seed in seeds:
                place = f"{operator.name}, seed {seed}, X = {x}"
                talk = subject.turns(
                    name,
                    x,
                    seed,
                    count=_TURNS,
                    overrides={operator.name: 1.0},
                    rating="strong",
                )
                try:
                    for said in talk:
                        found = truth_faults(said, character, subject.lexicon)
                        faults += [f"{place}: {fault}" for fault in found]
                        again = " ".join(subject.realizer.realize(item) for item in said.sentences)
                        if again != said.text:
                            faults.append(f"{place}: realizing twice differs: {said.text}")
                except Exception as error:  # whatever a user's operator raises is its fault
                    faults.append(f"{place}: {type(error).__name__}: {error}")
    if not watched.applied:
        faults.append(f"{operator.name} was never applicable")
    return faults


def _facts(plan: SentencePlan) -> list[str]:
    return sorted(fact for clause in plan.clauses for fact in clause.facts)
