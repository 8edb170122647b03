"""Clocks: the real one, also faster, and one that only moves when somebody sleeps."""

from __future__ import annotations

import time


class SystemClock:
    """Real seconds, since an unspecified moment, `speed` times as fast.

    A simulated listener does not mind another speed than 1; a person would.
    """

    def __init__(self, speed: float = 1.0) -> None:
        self._speed = speed

    def now(self) -> float:
        """Return the monotonic time in seconds, times the speed."""
        return time.monotonic() * self._speed

    def sleep(self, seconds: float) -> None:
        """Wait so many of these seconds; none for a negative number."""
        if seconds > 0:
            time.sleep(seconds / self._speed)


class SimulatedClock:
    """Seconds that pass only by sleeping: a session of minutes runs in a second.

    >>> clock = SimulatedClock()
    >>> clock.sleep(2.5)
    >>> clock.now()
    2.5
    """

    def __init__(self, start: float = 0.0) -> None:
        self._now = start

    def now(self) -> float:
        """Return the simulated time in seconds."""
        return self._now

    def sleep(self, seconds: float) -> None:
        """Let so many seconds pass at once; none for a negative number."""
        self._now += max(0.0, seconds)
