"""Knowledge: entities, facts about them and the rhetorical relations between the facts.

The format is described in docs/facts.md; `facts_reader` reads it.
"""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from itertools import pairwise
from typing import Literal, NamedTuple, TypeAlias

from personage_lite.realizer.specification import Clause, Gender, NounPhrase, Number, Phrase, Text

Polarity: TypeAlias = Literal["good", "neutral", "bad"]
Strength: TypeAlias = Literal["somewhat", "plainly", "extremely"]
Feeling: TypeAlias = Literal["", "funny", "surprising", "lovely", "sad", "awful"]
RelationKind: TypeAlias = Literal[
    "elaboration", "contrast", "concession", "justification", "restatement", "sequence"
]

POLARITIES: tuple[str, ...] = ("good", "neutral", "bad")
STRENGTHS: tuple[str, ...] = ("somewhat", "plainly", "extremely")
FEELINGS: tuple[str, ...] = ("funny", "surprising", "lovely", "sad", "awful")
# A fact's polarity must not be this where it makes one feel so.
UNFELT: dict[str, str] = {"lovely": "bad", "sad": "good", "awful": "good"}
RELATION_KINDS: tuple[str, ...] = (
    "elaboration",
    "contrast",
    "concession",
    "justification",
    "restatement",
    "sequence",
)
# In place of the kind of a fact that cannot be told yet: the last entry of a table of kinds.
WAITS = -1
# The second of these pairs makes sense only when the first has been told.
ORDERED_KINDS: tuple[str, ...] = ("elaboration", "sequence")
# These set two facts against each other.
OPPOSING_KINDS: tuple[str, ...] = ("concession", "contrast")
# Of two relations between the same facts, one of these is what is said.
TELLING_KINDS: tuple[str, ...] = (*OPPOSING_KINDS, "justification")


class Entity(NamedTuple):
    """Someone or something that facts are about or mention; made by `entity`.

    `phrase` is the noun phrase of the full name, `short_phrase` of what is said once it is clear
    who is meant, `pronoun` of the pronoun; `descriptions` are what "the …" can call it.
    """

    id: str
    name: str
    nouns: tuple[str, ...]
    phrase: NounPhrase
    short_phrase: NounPhrase
    pronoun: NounPhrase
    descriptions: tuple[NounPhrase, ...]


def entity(
    key: str,
    name: str,
    short_name: str = "",
    gender: Gender = "neuter",
    number: Number = "singular",
    animate: bool = False,
    nouns: tuple[str, ...] = (),
) -> Entity:
    """Make an entity from its names; a leading "the" becomes the determiner.

    >>> entity("white_rabbit", "the White Rabbit", nouns=("rabbit",)).descriptions[0].noun
    'rabbit'
    """

    def phrase(words: str) -> NounPhrase:
        article, _, rest = words.partition(" ")
        determiner, noun = ("the", rest) if article.lower() == "the" and rest else ("", words)
        return NounPhrase(
            noun, determiner, number=number, gender=gender, animate=animate, entity=key
        )

    full = phrase(name)
    return Entity(
        id=key,
        name=name,
        nouns=nouns,
        phrase=full,
        short_phrase=phrase(short_name or name),
        pronoun=full._replace(pronoun=True),
        descriptions=tuple(phrase(f"the {noun}") for noun in nouns),
    )


def entity_of(phrase: Phrase | None) -> str:
    """Return the entity that a phrase denotes; empty for what is no noun phrase.

    >>> entity_of(NounPhrase("Alice", entity="alice")), entity_of("nobody at all")
    ('alice', '')
    """
    return phrase.entity if isinstance(phrase, NounPhrase) else ""


class Fact(NamedTuple):
    """One proposition: its clause in deep syntax, and what planning needs to know of it.

    `clause.negated` is what is true; `polarity` is whether it is good or bad news: never the
    same thing. The clause names concepts of the lexicon where it has them. `about` is the entity
    that is the subject, or whose part is. `feeling` is what most people feel when they hear it for
    the first time; empty where that is nothing, and no speaker makes much of such a fact.
    `following` says the same right after the fact before it in the file, which it may lean on:
    "it's no big deal".
    """

    id: str
    about: str
    clause: Clause
    polarity: Polarity
    strength: Strength
    topic: str
    chapter: int
    source: str
    line: int
    mentions: frozenset[str]
    feeling: Feeling = ""
    following: Clause | None = None


class Relation(NamedTuple):
    """A rhetorical relation that holds between two facts (Mann & Thompson 1988)."""

    kind: RelationKind
    nucleus: str
    satellite: str
    line: int = 0


class Topic(NamedTuple):
    """What facts that are told together have in common.

    `setting` is a place or time that is true of all of them ("at the trial"); `in_order` says
    that they are a story, each told after the one before it in the file.
    """

    name: str
    setting: Text | None = None
    in_order: bool = False
    line: int = 0


class Character(NamedTuple):
    """All that is known of one entity, made by `character`; any kind of thing can be one.

    `topics` stand in the order in which they are best told. `places` holds each fact's place in
    the file, `kinds` its place in a table of polarities by strengths, `openings` the same, with
    `WAITS` for those that cannot be told before anything else; `by_topic` the places of each
    topic's facts, `by_others` the places of those that are about somebody else; `stories` the
    topics that are told in order. `related` holds each fact's relations; `prerequisites` the
    facts that must be told before a fact makes sense, `unlocks` the same the other way round.
    """

    entity: Entity
    entities: dict[str, Entity]
    facts: tuple[Fact, ...]
    relations: tuple[Relation, ...]
    topics: dict[str, Topic]
    source: str
    file: str
    by_id: dict[str, Fact]
    places: dict[str, int]
    kinds: tuple[int, ...]
    openings: tuple[int, ...]
    by_topic: dict[str, tuple[int, ...]]
    by_others: tuple[int, ...]
    stories: tuple[str, ...]
    related: dict[str, tuple[Relation, ...]]
    prerequisites: dict[str, tuple[str, ...]]
    unlocks: dict[str, tuple[str, ...]]


def character(
    about: Entity,
    entities: dict[str, Entity],
    facts: tuple[Fact, ...],
    relations: tuple[Relation, ...],
    topics: dict[str, Topic],
    source: str,
    file: str,
) -> Character:
    """Make a character, with the look-up tables that planning needs.

    Topics that are not in `topics` follow in the order in which the facts name them.
    """
    topics = topics | {fact.topic: Topic(fact.topic) for fact in facts if fact.topic not in topics}
    kinds = tuple(
        POLARITIES.index(fact.polarity) * len(STRENGTHS) + STRENGTHS.index(fact.strength)
        for fact in facts
    )
    by_topic: dict[str, tuple[int, ...]] = {}
    for place, fact in enumerate(facts):
        by_topic[fact.topic] = (*by_topic.get(fact.topic, ()), place)
    related: dict[str, tuple[Relation, ...]] = {}
    prerequisites: dict[str, tuple[str, ...]] = {}
    unlocks: dict[str, tuple[str, ...]] = {}

    def wait(later: str, earlier: str) -> None:
        if earlier not in prerequisites.get(later, ()):
            prerequisites[later] = (*prerequisites.get(later, ()), earlier)
            unlocks[earlier] = (*unlocks.get(earlier, ()), later)

    for relation in relations:
        first, second = relation.nucleus, relation.satellite
        for end in (first, second):
            related[end] = (*related.get(end, ()), relation)
        if relation.kind in ORDERED_KINDS:
            wait(second, first)
    for topic in topics.values():
        if topic.in_order:
            for earlier, later in pairwise(by_topic.get(topic.name, ())):
                wait(facts[later].id, facts[earlier].id)
    return Character(
        entity=about,
        entities=entities,
        facts=facts,
        relations=relations,
        topics=topics,
        source=source,
        file=file,
        by_id={fact.id: fact for fact in facts},
        places={fact.id: place for place, fact in enumerate(facts)},
        kinds=kinds,
        openings=tuple(
            WAITS if fact.id in prerequisites else kind
            for fact, kind in zip(facts, kinds, strict=True)
        ),
        by_topic=by_topic,
        by_others=tuple(place for place, fact in enumerate(facts) if fact.about != about.id),
        stories=tuple(name for name, topic in topics.items() if topic.in_order),
        related=related,
        prerequisites=prerequisites,
        unlocks=unlocks,
    )
