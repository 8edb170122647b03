"""Reads and validates facts files (docs/facts.md): every fault names file, line and remedy."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import cast

from personage_lite.errors import DataError, PersonageError, nearest, shown
from personage_lite.facts import (
    ORDERED_KINDS,
    POLARITIES,
    RELATION_KINDS,
    STRENGTHS,
    Character,
    Entity,
    Fact,
    Polarity,
    Relation,
    RelationKind,
    Strength,
    character,
    entity,
)
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Case,
    Cased,
    Clause,
    Gender,
    NounPhrase,
    Number,
    Tense,
    Text,
)
from personage_lite.yaml_reader import Node, read_yaml

ENTITIES_FILE = "entities.yaml"
_MENTION = re.compile(r"\{([a-z0-9_]+)('s|:self|:subject)?\}")
_CASES: dict[str | None, Case] = {
    None: "objective",
    "'s": "possessive",
    ":self": "reflexive",
    ":subject": "subjective",
}
# The fields of a fact: an unknown one is named before anything else is missed.
_FIELDS = (
    *("id", "subject", "part", "predicate", "attribute", "complement", "particle"),
    *("indirect_object", "object", "adverbials", "adverb", "quote", "tense", "modal"),
    *("perfect", "progressive", "passive", "negated", "negator", "polarity", "strength"),
    *("topic", "chapter", "source"),
)
_IDENTIFIER = re.compile(r"[a-z][a-z0-9_]*\Z")


def identifier(name: str) -> str:
    """Return a character's id for a name in any case, with spaces or hyphens.

    >>> identifier("White Rabbit"), identifier("the white-rabbit")
    ('white_rabbit', 'white_rabbit')
    """
    words = re.split(r"[\s_-]+", name.strip().lower())
    return "_".join(words[1:] if len(words) > 1 and words[0] == "the" else words)


def character_files(place: Path) -> dict[str, Path]:
    """Return the facts files under a folder (or the one file given) by character id."""
    try:
        if place.is_file():
            return {place.stem: place}
        folder = place.is_dir()
    except OSError as error:  # A name that is too long, a folder that is locked.
        raise PersonageError(f"{place}: {error.strerror}; check the path") from None
    if not folder:
        raise PersonageError(f"{place}: no such file or folder; check the path")
    files = sorted(path for path in place.rglob("*.yaml") if path.name != ENTITIES_FILE)
    if not files:
        raise PersonageError(
            f"{place}: holds no facts file; see docs/facts.md for how to write one"
        )
    found: dict[str, Path] = {}
    for path in files:
        if path.stem in found:
            raise PersonageError(
                f"{path}: '{path.stem}' is also {found[path.stem]}; rename one of the two files"
            )
        found[path.stem] = path
    return found


def find_character(name: str, place: Path) -> Character:
    """Load one character by id or name, reading only its file and the entities beside it.

    Raises `PersonageError` for an unknown name (nearest names offered), `DataError` for a fault.
    """
    files = character_files(place)
    key = identifier(name)
    if key not in files:
        raise PersonageError(f"no character '{shown(name)}'; {nearest(key[:200], files)}")
    return read_character(files[key])


def read_character(path: Path, faults: list[DataError] | None = None) -> Character:
    """Read one facts file, with `entities.yaml` beside it if there is one.

    With a list for `faults`, those of single facts and relations are put there and the rest is
    read on; without one the first is raised.
    """
    entities: dict[str, Entity] = {}
    shared = path.with_name(ENTITIES_FILE)
    if os.path.isfile(shared):  # False, too, in a folder that is locked.
        node = read_yaml(shared)
        _read_entities(node.need("entities"), entities)
        node.done()
    node = read_yaml(path)
    own = node.get("entities")
    if own is not None:
        _read_entities(own, entities)
    about = node.need("about")
    if about.text() != path.stem:
        raise about.fault(f"'{about.text()}' is not the file's name", f"write about: {path.stem}")
    if about.text() not in entities:
        raise about.fault(
            f"no entity '{about.text()}'", f"describe it under 'entities:' here or in {shared.name}"
        )
    reader = _FactReader(entities[about.text()], entities)
    facts: dict[str, Fact] = {}
    for item in node.need("facts").sequence():
        with _collecting(faults):
            fact = reader.fact(item)
            if fact.id in facts:
                raise item.fault(f"a second fact '{fact.id}'", "give it an id of its own")
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
        source,
        str(path),
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
        if not _IDENTIFIER.match(key):
            raise item.fault(f"'{key}' is no id", "use small letters, digits and _")
        if key in found:
            raise item.fault(f"the entity '{key}' is described twice", "keep one of the two")
        name = item.need("name").text()
        if not any(letter.isalpha() for letter in name) or len(name) > 80:
            raise item.need("name").fault("this is no name", "write a name of up to 80 letters")
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


class _FactReader:
    """Reads the facts of one character."""

    def __init__(self, about: Entity, entities: dict[str, Entity]) -> None:
        self._about = about
        self._entities = entities
        self._mentions: set[str] = set()

    def _entity(self, key: str, node: Node) -> Entity:
        found = self._entities.get(key)
        if found is None:
            raise node.fault(f"no entity '{key}'", nearest(key, self._entities))
        self._mentions.add(key)
        return found

    def text(self, node: Node) -> Text:
        """Read words with {mentions} between them."""
        words = node.text()
        parts: list[str | Cased] = []
        start = 0
        for match in _MENTION.finditer(words):
            _add_words(parts, words[start : match.start()])
            entity = self._entity(match.group(1), node)
            parts.append(Cased(entity.phrase, _CASES[match.group(2)]))
            start = match.end()
        _add_words(parts, words[start:])
        if any(isinstance(part, str) and ("{" in part or "}" in part) for part in parts):
            raise node.fault(
                "a mention in { } cannot be read",
                "write {id}, {id's}, {id:self} or {id:subject}",
            )
        return Text(tuple(parts))

    def _optional_text(self, item: Node, key: str) -> Text | None:
        found = item.get(key)
        return None if found is None else self.text(found)

    def _subject(self, item: Node) -> NounPhrase:
        own = item.get("subject")
        owner = self._about if own is None else self._entity(own.text(), own)
        self._mentions.add(owner.id)
        part = item.get("part")
        if part is None:
            return owner.phrase
        if part.is_mapping():
            noun, number = (
                _words(part, "noun"),
                part.choice_of("number", ("singular", "plural"), "singular"),
            )
            part.need("noun")
            part.done()
        else:
            noun, number = _words(item, "part"), "singular"
        return NounPhrase(noun, possessor=owner.phrase, number=cast(Number, number))

    def fact(self, item: Node) -> Fact:
        """Read one fact into its clause and its planning values."""
        self._mentions = set()
        item.only(_FIELDS)
        key = item.need("id").text()
        if not _IDENTIFIER.match(key):
            raise item.need("id").fault(f"'{key}' is no id", "use small letters, digits and _")
        attribute = item.get("attribute")
        complement = item.get("complement")
        if attribute is not None and complement is not None:
            raise item.fault("both attribute and complement", "keep one of the two")
        described = attribute is not None or complement is not None
        predicate = item.get("predicate")
        if predicate is None and not described:
            raise item.fault("'predicate' is missing", "add the verb, 'predicate: …'")
        adverbials = item.get("adverbials")
        clause = Clause(
            verb=_words(item, "predicate") or "be",
            subject=self._subject(item),
            particle=_words(item, "particle"),
            indirect_object=self._optional_text(item, "indirect_object"),
            object=self._optional_text(item, "object"),
            complement=AdjectivePhrase(_words(item, "attribute"))
            if attribute is not None
            else self._optional_text(item, "complement"),
            adverbials=tuple(self.text(node) for node in adverbials.sequence())
            if adverbials
            else (),
            adverbs=(_words(item, "adverb"),) if item.get("adverb") else (),
            quotation=_words(item, "quote"),
            tense=cast(Tense, item.choice_of("tense", ("present", "past", "future"), "present")),
            modal=item.text_of("modal"),
            perfect=item.flag_of("perfect"),
            progressive=item.flag_of("progressive"),
            passive=item.flag_of("passive"),
            negated=item.flag_of("negated"),
            negator=item.choice_of("negator", ("not", "never"), "not"),
        )
        if item.get("negator") is not None and not clause.negated:
            raise item.fault("a negator, but nothing negated", "add 'negated: true'")
        chapter = item.get("chapter")
        subject = clause.subject
        assert subject is not None
        fact = Fact(
            id=key,
            about=(subject.possessor or subject).entity,
            clause=clause,
            polarity=cast(Polarity, item.choice_of("polarity", POLARITIES, "neutral")),
            strength=cast(Strength, item.choice_of("strength", STRENGTHS, "plainly")),
            topic=item.need("topic").text(),
            chapter=0 if chapter is None else chapter.integer(1, 999),
            source=item.text_of("source"),
            line=item.line,
            mentions=frozenset(self._mentions),
        )
        item.done()
        return fact


def _words(item: Node, key: str) -> str:
    """Return words that are said as they stand; a mention has no place in them."""
    found = item.get(key)
    if found is None:
        return ""
    words = found.text()
    if "{" in words or "}" in words:
        raise found.fault(
            f"no mention can stand in '{key}'", "use object, complement or adverbials for it"
        )
    return words


def _add_words(parts: list[str | Cased], words: str) -> None:
    """Add fixed words, with their commas as tokens of their own."""
    for piece in re.findall(r"[^,]+|,", words):
        if piece.strip():
            parts.append(piece.strip())


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
    """Sequence and elaboration say what comes first: a circle of them could never be told."""
    open_facts = {fact.id for fact in about.facts}
    while open_facts:
        free = {
            key
            for key in open_facts
            if not any(first in open_facts for first in about.prerequisites.get(key, ()))
        }
        if not free:
            line = min(
                relation.line
                for relation in about.relations
                if relation.kind in ORDERED_KINDS and relation.satellite in open_facts
            )
            raise DataError(
                file,
                line,
                f"{', '.join(sorted(open_facts))} wait for each other",
                "remove one elaboration or sequence of the circle",
            )
        open_facts -= free
