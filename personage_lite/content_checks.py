"""What is wrong with a character's facts although their form is right: `personage-lite check`.

Facts said twice or against each other, facts that cannot be said, topics and relations that
nothing supports. Each fault names the line and what to do.
"""

from __future__ import annotations

from collections.abc import Iterator

from personage_lite.errors import DataError
from personage_lite.facts import Character, Fact, Relation
from personage_lite.lexicon import Lexicon
from personage_lite.realizer import Realizer
from personage_lite.realizer.reader import MisreadError
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Embedded,
    Phrase,
    Sentence,
)
from personage_lite.sentence_planner.templates import fits, framed, plain_clauses

# The most words that one fact takes: more cannot be followed inside a longer sentence.
MOST_WORDS = 24
# These say opposite things of one pair: that it is no wonder, and that it is one.
_AT_ODDS = ({"justification", "concession"}, {"justification", "contrast"})


def content_faults(character: Character, lexicon: Lexicon) -> list[DataError]:
    """Return the faults of a character that no reader of one fact alone can see."""
    realizer = Realizer(lexicon.grammar)
    return [
        *_said_twice(character),
        *_opposite_attributes(character, lexicon),
        *_unsayable(character, lexicon, realizer),
        *_following_nothing(character),
        *_empty_topics(character),
        *_relation_faults(character),
    ]


def _fault(character: Character, line: int, what: str, remedy: str) -> DataError:
    return DataError(character.file, line, what, remedy)


def _said_twice(character: Character) -> Iterator[DataError]:
    """Find facts with the same words, both true or one denied."""
    seen: dict[object, Fact] = {}
    for fact in character.facts:
        key = fact.clause._replace(negated=False, negator="not")
        if key in seen:
            other = seen[key]
            same = other.clause.negated == fact.clause.negated
            what = "says the same as" if same else "contradicts"
            yield _fault(
                character, fact.line, f"'{fact.id}' {what} '{other.id}'", "remove one of the two"
            )
        seen[key] = fact


def _opposite_attributes(character: Character, lexicon: Lexicon) -> Iterator[DataError]:
    """Find attributes of one subject that are synonyms, or each other's opposite."""
    restated = {
        frozenset((relation.nucleus, relation.satellite))
        for relation in character.relations
        if relation.kind == "restatement"
    }
    seen: list[tuple[Fact, Phrase | None, frozenset[str], frozenset[str]]] = []
    for fact in character.facts:
        said = fact.clause.complement
        if not isinstance(said, AdjectivePhrase) or fact.clause.negated:
            continue
        concept = lexicon.adjectives.get(said.adjective)
        synonyms = [word.text for word in concept.words] if concept else []
        words = frozenset((said.adjective, *synonyms))
        opposite = frozenset(concept.antonyms) if concept else frozenset()
        for other, subject, others, against in seen:
            if subject != fact.clause.subject or other.clause == fact.clause:
                continue
            if opposite & others or against & words:
                yield _fault(
                    character,
                    fact.line,
                    f"'{fact.id}' contradicts '{other.id}'",
                    "remove one of the two, or choose an attribute that is not its opposite",
                )
            elif words & others and frozenset((fact.id, other.id)) not in restated:
                yield _fault(
                    character,
                    fact.line,
                    f"'{fact.id}' can be said in the words of '{other.id}'"
                    f" ({', '.join(sorted(words & others))})",
                    "choose another attribute, or join the two by a restatement",
                )
        seen.append((fact, fact.clause.subject, words, opposite))


def _unsayable(character: Character, lexicon: Lexicon, realizer: Realizer) -> Iterator[DataError]:
    """Find facts that cannot be said plainly or in a template that they are offered."""
    name = character.entity.phrase
    for key, plan in plain_clauses(character, lexicon).items():
        fact = character.by_id[key]
        bodies = [Sentence(fact.clause)]
        if fact.following is not None:
            bodies.append(Sentence(fact.following))
        for templates in lexicon.templates.values():
            for template in templates:
                if template.marker.polarity in ("", plan.polarity) and fits(template, plan):
                    said = framed(plan, template, lexicon, name)
                    frame = said.frame
                    if frame is not None and frame.lead is not None and template.lead:
                        body = Embedded(frame.lead, said.clause, frame.complementizer)
                        bodies.append(Sentence(body))
        try:
            texts = [realizer.realize(body) for body in bodies]
        except MisreadError as error:
            yield _fault(character, fact.line, error.what, error.remedy)
            continue
        text = texts[0]
        if any("  " in said or " ," in said for said in texts):
            yield _fault(character, fact.line, f"'{key}' reads: {text}", "mend its words")
        words = len(text.split())
        if words > MOST_WORDS:
            yield _fault(
                character,
                fact.line,
                f"'{key}' takes {words} words",
                f"make it two facts of at most {MOST_WORDS} words",
            )


def _following_nothing(character: Character) -> Iterator[DataError]:
    """Find facts whose words for after the fact before can never be said."""
    before = ""
    for fact in character.facts:
        if fact.following is not None and fact.topic != before:
            yield _fault(
                character,
                fact.line,
                f"'{fact.id}' follows no fact of its topic",
                "remove its 'following', or move it after the fact that it leans on",
            )
        before = fact.topic


def _empty_topics(character: Character) -> Iterator[DataError]:
    for topic in character.topics.values():
        if topic.name not in character.by_topic:
            yield _fault(
                character,
                topic.line,
                f"no fact has the topic '{topic.name}'",
                "remove it, or give it to facts",
            )


def _relation_faults(character: Character) -> Iterator[DataError]:
    """Find relations told twice or against each other, the facts' order or their news."""
    seen: dict[frozenset[str], Relation] = {}
    for relation in character.relations:
        pair = frozenset((relation.nucleus, relation.satellite))
        other = seen.get(pair)
        if other is not None:
            if other[:3] == relation[:3]:
                yield _fault(character, relation.line, f"a second {relation.kind}", "remove it")
            elif {other.kind, relation.kind} in _AT_ODDS or other.kind == relation.kind:
                yield _fault(
                    character,
                    relation.line,
                    f"{relation.kind} of '{relation.nucleus}' and '{relation.satellite}' goes"
                    f" against the {other.kind} of the two",
                    "keep the one that is true",
                )
        seen[pair] = relation
        yield from _unsupported(character, relation)


def _unsupported(character: Character, relation: Relation) -> Iterator[DataError]:
    """Find a relation that its two facts do not support."""
    first, second = (character.by_id[key] for key in (relation.nucleus, relation.satellite))
    if relation.kind == "sequence" and 0 < second.chapter < first.chapter:
        yield _fault(
            character,
            relation.line,
            f"'{second.id}' (chapter {second.chapter}) is told after '{first.id}'"
            f" (chapter {first.chapter})",
            "exchange the two, or mend a chapter",
        )
    if relation.kind == "restatement" and {first.polarity, second.polarity} == {"good", "bad"}:
        yield _fault(
            character,
            relation.line,
            f"'{first.id}' is good news and its restatement '{second.id}' bad",
            "give both the same polarity, or remove the restatement",
        )
