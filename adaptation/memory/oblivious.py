"""A memory that keeps nothing: for listeners who give no name, or want nothing kept."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from adaptation.storyteller.protocols import Acquaintance
from personage_lite.names import checked_name


class Oblivious:
    """Meets everybody for the first time.

    >>> memory = Oblivious()
    >>> memory.begin("Anna", when=0.0)
    Acquaintance(name='Anna', episodes=1, told={}, learner=None, last_seen=None)
    >>> memory.recall("Anna") is None
    True
    """

    def recall(self, name: str) -> Acquaintance | None:
        """Return None: nobody is known."""
        return None

    def begin(self, name: str, when: float) -> Acquaintance:
        """Return what is known of a stranger; any name will do, also none."""
        return Acquaintance(checked_name(name) if name.strip() else "", 1, {}, None, None)

    def remember(
        self,
        name: str,
        turn: Mapping[str, Any],
        learner: Mapping[str, Any],
        told: Mapping[str, Mapping[str, int]],
    ) -> None:
        """Keep nothing."""

    def forget(self, name: str) -> bool:
        """Return False: there is nothing to erase."""
        return False

    def close(self) -> None:
        """Do nothing."""
