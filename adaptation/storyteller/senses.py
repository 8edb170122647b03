"""What the storyteller knows of the listener's engagement: sensors, their supervisor, estimator."""

from __future__ import annotations

from typing import NamedTuple

from adaptation.engagement.estimator import EngagementEstimator, engagement_of
from adaptation.sensing.session import Watch


class Sensed(NamedTuple):
    """E over one utterance: before, after, and each 200 ms, all in [-2, 2].

    `stream` is not smoothed: it holds the value of each tick, as the learners expect it (see
    adaptation/live_world.py; smoothed they do worse, docs/live.md), `before` and `after` are
    five-second averages. All are None or empty if nothing was sensed at all.
    """

    before: float | None
    after: float | None
    stream: tuple[float, ...]

    @property
    def known(self) -> bool:
        """Whether there is anything to learn from."""
        return self.before is not None and self.after is not None and bool(self.stream)


class Senses:
    """Reads the sensors at each tick; without a sensor nothing is known, and nothing learned."""

    def __init__(self, watch: Watch | None, estimator: EngagementEstimator) -> None:
        self._watch = watch
        self._estimator = estimator
        self._stream: list[float] = []
        self._seen = False

    def start(self) -> None:
        """Start the sensors; raises `PersonageError` if one says why it cannot."""
        if self._watch is not None:
            self._watch.start()

    def stop(self) -> None:
        """Stop them."""
        if self._watch is not None:
            self._watch.stop()

    def tick(self, now: float) -> None:
        """Read the sensors at `now`, in seconds."""
        if self._watch is None or self._watch.ended:
            return
        reading = self._watch.read(now)
        # Ticks without any cue still count once something was known: E then fades to its prior.
        self._seen = self._seen or any(value is not None for value in reading.cues.values())
        estimate = self._estimator.update(reading)
        if self._seen:
            self._stream.append(engagement_of(estimate.engaged))

    @property
    def engagement(self) -> float | None:
        """E now, None if nothing was sensed yet, or nothing is any more."""
        ended = self._watch is None or self._watch.ended
        return self._estimator.engagement if self._seen and not ended else None

    @property
    def fault(self) -> str:
        """The last fault of a sensor."""
        return self._watch.fault if self._watch is not None else ""

    def begin(self) -> float | None:
        """Take note that an utterance begins; returns E before it."""
        self._stream.clear()
        return self.engagement

    def end(self, before: float | None) -> Sensed:
        """Return what was sensed since `begin`, which returned `before`."""
        return Sensed(before, self.engagement, tuple(self._stream))
