"""What is read out of the database: one listener, all of them, and the turns of their episodes."""

from __future__ import annotations

from typing import Any, NamedTuple

from sqlalchemy import Connection, func, select

from adaptation.memory.knowledge import known_of
from adaptation.memory.names import key
from adaptation.memory.records import read_record
from adaptation.memory.schema import EPISODE, LISTENER, TOLD, TURN
from adaptation.storyteller.protocols import Acquaintance


class Known(NamedTuple):
    """A line of the list of listeners; `last_seen` in epoch seconds."""

    name: str
    episodes: int
    turns: int
    facts: int
    last_seen: float | None


def read_acquaintance(
    connection: Connection, row: Any, learner: str | None, place: str
) -> Acquaintance:
    """Return what is known of the listener with a row of `LISTENER`; `learner` as in `known_of`."""
    told: dict[str, dict[str, int]] = {}
    query = select(TOLD.c.character, TOLD.c.fact, TOLD.c.times)
    ordered = query.where(TOLD.c.listener == row.id).order_by(TOLD.c.character, TOLD.c.fact)
    for character, fact, times in connection.execute(ordered):
        told.setdefault(character, {})[fact] = times
    count = select(func.count()).select_from(EPISODE).where(EPISODE.c.listener == row.id)
    episodes = connection.execute(count).scalar_one()
    knowledge = known_of(connection, row.id, learner, place)
    return Acquaintance(row.name, episodes, told, knowledge, row.last_seen)


def read_listeners(connection: Connection) -> list[Known]:
    """Return who is known, by name."""
    turns = select(func.coalesce(func.sum(EPISODE.c.turns), 0))
    episodes = select(func.count()).select_from(EPISODE)
    facts = select(func.count()).select_from(TOLD)
    query = select(
        LISTENER.c.name,
        episodes.where(EPISODE.c.listener == LISTENER.c.id).scalar_subquery(),
        turns.where(EPISODE.c.listener == LISTENER.c.id).scalar_subquery(),
        facts.where(TOLD.c.listener == LISTENER.c.id).scalar_subquery(),
        LISTENER.c.last_seen,
    )
    found = [Known(*row) for row in connection.execute(query)]
    return sorted(found, key=lambda known: key(known.name))


def read_turns(connection: Connection, found: str, place: str) -> list[list[dict[str, Any]]]:
    """Return the turns' records of each episode with the listener of a key, the first one first."""
    query = (
        select(EPISODE.c.number, TURN.c.record)
        .join(LISTENER, EPISODE.c.listener == LISTENER.c.id)
        .outerjoin(TURN, TURN.c.episode == EPISODE.c.id)
        .where(LISTENER.c.key == found)
        .order_by(EPISODE.c.number, TURN.c.number)
    )
    episodes: dict[int, list[dict[str, Any]]] = {}
    for number, record in connection.execute(query):
        kept = episodes.setdefault(number, [])
        if record is not None:
            kept.append(read_record(record, place))
    return list(episodes.values())
