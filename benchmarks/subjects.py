"""What is measured text by text: personage-lite's utterances, its realizer alone, and pyrealb.

A subject is a function from a running number to the text it makes and its count of sentences.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from realizers import builders, said
from sentences import SENTENCES

Subject = Callable[[int], tuple[str, int]]

XS = (-2, 0, 2)
MIXED = f"styled, X = {', '.join(map(str, XS))} in turns"


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


def realizer(name: str) -> Subject:
    """Return the sentences that the named realizer says rightly, in turns."""
    functions = builders(name)
    texts = said(functions)
    build = [functions[key] for key, text in SENTENCES.items() if texts.get(key) == text]
    return lambda number: (build[number % len(build)](), 1)


SUBJECTS: dict[str, Callable[[], Subject]] = {
    "nothing": lambda: lambda _: ("", 0),
    "styled": lambda: styled(XS),
    **{f"styled, X = {x}": partial(styled, (x,)) for x in XS},
    MIXED: lambda: styled(XS),
    "realizer": lambda: realizer("personage-lite"),
    "pyrealb": lambda: realizer("pyrealb"),
}
