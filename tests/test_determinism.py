"""The same request gives the same text: in any process, thread and order; and Draws are sound."""

from __future__ import annotations

import hashlib
import json
import os
import random
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from statistics import fmean, pstdev
from threading import Barrier
from typing import NamedTuple

import pytest

from personage_lite import Generator
from personage_lite.plan import Utterance
from personage_lite.randomness import Draws, pick

ROOT = Path(__file__).parent.parent
CHARACTERS = ("alice", "white_rabbit", "queen_of_hearts")


class Request(NamedTuple):
    """What is asked of a generator."""

    character: str
    x: float
    seed: int


REQUESTS = [
    Request(character, x, seed)
    for character in CHARACTERS
    for x in (-2, -0.7, 0, 1, 2)
    for seed in range(12)
]


def asked(generator: Generator, request: Request) -> Utterance:
    """Return the answer to a request."""
    return generator.generate(*request)


def fingerprint(generator: Generator) -> str:
    """Return a digest of the records of all requests and of one conversation."""
    records = [asked(generator, request).record() for request in REQUESTS]
    for character in CHARACTERS:
        records += [said.record() for said in generator.turns(character, 1.3, 5, count=8)]
    return hashlib.sha256(json.dumps(records).encode()).hexdigest()


# The same text


@pytest.fixture(scope="module")
def expected() -> dict[Request, Utterance]:
    """What one fresh generator answers, asked in order."""
    generator = Generator()
    return {request: asked(generator, request) for request in REQUESTS}


@pytest.fixture(scope="module")
def here() -> str:
    """What this process says."""
    return fingerprint(Generator())


@pytest.mark.parametrize("hash_seed", ["0", "1", "random"])
def test_another_process_says_the_same(hash_seed: str, here: str) -> None:
    """Whatever Python's own hash seed is."""
    script = (
        "from personage_lite import Generator\n"
        "from tests.test_determinism import fingerprint\n"
        "print(fingerprint(Generator()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        cwd=ROOT,
        env={**os.environ, "PYTHONHASHSEED": hash_seed, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == here


def test_threads_share_a_generator(expected: dict[Request, Utterance]) -> None:
    """Eight threads ask one generator, all requests mixed up."""
    generator = Generator()
    mixed = REQUESTS * 2
    random.Random(1).shuffle(mixed)
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda request: asked(generator, request), mixed))
    for request, said in zip(mixed, found, strict=True):
        assert said == expected[request]


def test_threads_ask_first_at_the_same_time(expected: dict[Request, Utterance]) -> None:
    """A character that is being read for one thread is not half there for another."""
    threads = 6
    request = REQUESTS[0]
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        for _ in range(6):
            # A generator with no character read yet.
            fresh = Generator()
            barrier = Barrier(threads)

            def ask(_: int, fresh: Generator = fresh, barrier: Barrier = barrier) -> Utterance:
                barrier.wait()
                return asked(fresh, request)

            with ThreadPoolExecutor(threads) as pool:
                for said in pool.map(ask, range(threads)):
                    assert said == expected[request]
    finally:
        sys.setswitchinterval(before)


def test_any_order_of_calls(expected: dict[Request, Utterance]) -> None:
    """No call leaves anything behind that changes another one."""
    generator = Generator()
    backwards = {request: asked(generator, request) for request in reversed(REQUESTS)}
    assert backwards == expected
    mixed = list(REQUESTS)
    random.Random(2).shuffle(mixed)
    for request in mixed:
        generator.generate(request.character, 2, 99, overrides={"verbosity": 1.0})
        assert asked(generator, request) == expected[request]


def test_after_other_characters_were_loaded(expected: dict[Request, Utterance]) -> None:
    """What is said of one character does not depend on which others were read."""
    for character in CHARACTERS:
        alone, crowded = Generator(), Generator()
        crowded.characters()
        for request in REQUESTS:
            if request.character == character:
                assert asked(alone, request) == asked(crowded, request) == expected[request]


def test_by_id_or_by_name() -> None:
    """A character's name and its id are one request."""
    generator = Generator()
    for name, key in (("Alice", "alice"), ("The White Rabbit", "white_rabbit")):
        assert generator.generate(name, 1, 4) == generator.generate(key, 1, 4)


@pytest.mark.parametrize("x", [-2, -1, 0, 1, 2])
def test_x_as_int_or_float(x: int) -> None:
    """2 and 2.0 are one X, and it comes back as a float."""
    generator = Generator()
    for seed in range(10):
        one, other = (
            generator.generate("alice", x, seed),
            generator.generate("alice", float(x), seed),
        )
        assert one == other
        assert json.dumps(one.record()) == json.dumps(other.record())
        assert isinstance(one.x, float)


def test_zero_has_no_sign() -> None:
    """-0.0 says what 0 says."""
    generator = Generator()
    for seed in range(10):
        assert (
            generator.generate("alice", -0.0, seed).text
            == generator.generate("alice", 0, seed).text
        )


def test_a_trace_changes_nothing() -> None:
    """To look on is not to interfere."""
    generator = Generator()
    for request in REQUESTS[::5]:
        traced = generator.generate(*request, trace=True)
        assert traced.record() == asked(generator, request).record()


def test_a_record_survives_json(expected: dict[Request, Utterance]) -> None:
    """Writing a record and reading it again gives the same record."""
    for said in expected.values():
        record = said.record()
        assert json.loads(json.dumps(record)) == record
        assert json.loads(json.dumps(record, ensure_ascii=False)) == record


def test_the_state_goes_on_from_a_copy() -> None:
    """A turn depends on what the state holds, not on which object it is."""
    generator = Generator()
    first = generator.generate("alice", 1, 3)
    again = generator.generate("alice", 1, 3)
    assert first.state == again.state
    assert first.state is not again.state
    one = generator.generate("alice", 1, 3, state=first.state)
    assert one == generator.generate("alice", 1, 3, state=again.state)


# Draws


KNOWN = [
    ((0, 0, "stuttering"), 0.9625610776973574, 0.5580902481686855),
    ((7, 0, "verbosity"), 0.5962532362589352, 0.11190479794357121),
    ((7, 3, "fact/0"), 0.5790867395026076, 0.6877724717991488),
    ((-1, 2, "é"), 0.23357636759871825, 0.2681760692120495),
    ((2**70, 11, ""), 0.5977602373539324, 0.9411563383686786),
]


@pytest.mark.parametrize(("place", "uniform", "eighth"), KNOWN)
def test_draws_known_answers(place: tuple[int, int, str], uniform: float, eighth: float) -> None:
    """Every machine must agree on these numbers, to the last bit."""
    seed, turn, name = place
    draws = Draws(seed, turn)
    assert draws.uniform(name) == uniform
    assert draws.numbers(name, 8)[7] == eighth
    assert draws.numbers(name, 20)[:8] == draws.numbers(name, 8)


GAUSS = [1.50390625, 1.01171875, 1.91796875]


def test_gauss_known_answers() -> None:
    """The same for the noise on parameters."""
    assert Draws(7, 0).gauss(3) == GAUSS
    assert Draws(7, 0).gauss(60)[:3] == GAUSS


def test_draws_depend_on_seed_turn_and_name() -> None:
    """A change of any of the three gives another number; "1/2" is not "12/"."""
    places = [(1, 2, "a"), (1, 3, "a"), (2, 2, "a"), (1, 2, "b"), (12, 0, "a"), (1, 20, "a")]
    found = {Draws(seed, turn).uniform(name) for seed, turn, name in places}
    assert len(found) == len(places)


# With 99 degrees of freedom, chi-square lies within these bounds but for 1 in 5,000.
CHI_SQUARE = (55.0, 160.0)


def chi_square(numbers: list[float], bins: int = 100) -> float:
    """Return how far numbers in [0, 1) are from evenly spread."""
    counts = [0] * bins
    for number in numbers:
        counts[int(number * bins)] += 1
    even = len(numbers) / bins
    return sum((count - even) ** 2 / even for count in counts)


def test_uniform_numbers_look_uniform() -> None:
    """Over seeds, over turns, over names and within a row."""
    samples = [
        [Draws(seed, 0).uniform("stuttering") for seed in range(20_000)],
        [Draws(0, turn).uniform("stuttering") for turn in range(20_000)],
        [Draws(0, 0).uniform(f"name {index}") for index in range(20_000)],
        Draws(0, 0).numbers("row", 4_000),
        [number for seed in range(5_000) for number in Draws(seed, 1).numbers("row", 4)],
    ]
    for sample in samples:
        assert all(0.0 <= number < 1.0 for number in sample)
        assert CHI_SQUARE[0] < chi_square(sample) < CHI_SQUARE[1]


def test_neighbours_are_independent() -> None:
    """Successive seeds, and two names of one seed, do not go together."""
    pairs = [
        (Draws(seed, 0).uniform("a"), other)
        for seed in range(20_000)
        for other in (Draws(seed, 0).uniform("b"), Draws(seed + 1, 0).uniform("a"))
    ]
    tens = [int(one * 10) * 0.1 + int(other * 10) * 0.01 + 0.005 for one, other in pairs]
    assert CHI_SQUARE[0] < chi_square(tens) < CHI_SQUARE[1]


def test_gauss_has_mean_0_and_deviation_1() -> None:
    """And no number beyond 6; each place in the row alike."""
    rows = [Draws(seed, 0).gauss(45) for seed in range(1_000)]
    numbers = [number for row in rows for number in row]
    assert abs(fmean(numbers)) < 0.02
    assert abs(pstdev(numbers) - 1.0) < 0.02
    assert max(map(abs, numbers)) <= 6.0
    assert 0.66 < fmean([abs(number) < 1.0 for number in numbers]) < 0.71
    for place in zip(*rows, strict=True):
        assert abs(fmean(place)) < 0.15
        assert abs(pstdev(place) - 1.0) < 0.1


def test_pick_is_fair() -> None:
    """Each option is picked in proportion to its weight, one of weight 0 never."""
    weights = [1.0, 0.0, 3.0, 6.0, 0.0]
    picked = [pick(Draws(seed, 0).uniform("x"), range(5), weights) for seed in range(20_000)]
    for option, weight in enumerate(weights):
        assert abs(picked.count(option) / len(picked) - weight / 10.0) < 0.012
        assert weight or option not in picked
    chosen = [Draws(seed, 0).choose("x", range(5), weights) for seed in range(200)]
    assert chosen == picked[:200]
