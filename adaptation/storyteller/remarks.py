"""Remarks of the listener: understood by the words of the lexicon, and weighed as evidence.

The paper's outlook (section VI): "how to take advantage of implicitly and explicitly provided
feedback in order to overcome the noise of continuously provided social signals and the sparsity of
occasionally provided verbal feedback". To `bayes` a remark is evidence in the same belief as what
is sensed (see `adaptation.belief.remarked`, where the weights stand). To the other learners it is
a reward, of the size of a change of E by one level.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from adaptation.belief.remarked import Kind
from adaptation.learners.base import Learner
from adaptation.learners.bayes import Bayes
from adaptation.problem import HIGHEST, LOWEST, Choice, Context, Outcome
from adaptation.storyteller.understanding import Meaning, plain

# What praise is worth as a reward, and blame with the sign turned.
REWARD = 1.0
# How many words before a remark a negation turns it around.
_REACH = 3
_TURNED: Mapping[str, Kind] = {"praise": "blame", "blame": "praise", "more": "less"}


class Remark(NamedTuple):
    """What was meant: its kind, and whether it speaks of the manner just heard ("of that")."""

    kind: Kind
    of_that: bool = False

    def about(self, x: int) -> Kind:
        """Return what is meant after an utterance with `x`: of a quiet one, less is livelier.

        >>> Remark("less", of_that=True).about(2), Remark("less", of_that=True).about(-2)
        ('less', 'more')
        """
        if self.of_that and x < 0 and self.kind in ("less", "more"):
            return "more" if self.kind == "less" else "less"
        return self.kind


class Remarks:
    """Finds remarks in what is said; `words` are `DialogWords.remarks`.

    >>> from personage_lite import Generator
    >>> remarks = Remarks(Generator().dialog.remarks)
    >>> remarks.understood("Calm down, please!"), remarks.understood("that's not boring at all")
    (Remark(kind='less', of_that=False), Remark(kind='praise', of_that=False))
    >>> remarks.understood("the White Rabbit") is None
    True
    """

    def __init__(self, words: Mapping[str, Sequence[str]]) -> None:
        self._kinds = {
            tuple(plain(phrase).split()): kind
            for kind, phrases in words.items()
            if kind != "negation"
            for phrase in phrases
        }
        self._negations = frozenset(plain(word) for word in words["negation"])
        self._longest = max(len(phrase) for phrase in self._kinds)

    @property
    def phrases(self) -> tuple[str, ...]:
        """All remarks that are known, for a recogniser's grammar."""
        return tuple(" ".join(phrase) for phrase in self._kinds)

    def understood(self, text: str) -> Remark | None:
        """Return what a remark means, None if there is none in the text.

        Of several the last counts; one that says in which direction counts before praise and
        blame ("lovely, but calm down").
        """
        found = self._found(plain(text).split())
        directions = [remark for remark in found if remark.kind in ("less", "more")]
        counting = directions or found
        return counting[-1] if counting else None

    def _found(self, words: Sequence[str]) -> list[Remark]:
        found = []
        place = start = 0
        while place < len(words):
            length = self._length(words[place:])
            if length:
                kind = self._kinds[tuple(words[place : place + length])]
                before = words[max(start, place - _REACH) : place]
                remark = _remark(kind, not self._negations.isdisjoint(before))
                if remark is not None:
                    found.append(remark)
                start = place + length
            place += max(1, length)
        return found

    def _length(self, words: Sequence[str]) -> int:
        """Return of how many words the longest remark is that the words begin with; 0 if none."""
        for length in range(min(self._longest, len(words)), 0, -1):
            if tuple(words[:length]) in self._kinds:
                return length
        return 0


def _remark(kind: str, negated: bool) -> Remark | None:
    bare = kind.removesuffix("_of_that")
    meant = _TURNED.get(bare) if negated else bare
    return None if meant is None else Remark(meant, bare != kind)  # type: ignore[arg-type]


def as_answer(remark: Remark, meaning: Meaning, *, told: bool) -> tuple[Meaning, Remark | None]:
    """Return what a remark means where a suggestion waits for an answer, and what is left of it.

    "Great!" accepts the suggestion. "Boring" refuses it where nothing was `told` yet; later it
    speaks of what was told.
    """
    if remark.kind == "praise":
        return Meaning("yes"), None
    if remark.kind == "blame" and not told:
        return Meaning("no"), None
    return meaning, remark


def heed(
    learner: Learner, remark: Remark, x: int | None, engagement: float = 0.0, weight: float = 1.0
) -> bool:
    """Let a learner for one trial take a remark as evidence; returns whether it learned from it.

    `x` is that of the last utterance, None before the first: then there is nothing to remark on.
    `engagement` is E now; `weight`, from 0 to 1, how sure it is that this was said.

    Learners other than `bayes` are rewarded with `REWARD` · `weight` for staying at an X that is
    praised, and punished by as much at one that is blamed. "Less" and "more" punish staying, and
    reward the step in that direction; where there is no step left, they reward staying.
    """
    if x is None:
        return False
    kind, size = remark.about(x), REWARD * weight
    if isinstance(learner, Bayes):
        learner.heed(kind, x, weight)
        return True
    before = learner.save()
    step = {"less": -1, "more": 1}.get(kind, 0)
    if step and LOWEST <= x + step <= HIGHEST:
        _reward(learner, x, 0, engagement, -size)
        _reward(learner, x, step, engagement, size)
    else:
        _reward(learner, x, 0, engagement, -size if kind == "blame" else size)
    return learner.save() != before


def _reward(learner: Learner, x: int, step: int, engagement: float, reward: float) -> None:
    """Let a learner take a step from X that has brought a reward; E stays as it is."""
    now = np.array([engagement])
    context = Context(0, np.array([x]), now)
    outcome = Outcome(np.array([reward]), np.array([x + step]), now)
    learner.learn(context, Choice(np.array([step]), np.ones(1)), outcome)
