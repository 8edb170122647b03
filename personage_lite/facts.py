"""Knowledge: entities, facts about them and the rhetorical relations between the facts.

The format is described in docs/facts.md; `facts_reader` reads it.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal, TypeAlias

from personage_lite.realizer.specification import Clause, Gender, NounPhrase, Number

Polarity: TypeAlias = Literal["good", "neutral", "bad"]
Strength: TypeAlias = Literal["somewhat", "plainly", "extremely"]
RelationKind: TypeAlias = Literal[
    "elaboration", "contrast", "concession", "justification", "restatement", "sequence"
]

POLARITIES: tuple[str, ...] = ("good", "neutral", "bad")
STRENGTHS: tuple[str, ...] = ("somewhat", "plainly", "extremely")
RELATION_KINDS: tuple[str, ...] = (
    "elaboration",
    "contrast",
    "concession",
    "justification",
    "restatement",
    "sequence",
)
# The second of these pairs makes sense only when the first has been told.
ORDERED_KINDS: tuple[str, ...] = ("elaboration", "sequence")


@dataclass(frozen=True, slots=True)
class Entity:
    """Someone or something that facts are about or mention.

    `name` is the full name, `short_name` what is said once it is clear who is meant, `nouns`
    what "the …" can call it. `phrase` is the noun phrase of the full name.
    """

    id: str
    name: str
    short_name: str
    gender: Gender
    number: Number
    animate: bool
    nouns: tuple[str, ...]
    phrase: NounPhrase = field(init=False)
    short_phrase: NounPhrase = field(init=False)
    pronoun: NounPhrase = field(init=False)
    descriptions: tuple[NounPhrase, ...] = field(init=False)

    def __post_init__(self) -> None:
        def phrase(words: str) -> NounPhrase:
            article, _, rest = words.partition(" ")
            determiner, noun = ("the", rest) if article.lower() == "the" and rest else ("", words)
            return NounPhrase(
                noun,
                determiner=determiner,
                number=self.number,
                gender=self.gender,
                animate=self.animate,
                entity=self.id,
            )

        full = phrase(self.name)
        object.__setattr__(self, "phrase", full)
        object.__setattr__(self, "short_phrase", phrase(self.short_name))
        object.__setattr__(self, "pronoun", replace(full, pronoun=True))
        described = tuple(phrase(f"the {noun}") for noun in self.nouns)
        object.__setattr__(self, "descriptions", described)


@dataclass(frozen=True, slots=True)
class Fact:
    """One proposition: its clause in deep syntax, and what planning needs to know of it.

    `clause.negated` is what is true; `polarity` is whether it is good or bad news: never the
    same thing. The clause names concepts of the lexicon where it has them.
    """

    id: str
    clause: Clause
    polarity: Polarity
    strength: Strength
    topic: str
    chapter: int
    source: str
    line: int
    mentions: frozenset[str]


@dataclass(frozen=True, slots=True)
class Relation:
    """A rhetorical relation that holds between two facts (Mann & Thompson 1988)."""

    kind: RelationKind
    nucleus: str
    satellite: str
    line: int = 0


@dataclass(frozen=True, slots=True)
class Character:
    """All that is known of one entity; any kind of thing can be the character."""

    entity: Entity
    entities: dict[str, Entity]
    facts: tuple[Fact, ...]
    relations: tuple[Relation, ...]
    source: str
    file: str
    by_id: dict[str, Fact] = field(init=False)
    related: dict[str, tuple[Relation, ...]] = field(init=False)
    prerequisites: dict[str, tuple[str, ...]] = field(init=False)

    def __post_init__(self) -> None:
        related: dict[str, tuple[Relation, ...]] = {}
        prerequisites: dict[str, tuple[str, ...]] = {}
        for relation in self.relations:
            for end in (relation.nucleus, relation.satellite):
                related[end] = (*related.get(end, ()), relation)
            if relation.kind in ORDERED_KINDS:
                first, second = relation.nucleus, relation.satellite
                prerequisites[second] = (*prerequisites.get(second, ()), first)
        object.__setattr__(self, "by_id", {fact.id: fact for fact in self.facts})
        object.__setattr__(self, "related", related)
        object.__setattr__(self, "prerequisites", prerequisites)
