"""The simulated listeners, by the names of the command line."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from adaptation.listeners.base import Course, Listener, LiveListener
from adaptation.listeners.closer import Closer
from adaptation.listeners.graded import Graded
from adaptation.listeners.level import Level
from adaptation.listeners.live import Live
from adaptation.listeners.match import Match
from adaptation.listeners.near import Near
from personage_lite.errors import PersonageError, shown

__all__ = ["LISTENERS", "Course", "Listener", "LiveListener", "listener"]

LISTENERS: Mapping[str, Callable[[], Listener | LiveListener]] = MappingProxyType(
    {
        Match.name: Match,
        Closer.name: Closer,
        Graded.name: Graded,
        Near.name: Near,
        Level.name: Level,
        Live.name: Live,
    }
)


def listener(name: str) -> Listener | LiveListener:
    """Return the listener of this name; raises `PersonageError` for an unknown one.

    >>> listener("match").name
    'match'
    >>> listener("mach")
    Traceback (most recent call last):
    personage_lite.errors.PersonageError: no listener 'mach'; choose from: match, closer, graded, near, level, live
    """  # noqa: E501
    if name not in LISTENERS:
        raise PersonageError(f"no listener '{shown(name)}'; choose from: {', '.join(LISTENERS)}")
    return LISTENERS[name]()
