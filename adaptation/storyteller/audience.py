"""A simulated listener who sits before the storyteller: hears, shows cues, accepts everything.

For demonstration and tests: no person is there. E answers to X as `adaptation.listeners` say,
and is seen through the cues of `adaptation.sensing.simulated`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from adaptation.draws import Draws
from adaptation.listeners import Listener, LiveListener
from adaptation.schedule import drawn_levels, preferences
from adaptation.sensing.simulated import Simulated
from adaptation.storyteller.protocols import Clock, Ear, Heard

# For how many utterances preferences are laid out; later on they stay.
_LAID_OUT = 1000
_THINKS = 0.8


class Audience(Simulated):
    """A sensor of a listener whose preference changes before the utterances named in `changes`.

    Preferences are drawn by `seed`, or given as `tastes`, the first and one for each change.
    """

    def __init__(
        self,
        hearer: Listener | LiveListener,
        clock: Callable[[], float],
        *,
        seed: int = 0,
        changes: Sequence[int] = (),
        tastes: Sequence[int] = (),
    ) -> None:
        draws = Draws(seed).uniform("preference", 1, drawn_levels(changes, _LAID_OUT), 1)
        self._preferences = preferences(draws[:, 0], _LAID_OUT, changes)[:, 0]
        if tastes:
            starts = [0, *(change - 1 for change in changes), _LAID_OUT]
            for taste, start, end in zip(tastes, starts, starts[1:], strict=False):
                self._preferences[start:end] = taste
        self._utterances = 0
        random = np.random.default_rng(seed)
        super().__init__(hearer, self.preference, random, clock)

    @property
    def preference(self) -> int:
        """The X that is liked in the utterance that comes next, or now."""
        return int(self._preferences[min(self._utterances, _LAID_OUT - 1)])

    def listen_to(self, x: int, seconds: float) -> None:
        """Hear an utterance with `x` that takes so many seconds, from now on."""
        self.prefer(self.preference)
        self.hear(x, seconds)

    def heard_all(self) -> None:
        """Take note that the utterance is over."""
        self.settle()
        self._utterances += 1


class Agreeable:
    """The ear of a simulated listener: says yes after a moment, and nothing else.

    Whoever watches can still type: `beside` is the ear for that.
    """

    def __init__(self, clock: Clock, answer: str, beside: Ear | None = None) -> None:
        self._clock = clock
        self._answer = answer
        self._beside = beside

    def listen(self, seconds: float | None) -> Heard | None:
        """Return what is typed, or yes if there is time to think."""
        typed = self._beside.listen(0.0) if self._beside is not None else None
        if typed is not None:
            return typed
        if seconds is not None and seconds < _THINKS:
            if seconds > 0:
                self._clock.sleep(seconds)
            return None
        self._clock.sleep(_THINKS)
        return Heard(self._answer, 1.0, "simulated")

    def expect(self, phrases: Sequence[str]) -> None:
        """Nothing else could be said."""

    def close(self) -> None:
        """Nothing is held."""
