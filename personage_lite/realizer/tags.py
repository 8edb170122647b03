"""Tag questions that agree with their clause: "isn't she?", "did they?", "are there?"."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from personage_lite.realizer.agreement import agreement, existential_agreement
from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.number import is_plural
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Embedded,
    NounPhrase,
    Person,
    Phrase,
    PrepositionalPhrase,
    Sentence,
    Text,
)
from personage_lite.realizer.verb_group import verb_group

if TYPE_CHECKING:
    from personage_lite.realizer.syntax import Syntax

IT = NounPhrase("", pronoun=True)


def raises_negation(sentence: Sentence, grammar: Grammar) -> bool:
    """Whether the frame of a clause is negative for it: "I don't think she's here, is she?"."""
    body = sentence.joined[-1].body if sentence.joined else sentence.body
    if not isinstance(body, Embedded):
        return False
    words = [word for part in body.lead.parts if isinstance(part, str) for word in part.split()]
    negatives = grammar.negative_contractions.values()
    return any(word in grammar.negators or word in negatives for word in words)


def tagged_clause(sentence: Sentence) -> Clause | None:
    """Return the clause that a tag question agrees with: the last one; fixed words have none."""
    body: object = sentence.joined[-1].body if sentence.joined else sentence.body
    while isinstance(body, Coordination):
        body = body.items[-1]
    if isinstance(body, Embedded):
        body = body.clause if body.inner_tag else None
    if not isinstance(body, Clause) or body.form != "finite":
        return None
    return None if body.mood in ("interrogative", "exclamative") else body


def tag_question(
    syntax: Syntax, out: list[str], clause: Clause, subject: Phrase | None, negative: bool
) -> None:
    """Add the tag question of a clause; `subject` is its own or the one that it shares.

    `negative` says that what stands around the clause makes it so.
    """
    grammar = syntax.grammar
    out.append(",")
    if clause.mood == "imperative":
        first = subject is not None and agreement(subject, grammar) == (1, True)
        out.append(grammar.imperative_tags["first" if first else "second"])
        return
    asked = _pronoun(subject, grammar)
    if clause.existential:
        agrees = existential_agreement(subject, grammar)
    else:
        agrees = agreement(asked, grammar)
    finite = verb_group(clause, agrees, grammar, support=True).finite
    if not (negative or _sounds_negative(clause, subject, grammar)):
        finite = (
            grammar.tag_negatives.get(finite) or grammar.negative_contractions.get(finite) or finite
        )
    out.append(finite)
    if clause.existential:
        out.append(grammar.words.existential)
    else:
        syntax.phrase(out, asked, "subjective")


def _pronoun(subject: Phrase | None, grammar: Grammar) -> NounPhrase:
    """Return the pronoun that a tag question asks after a subject with."""
    if isinstance(subject, Text) and len(subject.parts) == 1:
        part = subject.parts[0]
        subject = part.phrase if isinstance(part, Cased) else part
    if isinstance(subject, NounPhrase):
        if subject.pronoun:
            return subject._replace(relative=None, apposition=None, modifiers=(), interruption="")
        if subject.noun in grammar.repeated_in_tags and not subject.determiner:
            return NounPhrase(subject.noun)
        # "Neither of them, did they?", but of things "did it?"
        word = subject.noun or (subject.determiner if subject.animate else "")
        plural = is_plural(subject, grammar) or word in grammar.plural_in_tags
        return NounPhrase(
            subject.noun,
            number="plural" if plural else "singular",
            gender=subject.gender,
            person=subject.person,
            pronoun=True,
        )
    if isinstance(subject, str) and (
        subject in grammar.plural_in_tags or subject.rsplit(" ", 1)[-1] in grammar.plural_in_tags
    ):
        return IT._replace(number="plural")
    if isinstance(subject, Coordination):
        people = [agreement(item, grammar)[0] for item in subject.items if _names(item)]
        if people:
            # "Either Alice or Bill runs, don't they?", "neither you nor I do, do we?"
            return IT._replace(number="plural", person=cast(Person, min(people)))
    return IT


def _names(phrase: Phrase) -> bool:
    """Whether a phrase names somebody or something, as no infinitive does."""
    return isinstance(phrase, NounPhrase | Text | str)


def _sounds_negative(clause: Clause, subject: Phrase | None, grammar: Grammar) -> bool:
    """Whether a tag must be positive: "she never runs, does she?", "… nobody, does she?"."""
    if clause.negated or _negative_adverbs(clause.adverbs, grammar):
        return True
    objects = (clause.indirect_object, clause.object, clause.complement, clause.agent)
    said = (subject, *objects, *clause.preposed, *clause.adverbials)
    return any(_negative(phrase, grammar) for phrase in said)


def _negative(phrase: Phrase | None, grammar: Grammar) -> bool:
    """Whether a phrase begins with a negator: "nobody", "no friends", "hardly curious"."""
    if isinstance(phrase, str):
        return phrase in grammar.negative_determiners or _negative_word(phrase, grammar)
    if isinstance(phrase, AdjectivePhrase):
        return _negative_adverbs(phrase.adverbs, grammar)
    if isinstance(phrase, Coordination):
        if phrase.correlative and phrase.conjunction in grammar.correlatives:
            return _negative_word(grammar.correlatives[phrase.conjunction], grammar)
        return _negative(phrase.items[0], grammar)
    if isinstance(phrase, Text):
        part = phrase.parts[0]
        return _negative(part.phrase if isinstance(part, Cased) else part, grammar)
    if isinstance(phrase, PrepositionalPhrase):
        return _negative(phrase.object, grammar)
    if isinstance(phrase, NounPhrase) and not phrase.pronoun:
        if phrase.predeterminer:
            words = f"{phrase.predeterminer} {phrase.determiner or phrase.noun}"
            return _negative_word(words, grammar)
        if phrase.determiner in grammar.negative_determiners:
            return True
        if phrase.determiner or phrase.possessor is None:
            return _negative_word(phrase.determiner or phrase.noun, grammar)
        return _negative(phrase.possessor, grammar)
    return False


def _negative_word(words: str, grammar: Grammar) -> bool:
    first, _, rest = words.partition(" ")
    if first in grammar.approximators:
        return _negative_word(rest, grammar)
    return first in grammar.negators and not words.startswith(grammar.not_negative)


def _negative_adverbs(adverbs: tuple[str, ...], grammar: Grammar) -> bool:
    return any(
        not grammar.negators.isdisjoint(adverb.split())
        for adverb in adverbs
        if adverb not in grammar.not_negative
    )
