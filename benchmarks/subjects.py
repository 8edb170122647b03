"""What is measured: personage-lite's utterances, its realizer alone, and pyrealb.

A subject is a function from a running number to the text it makes and its count of sentences.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

Subject = Callable[[int], tuple[str, int]]

SENTENCES = (
    "Alice is an imaginative girl.",
    "The Queen of Hearts does not like white roses.",
    "Although she is small, the Queen shouts.",
    "She has been chased by the cards.",
)
XS = (-2, 0, 2)


def styled(xs: tuple[int, ...]) -> Subject:
    """Return styled utterances over successive seeds, all characters and these values of X."""
    from personage_lite import Generator

    generator = Generator()
    names = [character.entity.id for character in generator.characters()]

    def say(number: int) -> tuple[str, int]:
        name = names[number // len(xs) % len(names)]
        utterance = generator.generate(name, x=xs[number % len(xs)], seed=number)
        return utterance.text, len(utterance.sentences)

    return say


def realizer() -> Subject:
    """Return our realizer over the four sentences, each built anew."""
    from personage_lite import english
    from personage_lite.realizer import (
        AdjectivePhrase,
        Cased,
        Clause,
        NounPhrase,
        Subordinate,
        Text,
    )

    def she() -> NounPhrase:
        return NounPhrase("girl", gender="feminine", animate=True, pronoun=True)

    def alice() -> Clause:
        girl = NounPhrase("girl", determiner="a", adjectives=(AdjectivePhrase("imaginative"),))
        return Clause("be", NounPhrase("Alice"), complement=girl)

    def roses() -> Clause:
        white = NounPhrase("rose", adjectives=(AdjectivePhrase("white"),), number="plural")
        queen = NounPhrase("Queen of Hearts", determiner="the")
        return Clause("like", queen, object=white, negated=True)

    def although() -> Clause:
        small = Clause("be", she(), complement=AdjectivePhrase("small"))
        queen = NounPhrase("Queen", determiner="the")
        return Clause("shout", queen, subordinates=(Subordinate("although", small, fronted=True),))

    def chased() -> Clause:
        cards = NounPhrase("card", determiner="the", number="plural")
        by = Text(("by", Cased(cards)))
        return Clause("chase", she(), adverbials=(by,), perfect=True, passive=True)

    build = (alice, roses, although, chased)
    realize = english().realize
    return _checked("personage-lite", lambda number: (realize(build[number % 4]()), 1))


def pyrealb() -> Subject:
    """Return pyrealb over the four sentences, each built anew (realizing spoils its trees)."""
    from pyrealb import (  # type: ignore[import-untyped,import-not-found,unused-ignore]
        NP,
        SP,
        VP,
        A,
        C,
        D,
        N,
        Pro,
        Q,
        S,
        V,
    )

    build = (
        lambda: S(Q("Alice"), VP(V("be"), NP(D("a"), A("imaginative"), N("girl")))),
        lambda: S(
            NP(D("the"), Q("Queen of Hearts")),
            VP(V("like"), NP(A("white"), N("rose")).n("p")),
        ).typ({"neg": True}),
        lambda: S(
            SP(C("although"), Pro("I").g("f"), VP(V("be"), A("small"))).a(","),
            NP(D("the"), Q("Queen")),
            VP(V("shout")),
        ),
        lambda: S(NP(D("the"), N("card")).n("p"), VP(V("chase"), Pro("me").g("f"))).typ(
            {"pas": True, "perf": True}
        ),
    )
    return _checked("pyrealb", lambda number: (build[number % 4]().realize(), 1))


def _checked(name: str, subject: Subject) -> Subject:
    for number, expected in enumerate(SENTENCES):
        text = subject(number)[0].rstrip()
        if text != expected:
            raise SystemExit(f"{name} says '{text}' instead of '{expected}': nothing was timed")
    return subject


SUBJECTS: dict[str, Callable[[], Subject]] = {
    "nothing": lambda: lambda _: ("", 0),
    "styled": lambda: styled(XS),
    **{f"styled, X = {x}": partial(styled, (x,)) for x in XS},
    "realizer": realizer,
    "pyrealb": pyrealb,
}
