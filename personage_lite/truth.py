"""A checker of truth: reads what the final clauses say and holds it against the facts.

It does not look at the trace. Every clause of the realizer's input is taken apart into the
propositions that a listener would hear (coordinations, relative clauses, "with …", negated
antonyms, ellipses resolved) and each must be one of the facts; and every cue word must have its
relation behind it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from personage_lite.facts import Character, Fact, entity_of
from personage_lite.lexicon import Lexicon
from personage_lite.plan import Utterance
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Embedded,
    NounPhrase,
    Phrase,
    Relative,
    Sentence,
    Text,
)

_CUES = {
    "contrast_cue_word": "contrast",
    "justify_cue_word": "justification",
    "concede_cue_word": "concession",
    "sequence_cue_word": "sequence",
}
# How cue words join what comes next, not what is subordinate.
_NEXT = ("coordinate", "connective", "beginning")
# What a clause's own time and mood must share with its fact's.
_SAME = ("tense", "modal", "perfect", "progressive", "passive", "quotation")


class _Heard(NamedTuple):
    """A clause as heard, with the entity its subject stands for where that is left unsaid."""

    clause: Clause
    owner: str = ""


def truth_faults(utterance: Utterance, character: Character, lexicon: Lexicon) -> list[str]:
    """Return what is wrong between the facts planned and the clauses said; empty if nothing."""
    planned = {message.fact.id for message in utterance.plan.messages}
    checker = _Checker(character, lexicon, planned)
    stated = checker.read(utterance.sentences)
    faults = checker.faults
    faults += [f"not stated: {key}" for key in sorted(planned - stated)]
    faults += [f"not planned: {key}" for key in sorted(stated - planned)]
    if planned != {*utterance.facts, *utterance.recalled}:
        faults.append("the record's facts are not those planned")
    return faults


class _Checker:
    def __init__(self, character: Character, lexicon: Lexicon, planned: set[str]) -> None:
        self._character = character
        self._planned = planned
        self._lexicon = lexicon
        self.faults: list[str] = []
        # The facts heard so far, for those that lean on the one before.
        self._heard: set[str] = set()
        self._before = {fact.id: other.id for other, fact in pairwise(character.facts)}
        self._hedges = {
            marker.text
            for marker in lexicon.markers["softener_hedges"]
            if marker.place == "quantity"
        }

    def read(self, sentences: tuple[Sentence, ...]) -> set[str]:
        """Return the ids of the facts that the sentences state."""
        stated: set[str] = set()
        before: set[str] = set()
        owner = ""
        for sentence in sentences:
            main = sentence.body
            if not isinstance(main, Clause | Embedded):
                continue
            groups: list[tuple[str, set[str]]] = []
            setting: Phrase | None = None
            bodies = [("", main, False)]
            bodies += [
                (join.conjunction, join.body, join.shared_subject) for join in sentence.joined
            ]
            for cue, body, shared in bodies:
                clause = body.clause if isinstance(body, Embedded) else body
                if shared and groups:
                    # What is heard as its subject is the subject of the clause before.
                    clause = clause._replace(subject=self._subject_before)
                facts = self._clause(clause, owner)
                self._subject_before = clause.subject
                owner = entity_of(clause.subject) or owner
                for phrase in clause.preposed:
                    setting = phrase
                if setting is not None:
                    self._setting(setting, facts)
                if groups:
                    self._relation(cue, groups[-1][1], facts, coordinate=True)
                groups.append((cue, facts))
            begun = [opener.text for opener in sentence.openers]
            for cue in filter(None, (sentence.connective, *begun)):
                self._relation(cue, before, groups[0][1], coordinate=True)
            before = groups[-1][1]
            stated.update(*(facts for _, facts in groups))
        return stated

    _subject_before: Phrase | None = None

    def _setting(self, said: Phrase, facts: set[str]) -> None:
        """Require that all a sentence states happens where or when it begins by saying."""
        for key in sorted(facts):
            topic = self._character.topics[self._character.by_id[key].topic]
            if topic.setting is None or not self._same_phrase(said, topic.setting):
                self.faults.append(f"'{key}' is not set where it is said to be: {said}")

    def _clause(self, clause: Clause, owner: str) -> set[str]:
        """Return the facts that a clause and the clauses inside it state."""
        main: set[str] = set()
        for heard in self._propositions(clause, owner):
            found = {fact.id for fact in self._character.facts if self._states(heard, fact)}
            if not found:
                self.faults.append(f"states no fact: {heard.clause}")
            # Two facts can share an antonym ("isn't gentle"): hear the one that was meant.
            main |= found & self._planned or found
            self._heard |= main
        inner: set[str] = set()
        for subordinate in clause.subordinates:
            facts = self._clause(subordinate.clause, entity_of(clause.subject) or owner)
            self._relation(subordinate.conjunction, main, facts, coordinate=False)
            inner |= facts
        return main | inner

    def _propositions(self, clause: Clause, owner: str) -> Iterator[_Heard]:
        subject = clause.subject
        bare = clause._replace(subordinates=(), asides=())
        if isinstance(subject, NounPhrase) and subject.relative is not None:
            about = subject._replace(relative=None)
            yield from self._relative(subject.relative, about, owner)
            bare = bare._replace(subject=about)
        for aside in clause.asides:
            yield _Heard(self._aside(aside, bare), entity_of(subject))
        for phrase in (clause.object, clause.complement, *clause.adverbials):
            if isinstance(phrase, Text):
                for part in phrase.parts:
                    if isinstance(part, Cased) and part.phrase.relative is not None:
                        about = part.phrase._replace(relative=None)
                        yield from self._relative(part.phrase.relative, about, owner)
        said = clause.complement
        described = said.relative if isinstance(said, NounPhrase) else None
        if described is not None and described.restrictive:
            yield from self._relative(described, bare.subject, owner)
        elif isinstance(said, Coordination):
            for item in said.items:
                yield _Heard(bare._replace(complement=item), owner)
        elif isinstance(clause.object, Coordination):
            for item in clause.object.items:
                yield _Heard(bare._replace(object=item), owner)
        else:
            yield _Heard(bare, owner)

    def _relative(self, said: Relative, about: Phrase | None, owner: str) -> Iterator[_Heard]:
        """Return what a relative clause, or several joined, says of the one it describes."""
        items = said.clause.items if isinstance(said.clause, Coordination) else (said.clause,)
        for item in items:
            if isinstance(item, Clause):
                yield from self._propositions(item._replace(subject=about), owner)

    def _aside(self, aside: Phrase, host: Clause) -> Clause:
        """Return what "with …" says of its host's subject."""
        assert isinstance(aside, Text)
        what = aside.parts[1:]
        first = what[0] if what else ""
        if isinstance(first, Cased) and first.phrase.adjectives:
            part = first.phrase._replace(adjectives=(), possessor=host.subject)
            return Clause("be", part, complement=first.phrase.adjectives[0])
        return Clause("have", host.subject, object=Text(what))

    # Comparing one clause with one fact

    def _states(self, heard: _Heard, fact: Fact) -> bool:
        """Whether a clause states a fact, in words that need no other or after the one before."""
        if self._says(heard, fact.clause):
            return True
        if fact.following is None or self._before.get(fact.id) not in self._heard:
            return False
        return self._says(heard, fact.following)

    def _says(self, heard: _Heard, meant: Clause) -> bool:
        clause = heard.clause
        if any(getattr(clause, name) != getattr(meant, name) for name in _SAME):
            return False
        if not self._same_subject(clause.subject, meant.subject, heard.owner):
            return False
        if not self._same_verb(clause, meant) or not self._same_adverbs(clause, meant):
            return False
        if not self._same_quality(clause, meant):
            return False
        pairs = (
            (clause.indirect_object, meant.indirect_object),
            (clause.object, meant.object),
        )
        if not all(self._same_phrase(one, other) for one, other in pairs):
            return False
        return len(clause.adverbials) == len(meant.adverbials) and all(
            self._same_phrase(one, other)
            for one, other in zip(clause.adverbials, meant.adverbials, strict=True)
        )

    def _same_subject(self, one: Phrase | None, other: Phrase | None, owner: str) -> bool:
        if not isinstance(one, NounPhrase) or not isinstance(other, NounPhrase):
            return one == other
        if other.possessor is None:
            return one.entity == other.entity
        possessor = owner if one.possessor is None else entity_of(one.possessor)
        return (
            one.noun == other.noun
            and one.number == other.number
            and possessor == entity_of(other.possessor)
        )

    def _same_verb(self, clause: Clause, meant: Clause) -> bool:
        if (clause.verb, clause.particle) == (meant.verb, meant.particle):
            return True
        concept = self._lexicon.verbs.get(meant.verb)
        words = concept.words if concept is not None and not meant.particle else ()
        return any((clause.verb, clause.particle) == (word.text, word.particle) for word in words)

    def _same_adverbs(self, clause: Clause, meant: Clause) -> bool:
        also = {marker.text for marker in self._lexicon.markers["also_cue_word"]}
        return tuple(word for word in clause.adverbs if word not in also) == meant.adverbs

    def _same_quality(self, clause: Clause, meant: Clause) -> bool:
        one, other = clause.complement, meant.complement
        truth = (clause.negated, clause.negated and clause.negator)
        meant_truth = (meant.negated, meant.negated and meant.negator)
        if isinstance(one, AdjectivePhrase) and isinstance(other, AdjectivePhrase):
            concept = self._lexicon.adjectives.get(other.adjective)
            words = {word.text for word in concept.words} if concept else set()
            if one.adjective in words | {other.adjective}:
                return truth == meant_truth
            antonyms = concept.antonyms if concept else ()
            return one.adjective in antonyms and clause.negated and not meant.negated
        return truth == meant_truth and self._same_phrase(one, other)

    def _same_phrase(self, one: Phrase | None, other: Phrase | None) -> bool:
        if not isinstance(one, Text) or not isinstance(other, Text):
            return one is None and other is None
        # "Around forty" is a hedge, "bosses the pack around" is not.
        hedged = one.parts[0] in self._hedges and one.parts[0] != other.parts[0]
        said = one.parts[1:] if hedged else one.parts
        return len(said) == len(other.parts) and all(
            (left.phrase.entity, left.case) == (right.phrase.entity, right.case)
            if isinstance(left, Cased) and isinstance(right, Cased)
            else left == right
            for left, right in zip(said, other.parts, strict=True)
        )

    # Cue words

    def _relation(self, cue: str, before: set[str], facts: set[str], coordinate: bool) -> None:
        """Require a relation of the kind that a cue word claims, in its direction."""
        claims = [
            (kind, marker.role)
            for name, kind in _CUES.items()
            for marker in self._lexicon.markers[name]
            if marker.text == cue and (marker.attach in _NEXT) == coordinate
        ]
        if claims and not any(self._holds(kind, role, before, facts) for kind, role in claims):
            self.faults.append(f"'{cue}' without its relation: {before} / {facts}")

    def _holds(self, kind: str, role: str, before: set[str], facts: set[str]) -> bool:
        for relation in self._character.relations:
            if relation.kind != kind:
                continue
            ends = (relation.nucleus, relation.satellite)
            forward = ends[0] in before and ends[1] in facts
            backward = ends[1] in before and ends[0] in facts
            polarities = {self._character.by_id[end].polarity for end in ends}
            either = kind == "contrast" or (kind == "concession" and polarities == {"good", "bad"})
            if (forward and (role != "nucleus" or either)) or (
                backward and (role == "nucleus" or either)
            ):
                return True
        return False
