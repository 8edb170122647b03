"""Prints a line for every text of a fixed sample, with a digest of how it came about.

`test_compiled_build.py` runs it with each build of the package; both must print the same.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator

from personage_lite import Generator, PersonageError, english
from personage_lite.plan import Utterance
from personage_lite.trace import explain
from tests.realizer.case_list import read_cases
from tests.realizer.random_specs import RandomSpecs

XS = (-2.0, -0.7, 0.0, 1.0, 2.0)


def _digest(value: object) -> str:
    return hashlib.sha256(repr(value).encode()).hexdigest()[:16]


def _line(said: Utterance) -> str:
    """Return the text, with a digest of the facts, parameters, decisions, plans and state."""
    told = {name: dict(counts) for name, counts in said.state.told.items()}
    # Sets are printed in an order of their own.
    state = said.state._replace(
        told=told,
        worn=dict(sorted(said.state.worn.items())),
        recent=(),
        introduced=frozenset(),
        focus=frozenset(),
    )
    sets = [sorted(each) for each in (*said.state.recent, said.state.introduced, said.state.focus)]
    how = (said.record(), said.parameters, said.decisions, said.sentences, state, sets)
    return f"{_digest(how)} {said.text}"


def utterances(seeds: int) -> Iterator[str]:
    """Yield single turns, conversations, traces, overrides and every rating."""
    generator = Generator()
    names = [character.entity.id for character in generator.characters()]
    for name in names:
        for x in XS:
            for seed in range(seeds):
                yield _line(generator.generate(name, x, seed))
            for said in generator.turns(name, x, 7, count=20, rating="strong", trace=True):
                yield f"{_line(said)} {_digest(explain(said, generator))}"
    for parameter in generator.style.parameters:
        for value in (0.0, 1.0):
            said = generator.generate(names[0], 1, 3, overrides={parameter: value}, rating="clean")
            yield _line(said)


def sentences(count: int) -> Iterator[str]:
    """Yield the reviewed cases of the realizer and sentences made at random."""
    for case in read_cases():
        yield english(**dict(case.options)).realize(case.spec)
    realizer = english("american", oxford_comma=True, curly_apostrophes=True)
    for seed in range(count):
        yield realizer.realize(RandomSpecs(seed).sentence())


def faults() -> Iterator[str]:
    """Yield what is said of requests that cannot be answered."""
    generator = Generator()
    wrong: list[dict[str, object]] = [
        {"character": "alcie"},
        {"character": "alice", "x": 3},
        {"character": "alice", "x": "much"},
        {"character": "alice", "x": None},
        {"character": "alice", "overrides": {"verbosy": 1}},
        {"character": "alice", "overrides": {"verbosity": 2}},
        {"character": "alice", "rating": "rude"},
    ]
    for request in wrong:
        try:
            generator.generate(**request)  # type: ignore[arg-type]
        except PersonageError as error:
            yield f"{type(error).__name__}: {error}"


if __name__ == "__main__":
    for line in (*utterances(60), *sentences(1000), *faults()):
        print(json.dumps(line, ensure_ascii=False))
