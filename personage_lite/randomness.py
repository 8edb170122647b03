"""Draws: every decision has its own random number, derived from seed, turn and its name.

So adding an operator shifts no other draw, and raising a probability only ever adds decisions.
The numbers come from a hash, not from a generator: they are the same on every machine and
whatever Python's own hash seed is.
"""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import blake2b
from typing import TypeVar

T = TypeVar("T")
_SCALE = 1.0 / (1 << 53)


class Draws:
    """Named uniform and Gaussian draws of one turn.

    >>> draws = Draws(seed=7, turn=0)
    >>> draws.uniform("stuttering") == Draws(7, 0).uniform("stuttering")
    True
    """

    __slots__ = ("_base",)

    def __init__(self, seed: int, turn: int) -> None:
        self._base = blake2b(f"{seed}/{turn}/".encode(), digest_size=12)

    def _digest(self, name: str) -> bytes:
        hasher = self._base.copy()
        hasher.update(name.encode())
        return hasher.digest()

    def uniform(self, name: str) -> float:
        """Return the number in [0, 1) that belongs to `name`."""
        return (int.from_bytes(self._digest(name)[:8], "big") >> 11) * _SCALE

    def gauss(self, name: str) -> float:
        """Return a number of mean 0 and deviation 1, within ±6, that belongs to `name`.

        The sum of twelve even bytes: near enough to normal, and exact on every machine.
        """
        return (sum(self._digest(name)) - 1530) / 256.0

    def choose(self, name: str, options: Sequence[T], weights: Sequence[float]) -> T:
        """Return one of `options`, each with a chance in proportion to its weight (>= 0)."""
        mark = self.uniform(name) * sum(weights)
        for option, weight in zip(options, weights, strict=True):
            mark -= weight
            if mark < 0:
                return option
        return options[-1]


