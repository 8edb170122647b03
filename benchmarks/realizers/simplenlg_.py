"""The sentences in the terms of SimpleNLG's Python port; java/Sentences.java has the same ones."""

# mypy: disable-error-code="import-untyped, import-not-found"

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from simplenlg import (
    ClauseStatus,
    Feature,
    Form,
    InternalFeature,
    InterrogativeType,
    Lexicon,
    NLGFactory,
    Realiser,
    Tense,
)

from realizers import Builders

Element = Any

LEXICON = Lexicon.getDefaultLexicon()
FACTORY = NLGFactory(LEXICON)
REALISER = Realiser(LEXICON)
REALISER.setCommaSepCuephrase(True)  # A comma after a clause in front.

PAST = {Feature.TENSE: Tense.PAST}
PERFECT = {Feature.PERFECT: True}
PROGRESSIVE = {Feature.PROGRESSIVE: True}
PASSIVE = {Feature.PASSIVE: True}
NEGATED = {Feature.NEGATED: True}
ASKED = Feature.INTERROGATIVE_TYPE
INFINITIVE = {Feature.FORM: Form.INFINITIVE}


def noun(determiner: str | Element | None, word: str, *adjectives: str | Element) -> Element:
    """Return a noun phrase."""
    phrase = FACTORY.createNounPhrase(determiner, word)
    for adjective in adjectives:
        phrase.addPreModifier(adjective)
    return phrase


def plural(determiner: str | Element | None, word: str, *adjectives: str) -> Element:
    """Return a noun phrase in the plural."""
    phrase = noun(determiner, word, *adjectives)
    phrase.setPlural(True)
    return phrase


def possessive(phrase: Element) -> Element:
    """Return this noun phrase as a possessor."""
    phrase.setFeature(Feature.POSSESSIVE, True)
    return phrase


def preposition(word: str, phrase: Element) -> Element:
    """Return a prepositional phrase."""
    return FACTORY.createPrepositionPhrase(word, phrase)


def with_modifier(phrase: Element, modifier: Element) -> Element:
    """Return this phrase with a modifier after it."""
    phrase.addPostModifier(modifier)
    return phrase


def adjective(word: str, feature: str) -> Element:
    """Return an adjective phrase in a degree."""
    phrase = FACTORY.createAdjectivePhrase(word)
    phrase.setFeature(feature, True)
    return phrase


def both(*items: str | Element) -> Element:
    """Return these joined by "and"."""
    coordination = FACTORY.createCoordinatedPhrase()
    for item in items:
        coordination.addCoordinate(item)
    return coordination


def clause(
    subject: str | Element | None,
    verb: str,
    direct_object: str | Element | None = None,
    *features: dict[str, Any],
    indirect_object: str | None = None,
    complement: str | Element | None = None,
    modifier: str | Element | None = None,
    adverb: str | None = None,
    front: Element | None = None,
) -> Element:
    """Return a clause."""
    built = FACTORY.createClause(subject, verb, direct_object)
    for each in features:
        for name, value in each.items():
            built.setFeature(name, value)
    if indirect_object is not None:
        built.setIndirectObject(indirect_object)
    if complement is not None:
        built.addComplement(complement)
    if modifier is not None:
        built.addPostModifier(modifier)
    if adverb is not None:
        built.addPreModifier(adverb)
    if front is not None:
        built.addFrontModifier(front)
    return built


def subordinate(conjunction: str, built: Element) -> Element:
    """Return this clause under a conjunction."""
    built.setFeature(InternalFeature.CLAUSE_STATUS, ClauseStatus.SUBORDINATE)
    built.setFeature(Feature.COMPLEMENTISER, conjunction)
    return built


def predicate(verb: str, direct_object: Element) -> Element:
    """Return a verb phrase."""
    phrase = FACTORY.createVerbPhrase(verb)
    phrase.setObject(direct_object)
    return phrase


def clause_of(subject: str, phrase: Element) -> Element:
    """Return a clause with this verb phrase."""
    built = FACTORY.createClause()
    built.setSubject(subject)
    built.setVerbPhrase(phrase)
    return built


SPECIFICATIONS: dict[str, Callable[[], Element]] = {
    "copula": lambda: clause("Alice", "be", noun("a", "girl", "imaginative")),
    "negation": lambda: clause(
        noun("the", "Queen of Hearts"), "like", plural(None, "rose", "white"), NEGATED
    ),
    "although": lambda: clause(
        noun("the", "Queen"),
        "shout",
        front=subordinate("although", clause("she", "be", complement="small")),
    ),
    "passive_perfect": lambda: clause(plural("the", "card"), "chase", "she", PASSIVE, PERFECT),
    "possessive_pronoun": lambda: clause(
        noun("the", "White Rabbit"), "lose", plural(possessive(noun(None, "he")), "glove"), PAST
    ),
    "future": lambda: clause(
        noun("the", "Cheshire Cat"),
        "grin",
        None,
        {Feature.TENSE: Tense.FUTURE},
        complement=preposition("at", noun("the", "Duchess")),
    ),
    "past_progressive": lambda: clause(
        noun("the", "Hatter"),
        "drink",
        noun(None, "tea"),
        PAST,
        PROGRESSIVE,
        complement=preposition("with", noun("the", "March Hare")),
    ),
    "past_perfect": lambda: clause("Alice", "eat", noun("the", "cake", "small"), PAST, PERFECT),
    "passive_past": lambda: clause(
        noun("the", "Knave"), "steal", plural("the", "tart"), PAST, PASSIVE
    ),
    "modal_negation": lambda: clause(
        noun("the", "Dormouse"), "stay", None, {Feature.MODAL: "can"}, NEGATED, complement="awake"
    ),
    "modal_perfect": lambda: clause(
        noun("the", "Knave"), "steal", plural("the", "tart"), {Feature.MODAL: "must"}, PERFECT
    ),
    "yes_no": lambda: clause(
        noun("the", "Caterpillar"), "smoke", noun("a", "pipe"), {ASKED: InterrogativeType.YES_NO}
    ),
    "yes_no_past": lambda: clause(
        noun("the", "King"),
        "forgive",
        noun("the", "Knave"),
        PAST,
        {ASKED: InterrogativeType.YES_NO},
    ),
    "who": lambda: clause(
        None, "steal", plural("the", "tart"), PAST, {ASKED: InterrogativeType.WHO_SUBJECT}
    ),
    "what": lambda: clause(
        noun("the", "Rabbit"), "lose", None, PAST, {ASKED: InterrogativeType.WHAT_OBJECT}
    ),
    "where": lambda: clause(noun("the", "Duchess"), "live", None, {ASKED: InterrogativeType.WHERE}),
    "why": lambda: clause(
        noun("the", "Hatter"), "sing", None, PROGRESSIVE, {ASKED: InterrogativeType.WHY}
    ),
    "relative_subject": lambda: clause(
        "Alice",
        "follow",
        with_modifier(
            noun("a", "rabbit"), subordinate("that", clause(None, "wear", noun("a", "waistcoat")))
        ),
    ),
    "relative_object": lambda: clause(
        with_modifier(noun("the", "key"), subordinate("that", clause("Alice", "find", None, PAST))),
        "open",
        noun("a", "door", "little"),
    ),
    "because": lambda: clause(
        noun("the", "Rabbit"),
        "hurry",
        modifier=subordinate("because", clause("he", "be", complement="late")),
    ),
    "when": lambda: clause(
        plural("the", "gardener"),
        "fall",
        None,
        PAST,
        front=subordinate("when", clause(noun("the", "Queen"), "shout", None, PAST)),
    ),
    "and_names": lambda: clause(
        both(noun("the", "Hatter"), noun("the", "March Hare"), noun("the", "Dormouse")),
        "be",
        plural(None, "friend"),
    ),
    "and_adjectives": lambda: clause("Alice", "be", both("kind", "curious", "polite")),
    "and_clauses": lambda: both(
        clause(noun("the", "Queen"), "shout"), clause(plural("the", "gardener"), "tremble")
    ),
    "and_predicates": lambda: clause_of(
        "Alice",
        both(predicate("open", noun("the", "bottle")), predicate("drink", noun("the", "potion"))),
    ),
    "irregular_plurals": lambda: clause(
        plural("the", "child"), "feed", both(plural("two", "goose"), plural("three", "mouse"))
    ),
    "possessive": lambda: clause(
        noun(possessive(noun(None, "Alice")), "sister"), "read", noun("a", "book")
    ),
    "plural_possessive": lambda: clause(
        plural(possessive(plural("the", "gardener")), "brush"), "be", complement="red"
    ),
    "pronouns": lambda: clause(
        "they", "give", noun("a", "key", "golden"), PAST, indirect_object="she"
    ),
    "prepositions": lambda: clause(
        "Alice",
        "fall",
        complement=preposition(
            "into",
            with_modifier(noun("a", "hole", "deep"), preposition("under", noun("the", "hedge"))),
        ),
    ),
    "infinitive": lambda: clause(
        noun("the", "Queen"), "want", clause(None, "play", noun(None, "croquet"), INFINITIVE)
    ),
    "object_infinitive": lambda: clause(
        noun("the", "Duchess"),
        "tell",
        noun(None, "Alice"),
        PAST,
        complement=clause(None, "leave", None, INFINITIVE),
    ),
    "a_an": lambda: clause(
        noun("a", "unicorn"), "wait", complement=preposition("for", noun("a", "hour"))
    ),
    "contraction": lambda: clause("Alice", "be", None, NEGATED, complement="afraid"),
    "imperative": lambda: clause(
        "you", "wake", noun("the", "Dormouse"), NEGATED, {Feature.FORM: Form.IMPERATIVE}
    ),
    "existential": lambda: clause(
        "there", "be", plural(None, "tart"), modifier=preposition("on", noun("the", "table"))
    ),
    "comparative": lambda: clause(
        "Alice",
        "be",
        with_modifier(
            adjective("tall", Feature.IS_COMPARATIVE), preposition("than", noun("the", "mushroom"))
        ),
    ),
    "superlative": lambda: clause(
        noun("the", "Queen"),
        "be",
        noun("the", "person", adjective("angry", Feature.IS_SUPERLATIVE)),
        modifier=preposition("in", noun(None, "Wonderland")),
    ),
    "adverbs": lambda: clause(noun("the", "Cat"), "disappear", adverb="often", modifier="slowly"),
    "that_clause": lambda: clause(
        "Alice", "think", clause(noun("the", "Hatter"), "be", complement="rude")
    ),
}


def builders() -> Builders:
    """Return a function for each sentence."""
    return {
        name: lambda build=build: REALISER.realiseSentence(build())  # type: ignore[misc]
        for name, build in SPECIFICATIONS.items()
    }
