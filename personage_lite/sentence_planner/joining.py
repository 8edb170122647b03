"""What the aggregation operators share: the pair they join, and the ways of joining.

Source: Mairesse & Walker 2011, section 4.3; Reiter & Dale 2000, chapter 5.
"""

from __future__ import annotations

from typing import Final, Protocol, TypeAlias

from personage_lite.facts import OPPOSING_KINDS
from personage_lite.lexicon import Lexicon, Marker
from personage_lite.operators import OperatorDraws
from personage_lite.plan import STATES, ClausePlan, Link, SentencePlan
from personage_lite.realizer.specification import AdjectivePhrase, Clause, Text

# The most clauses in a sentence, where a cue word binds them and where only "and" does.
MOST_CUED: Final = 3
MOST_UNCUED: Final = 2
_SHARED_SUBJECT: Final = 0.5
# After more different words than these one has forgotten whose verb the next one is.
_MOST_BETWEEN: Final = 5
_OPPOSED: Final = (("good", "bad"), ("bad", "good"))


class Pair:
    """The sentence so far, the clause that comes next, and what holds between them.

    `last` is the clause that the right one follows.
    """

    __slots__ = ("last", "left", "link", "right")

    def __init__(self, left: SentencePlan, right: ClausePlan, link: Link) -> None:
        self.left = left
        self.right = right
        self.link = link
        self.last = left.clauses[-1]


Joint: TypeAlias = tuple[SentencePlan, ...]


class PairRewrite(Protocol):
    """The signature of an aggregation operator; None where its constraint does not hold."""

    def __call__(self, pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
        """Return the sentences that the pair becomes, or None."""


def same_subject(one: ClausePlan, other: ClausePlan) -> bool:
    """Whether two clauses have the same subject."""
    return one.clause.subject == other.clause.subject


def opposed(one: ClausePlan, other: ClausePlan) -> bool:
    """Whether one clause is good news and the other bad."""
    return (one.polarity, other.polarity) in _OPPOSED


def plain(plan: ClausePlan) -> bool:
    """Whether a clause can be moved or embedded: no frame around it, no speech in it."""
    return plan.frame is None and not plan.clause.quotation and plan.role == "assertion"


def extend(sentence: SentencePlan, clause: ClausePlan, word: str = "") -> Joint:
    """Return a sentence with one more clause, and the cue word that joined it."""
    words = (*sentence.words, word) if word else sentence.words
    # Made anew, here and below: `_replace` takes several times as long.
    fields = ((*sentence.clauses, clause), *sentence[1:-1], words)
    return (tuple.__new__(SentencePlan, fields),)


def replace_last(sentence: SentencePlan, clause: ClausePlan, word: str = "") -> Joint:
    """Return a sentence with another last clause."""
    words = (*sentence.words, word) if word else sentence.words
    return (sentence._replace(clauses=(*sentence.clauses[:-1], clause), words=words),)


def coordinate(pair: Pair, cue: Marker, rng: OperatorDraws, most: int) -> Joint | None:
    """Join with a coordinating cue, up to `most` clauses; an equal subject may be left unsaid."""
    left, right, last = pair.left, pair.right, pair.last
    if len(left.clauses) >= most or last.clause.quotation:
        return None
    if last.frame is not None and not last.frame.inner_tag:
        return None  # the love of "I love how …" would go on, or a "so …" follow from it
    if right.frame is not None:
        return None  # "…, and I love how …" begins anew
    shared = (
        same_subject(last, right)
        and len(left.clauses) == 1
        and last.frame is None
        and not cue.own_subject
        and pair.link.kind not in OPPOSING_KINDS  # "… but would rather stay" is written English
        and last.role == "assertion"
        and last.clause.verb != right.clause.verb
        and not (describes(last) or describes(right))  # not "is old and has a son"
        and last.clause.tense == right.clause.tense
        # Not "… the Hatter and the Hare and laughs", nor "… and dozes off and dreams".
        and not (says(last.clause, cue.text) or says(right.clause, cue.text))
        and len(words_after_verb(last.clause)) <= _MOST_BETWEEN
        and rng.uniform("shared_subject") < _SHARED_SUBJECT
    )
    fields = (*right[:5], "coordinate", cue.text, shared, *right[8:])
    return extend(left, tuple.__new__(ClausePlan, fields), cue.text)


def words_after_verb(clause: Clause) -> set[str]:
    """Return the words of what follows a clause's verb, without the names in it."""
    words: set[str] = set()
    for phrase in (clause.object, clause.complement, *clause.adverbials):
        if isinstance(phrase, AdjectivePhrase):
            words.add(phrase.adjective)
        elif isinstance(phrase, Text):
            for part in phrase.parts:
                if isinstance(part, str):
                    words.update(part.split(" "))
    return words


def says(clause: Clause, word: str) -> bool:
    """Whether a word stands in what follows a clause's verb."""
    return word in words_after_verb(clause)


def kind_of(plan: ClausePlan) -> str:
    """Return whether a clause names a quality, another state, or a deed.

    Only clauses of one kind are joined by "and" alone: not "he is made of cardboard and shy".
    """
    if not describes(plan):
        return "deed"
    return "quality" if isinstance(plan.clause.complement, AdjectivePhrase) else "state"


def describes(plan: ClausePlan) -> bool:
    """Whether a clause says how somebody is or what they have, not what they do."""
    return plan.clause.verb in STATES and not plan.clause.perfect
