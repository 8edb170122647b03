"""The sentence planner: messages to sentences, in the stages of PERSONAGE.

Templates, aggregation, pragmatic markers, lexical choice, referring expressions; then assembly
into deep syntax. Source: Mairesse & Walker 2011, section 4; the paper, section IV-C.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

from personage_lite.facts import TELLING_KINDS, Character
from personage_lite.operators import Operator, Turn, run_operators
from personage_lite.plan import (
    ClausePlan,
    ContentPlan,
    Link,
    Made,
    SentencePlan,
    Status,
)
from personage_lite.randomness import pick
from personage_lite.realizer.specification import Cased, Sentence
from personage_lite.sentence_planner import hedges, rewording, speech
from personage_lite.sentence_planner.aggregation import COMPETING, UNCUED
from personage_lite.sentence_planner.assembly import assemble
from personage_lite.sentence_planner.discourse import with_openings, with_reaction
from personage_lite.sentence_planner.joining import Joint, Pair, plain
from personage_lite.sentence_planner.lexical_choice import LexicalChoice
from personage_lite.sentence_planner.referring_expressions import ReferringExpressions
from personage_lite.sentence_planner.templates import PlainClauses, select_templates

# The order in which pragmatic markers are offered: what changes a clause comes before what
# stands around the sentence, for the latter looks at the former.
PRAGMATIC_MARKERS: Final[tuple[Operator, ...]] = (
    Operator("subject_implicitness", rewording.subject_implicitness, limit=2),
    Operator("negation", rewording.negation, limit=1),
    Operator("weakened_positive_content", hedges.weakened_positive_content, limit=2),
    Operator("softener_hedges", hedges.softener_hedges, limit=1),
    Operator("informal_softeners", hedges.informal_softeners, limit=1),
    Operator("emphasizer_hedges", hedges.emphasizer_hedges, limit=2),
    Operator("stuttering", speech.stuttering, limit=1),
    Operator("object_ellipsis", speech.object_ellipsis, limit=1),
    Operator("in_group_marker", speech.in_group_marker, limit=1),
    Operator("expletives", speech.expletives, limit=1),
    Operator("near_expletives", speech.near_expletives, limit=1),
    Operator("acknowledgments", speech.acknowledgments, limit=1),
    Operator("filled_pauses", speech.filled_pauses, limit=1),
    Operator("tag_question", speech.tag_question, limit=1),
    Operator("exclamation", speech.exclamation, limit=4),
)
# What surrounds the first sentence that states a fact.
_OPENING: Final = SentencePlan(first=True)
# The relations that a sentence can do without where a stronger one follows.
_LOOSE: Final = ("infer", "elaboration")
_LAST: Final = Link("none")


class PlannedSentences(NamedTuple):
    """What the sentence planner hands on: the realizer's input, and what to remember."""

    sentences: tuple[Sentence, ...]
    facts: tuple[str, ...]
    made: tuple[Made, ...]
    markers: frozenset[str]
    mentioned: frozenset[str]
    focus: frozenset[str]
    focus_subject: str


def plan_sentences(
    plan: ContentPlan,
    character: Character,
    plain: PlainClauses,
    turn: Turn,
    operators: Sequence[Operator],
) -> PlannedSentences:
    """Turn a content plan into sentences, ready for the realizer.

    `plain` holds the character's facts as clauses.
    """
    clauses, decisions, used = select_templates(plan, character, plain, turn)
    sentences, joined = aggregate(clauses, plan.links, turn)
    decisions += joined
    sentences, opened = with_openings(sentences, plan, character, turn)
    decisions += opened
    decisions += run_operators(sentences, operators, "pragmatic_markers", turn)
    sentences, reacted = with_reaction(sentences, turn)
    decisions += reacted
    words = LexicalChoice(turn)
    referring = ReferringExpressions(character, turn)
    assembled = []
    facts: list[str] = []
    marked = {*used}
    for index, sentence in enumerate(sentences):
        parts, contracted = words.clauses(sentence.clauses, index)
        if sentence.fragment is None:
            parts = referring.clauses(parts, contracted)
        elif any(isinstance(part, Cased) for part in sentence.fragment.parts):
            referring.fragment(sentence.fragment)
        for part in parts:
            facts += part.facts
        marked.update(sentence.words)
        assembled.append(assemble(sentence, parts))
    decisions += words.decisions
    decisions += referring.decisions
    marked.update(words.words)
    marked.update([name for name, _, _, _, status, _, _, _ in decisions if status == "applied"])
    told = tuple(dict.fromkeys(facts))
    made, markers = tuple(decisions), frozenset(marked)
    focus = (referring.focus, referring.focus_subject)
    # Made directly, here and below: a named tuple's own maker takes twice as long.
    fields = (tuple(assembled), told, made, markers, referring.said, *focus)
    return tuple.__new__(PlannedSentences, fields)


def aggregate(
    clauses: list[ClausePlan], links: tuple[Link, ...], turn: Turn
) -> tuple[list[SentencePlan], list[Made]]:
    """Join each clause to the sentence before it, by one of its relation's operators.

    An operator whose constraint does not hold is struck off and another one drawn.
    """
    done: list[SentencePlan] = []
    current = tuple.__new__(SentencePlan, ((clauses[0],), *_OPENING[1:]))
    decisions: list[Made] = []
    # What comes after each pair; nothing after the last.
    following = (*links, _LAST)[1:]
    for index, (clause, link, after) in enumerate(zip(clauses[1:], links, following, strict=True)):
        # Where clauses changed places, what the relation holds of is no longer the last one.
        last = current.clauses[-1]
        if last is not clauses[index] and not set(clauses[index].facts) <= set(last.facts):
            if clause.role in ("repetition", "restatement"):
                continue  # it would say again, alone, what was said before
            link = Link("none")
        # "It's touchy. It gets offended over nothing, so …": only what goes with it joins the "so".
        alone = after.kind in TELLING_KINDS and link.kind in _LOOSE
        (*before, current), made = _join(Pair(current, clause, link), index, turn, alone)
        decisions += made
        done += before
    return [*done, current], decisions


def _join(pair: Pair, index: int, turn: Turn, alone: bool) -> tuple[Joint, list[Made]]:
    """Join a pair by one of its relation's operators; one that stays `alone` begins a sentence."""
    decisions: list[Made] = []
    left, right, kind = pair.left, pair.right, pair.link.kind
    able = list(COMPETING["none" if alone else kind])
    if not (plain(pair.last) and plain(right)):
        able = [joiner for joiner in able if not joiner.embedding]
    parameters = turn.parameters
    weights = [factor * parameters[name] for name, _, factor, _ in able]
    if pair.last.role == "recall":
        # What was taken up is joined to what it explains or opposes, if it can be.
        weights = [0.0 if j.name in UNCUED else w for j, w in zip(able, weights, strict=True)]
    target = f"{kind} {index + 1}"
    while able:
        total = sum(weights)
        if not total:
            break
        draw = turn.draws.uniform(f"aggregation/{index}/{len(able)}")
        joiner = pick(draw, able, weights)
        name = joiner.name
        joint = joiner.apply(pair, rng=turn.rng(f"{name}/{index}"), lexicon=turn.lexicon)
        before = after = ""
        if joint is not None and turn.show is not None:
            before = f"{turn.show(left)} + {turn.show(SentencePlan((right,)))}"
            after = " ".join(turn.show(sentence) for sentence in joint)
        place = able.index(joiner)
        chance = weights[place] / total
        status: Status = "not_applicable" if joint is None else "applied"
        decisions.append((name, "aggregation", chance, draw, status, target, before, after))
        if joint is not None:
            return joint, decisions
        del able[place], weights[place]
    # What only says again what the sentence says already can be left out; all else stands alone.
    if kind == "restatement":
        return (left,), decisions
    return (left, SentencePlan((right,))), decisions
