"""What the tests of the ears share."""

from __future__ import annotations

from collections.abc import Iterator

from adaptation.storyteller.protocols import Ear, EndOfInput, Heard


def answers_in_order(ear: Ear) -> Iterator[Heard | None]:
    """Yield everything an ear hears until its end (what is not understood is None)."""
    while True:
        try:
            yield ear.listen(None)
        except EndOfInput:
            return
