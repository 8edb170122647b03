"""Corpora of styled utterances: which utterances, how they are written, and how one goes on.

The utterances go evenly over X and characters, in turns. Each has its own seed, derived from the
corpus's, and a turn of a conversation; so it can be said again alone:
`generate --character C --x X --seed S --count TURN+1` ends with it.
"""

from __future__ import annotations

import json
import os
import signal
import sys
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from hashlib import blake2b
from itertools import islice
from os import PathLike
from pathlib import Path
from typing import IO, NamedTuple, TypeVar

from personage_lite.errors import PersonageError, shown
from personage_lite.generator import Generator
from personage_lite.lexicon import Rating
from personage_lite.style import check_x

T = TypeVar("T")
DEFAULT_X = (-2.0, -1.0, 0.0, 1.0, 2.0)
SUFFIXES = (".jsonl", ".json")
# Which turn of its conversation each utterance of one X and character is, over and over, from a
# place that depends on the character: three in sixteen are later ones. The turns before them are
# said in vain, so they cannot be many.
TURNS = (0, 1, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)
# So many utterances are written at once, and so many of an unfinished file's last are checked.
_CHUNK = 50
_CHECKED = 16


class Request(NamedTuple):
    """What one record of a corpus is generated from."""

    character: str
    x: float
    seed: int
    turn: int


class Order(NamedTuple):
    """What a corpus is made of; `characters` are ids."""

    seed: int
    xs: tuple[float, ...]
    characters: tuple[str, ...]
    overrides: Mapping[str, float]
    rating: Rating
    facts: str | None

    def request(self, index: int) -> Request:
        """Return what the record at `index` is generated from, whatever the count.

        >>> Order(0, (-2.0, 2.0), ("alice",), {}, "mild", None).request(3).turn
        1
        """
        rest, place = divmod(index, len(self.xs))
        number, who = divmod(rest, len(self.characters))
        x, character = self.xs[place], self.characters[who]
        turn = TURNS[(_hashed(character) + number) % len(TURNS)]
        return Request(character, x, _hashed(f"{self.seed}/{character}/{x!r}/{number}"), turn)


def _hashed(name: str) -> int:
    """Return a number below 2^48, which any reader of JSON can hold, that belongs to a name."""
    return int.from_bytes(blake2b(name.encode(), digest_size=6).digest(), "big")


class Written(NamedTuple):
    """A corpus that is written, and how many of its utterances an earlier run had written."""

    path: Path
    utterances: int
    earlier: int


def write_corpus(
    out: str | PathLike[str],
    count: int,
    *,
    xs: Sequence[float | str] = DEFAULT_X,
    characters: Sequence[str] = (),
    facts: str | PathLike[str] | None = None,
    seed: int = 0,
    overrides: Mapping[str, float] | None = None,
    rating: Rating = "mild",
    workers: int = 1,
    progress: Callable[[int], object] = int,
) -> Written:
    """Write `count` utterances to a file of JSON lines; the same call writes the same bytes.

    `characters` are all of the facts if none is named. What is not finished stands in a file
    `.partial` beside; the same call goes on from it, and a longer one too. `workers` are processes
    that generate; `progress` is called with the number of utterances so far (by default it shows
    nothing). Raises `PersonageError` for a fault in what is given and for what cannot be written.
    """
    path = check_out(out)
    generator = Generator(facts=facts)
    order = Order(
        seed,
        _different((check_x(x) + 0.0 for x in xs), "X", "{:g}".format),
        _characters(generator, characters),
        dict(overrides or {}),
        rating,
        None if facts is None else os.fspath(facts),
    )
    line(generator, order, 0)  # A fault in the options, before anything is written.
    partial = path.with_name(f"{path.name}.partial")
    try:
        with _opened(partial) as file:
            earlier = _go_on(file, partial, count, lambda index: line(generator, order, index))
            progress(earlier)
            done = earlier
            for lines in _chunks(generator, order, range(earlier, count), workers):
                _append(file, lines)
                done += len(lines)
                progress(done)
            os.fsync(file.fileno())
        partial.replace(path)
    except OSError as error:
        raise PersonageError(
            f"{path}: cannot be written ({error.strerror}); choose another place"
        ) from None
    return Written(path, count, earlier)


def check_out(out: str | PathLike[str]) -> Path:
    """Return the path of a corpus; raises `PersonageError` if its name is none."""
    path = Path(out)
    if path.suffix.lower() not in SUFFIXES:
        raise PersonageError(
            f"a corpus is JSON lines, and '{shown(path.name)}' is no such name; end it in .jsonl"
        )
    if path.is_dir():
        raise PersonageError(f"{path}: is a folder; name a file in it")
    return path


def line(generator: Generator, order: Order, index: int) -> bytes:
    """Return the record at `index` as a line: as `generate --format json` prints it."""
    character, x, seed, turn = order.request(index)
    turns = generator.turns(
        character, x, seed, count=turn + 1, overrides=order.overrides, rating=order.rating
    )
    utterance = deque(turns, maxlen=1).pop()
    return f"{json.dumps(utterance.record(), ensure_ascii=False)}\n".encode()


def _characters(generator: Generator, names: Sequence[str]) -> tuple[str, ...]:
    found = [generator.character(name) for name in names] or generator.characters()
    return _different((one.entity.id for one in found), "character", "'{}'".format)


def _different(values: Iterable[T], kind: str, show: Callable[[T], str]) -> tuple[T, ...]:
    found: list[T] = []
    for value in values:
        if value in found:
            raise PersonageError(f"{kind} {show(value)} is given twice; give each but once")
        found.append(value)
    return tuple(found)


@contextmanager
def _opened(partial: Path) -> Iterator[IO[bytes]]:
    """Open an unfinished file to read it and write on, for one process at a time."""
    with open(partial, "a+b", buffering=0) as file:
        try:
            import fcntl
        except ImportError:  # Windows, where nothing keeps two processes from it.
            yield file
            return
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise PersonageError(
                f"another process is writing {partial}; wait for it, or choose another --out"
            ) from None
        yield file


def _go_on(file: IO[bytes], partial: Path, count: int, made: Callable[[int], bytes]) -> int:
    """Return how many whole lines an unfinished file has, and cut off what follows them.

    Its first and last ones must be what this order makes.
    """
    file.seek(0)
    first: list[bytes] = []
    last: deque[tuple[int, bytes]] = deque(maxlen=_CHECKED)
    found = end = 0
    with open(file.fileno(), "rb", closefd=False) as lines:
        for text in islice(lines, count):
            if not text.endswith(b"\n"):
                break
            if len(first) < _CHECKED:
                first.append(text)
            last.append((found, text))
            found, end = found + 1, end + len(text)
    for index, text in (*enumerate(first), *last):
        if made(index) != text:
            raise PersonageError(
                f"{partial} is of another command (line {index + 1} differs); "
                "run that again, remove the file, or choose another --out"
            )
    file.truncate(end)
    return found


def _append(file: IO[bytes], lines: Sequence[bytes]) -> None:
    """Write lines with Ctrl-C held back, so that they are whole."""
    left = memoryview(b"".join(lines))
    with _held_back():
        while left:
            left = left[file.write(left) :]


@contextmanager
def _held_back() -> Iterator[None]:
    if sys.platform == "win32":
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT,))
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


# In a worker: what it generates with.
_working: list[tuple[Generator, Order]] = []


def _chunks(
    generator: Generator, order: Order, indices: range, workers: int
) -> Iterator[list[bytes]]:
    """Yield the lines at the indices in their order, some at a time."""
    chunks = [indices[start : start + _CHUNK] for start in range(0, len(indices), _CHUNK)]
    if min(workers, len(chunks)) < 2:
        for chunk in chunks:
            yield [line(generator, order, index) for index in chunk]
        return
    from multiprocessing import Pool

    with Pool(min(workers, len(chunks)), _start_worker, (order,)) as pool:
        yield from pool.imap(_work, chunks)


def _start_worker(order: Order) -> None:
    # Ctrl-C is for the process that writes; it ends the others.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _working.append((Generator(facts=order.facts), order))


def _work(indices: range) -> list[bytes]:
    generator, order = _working[0]
    return [line(generator, order, index) for index in indices]
