"""The sentences in personage-lite's own terms."""

from __future__ import annotations

from collections.abc import Callable

from personage_lite import english
from personage_lite.realizer import (
    AdjectivePhrase,
    Clause,
    Coordination,
    NounPhrase,
    Phrase,
    PrepositionalPhrase,
    Question,
    Relative,
    Sentence,
    Subordinate,
)
from realizers import Builders


def the(noun: str) -> NounPhrase:
    """Return a noun phrase with the definite article."""
    return NounPhrase(noun, "the")


def plural(noun: str) -> NounPhrase:
    """Return a noun phrase in the plural with the definite article."""
    return NounPhrase(noun, "the", number="plural")


def a(noun: str, *adjectives: str) -> NounPhrase:
    """Return a noun phrase with the indefinite article."""
    return NounPhrase(noun, "a", tuple(map(AdjectivePhrase, adjectives)))


def alice() -> NounPhrase:
    """Return Alice."""
    return NounPhrase("Alice", gender="feminine", animate=True)


def she() -> NounPhrase:
    """Return the pronoun of Alice."""
    return NounPhrase("Alice", gender="feminine", animate=True, pronoun=True)


def he() -> NounPhrase:
    """Return the pronoun of the White Rabbit."""
    return NounPhrase("White Rabbit", gender="masculine", animate=True, pronoun=True)


def to(verb: str, direct_object: Phrase | None = None) -> Clause:
    """Return an infinitive."""
    return Clause(verb, object=direct_object, form="infinitive")


SPECIFICATIONS: dict[str, Callable[[], Sentence | Clause | Coordination]] = {
    "copula": lambda: Clause("be", alice(), complement=a("girl", "imaginative")),
    "negation": lambda: Clause(
        "like",
        the("Queen of Hearts"),
        object=NounPhrase("rose", adjectives=(AdjectivePhrase("white"),), number="plural"),
        negated=True,
    ),
    "although": lambda: Clause(
        "shout",
        the("Queen"),
        subordinates=(
            Subordinate(
                "although", Clause("be", she(), complement=AdjectivePhrase("small")), fronted=True
            ),
        ),
    ),
    "passive_perfect": lambda: Clause(
        "chase", she(), agent=plural("card"), passive=True, perfect=True
    ),
    "possessive_pronoun": lambda: Clause(
        "lose",
        the("White Rabbit"),
        object=NounPhrase("glove", possessor=he(), number="plural"),
        tense="past",
    ),
    "future": lambda: Clause(
        "grin",
        the("Cheshire Cat"),
        adverbials=(PrepositionalPhrase("at", the("Duchess")),),
        tense="future",
    ),
    "past_progressive": lambda: Clause(
        "drink",
        the("Hatter"),
        object=NounPhrase("tea"),
        adverbials=(PrepositionalPhrase("with", the("March Hare")),),
        tense="past",
        progressive=True,
    ),
    "past_perfect": lambda: Clause(
        "eat",
        alice(),
        object=NounPhrase("cake", "the", (AdjectivePhrase("small"),)),
        tense="past",
        perfect=True,
    ),
    "passive_past": lambda: Clause(
        "steal", plural("tart"), agent=the("Knave"), passive=True, tense="past"
    ),
    "modal_negation": lambda: Clause(
        "stay",
        the("Dormouse"),
        complement=AdjectivePhrase("awake"),
        modal="can",
        negated=True,
        contracted=True,
    ),
    "modal_perfect": lambda: Clause(
        "steal", the("Knave"), object=plural("tart"), modal="must", perfect=True
    ),
    "yes_no": lambda: Clause("smoke", the("Caterpillar"), object=a("pipe"), mood="interrogative"),
    "yes_no_past": lambda: Clause(
        "forgive", the("King"), object=the("Knave"), tense="past", mood="interrogative"
    ),
    "who": lambda: Clause(
        "steal", object=plural("tart"), tense="past", mood="interrogative", question=Question("who")
    ),
    "what": lambda: Clause(
        "lose",
        the("Rabbit"),
        tense="past",
        mood="interrogative",
        question=Question("what", "object"),
    ),
    "where": lambda: Clause(
        "live", the("Duchess"), mood="interrogative", question=Question("where", "adverbial")
    ),
    "why": lambda: Clause(
        "sing",
        the("Hatter"),
        progressive=True,
        mood="interrogative",
        question=Question("why", "adverbial"),
    ),
    "relative_subject": lambda: Clause(
        "follow",
        alice(),
        object=NounPhrase(
            "rabbit",
            "a",
            relative=Relative(Clause("wear", object=a("waistcoat")), restrictive=True),
        ),
    ),
    "relative_object": lambda: Clause(
        "open",
        NounPhrase(
            "key",
            "the",
            relative=Relative(Clause("find", alice(), tense="past"), "object", restrictive=True),
        ),
        object=a("door", "little"),
    ),
    "because": lambda: Clause(
        "hurry",
        the("Rabbit"),
        subordinates=(
            Subordinate("because", Clause("be", he(), complement=AdjectivePhrase("late"))),
        ),
    ),
    "when": lambda: Clause(
        "fall",
        plural("gardener"),
        subordinates=(
            Subordinate("when", Clause("shout", the("Queen"), tense="past"), fronted=True),
        ),
        tense="past",
    ),
    "and_names": lambda: Clause(
        "be",
        Coordination((the("Hatter"), the("March Hare"), the("Dormouse"))),
        complement=NounPhrase("friend", number="plural"),
    ),
    "and_adjectives": lambda: Clause(
        "be",
        alice(),
        complement=Coordination(
            (AdjectivePhrase("kind"), AdjectivePhrase("curious"), AdjectivePhrase("polite"))
        ),
    ),
    "and_clauses": lambda: Coordination(
        (Clause("shout", the("Queen")), Clause("tremble", plural("gardener")))
    ),
    "and_predicates": lambda: Coordination(
        (
            Clause("open", alice(), object=the("bottle")),
            Clause("drink", alice(), object=the("potion"), ellipsis=("subject",)),
        )
    ),
    "irregular_plurals": lambda: Clause(
        "feed",
        plural("child"),
        object=Coordination((NounPhrase("goose", cardinal=2), NounPhrase("mouse", cardinal=3))),
    ),
    "possessive": lambda: Clause("read", NounPhrase("sister", possessor=alice()), object=a("book")),
    "plural_possessive": lambda: Clause(
        "be",
        NounPhrase("brush", possessor=plural("gardener"), number="plural"),
        complement=AdjectivePhrase("red"),
    ),
    "pronouns": lambda: Clause(
        "give",
        NounPhrase("gardener", number="plural", pronoun=True),
        indirect_object=she(),
        object=a("key", "golden"),
        tense="past",
    ),
    "prepositions": lambda: Clause(
        "fall",
        alice(),
        adverbials=(
            PrepositionalPhrase(
                "into",
                NounPhrase(
                    "hole",
                    "a",
                    (AdjectivePhrase("deep"),),
                    modifiers=(PrepositionalPhrase("under", the("hedge")),),
                ),
            ),
        ),
    ),
    "infinitive": lambda: Clause("want", the("Queen"), object=to("play", NounPhrase("croquet"))),
    "object_infinitive": lambda: Clause(
        "tell", the("Duchess"), object=alice(), complement=to("leave"), tense="past"
    ),
    "a_an": lambda: Clause(
        "wait", a("unicorn"), adverbials=(PrepositionalPhrase("for", a("hour")),)
    ),
    "contraction": lambda: Clause(
        "be", alice(), complement=AdjectivePhrase("afraid"), negated=True, contracted=True
    ),
    "imperative": lambda: Clause("wake", object=the("Dormouse"), negated=True, mood="imperative"),
    "existential": lambda: Clause(
        "be",
        NounPhrase("tart", number="plural"),
        adverbials=(PrepositionalPhrase("on", the("table")),),
        existential=True,
    ),
    "comparative": lambda: Clause(
        "be",
        alice(),
        complement=AdjectivePhrase("tall", degree="comparative", compared=the("mushroom")),
    ),
    "superlative": lambda: Clause(
        "be",
        the("Queen"),
        complement=NounPhrase(
            "person",
            "the",
            (AdjectivePhrase("angry", degree="superlative"),),
            modifiers=(PrepositionalPhrase("in", NounPhrase("Wonderland")),),
        ),
    ),
    "adverbs": lambda: Clause(
        "disappear", the("Cat"), adverbs=("often",), adverbials=(AdjectivePhrase("slowly"),)
    ),
    "that_clause": lambda: Clause(
        "think",
        alice(),
        object=Clause(
            "be", the("Hatter"), complement=AdjectivePhrase("rude"), complementizer="that"
        ),
    ),
}


def builders() -> Builders:
    """Return a function for each sentence."""
    realize = english().realize
    return {
        name: lambda build=build: realize(build())  # type: ignore[misc]
        for name, build in SPECIFICATIONS.items()
    }
