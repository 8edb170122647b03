"""Cue words: operators that mark a relation with a word, only where the relation holds.

Source: Mairesse & Walker 2011, section 4.3.
"""

from __future__ import annotations

from typing import Final

from personage_lite.facts import OPPOSING_KINDS
from personage_lite.lexicon import Lexicon, Marker
from personage_lite.operators import OperatorDraws
from personage_lite.plan import SentencePlan
from personage_lite.sentence_planner.hedges import with_opener
from personage_lite.sentence_planner.joining import (
    MOST_CUED,
    Joint,
    Pair,
    coordinate,
    describes,
    extend,
    plain,
)

# Relations that one sentence marks only once.
_ONCE: Final = (*OPPOSING_KINDS, "sequence")


def _cued(pair: Pair, markers: tuple[Marker, ...], rng: OperatorDraws) -> Joint | None:
    """Join with a cue word that suits the relation, the clauses and the speaker."""
    able = [marker for marker in markers if marker.text not in pair.left.words]
    while able:
        cue = rng.marker(able)
        if cue is None:
            return None
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
    if pair.link.kind == "justification" and len(pair.left.clauses) > 1:
        return None  # the reason, or what it explains, would be taken for all that came before
    if pair.last.link == "relative":
        return None  # what comes would be set against the main clause
    begins = cue.attach == "beginning"
    if pair.link.kind in _ONCE and not begins and any(clause.cue for clause in pair.left.clauses):
        return None  # not "…, but …, yet …", nor "… and then …, and after that …"
    if len(pair.last.facts) > 1 and pair.link.kind in ("justification", "concession"):
        return None  # only one of two merged qualities is the reason, or is conceded
    deeds = not (describes(pair.last) and describes(pair.right))
    if cue.only == "states" and deeds:
        return None
    if begins:
        said_so = introduced is pair.right and pair.right.frame is None
        return (pair.left, with_opener(SentencePlan((pair.right,)), cue)) if said_so else None
    if cue.attach in ("coordinate", "connective"):
        turned = pair if introduced is pair.right else _turned(pair)
        if turned is None:
            return None
        if cue.attach == "connective":
            if pair.left.words:
                return None  # one reversal after another tires: "…, but … However, …"
            if turned.right.frame is not None:
                return None  # "Then, I love that …" would date the love, not the deed
            if len(turned.left.clauses) > 1 and turned is not pair:
                return None
            new = SentencePlan((turned.right,), connective=cue.text, words=(cue.text,))
            return (turned.left, new)
        return coordinate(turned, cue, rng, MOST_CUED)
    if not (plain(pair.last) and plain(pair.right)):
        return None
    if cue.attach == "subordinate":
        turned = pair if introduced is pair.right else _turned(pair)
        if turned is None or len(turned.left.clauses) >= MOST_CUED:
            return None
        if turned.last.link not in ("main", "coordinate") or turned.last.shared_subject:
            return None
        return extend(
            turned.left, turned.right._replace(link="subordinate", cue=cue.text), cue.text
        )
    if len(pair.left.clauses) > 1 or pair.link.fixed_order or pair.left.openers:
        return None
    if pair.right.following and introduced is pair.right:
        return None  # not "Although it's no big deal, …"
    main = pair.right if introduced is pair.last else pair.last
    front = introduced._replace(link="fronted", cue=cue.text)
    sentence = pair.left._replace(clauses=(front, main), words=(*pair.left.words, cue.text))
    return (sentence,)


def _turned(pair: Pair) -> Pair | None:
    """Return the pair in the other order, if nothing before it or in it forbids that."""
    begun = pair.left.connective or pair.left.openers  # "But …" is said of what came first
    if len(pair.left.clauses) > 1 or pair.link.fixed_order or begun:
        return None
    if pair.last.following or pair.right.following:
        return None  # "it's no big deal" comes after what is none
    if not (plain(pair.last) and plain(pair.right)):
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
