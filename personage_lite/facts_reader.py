"""Reads and validates facts files (docs/facts.md): every fault names file, line and remedy."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from os import PathLike, fspath, stat, walk
from os.path import basename, dirname, isfile, join, splitext
from stat import S_ISDIR
from typing import cast

from personage_lite.errors import DataError, PersonageError, nearest, shown
from personage_lite.fact_reader import IDENTIFIER, FactReader
from personage_lite.facts import (
    ORDERED_KINDS,
    RELATION_KINDS,
    Character,
    Entity,
    Fact,
    Relation,
    RelationKind,
    Topic,
    character,
    entity,
)
from personage_lite.realizer.specification import (
    Gender,
    Number,
)
from personage_lite.yaml_reader import Node, read_yaml

ENTITIES_FILE = "entities.yaml"
_LONGEST_NAME = 80
_MARKS_IN_NAMES = " '’.,-&()!"


def identifier(name: str) -> str:
    """Return a character's id for a name in any case, with spaces or hyphens.

    >>> identifier("White Rabbit"), identifier("the white-rabbit")
    ('white_rabbit', 'white_rabbit')
    """
    words = re.split(r"[\s_-]+", name.strip().lower())
    return "_".join(words[1:] if len(words) > 1 and words[0] == "the" else words)


def character_files(place: str | PathLike[str]) -> dict[str, str]:
    """Return the facts files under a folder (or the one file given) by character id."""
    place = fspath(place)
    try:
        kind = stat(place).st_mode
    except FileNotFoundError:
        raise PersonageError(f"{place}: no such file or folder; check the path") from None
    except OSError as error:  # A name that is too long, a folder that is locked.
        raise PersonageError(f"{place}: {error.strerror}; check the path") from None
    if not S_ISDIR(kind):
        return {_stem(place): place}
    found: dict[str, str] = {}
    for folder, folders, names in walk(place):
        folders.sort()
        for name in sorted((*names, *folders)):  # reading a folder of that name says what is wrong
            if not name.endswith(".yaml") or name == ENTITIES_FILE:
                continue
            path, key = join(folder, name), _stem(name)
            if key in found:
                raise PersonageError(
                    f"{path}: '{key}' is also {found[key]}; rename one of the two files"
                )
            found[key] = path
    if not found:
        raise PersonageError(
            f"{place}: holds no facts file; see docs/facts.md for how to write one"
        )
    return dict(sorted(found.items()))


def _stem(path: str) -> str:
    return splitext(basename(path))[0]


def find_character(name: str, place: str | PathLike[str]) -> Character:
    """Load one character by id or name, reading only its file and the entities beside it.

    Raises `PersonageError` for an unknown name (nearest names offered), `DataError` for a fault.
    """
    files = character_files(place)
    key = identifier(name)
    if key not in files:
        raise PersonageError(f"no character '{shown(name)}'; {nearest(key[:200], files)}")
    return read_character(files[key])


def read_character(path: str | PathLike[str], faults: list[DataError] | None = None) -> Character:
    """Read one facts file, with `entities.yaml` beside it if there is one.

    With a list for `faults`, those of single facts and relations are put there and the rest is
    read on; without one the first is raised.
    """
    path = fspath(path)
    entities: dict[str, Entity] = {}
    shared = join(dirname(path), ENTITIES_FILE)
    if isfile(shared):  # False, too, in a folder that is locked.
        node = read_yaml(shared)
        _read_entities(node.need("entities"), entities)
        node.done()
    node = read_yaml(path)
    own = node.get("entities")
    if own is not None:
        _read_entities(own, entities)
    about = node.need("about")
    if about.text() != _stem(path):
        raise about.fault(f"'{about.text()}' is not the file's name", f"write about: {_stem(path)}")
    if about.text() not in entities:
        raise about.fault(
            f"no entity '{about.text()}'",
            f"describe it under 'entities:' here or in {ENTITIES_FILE}",
        )
    reader = FactReader(entities[about.text()], entities)
    topics = _topics(node, reader)
    facts: dict[str, Fact] = {}
    for item in node.need("facts").sequence():
        with _collecting(faults):
            fact = reader.fact(item)
            if fact.id in facts:
                raise item.fault(f"a second fact '{fact.id}'", "give it an id of its own")
            if topics and fact.topic not in topics:
                remedy = f"list it under 'topics:', or {nearest(fact.topic, topics)}"
                raise item.need("topic").fault(f"no topic '{shown(fact.topic)}'", remedy)
            facts[fact.id] = fact
    if not facts and not faults:
        raise node.need("facts").fault("there is no fact", "add at least one")
    relations: list[Relation] = []
    listed = node.get("relations")
    for item in listed.sequence() if listed is not None else ():
        with _collecting(faults):
            relations.append(_relation(item, facts))
    source = node.text_of("source")
    node.done()
    found = character(
        entities[about.text()],
        entities,
        tuple(facts.values()),
        tuple(relations),
        topics,
        source,
        path,
    )
    _refuse_cycles(found, node.file)
    return found


@contextmanager
def _collecting(faults: list[DataError] | None) -> Iterator[None]:
    try:
        yield
    except DataError as fault:
        if faults is None:
            raise
        faults.append(fault)


def _read_entities(node: Node, found: dict[str, Entity]) -> None:
    for key, item in node.items():
        if not IDENTIFIER.match(key):
            raise item.fault(f"'{key}' is no id", "use small letters, digits and _")
        if key in found:
            raise item.fault(f"the entity '{key}' is described twice", "keep one of the two")
        name = item.need("name").text()
        if not _sayable(name):
            raise item.need("name").fault(
                f"'{shown(name)}' is no name", "write one of up to 80 letters, without symbols"
            )
        found[key] = entity(
            key,
            name,
            short_name=item.text_of("short_name"),
            gender=cast(
                Gender, item.choice_of("gender", ("masculine", "feminine", "neuter"), "neuter")
            ),
            number=cast(Number, item.choice_of("number", ("singular", "plural"), "singular")),
            animate=item.flag_of("animate"),
            nouns=item.texts_of("nouns"),
        )
        item.done()


def _sayable(name: str) -> bool:
    """Whether a name is made of letters, with the digits and marks that names can have."""
    if not any(letter.isalpha() for letter in name) or len(name) > _LONGEST_NAME:
        return False
    odd = [sign for sign in name if not (sign.isalnum() or sign in _MARKS_IN_NAMES)]
    if not odd:
        return True
    from unicodedata import category  # Here, because few names need it.

    return all(category(sign).startswith("M") for sign in odd)  # vowel signs and accents


def _topics(node: Node, reader: FactReader) -> dict[str, Topic]:
    """Read the topics, in the order in which they are best told; none if the file lists none."""
    listed = node.get("topics")
    topics: dict[str, Topic] = {}
    for name, item in listed.items() if listed is not None else ():
        setting = item.get("setting")
        topics[name] = Topic(
            name,
            None if setting is None else reader.text(setting),
            item.flag_of("in_order"),
            item.line,
        )
        item.done()
    return topics


def _relation(item: Node, facts: dict[str, Fact]) -> Relation:
    kind = cast(RelationKind, item.need("kind").choice(RELATION_KINDS))
    ends = []
    for role in ("nucleus", "satellite"):
        node = item.need(role)
        if node.text() not in facts:
            raise node.fault(f"no fact '{node.text()}'", nearest(node.text(), facts))
        ends.append(node.text())
    item.done()
    if ends[0] == ends[1]:
        raise item.fault(f"'{ends[0]}' is related to itself", "name two facts")
    return Relation(kind, ends[0], ends[1], item.line)


def _refuse_cycles(about: Character, file: str) -> None:
    """Sequence, elaboration and order say what comes first: a circle could never be told."""
    open_facts = {fact.id for fact in about.facts}
    while open_facts:
        free = {
            key
            for key in open_facts
            if not any(first in open_facts for first in about.prerequisites.get(key, ()))
        }
        if not free:
            lines = [
                relation.line
                for relation in about.relations
                if relation.kind in ORDERED_KINDS and relation.satellite in open_facts
            ]
            raise DataError(
                file,
                min(lines),
                f"{', '.join(sorted(open_facts))} wait for each other",
                "remove one elaboration or sequence of the circle, or 'in_order' of a topic",
            )
        open_facts -= free
