"""The sensor `simulated`: a simulated listener's true E, shown as cues that come and go.

It lets the whole chain run without a person: listener, cues, network, E, learner. The listeners
are those of `adaptation.listeners`; how likely each cue is when the listener is engaged and when
not is the table below, ours, and after the directions that the paper gives (section IV-B: an
engaged user leans forward, is open, nods; a disengaged one leans back, crosses arms, looks away).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import cast

import numpy as np

from adaptation.experiment import is_live
from adaptation.listeners import Listener, LiveListener, listener
from adaptation.listeners.live import samples_of
from adaptation.problem import HIGHEST, LEVELS, LOWEST, SAMPLE_SECONDS, Floats, Ints, moved
from adaptation.sensing.cues import CUES, CueReading
from adaptation.sensing.setup import Setup

# How likely each cue is at E = -2 and at E = 2; evenly between.
CUE_RATES: Mapping[str, tuple[float, float]] = MappingProxyType(
    {
        "head_tilt": (0.15, 0.45),
        "look_away": (0.75, 0.05),
        "leaning_forward": (0.05, 0.65),
        "leaning_back": (0.65, 0.05),
        "arms_crossed": (0.60, 0.05),
        "arms_open": (0.10, 0.60),
        "smile": (0.05, 0.60),
        "nodding": (0.02, 0.50),
        "backchannel": (0.02, 0.40),
        "presence": (0.97, 1.00),
    }
)
# Of these nobody does both at once.
_EITHER = tuple(
    (CUES.index(one), CUES.index(other))
    for one, other in (("leaning_forward", "leaning_back"), ("arms_crossed", "arms_open"))
)
# A cue that is present or absent stays so for this long on average.
CUE_SECONDS = 1.5
# The sensor says of a cue that is present 0.85 on average, of an absent one 0.15; of 3 in 100
# readings of a cue it says nothing.
_SURE, _SPREAD, _MISSING = 0.85, 12.0, 0.03


class Simulated:
    """A listener with a preference, seen through a sensor that errs.

    `hear` says with which X an utterance begins; while it lasts (until `settle`, or 4 to 12 s, as
    `live` has it) the true E runs as the listener says: in real time for a live one, evenly for
    others. `prefer` lets the listener like another X. `talk` returns the X of the next utterance,
    given the last one, when nobody says otherwise; None: E rests. All chance comes from `random`.
    """

    name = "simulated"
    blocking = False
    live = False

    def __init__(
        self,
        hearer: Listener | LiveListener,
        preference: int,
        random: np.random.Generator,
        clock: Callable[[], float],
        talk: Callable[[int], int] | None = None,
    ) -> None:
        self._hearer = hearer
        self._preference: Ints = np.array([preference])
        self._random = random
        self._clock = clock
        self._talk = talk
        self._x = 0
        self._path: list[float] = []
        self._true: Floats = hearer.start(1)
        self._states = np.array([cue == "presence" for cue in CUES])
        self._sample: int | None = None

    @property
    def engagement(self) -> float:
        """The true E now."""
        return float(self._true[0])

    @property
    def listener(self) -> str:
        """The listener's name in the registry."""
        return self._hearer.name

    def start(self) -> None:
        """Begin to watch."""
        self._sample = None

    def stop(self) -> None:
        """Nothing is held."""

    def prefer(self, preference: int) -> None:
        """Let the listener like another X, -2 to 2, from the next utterance on."""
        self._preference = np.array([preference])

    def hear(self, x: int, seconds: float | None = None) -> None:
        """Let the listener hear an utterance with `x`, -2 to 2, from now on.

        It takes so many seconds; without them as long as `live` has it. Who answers in real time
        goes on answering until it is over (`settle`), but no longer than `live` has it.
        """
        before, now = np.array([self._x]), np.array([x])
        if is_live(self._hearer):
            course = cast("LiveListener", self._hearer).listen(self._true, now, self._preference)
            self._path = [float(row[0]) for row in course.path[: int(course.samples[0])]]
        else:
            hearer = cast("Listener", self._hearer)
            draws = self._random.random((hearer.draws, 1))
            after = hearer.respond(self._true, now, before, self._preference, draws)
            usual = int(samples_of(now)[0])
            count = usual if seconds is None else max(1, round(seconds / SAMPLE_SECONDS))
            steps = np.linspace(self._true[0], after[0], count + 1)
            self._path = [float(value) for value in steps[1:]]
        self._x = x

    def settle(self) -> None:
        """Take note that the utterance is over; who answers in steps has answered now."""
        if self._path and not is_live(self._hearer):
            self._true = np.array([self._path[-1]])
        self._path = []

    def read(self) -> CueReading:
        """Return what a sensor would say now."""
        now = self._clock()
        sample = round(now / SAMPLE_SECONDS)
        # A leap of the clock is no reason to live through all that time.
        passed = 1 if self._sample is None else min(max(sample - self._sample, 0), 300)
        self._sample = sample
        for _ in range(passed):
            self._live_on()
        return CueReading(now, self._cues(), self.name)

    def _live_on(self) -> None:
        """Let one sample, 200 ms, go by."""
        if not self._path and self._talk is not None:
            self.hear(self._talk(self._x))
        if self._path:
            self._true = np.array([self._path.pop(0)])
        share = (self.engagement - LOWEST) / (HIGHEST - LOWEST)
        rates = np.array([low + (high - low) * share for low, high in map(CUE_RATES.get, CUES)])  # type: ignore[misc]
        fresh = self._random.random((2, len(CUES)))
        changes = fresh[0] < SAMPLE_SECONDS / CUE_SECONDS
        self._states = np.where(changes, fresh[1] < rates, self._states)
        for one, other in _EITHER:
            # Nobody does both: what has lasted longer goes on, or else the likelier of the two.
            if self._states[one] and self._states[other]:
                fresher = [cue for cue in (one, other) if changes[cue]]
                least = min(fresher, key=lambda cue: (len(fresher) > 1) * rates[cue])
                self._states[least] = False

    def _cues(self) -> dict[str, float | None]:
        sure = np.where(self._states, _SURE, 1 - _SURE)
        said = self._random.beta(_SPREAD * sure, _SPREAD * (1 - sure))
        missing = self._random.random(len(CUES)) < _MISSING
        return {cue: None if missing[i] else round(float(said[i]), 3) for i, cue in enumerate(CUES)}


def from_setup(setup: Setup) -> Simulated:
    """Return the listener `setup.input` (default `live`) with a preference drawn by the seed.

    It hears utterances whose X goes up or down by one, or stays, by chance.
    """
    random = np.random.default_rng(setup.seed)

    def talk(x: int) -> int:
        return int(moved(np.array([x]), random.integers(-1, 2, 1))[0])

    preference = int(random.choice(LEVELS))
    return Simulated(listener(setup.input or "live"), preference, random, setup.clock, talk)
