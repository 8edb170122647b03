"""The memory in a database: what `Memory` of the storyteller's protocols promises.

Each method is one transaction. Those about one listener come one after the other, because each
begins by raising the listener's `version`, which locks its row (on SQLite: the file): so two
sessions at once lose nothing of each other, and no transaction has to be tried again.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, NamedTuple, Self, TypeVar

from sqlalchemy import Connection, Engine, delete, func, insert, select, update
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.exc import DBAPIError, SQLAlchemyError

from adaptation.memory.engine import make_engine, writing
from adaptation.memory.erasing import tidied
from adaptation.memory.faults import NoMemoryError, fault_of, needed_packages
from adaptation.memory.migrating import migrate
from adaptation.memory.names import key
from adaptation.memory.places import found_place, is_missing, make_folder, shown_place
from adaptation.memory.reading import Known, read_acquaintance, read_listeners, read_turns
from adaptation.memory.records import written_record
from adaptation.memory.schema import EPISODE, LISTENER, TOLD, TURN
from adaptation.storyteller.protocols import Acquaintance
from personage_lite.errors import PersonageError, shown
from personage_lite.names import checked_name

Told = Mapping[str, Mapping[str, int]]
_Result = TypeVar("_Result")


class Erased(NamedTuple):
    """What came of erasing someone.

    `known`: whether anything was there. `traces`: whether another session keeps pages with what
    was erased in the database's files, until it ends.
    """

    known: bool
    traces: bool


class _Session(NamedTuple):
    """An episode that this process is in: its row, its listener's, and what was told so far."""

    listener: int
    episode: int
    told: Told


class SqlMemory:
    """Remembers listeners in SQLite or PostgreSQL; see `adaptation.memory.open_memory`.

    `place` is how messages name the database. Every method raises `PersonageError`, in one line,
    where the database cannot be used; nothing is changed then.
    """

    def __init__(self, engine: Engine, place: str, learner: str | None = None) -> None:
        self._engine = engine
        self.place = place
        self._learner = learner
        self._sessions: dict[str, _Session] = {}

    @classmethod
    def opened(
        cls, where: str | None, *, learner: str | None, patience: float, make: bool = True
    ) -> Self:
        """Open a database, and bring its tables up to date; see `open_memory`."""
        url = found_place(where)
        if make:
            make_folder(url)
        elif is_missing(url):
            raise NoMemoryError(f"{shown_place(url)}: nothing is remembered there; check the path")
        with needed_packages():
            engine = make_engine(url, patience)
        memory = cls(engine, shown_place(url), learner)
        try:
            with needed_packages():
                memory._transaction(lambda connection: migrate(connection, memory.place))
        except PersonageError:
            engine.dispose()
            raise
        return memory

    def recall(self, name: str) -> Acquaintance | None:
        """Return what is remembered of a listener, or None for a stranger."""
        found = key(name)

        def read(connection: Connection) -> Acquaintance | None:
            row = connection.execute(select(LISTENER).where(LISTENER.c.key == found)).first()
            return None if row is None else self._acquaintance(connection, row)

        return self._transaction(read, writes=False)

    def begin(self, name: str, when: float) -> Acquaintance:
        """Begin an episode at `when` (epoch seconds); returns what is known, this one counted.

        Raises `PersonageError` for a name that is none (see `personage_lite.names`).
        """
        shown_name, found = checked_name(name), key(name)
        if not math.isfinite(when):
            raise PersonageError("an episode begins at no time; give seconds")

        def begin(connection: Connection) -> tuple[Acquaintance, _Session]:
            row = self._locked(connection, found, shown_name)
            known = self._acquaintance(connection, row)
            number = known.episodes + 1
            episode = connection.execute(
                insert(EPISODE)
                .values(
                    listener=row.id,
                    number=number,
                    at=when,
                    began=row.version,
                    written=row.version,
                    turns=0,
                )
                .returning(EPISODE.c.id)
            ).scalar_one()
            connection.execute(
                update(LISTENER).where(LISTENER.c.id == row.id).values(last_seen=when)
            )
            return known._replace(episodes=number), _Session(row.id, episode, known.told)

        known, self._sessions[found] = self._transaction(begin)
        return known

    def remember(
        self, name: str, turn: Mapping[str, Any], learner: Mapping[str, Any], told: Told
    ) -> None:
        """Keep one turn, what the learner knows after it and what has been told: all, or nothing.

        `turn` is any record that JSON can hold; a number under `when` (epoch seconds) in it is
        when the listener was last seen. `told` are all counts of the conversation: of each fact
        the larger count is kept, this one or another session's.
        """
        found = key(name)
        session = self._sessions.get(found)
        if session is None:
            raise PersonageError(f"no episode with {shown(name)} was begun; begin one first")
        record, knowledge = written_record(turn), written_record(learner)
        seen = _seen(turn.get("when"))

        def remember(connection: Connection) -> None:
            version = connection.execute(
                update(LISTENER)
                .where(LISTENER.c.id == session.listener, LISTENER.c.key == found)
                .values(version=LISTENER.c.version + 1, **seen)
                .returning(LISTENER.c.version)
            ).scalar()
            if version is None:
                raise PersonageError(
                    f"everything about {shown(name)} was erased during the session; nothing more "
                    "is kept of it"
                )
            number = connection.execute(
                update(EPISODE)
                .where(EPISODE.c.id == session.episode)
                .values(
                    turns=EPISODE.c.turns + 1,
                    written=version,
                    learner=learner.get("learner"),
                    knowledge=knowledge if learner else None,
                )
                .returning(EPISODE.c.turns)
            ).scalar_one()
            connection.execute(
                insert(TURN).values(episode=session.episode, number=number, record=record)
            )
            self._tell(connection, session, told)

        self._transaction(remember)
        kept = {character: dict(facts) for character, facts in told.items()}
        self._sessions[found] = session._replace(told=kept)

    def forget(self, name: str) -> bool:
        """Erase everything about a listener; returns whether anything was known."""
        return self.erase(name).known

    def erase(self, name: str) -> Erased:
        """Erase everything about a listener: rows, and what is left of them in the files."""
        found = key(name)

        def erase(connection: Connection) -> bool:
            # Episodes, turns and facts told go with the listener, by their foreign keys.
            gone = connection.execute(delete(LISTENER).where(LISTENER.c.key == found))
            return gone.rowcount > 0

        known = self._transaction(erase)
        self._sessions.pop(found, None)
        return Erased(known, known and not tidied(self._engine))

    def listeners(self) -> list[Known]:
        """Return who is known, by name."""
        return self._transaction(read_listeners, writes=False)

    def turns(self, name: str) -> list[list[dict[str, Any]]]:
        """Return the turns' records of each episode with a listener, the first one first."""
        found = key(name)
        return self._transaction(
            lambda connection: read_turns(connection, found, self.place), writes=False
        )

    def close(self) -> None:
        """Give the database back."""
        self._engine.dispose()

    def _locked(self, connection: Connection, found: str, name: str) -> Any:
        """Return a listener's row, made if there is none, its version raised, locked for others."""
        new = {"key": found, "name": name, "version": 1}
        statement: Any = _dialect(connection).insert(LISTENER).values(new)
        return connection.execute(
            statement.on_conflict_do_update(
                index_elements=["key"], set_={"version": LISTENER.c.version + 1}
            ).returning(LISTENER)
        ).one()

    def _acquaintance(self, connection: Connection, row: Any) -> Acquaintance:
        return read_acquaintance(connection, row, self._learner, self.place)

    def _tell(self, connection: Connection, session: _Session, told: Told) -> None:
        """Keep the counts that have grown, each the larger one of ours and the database's."""
        rows = [
            {"listener": session.listener, "character": character, "fact": fact, "times": times}
            for character, facts in told.items()
            for fact, times in facts.items()
            if times > session.told.get(character, {}).get(fact, 0)
        ]
        if not rows:
            return
        statement: Any = _dialect(connection).insert(TOLD)
        larger = func.greatest if connection.dialect.name == "postgresql" else func.max
        connection.execute(
            statement.on_conflict_do_update(
                index_elements=["listener", "character", "fact"],
                set_={"times": larger(TOLD.c.times, statement.excluded.times)},
            ),
            rows,
        )

    def _transaction(
        self, work: Callable[[Connection], _Result], *, writes: bool = True
    ) -> _Result:
        """Do some work in a transaction of its own; what fails changes nothing."""
        with self._faults():
            connection = writing(self._engine) if writes else self._engine.connect()
            with connection, connection.begin():
                return work(connection)

    @contextmanager
    def _faults(self) -> Iterator[None]:
        try:
            yield
        except DBAPIError as error:
            raise fault_of(error, self.place) from None
        except SQLAlchemyError as error:
            said = " ".join(str(error).split())[:160]
            raise PersonageError(f"{self.place}: failed ({said}); try again") from None


def _dialect(connection: Connection) -> Any:
    """Return the module of SQLAlchemy that knows how the database inserts or updates at once."""
    return postgresql if connection.dialect.name == "postgresql" else sqlite


def _seen(when: object) -> dict[str, float]:
    """Return what to set where a turn says when it was; nothing where it does not."""
    if isinstance(when, int | float) and not isinstance(when, bool) and math.isfinite(when):
        return {"last_seen": float(when)}
    return {}
