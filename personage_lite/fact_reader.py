"""Reads one fact of a facts file into its clause, with its mentions and its planning values."""

from __future__ import annotations

import re
from typing import cast

from personage_lite.errors import nearest
from personage_lite.facts import (
    FEELINGS,
    POLARITIES,
    STRENGTHS,
    UNFELT,
    Entity,
    Fact,
    Feeling,
    Polarity,
    Strength,
    entity_of,
)
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Case,
    Cased,
    Clause,
    NounPhrase,
    Number,
    Tense,
    Text,
)
from personage_lite.yaml_reader import Node

IDENTIFIER = re.compile(r"[a-z][a-z0-9_]*\Z")
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
    *("feeling", "topic", "chapter", "source", "following"),
)
# What is said in other words right after the fact before.
_FOLLOWING = ("indirect_object", "object", "complement", "adverbials", "adverb")


class FactReader:
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

    def _following(self, item: Node, clause: Clause) -> Clause | None:
        """Read how the clause is said right after the fact before it, if that is given."""
        found = item.get("following")
        if found is None:
            return None
        found.only(_FOLLOWING)
        told = clause._replace(
            indirect_object=self._optional_text(found, "indirect_object") or clause.indirect_object,
            object=self._optional_text(found, "object") or clause.object,
            complement=self._optional_text(found, "complement") or clause.complement,
        )
        if found.get("adverbials") is not None:
            told = told._replace(adverbials=self._adverbials(found))
        if found.get("adverb") is not None:
            told = told._replace(adverbs=(_words(found, "adverb"),))
        found.done()
        return told

    def _adverbials(self, item: Node) -> tuple[Text, ...]:
        found = item.get("adverbials")
        return tuple(self.text(node) for node in found.sequence()) if found is not None else ()

    def fact(self, item: Node) -> Fact:
        """Read one fact into its clause and its planning values."""
        self._mentions = set()
        item.only(_FIELDS)
        key = item.need("id").text()
        if not IDENTIFIER.match(key):
            raise item.need("id").fault(f"'{key}' is no id", "use small letters, digits and _")
        attribute = item.get("attribute")
        complement = item.get("complement")
        if attribute is not None and complement is not None:
            raise item.fault("both attribute and complement", "keep one of the two")
        described = attribute is not None or complement is not None
        predicate = item.get("predicate")
        if predicate is None and not described:
            raise item.fault("'predicate' is missing", "add the verb, 'predicate: …'")
        verb = _words(item, "predicate") or "be"
        subject = self._subject(item)
        clause = Clause(
            verb=verb,
            subject=subject,
            particle=_words(item, "particle"),
            indirect_object=self._optional_text(item, "indirect_object"),
            object=self._optional_text(item, "object"),
            complement=AdjectivePhrase(_words(item, "attribute"))
            if attribute is not None
            else self._optional_text(item, "complement"),
            adverbials=self._adverbials(item),
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
        polarity = item.choice_of("polarity", POLARITIES, "neutral")
        feeling = item.choice_of("feeling", FEELINGS, "")
        if UNFELT.get(feeling) == polarity:
            raise item.fault(f"{polarity} news that is {feeling}", "change polarity or feeling")
        following = self._following(item, clause)
        fact = Fact(
            id=key,
            about=entity_of(subject.possessor) or subject.entity,
            clause=clause,
            polarity=cast(Polarity, polarity),
            strength=cast(Strength, item.choice_of("strength", STRENGTHS, "plainly")),
            topic=item.need("topic").text(),
            chapter=0 if chapter is None else chapter.integer(1, 999),
            source=item.text_of("source"),
            line=item.line,
            mentions=frozenset(self._mentions),
            feeling=cast(Feeling, feeling),
            following=following,
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
