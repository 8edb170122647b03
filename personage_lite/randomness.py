"""Draws: every decision has its own random number, derived from seed, turn and its name.

So adding an operator shifts no other draw, and raising a probability only ever adds decisions.
The numbers come from a hash, not from a generator: they are the same on every machine and
whatever Python's own hash seed is.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from hashlib import blake2b
from itertools import accumulate
from struct import Struct
from typing import Final, TypeVar

T = TypeVar("T")
# What makes a number in [0, 1) of a whole one below 2^64.
SCALE: Final = 1.0 / (1 << 64)
# How many numbers one hash of 64 bytes holds, and how to read the first so many of them.
_ROW: Final = 8
_FIRST: Final = tuple(Struct(f">{count}Q").unpack_from for count in range(_ROW + 1))
# How many bytes of a hash make Gaussian numbers, three each, and the deviation of their sum.
_GAUSS: Final = 63
GAUSS_SCALE: Final = 128.0


class Draws:
    """Named uniform and Gaussian draws of one turn.

    >>> draws = Draws(seed=7, turn=0)
    >>> draws.uniform("stuttering") == Draws(7, 0).uniform("stuttering")
    True
    """

    __slots__ = ("_row", "_uniform")

    def __init__(self, seed: int, turn: int) -> None:
        start = f"{seed}/{turn}/".encode()
        self._uniform = blake2b(start, digest_size=8)
        self._row = blake2b(start, digest_size=64)

    def uniform(self, name: str) -> float:
        """Return the number in [0, 1) that belongs to `name`."""
        hasher = self._uniform.copy()
        hasher.update(name.encode())
        number: int = _FIRST[1](hasher.digest())[0]
        return number * SCALE

    def numbers(self, name: str, count: int) -> list[float]:
        """Return `count` numbers in [0, 1) that belong to `name`, eight at the cost of one.

        Asking for more leaves the first ones as they are.
        """
        return [number * SCALE for number in self.whole_numbers(name, count)]

    def whole_numbers(self, name: str, count: int) -> tuple[int, ...]:
        """Return the same numbers times 2^64, for those who need only the lowest."""
        if count > _ROW:
            more = self.whole_numbers(f"{name}+", count - _ROW)
            return (*self.whole_numbers(name, _ROW), *more)
        hasher = self._row.copy()
        hasher.update(name.encode())
        return _FIRST[count](hasher.digest())

    def gauss(self, count: int) -> list[float]:
        """Return `count` numbers of mean 0 and deviation 1, within ±3."""
        return self.around((0.0,) * count, (1.0 / GAUSS_SCALE,) * count)

    def around(self, means: tuple[float, ...], deviations: tuple[float, ...]) -> list[float]:
        """Return a number for each mean; the deviations are given in parts of `GAUSS_SCALE`.

        Each is the sum of three even bytes: near enough to normal, and exact on every machine.
        Asking for more leaves the first ones as they are.
        """
        even = b""
        while len(even) < 3 * len(means):
            hasher = self._row.copy()
            hasher.update(b"gauss/%d" % (len(even) // 3))
            even += hasher.digest()[:_GAUSS]
        # Without `strict` a compiled build makes a plain loop of it.
        first, second, third = even[0::3], even[1::3], even[2::3]
        return [
            mean + deviation * (one + two + three - 382.5)
            for mean, deviation, one, two, three in zip(  # noqa: B905
                means, deviations, first, second, third
            )
        ]

    def choose(self, name: str, options: Sequence[T], weights: Sequence[float]) -> T:
        """Return one of `options`, each with a chance in proportion to its weight (>= 0)."""
        return pick(self.uniform(name), options, weights)


def pick(draw: float, options: Sequence[T], weights: Sequence[float]) -> T:
    """Return the option in whose share of [0, 1) a draw falls.

    >>> pick(0.4, ["a", "b"], [1.0, 3.0])
    'b'
    """
    heaped = list(accumulate(weights))
    # To the right of equal heaps, so that an option of weight 0 is never picked.
    return options[bisect_right(heaped, draw * heaped[-1], 0, len(heaped) - 1)]
