"""Aggregation operators: each joins a clause to the sentence before it, by their relation.

A cue word is used only where its relation holds in the facts. Source: Mairesse & Walker 2011,
section 4.3; Reiter & Dale 2000, chapter 5.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from personage_lite.facts import entity_of
from personage_lite.lexicon import Lexicon
from personage_lite.operators import OperatorDraws
from personage_lite.plan import ClausePlan, SentencePlan
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    NounPhrase,
    Phrase,
    Text,
)
from personage_lite.sentence_planner.cue_words import (
    concede_cue_word,
    contrast_cue_word,
    justify_cue_word,
    sequence_cue_word,
)
from personage_lite.sentence_planner.hedges import EMPHASIZED, with_opener
from personage_lite.sentence_planner.joining import (
    MOST_UNCUED,
    Joint,
    Pair,
    PairRewrite,
    coordinate,
    describes,
    extend,
    kind_of,
    opposed,
    plain,
    replace_last,
    same_subject,
    says,
)

_MOST_MERGED: Final = 3
# A sentence with nothing around its clauses.
_BARE: Final = SentencePlan()


# Without a cue


def period(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Leave two sentences."""
    return (pair.left, tuple.__new__(SentencePlan, ((pair.right,), *_BARE[1:])))


def conjunction(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Join with "and": "Alice is polite, and she has a cat"."""
    if pair.link.kind in ("infer", "none") and not same_subject(pair.last, pair.right):
        return None
    if opposed(pair.last, pair.right) or pair.last.topic != pair.right.topic:
        return None
    if _introduced(pair):
        return None  # not "he has a friend, the Gryphon, and the Gryphon …"
    if pair.link.kind == "infer" and kind_of(pair.last) != kind_of(pair.right):
        return None  # not "she's watchful and makes some tarts"
    cue = rng.marker(lexicon.markers["conjunction"])
    return coordinate(pair, cue, rng, MOST_UNCUED) if cue else None


def merge(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Join what shares subject and verb: "is kind, curious and brave", "has a cat and a dog"."""
    last, right = pair.last, pair.right
    one, other = last.clause, right.clause
    if one.verb != other.verb or last.link != "main" or opposed(last, right):
        return None
    if not _same_shell(one, other):
        return None
    if isinstance(other.complement, AdjectivePhrase) and _mergeable(one.complement):
        clause = one._replace(complement=_with_item(one.complement, other.complement))
    elif one.verb == "have" and _plain_words(one.object) and _plain_words(other.object):
        if one.adverbials:
            return None
        assert other.object is not None
        clause = one._replace(object=_with_item(one.object, other.object))
    else:
        return None
    strength = "somewhat" if "somewhat" in (last.strength, right.strength) else last.strength
    return replace_last(
        pair.left,
        last._replace(
            clause=clause,
            facts=(*last.facts, *right.facts),
            strength=strength,
            gradable=False,
            feeling=last.feeling if last.feeling == right.feeling else "",
        ),
    )


def _same_shell(one: Clause, other: Clause) -> bool:
    """Whether two clauses are equal but for what a merge joins, the object and the complement."""
    return one[:4] == other[:4] and one[6:] == other[6:]


def _plain_words(phrase: Phrase | None) -> bool:
    """Whether a phrase names nobody: not "five moons and a moon called Charon", one of them."""
    return isinstance(phrase, Text) and all(isinstance(part, str) for part in phrase.parts)


def _mergeable(phrase: Phrase | None) -> bool:
    if isinstance(phrase, Coordination):
        return len(phrase.items) < _MOST_MERGED and phrase.conjunction == "and"
    return isinstance(phrase, AdjectivePhrase)


def _with_item(phrase: Phrase | None, item: Phrase) -> Coordination:
    assert phrase is not None
    items = phrase.items if isinstance(phrase, Coordination) else (phrase,)
    return Coordination((*items, item))


def relative_clause(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Put one clause inside the other: "Alice, who has a cat, …" or "… a cat called Dinah, who …".

    The describing clause (be, have) becomes the relative one; an elaboration always does.
    """
    left, last, right = pair.left, pair.last, pair.right
    if len(left.clauses) > 1:
        return None
    if not entity_of(right.clause.subject):
        return None
    if not same_subject(last, right) or pair.link.fixed_order or opposed(last, right):
        return None
    if last.topic != right.topic or last.story or right.story or right.following:
        return None
    main, inner = last, right
    if describes(last) and not describes(right) and pair.link.kind != "elaboration":
        main, inner = right, last
    # Two qualities are better merged: not "Alice, who is kind, is brave".
    if not describes(inner) or (main.clause.verb == inner.clause.verb == "be"):
        return None
    joined = (main._replace(link="main"), inner._replace(link="relative"))
    return (left._replace(clauses=joined),)


def object_relative_clause(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Say more of whom the sentence named last: "She has a cat called Dinah, who …"."""
    if len(pair.left.clauses) > 1 or not _introduced(pair):
        return None
    return extend(pair.left, pair.right._replace(link="object_relative"))


def _introduced(pair: Pair) -> bool:
    """Whether the right clause is about somebody else, whom the left one names at its end."""
    subject = entity_of(pair.right.clause.subject)
    if not subject or same_subject(pair.last, pair.right):
        return False
    return _last_mention(pair.last.clause) == subject


def _last_mention(clause: Clause) -> str:
    """Return the entity that a clause names as its very last word, if it does."""
    ends = [clause.object, clause.complement, *clause.adverbials]
    said = [phrase for phrase in ends if phrase is not None]
    final = said[-1] if said else None
    if isinstance(final, Text) and isinstance(final.parts[-1], Cased):
        part = final.parts[-1]
        return part.phrase.entity if part.case == "objective" else ""
    return ""


def with_cue_word(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Say how parts look after "with": "The White Rabbit is small, with pink eyes"."""
    left, last, right = pair.left, pair.last, pair.right
    if len(left.clauses) > 1 or last.clause.asides:
        return None
    if last.clause.verb != "be" or right.clause.negated or last.topic != right.topic:
        return None
    owned = _owned(last, right)
    cue = rng.marker(lexicon.markers["with_cue_word"])
    if owned is None or cue is None or opposed(last, right) or says(last.clause, cue.text):
        return None
    aside = Text((cue.text, *owned))
    clause = last.clause._replace(asides=(aside,))
    facts = (*last.facts, *right.facts)
    return replace_last(left, last._replace(clause=clause, facts=facts), cue.text)


def _owned(last: ClausePlan, right: ClausePlan) -> tuple[Cased | Phrase, ...] | None:
    """Return what the right clause says of parts of the left one's subject."""
    clause = right.clause
    part, quality = clause.subject, clause.complement
    if not isinstance(part, NounPhrase) or part.possessor is None:
        return None
    if clause.verb != "be" or clause.tense != "present":
        return None
    own = part.possessor == last.clause.subject and part.number == "plural"
    if own and isinstance(quality, AdjectivePhrase):
        return (Cased(part._replace(possessor=None, adjectives=(quality,))),)
    return None


def also_cue_word(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Begin a new sentence with "also": "She also has a cat"."""
    right = pair.right
    if not same_subject(pair.last, right) or not plain(right) or right.clause.adverbs:
        return None
    if pair.last.topic != right.topic or kind_of(pair.last) != kind_of(right):
        return None
    if right.clause.negated or opposed(pair.last, right):
        return None
    if right.story or pair.last.clause.quotation:
        return None  # the next step of a story is not one more of the same
    cue = rng.marker(lexicon.markers["also_cue_word"])
    if cue is None:
        return None
    if cue.place == "connective":
        if cue.after == ",":
            return (pair.left, SentencePlan((right,), connective=cue.text, words=(cue.text,)))
        return (pair.left, with_opener(SentencePlan((right,)), cue))
    clause = right.clause._replace(adverbs=(cue.text,))
    return (pair.left, SentencePlan((right._replace(clause=clause),), words=(cue.text,)))


# What is said again


def merge_with_comma(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Say an attribute again after a comma: "curious, really curious"."""
    last, right = pair.last, pair.right
    said = last.clause.complement
    again = right.clause.complement
    if last.clause.mood == "exclamative" or not isinstance(said, AdjectivePhrase):
        return None
    if not isinstance(again, AdjectivePhrase) or last.facts != right.facts:
        return None
    if right.role == "restatement":
        concept = lexicon.adjectives.get(again.adjective)
        if concept is None or len(concept.words) < 2:
            return None
    cue = rng.marker(lexicon.markers["merge_with_comma"])
    if cue is None:
        return None
    first = said if said.adverbs or not cue.first else said._replace(adverbs=(cue.first,))
    second = again._replace(adverbs=(cue.text,))
    clause = last.clause._replace(complement=Coordination((first, second), ","))
    return replace_last(
        pair.left,
        last._replace(
            clause=clause,
            role=right.role,
            gradable=False,
            marks=(*last.marks, EMPHASIZED),
        ),
        cue.text,
    )


class Joiner(NamedTuple):
    """An aggregation operator that competes for a relation.

    `name` is its style parameter, whose value times `factor` is its weight in the draw. One that
    is `embedding` moves a clause into another: it is offered only pairs that are both `plain`.
    """

    name: str
    apply: PairRewrite
    factor: float = 1.0
    embedding: bool = False


# Those that do not say which relation holds.
UNCUED: Final = ("period", "conjunction")
# For each relation, the operators that compete for it.
COMPETING: Final[dict[str, tuple[Joiner, ...]]] = {
    "none": (Joiner("period", period),),
    "infer": (
        Joiner("period", period, 0.7),
        Joiner("conjunction", conjunction),
        Joiner("merge", merge, 1.5, embedding=True),
        Joiner("relative_clause", relative_clause, embedding=True),
        Joiner("object_relative_clause", object_relative_clause, embedding=True),
        Joiner("with_cue_word", with_cue_word, embedding=True),
        Joiner("also_cue_word", also_cue_word),
    ),
    "elaboration": (
        Joiner("period", period, 0.6),
        Joiner("conjunction", conjunction, 0.6),
        Joiner("relative_clause", relative_clause, 3.0, embedding=True),
        Joiner("object_relative_clause", object_relative_clause, embedding=True),
        Joiner("with_cue_word", with_cue_word, embedding=True),
    ),
    "contrast": (
        Joiner("contrast_cue_word", contrast_cue_word),
        Joiner("period", period, 0.05),
    ),
    "justification": (
        Joiner("justify_cue_word", justify_cue_word),
        Joiner("period", period, 0.06),
    ),
    "concession": (Joiner("concede_cue_word", concede_cue_word), Joiner("period", period, 0.02)),
    "sequence": (
        Joiner("sequence_cue_word", sequence_cue_word),
        Joiner("conjunction", conjunction, 0.6),
        Joiner("period", period, 0.5),
    ),
    "restatement": (Joiner("merge_with_comma", merge_with_comma),),
}
