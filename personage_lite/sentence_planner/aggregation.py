"""Aggregation operators: each joins a clause to the sentence before it, by their relation.

A cue word is used only where its relation holds in the facts. Source: Mairesse & Walker 2011,
section 4.3; Reiter & Dale 2000, chapter 5.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol, TypeAlias

from personage_lite.lexicon import Lexicon, Marker
from personage_lite.operators import OperatorDraws
from personage_lite.plan import ClausePlan, Link, SentencePlan
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Phrase,
    Text,
)
from personage_lite.sentence_planner.hedges import EMPHASIZED

# The most clauses in a sentence, where a cue word binds them and where only "and" does.
_MOST_CUED = 3
_MOST_UNCUED = 2
_MOST_MERGED = 3
_SHARED_SUBJECT = 0.5


class Pair(NamedTuple):
    """The sentence so far, the clause that comes next, and what holds between them."""

    left: SentencePlan
    right: ClausePlan
    link: Link

    @property
    def last(self) -> ClausePlan:
        """The clause that the right one follows."""
        return self.left.clauses[-1]


Joint: TypeAlias = tuple[SentencePlan, ...]


class PairRewrite(Protocol):
    """The signature of an aggregation operator; None where its constraint does not hold."""

    def __call__(self, pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
        """Return the sentences that the pair becomes, or None."""


def _same_subject(one: ClausePlan, other: ClausePlan) -> bool:
    return one.clause.subject == other.clause.subject


def _opposed(one: ClausePlan, other: ClausePlan) -> bool:
    return {one.polarity, other.polarity} == {"good", "bad"}


def _plain(plan: ClausePlan) -> bool:
    """Whether a clause can be moved or embedded: no frame around it, no speech in it."""
    return plan.frame is None and not plan.clause.quotation and plan.role == "assertion"


def _extend(sentence: SentencePlan, clause: ClausePlan, word: str = "") -> Joint:
    words = (*sentence.words, word) if word else sentence.words
    return (sentence._replace(clauses=(*sentence.clauses, clause), words=words),)


def _replace_last(sentence: SentencePlan, clause: ClausePlan, word: str = "") -> Joint:
    return _extend(sentence._replace(clauses=sentence.clauses[:-1]), clause, word)


# Without a cue


def period(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Leave two sentences; where one is the ground of a contrast, that would lose the relation."""
    return (pair.left, SentencePlan((pair.right,)))


def _coordinate(pair: Pair, cue: Marker, rng: OperatorDraws, most: int) -> Joint | None:
    left, right, last = pair.left, pair.right, pair.last
    if len(left.clauses) >= most or last.clause.quotation:
        return None
    if right.frame is not None and not _frame_fits(pair):
        return None
    shared = (
        _same_subject(last, right)
        and len(left.clauses) == 1
        and last.frame is None
        and right.frame is None
        and not cue.own_subject
        and last.role == "assertion"
        and last.clause.verb != right.clause.verb
        and last.clause.tense == right.clause.tense
        and rng.uniform("shared_subject") < _SHARED_SUBJECT
    )
    joined = right._replace(link="coordinate", cue=cue.text, shared_subject=shared)
    return _extend(left, joined, cue.text)


def _frame_fits(pair: Pair) -> bool:
    """Whether a framed clause can be joined: "…, but I love how …", not "…, so I love how …".

    Nor after another frame, nor where the frame's lead needs a comma of its own.
    """
    frame = pair.right.frame
    assert frame is not None
    if any(clause.frame for clause in pair.left.clauses):
        return False
    if pair.link.kind in ("justification", "sequence"):
        return False
    last = frame.lead.parts[-1] if frame.lead is not None else ""
    return not (isinstance(last, str) and last.endswith(","))


def conjunction(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Join with "and": "Alice is polite, and she has a cat"."""
    if pair.link.kind in ("infer", "none") and not _same_subject(pair.last, pair.right):
        return None
    if _opposed(pair.last, pair.right) or pair.last.topic != pair.right.topic:
        return None
    cue = rng.marker(lexicon.markers["conjunction"])
    return _coordinate(pair, cue, rng, _MOST_UNCUED) if cue else None


def merge(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Join what shares subject and verb: "is kind, curious and brave", "has a cat and a dog"."""
    last, right = pair.last, pair.right
    if last.clause.verb != right.clause.verb or last.link != "main":
        return None
    if not (_plain(last) and _plain(right) and _same_subject(last, right)):
        return None
    if _opposed(last, right) or _shell(last.clause) != _shell(right.clause):
        return None
    one, other = last.clause, right.clause
    if isinstance(other.complement, AdjectivePhrase) and _mergeable(one.complement):
        clause = one._replace(complement=_with_item(one.complement, other.complement))
    elif one.verb == "have" and other.object and one.object and not one.adverbials:
        clause = one._replace(object=_with_item(one.object, other.object))
    else:
        return None
    strength = "somewhat" if "somewhat" in (last.strength, right.strength) else last.strength
    return _replace_last(
        pair.left,
        last._replace(
            clause=clause,
            facts=(*last.facts, *right.facts),
            strength=strength,
            gradable=False,
        ),
    )


def _shell(clause: Clause) -> Clause:
    """Return a clause without what a merge joins: what is left must be equal on both sides."""
    return clause._replace(complement=None, object=None)


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
    if len(left.clauses) > 1 or not (_plain(last) and _plain(right)):
        return None
    subject = right.clause.subject
    if subject is None or not subject.entity:
        return None
    if _last_mention(last.clause) == subject.entity and not _same_subject(last, right):
        return _extend(left, right._replace(link="object_relative"))
    if not _same_subject(last, right) or pair.link.fixed_order or _opposed(last, right):
        return None
    if last.topic != right.topic:
        return None
    main, inner = last, right
    if _describes(last) and not _describes(right) and pair.link.kind != "elaboration":
        main, inner = right, last
    # Two qualities are better merged: not "Alice, who is kind, is brave".
    if not _describes(inner) or (main.clause.verb == inner.clause.verb == "be"):
        return None
    joined = (main._replace(link="main"), inner._replace(link="relative"))
    return (left._replace(clauses=joined),)


def _describes(plan: ClausePlan) -> bool:
    return plan.clause.verb in ("be", "have") and not plan.clause.perfect


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
    """Say a possession after "with": "The White Rabbit is small, with pink eyes"."""
    left, last, right = pair.left, pair.last, pair.right
    if len(left.clauses) > 1 or not (_plain(last) and _plain(right)) or last.clause.asides:
        return None
    if last.clause.verb != "be" or right.clause.negated or last.topic != right.topic:
        return None
    owned = _owned(last, right)
    cue = rng.marker(lexicon.markers["with_cue_word"])
    if owned is None or cue is None or _opposed(last, right):
        return None
    aside = Text((cue.text, *owned))
    clause = last.clause._replace(asides=(aside,))
    facts = (*last.facts, *right.facts)
    return _replace_last(left, last._replace(clause=clause, facts=facts), cue.text)


def _owned(last: ClausePlan, right: ClausePlan) -> tuple[str | Cased, ...] | None:
    """Return what the right clause says that the left one's subject has."""
    clause = right.clause
    if clause.verb == "have" and _same_subject(last, right) and not clause.adverbs:
        if isinstance(clause.object, Text) and not clause.adverbials and not clause.perfect:
            return clause.object.parts
        return None
    part, quality = clause.subject, clause.complement
    if part is None or part.possessor is None or clause.verb != "be" or clause.tense != "present":
        return None
    own = part.possessor == last.clause.subject and part.number == "plural"
    if own and isinstance(quality, AdjectivePhrase):
        return (Cased(part._replace(possessor=None, adjectives=(quality,))),)
    return None


def also_cue_word(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Begin a new sentence with "also": "She also has a cat"."""
    right = pair.right
    if not _same_subject(pair.last, right) or not _plain(right) or right.clause.adverbs:
        return None
    if pair.last.topic != right.topic or _describes(pair.last) != _describes(right):
        return None
    if right.clause.negated or _opposed(pair.last, right):
        return None
    cue = rng.marker(lexicon.markers["also_cue_word"])
    if cue is None:
        return None
    if cue.place == "connective":
        return (pair.left, SentencePlan((right,), connective=cue.text, words=(cue.text,)))
    clause = right.clause._replace(adverbs=(cue.text,))
    return (pair.left, SentencePlan((right._replace(clause=clause),), words=(cue.text,)))


# With a cue word


def _cued(pair: Pair, markers: tuple[Marker, ...], rng: OperatorDraws) -> Joint | None:
    """Join with a cue word that suits the relation, the clauses and the speaker."""
    able = [marker for marker in markers if marker.text not in pair.left.words]
    while able:
        cue = rng.marker(able)
        assert cue is not None
        joint = _joined(pair, cue, rng)
        if joint is not None:
            return joint
        able.remove(cue)
    return None


def _joined(pair: Pair, cue: Marker, rng: OperatorDraws) -> Joint | None:
    """Join with one cue word, turning the clauses round where it introduces the other one."""
    right_role = "nucleus" if pair.link.satellite_first else "satellite"
    introduced = pair.right
    if cue.role and cue.role != right_role:
        introduced = pair.last
    if cue.attach in ("coordinate", "connective"):
        turned = pair if introduced is pair.right else _turned(pair)
        if turned is None:
            return None
        if cue.attach == "connective":
            if len(turned.left.clauses) > 1 and turned is not pair:
                return None
            new = SentencePlan((turned.right,), connective=cue.text, words=(cue.text,))
            return (turned.left, new)
        return _coordinate(turned, cue, rng, _MOST_CUED)
    if not (_plain(pair.last) and _plain(pair.right)):
        return None
    if cue.attach == "subordinate":
        turned = pair if introduced is pair.right else _turned(pair)
        if turned is None or len(turned.left.clauses) >= _MOST_CUED:
            return None
        if turned.last.link not in ("main", "coordinate") or turned.last.shared_subject:
            return None
        return _extend(
            turned.left, turned.right._replace(link="subordinate", cue=cue.text), cue.text
        )
    if len(pair.left.clauses) > 1 or pair.link.fixed_order:
        return None
    main = pair.right if introduced is pair.last else pair.last
    front = introduced._replace(link="fronted", cue=cue.text)
    sentence = pair.left._replace(clauses=(front, main), words=(*pair.left.words, cue.text))
    return (sentence,)


def _turned(pair: Pair) -> Pair | None:
    """Return the pair in the other order, if nothing before it or in it forbids that."""
    if len(pair.left.clauses) > 1 or pair.link.fixed_order or pair.left.connective:
        return None
    if not (_plain(pair.last) and _plain(pair.right)):
        return None
    return Pair(pair.left._replace(clauses=(pair.right,)), pair.last, pair.link)


def contrast_cue_word(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Mark a contrast: but, while, however."""
    return _cued(pair, lexicon.markers["contrast_cue_word"], rng)


def justify_cue_word(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Mark a justification: because, since, so."""
    return _cued(pair, lexicon.markers["justify_cue_word"], rng)


def concede_cue_word(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Mark a concession: although, even though, but."""
    return _cued(pair, lexicon.markers["concede_cue_word"], rng)


def sequence_cue_word(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Mark what happens next: and then, after that."""
    return _cued(pair, lexicon.markers["sequence_cue_word"], rng)


# What is said again


def merge_with_comma(pair: Pair, *, rng: OperatorDraws, lexicon: Lexicon) -> Joint | None:
    """Say an attribute again after a comma: "curious, really curious"."""
    last, right = pair.last, pair.right
    said = last.clause.complement
    again = right.clause.complement
    if last.clause.degree or not isinstance(said, AdjectivePhrase):
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
    return _replace_last(
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

    `name` is its style parameter, whose value times `factor` is its weight in the draw.
    """

    name: str
    apply: PairRewrite
    factor: float = 1.0


# For each relation, the operators that compete for it.
COMPETING: dict[str, tuple[Joiner, ...]] = {
    "none": (Joiner("period", period),),
    "infer": (
        Joiner("period", period),
        Joiner("conjunction", conjunction),
        Joiner("merge", merge, 1.5),
        Joiner("relative_clause", relative_clause),
        Joiner("with_cue_word", with_cue_word),
        Joiner("also_cue_word", also_cue_word),
    ),
    "elaboration": (
        Joiner("period", period, 0.6),
        Joiner("conjunction", conjunction, 0.6),
        Joiner("relative_clause", relative_clause, 1.5),
        Joiner("with_cue_word", with_cue_word),
    ),
    "contrast": (
        Joiner("contrast_cue_word", contrast_cue_word),
        Joiner("conjunction", conjunction, 0.05),
        Joiner("period", period, 0.02),
    ),
    "justification": (
        Joiner("justify_cue_word", justify_cue_word),
        Joiner("period", period, 0.3),
    ),
    "concession": (Joiner("concede_cue_word", concede_cue_word), Joiner("period", period, 0.02)),
    "sequence": (
        Joiner("sequence_cue_word", sequence_cue_word),
        Joiner("conjunction", conjunction, 0.6),
        Joiner("period", period, 0.8),
    ),
    "restatement": (Joiner("merge_with_comma", merge_with_comma),),
}
