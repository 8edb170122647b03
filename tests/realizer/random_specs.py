"""Random specifications of every type, with marks inside their words where data may have them."""

from __future__ import annotations

from random import Random
from typing import Any

from personage_lite.realizer import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Date,
    Embedded,
    Joined,
    NounPhrase,
    Numeral,
    Opener,
    Phrase,
    PrepositionalPhrase,
    Question,
    Quotation,
    Relative,
    Sentence,
    Subordinate,
    Text,
)
from personage_lite.realizer.specification import Role

LONE = ("um", "oh", "I suppose", "my friend", "you know", "honestly", "why not")
ADVERBS = ("really", "often", "never", "hardly ever", "always")
ADJECTIVES = ("kind", "old", "honest", "hot-tempered", "8-page", "good", "Dutch")
NOUNS = (
    *("Alice", "egg", "Queen of Hearts", "James", "child", "nobody", "hour", "UFO"),
    *("pack of cards", "furniture", "trousers", "sheep", "colour", "etc."),
)
DETERMINERS = ("", "a", "the", "no", "every", "this", "many", "few", "how many")
WORDS = (
    *("a cat", "to Bill", "nothing at all", "yes, no", "etc.", "I must say,"),
    *("Oh!", "why?", "so…"),
)
VERBS = ("be", "have", "do", "run", "cry", "panic", "stand", "go", "echo", "travel")
MODALS = ("", "", "can", "may", "should", "ought to", "have to", "be going to")
SPEECHES = (
    *("Off with her head!", "I am late.", "Run", "Who are you?", "Well…", "Oh,", "No..."),
    "At 4 a.m.",
)
ROLES: tuple[Role, ...] = ("subject", "object", "indirect_object", "complement", "adverbial")
CONJUNCTIONS = ("and", "or", "nor", "but also", ",")


class RandomSpecs:
    """Makes specifications from a seed: any that is well typed and has what its form needs."""

    def __init__(self, seed: int) -> None:
        self.rng = Random(seed)

    def one(self, *choices: Any) -> Any:
        """Return one of the choices."""
        return self.rng.choice(choices)

    def flag(self) -> bool:
        """Return true or false."""
        return self.rng.random() < 0.5

    def rarely(self) -> bool:
        """Return true once in four times."""
        return self.rng.random() < 0.25

    def few(self, make: Any, *arguments: Any, most: int = 2) -> tuple[Any, ...]:
        """Return up to so many values."""
        return tuple(make(*arguments) for _ in range(self.rng.randint(0, most)))

    def word(self, words: tuple[str, ...]) -> str:
        """Return one of some words."""
        return self.rng.choice(words)

    def adjective(self, depth: int) -> AdjectivePhrase:
        """Return a graded adjective."""
        return AdjectivePhrase(
            self.word(ADJECTIVES),
            self.few(self.word, ADVERBS),
            self.one("positive", "positive", "comparative", "superlative", "equative"),
            self.phrase(depth - 1) if self.rarely() else None,
            self.phrase(depth - 1) if self.rarely() else None,
        )

    def noun(self, depth: int) -> NounPhrase:
        """Return a noun phrase."""
        inner = depth > 0
        return NounPhrase(
            noun=self.word(NOUNS),
            determiner=self.word(DETERMINERS),
            adjectives=(*self.few(self.adjective, depth - 1), *self.few(self.word, ADJECTIVES)),
            possessor=self.noun(depth - 1) if inner and self.rarely() else None,
            number=self.one("singular", "plural"),
            gender=self.one("masculine", "feminine", "neuter"),
            person=self.one(1, 2, 3),
            animate=self.flag(),
            pronoun=self.rarely(),
            relative=self.relative(depth - 1) if inner and self.rarely() else None,
            stutter=self.one(0, 0, 1, 2),
            entity=self.one("", "alice"),
            reflexive=self.rng.random() < 0.1,
            predeterminer=self.one("", "", "all"),
            cardinal=self.number() if self.rarely() else None,
            ordinal=self.rng.randint(1, 30) if self.rarely() else None,
            figures=self.flag(),
            modifiers=self.few(self.phrase, depth - 1, most=1) if inner else (),
            apposition=self.phrase(depth - 1) if inner and self.rarely() else None,
        )

    def number(self) -> int | float:
        """Return a number, often a small one."""
        number: int | float = self.one(0, 1, 1.5, 2, -1, self.rng.randint(-10, 2_000_000))
        return number

    def text(self, depth: int) -> Text:
        """Return words with phrases between them."""

        def part() -> Any:
            case = self.one("subjective", "objective", "possessive", "reflexive")
            return self.one(self.word(WORDS), ",", Cased(self.noun(depth), case))

        first = self.one(self.word(WORDS), Cased(self.noun(depth)))
        return Text((first, *self.few(part)))

    def phrase(self, depth: int) -> Phrase:
        """Return a phrase of any type; at the bottom, one without clauses."""
        makers: list[Any] = [
            lambda: self.word(WORDS),
            lambda: Numeral(self.number(), figures=self.flag()),
            lambda: Numeral(self.rng.randint(0, 999), True, self.flag()),
            lambda: Date(self.rng.randint(1, 2100), self.rng.randint(1, 12), 28, self.flag()),
            lambda: self.text(0),
            lambda: self.noun(depth),
        ]
        if depth > 0:
            makers += [
                lambda: self.adjective(depth),
                lambda: self.clause(depth - 1),
                lambda: self.non_finite(depth - 1),
                lambda: PrepositionalPhrase(self.one("with", "by"), self.phrase(depth - 1)),
                lambda: self.coordination(self.phrase, depth - 1),
            ]
        made: Phrase = self.rng.choice(makers)()
        return made

    def coordination(self, make: Any, depth: int) -> Coordination:
        """Return up to three phrases or clauses joined."""
        items = (make(depth), *self.few(make, depth))
        relative = self.relative(depth - 1) if depth > 0 and self.rng.random() < 0.1 else None
        return Coordination(items, self.word(CONJUNCTIONS), self.flag(), self.flag(), relative)

    def relative(self, depth: int) -> Relative:
        """Return a relative clause whose role nothing else fills."""
        role = self.rng.choice(ROLES)
        possessed = self.rarely() and role != "adverbial"
        clause = self.clause(depth)
        while clause.question is not None:
            clause = self.clause(depth)
        if not possessed:
            clause = without(clause, role)
        preposition = self.one("", "with") if role == "adverbial" else ""
        return Relative(
            clause, role, self.flag(), possessed, preposition, self.flag(), omitted=self.flag()
        )

    def clause(self, depth: int) -> Clause:
        """Return a finite clause that has what its mood needs."""
        clause = Clause(
            verb=self.word(VERBS),
            subject=self.noun(depth - 1),
            particle=self.one("", "", "up", "for"),
            indirect_object=self.phrase(depth - 1) if self.rarely() else None,
            object=self.phrase(depth - 1) if self.rarely() else None,
            complement=self.phrase(depth - 1) if self.rarely() else None,
            adverbials=self.few(self.phrase, depth - 1, most=1),
            asides=self.few(self.phrase, depth - 1, most=1),
            adverbs=self.few(self.word, ADVERBS, most=1),
            emphasizers=self.few(self.word, ADVERBS, most=1),
            interruption=self.one("", "", "um"),
            quotation=self.quotation(depth) if self.rarely() else "",
            subordinates=self.few(self.subordinate, depth - 1, most=1) if depth > 0 else (),
            tense=self.one("present", "past", "future"),
            modal=self.word(MODALS),
            perfect=self.flag(),
            progressive=self.flag(),
            passive=self.flag(),
            negated=self.flag(),
            negator=self.one("not", "never"),
            contracted=self.flag(),
            truncated=self.rarely(),
            mood=self.one("declarative", "declarative", "interrogative", "exclamative"),
            existential=self.rarely(),
            agent=self.phrase(depth - 1) if self.rarely() else None,
            preposed=self.few(self.word, ("never", "yesterday"), most=1),
            complementizer=self.one("", "that"),
            backshifted=self.rarely(),
            ellipsis=self.one((), (), (), ("subject",), ("auxiliary",), ("verb",), ("predicate",)),
        )
        if clause.mood != "interrogative" or self.flag():
            return clause
        role = self.rng.choice(ROLES)
        asked = self.one("who", "what", self.noun(0))
        question = Question(asked, role, self.one("", "", "with"))
        return without(clause, role)._replace(question=question)

    def quotation(self, depth: int) -> str | Quotation:
        """Return direct speech."""
        said: str | Sentence = self.word(SPEECHES)
        if depth > 0 and self.flag():
            said = Sentence(self.clause(depth - 1), tag=self.one("", "auto"))
        return self.one(self.word(SPEECHES), Quotation(said, self.flag(), self.flag()))  # type: ignore[no-any-return]

    def subordinate(self, depth: int) -> Subordinate:
        """Return an adverbial clause."""
        clause = self.clause(depth) if self.flag() else self.non_finite(depth)
        inverted = self.rng.random() < 0.1
        conjunction = "" if inverted else self.one("because", "although", "before")
        return Subordinate(conjunction, clause, self.flag(), inverted)

    def non_finite(self, depth: int) -> Clause:
        """Return an infinitive or a participle."""
        forms = ("infinitive", "bare_infinitive", "present_participle", "past_participle")
        return self.clause(depth)._replace(
            form=self.one(*forms), question=None, mood="declarative", ellipsis=()
        )

    def sentence(self) -> Sentence:
        """Return a sentence with anything around it."""
        clause = self.clause(1)
        embedded = Embedded(self.text(0), clause, self.one("", "that"), self.flag())
        imperative = clause._replace(mood="imperative", question=None)
        several = self.coordination(self.clause, 1)
        bodies = (clause, clause, embedded, imperative, several, self.text(1), self.phrase(1))
        return Sentence(
            body=self.rng.choice(bodies),
            joined=self.few(self.joined, most=1),
            openers=self.few(
                lambda: Opener(self.word(LONE), self.one(",", "!", "?", "…", ".", ""))
            ),
            connective=self.one("", "", "however"),
            vocative=self.one("", "", "buddy"),
            afterthought=self.one("", self.word(LONE)),
            tag=self.one("", "", "auto", "right"),
            terminal=self.one("", ".", "!", "?", "…"),
            false_start=self.rarely(),
            hesitation=self.one("", "", "", "um"),
        )

    def joined(self) -> Joined:
        """Return a clause joined to another."""
        return Joined(self.one("and", "but"), self.clause(1), self.flag())


def without(clause: Clause, role: Role) -> Clause:
    """Return a clause with nothing in a role."""
    if role == "adverbial":
        return clause
    fields: dict[str, Any] = {role: None}
    return clause._replace(**fields)
