"""What the storyteller remembers of its listeners from one episode to the next.

The paper's outlook (section VI): "from single conversational episodes with the robot to multiple
conversational episodes covering a longer period of time". names.py: by what one is found;
store.py: the database, by schema.py and migrations/; resuming.py: how an episode goes on from what
is remembered, and how that fades; faults.py: what can go wrong, in one line each.

SQLAlchemy is imported when a database is opened, not before.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from adaptation.memory.faults import NoMemoryError

if TYPE_CHECKING:
    from adaptation.memory.store import SqlMemory

__all__ = ["NoMemoryError", "open_memory"]


def open_memory(
    where: str | None = None,
    *,
    learner: str | None = None,
    patience: float = 5.0,
    make: bool = True,
) -> SqlMemory:
    """Open the memory, making it where there is none and bringing an older one up to date.

    `where` is a path of an SQLite file, a URL (`sqlite:///path`, `postgresql://…`), or None for
    the user's own file (`adaptation.memory.places.usual_place`). `learner` names the learner of
    this session: what that one knows is recalled, whatever others were used in between.
    `patience` is how many seconds to wait while another process writes. Without `make` a file that
    is not there is a fault.

    Raises `PersonageError` for a missing package, a wrong URL, and a database that is locked,
    read-only, corrupt, or made by a newer version.

    >>> memory = open_memory("sqlite://")  # one that is gone when it is closed
    >>> memory.begin("Anna", when=0.0).episodes
    1
    >>> memory.remember("anna", {"text": "Hello."}, {}, {"alice": {"clumsy": 1}})
    >>> memory.recall("ANNA").told
    {'alice': {'clumsy': 1}}
    >>> memory.close()
    """
    from adaptation.memory.faults import needed_packages

    with needed_packages():
        from adaptation.memory.store import SqlMemory
    return SqlMemory.opened(where, learner=learner, patience=patience, make=make)
