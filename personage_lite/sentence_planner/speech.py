"""Marks of speech around and inside a sentence: openers, tags, vocatives, oaths, stutters.

Source: Mairesse & Walker 2011, section 4.4; the paper, section IV-C and figure 7.
"""

from __future__ import annotations

from typing import Final

from personage_lite.lexicon import Lexicon
from personage_lite.operators import OperatorDraws
from personage_lite.plan import Frame, SentencePlan
from personage_lite.realizer.specification import Cased, NounPhrase, Phrase, Text
from personage_lite.sentence_planner.fitting import suits
from personage_lite.sentence_planner.hedges import (
    EMPHASIZED,
    HEDGED,
    degree_fits,
    doubtful,
    hedged,
    middle_free,
    opener_fits,
    replaced,
    start_fits,
    unhedged,
    with_degree,
    with_opener,
)
from personage_lite.sentence_planner.joining import describes, kind_of, says, words_after_verb

_TWICE: Final = 0.01
_BEFORE_ADJECTIVE: Final = 0.5
_MOST_MARKS: Final = 1
STUTTER: Final = "stutter"
FALSE_START: Final = "false start"
# One starts again only where there is something to search for: not "he is… he's shy".
_WORTH_STARTING_AGAIN: Final = 3
# What takes more different words is news, not a judgement that one can share.
_SHORT_JUDGEMENT: Final = 5


def _opener(
    plan: SentencePlan, kind: str, places: tuple[str, ...], rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Put one of a kind's openers before a sentence."""
    first = plan.clauses[0] if plan.clauses else None
    sworn = first is not None and first.frame is not None and EMPHASIZED in first.marks
    announced = rng.announced and plan.first
    if not opener_fits(plan) or sworn or announced or crowded(plan):
        return None
    able = [item for item in lexicon.markers[kind] if item.place in places]
    if first is not None:
        able = [item for item in able if suits(item, first)]
    marker = rng.marker(able)
    return None if marker is None else with_opener(plan, marker)


def crowded(plan: SentencePlan) -> bool:
    """Whether a sentence carries as many marks of speech as one person puts into one."""
    marks = len(plan.openers) + bool(plan.tag) + bool(plan.vocative) + bool(plan.hesitation)
    for clause in plan.clauses:
        marks += bool(clause.clause.interruption)
        marks += clause.frame is not None and EMPHASIZED in clause.marks
    return marks >= _MOST_MARKS


def acknowledgments(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Answer the listener: "Yeah, …", "I see! You want …"."""
    if plan.fragment is not None:
        if plan.terminal != "?" or not any(map(_is_mention, plan.fragment.parts)):
            return None
        return _opener(plan, "acknowledgments", ("question",), rng, lexicon)
    if not plan.first:
        return None  # one answers before one speaks, not in between
    # Who asks "you want to hear about …?" answers "of course!", not "oh yeah, …".
    places = ("answer",) if plan.answers else ("sentence", "utterance")
    return _opener(plan, "acknowledgments", places, rng, lexicon)


def filled_pauses(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Hesitate: "Alice is, um, curious", "Alice… um, she never asks".

    Chatty speakers say "like" and "you know".
    """
    if crowded(plan) or rng.has_said(STUTTER) or rng.has_said(FALSE_START):
        return None  # one stumble is enough
    if plan.afterthought:
        return None  # and one doubt: not "she, er, purrs, if I remember right"
    for index, clause in enumerate(plan.clauses):
        if clause.link not in ("main", "coordinate") or clause.role == "recall":
            continue
        starting = index == 0 and start_fits(plan)
        free = middle_free(clause)
        places = ["pause"] if free or starting else []
        if index == 0 and opener_fits(plan) and (plan.answers or not plan.first):
            places.append("answer" if plan.answers else "opener")
        able = tuple(
            marker
            for marker in lexicon.markers["filled_pauses"]
            if marker.place in places
            and suits(marker, clause)
            and (free or marker.lean < 0 or marker.place != "pause")
            # Nobody gropes for words and stresses them at once, nor says "like" twice, nor
            # "I think she, er, …".
            and not (marker.lean < 0 and (EMPHASIZED in clause.marks or clause.frame))
            and not says(clause.clause, marker.text)
        )
        marker = rng.marker(able)
        if marker is None:
            continue
        if marker.place != "pause":
            return with_opener(plan, marker)
        if marker.lean < 0:
            clause = clause._replace(marks=(*clause.marks, HEDGED))
            if starting:
                return replaced(plan, index, clause, marker.text)._replace(hesitation=marker.text)
        paused = clause.clause._replace(interruption=marker.text)
        return replaced(plan, index, clause._replace(clause=paused), marker.text)
    return None


def expletives(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
    """Swear: only with the rating "strong"."""
    return _oath(plan, "expletives", rng, lexicon) if rng.rating == "strong" else None


def near_expletives(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Almost swear: "Oh my gosh, …"; not with the rating "clean"."""
    return _oath(plan, "near_expletives", rng, lexicon) if rng.rating != "clean" else None


def _oath(
    plan: SentencePlan, kind: str, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Put an oath before an adjective that has no degree yet, or before the sentence."""
    if plan.fragment is not None or doubtful(plan):
        return None
    for index, clause in enumerate(plan.clauses):
        if not (unhedged(clause) and degree_fits(clause)) or clause.strength == "somewhat":
            continue
        marker = rng.marker([m for m in lexicon.markers[kind] if m.place == "degree"])
        if marker is not None and rng.uniform("degree") < _BEFORE_ADJECTIVE:
            return replaced(plan, index, with_degree(clause, marker.text, EMPHASIZED), marker.text)
    # One swears when one begins, not in passing; nor at how one loves what comes.
    begins = plan.first and not plan.answers
    if plan.clauses[0].clause.quotation or plan.clauses[0].frame or not begins:
        return None
    return _opener(plan, kind, ("opener",), rng, lexicon)


def competence_mitigation(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Say that it is common knowledge: "everybody knows that …"."""
    if not plan.clauses or plan.connective or plan.openers or plan.clauses[0].frame is not None:
        return None
    first = plan.clauses[0]
    if first.story or not describes(first):
        return None  # nobody knows already what happens
    alone = len(plan.clauses) == 1 and not first.clause.quotation
    able = [
        marker
        for marker in lexicon.markers["competence_mitigation"]
        if marker.place == "opener" or alone
    ]
    marker = rng.marker(able)
    if marker is None:
        return None
    if marker.place == "opener":
        return with_opener(hedged(plan), marker)
    frame = Frame("clause", Text((marker.text,)), inner_tag=True)
    return replaced(plan, 0, first._replace(frame=frame), marker.text)


def tag_question(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Ask back: "…, isn't she?", "…, right?"."""
    if not plan.clauses or plan.afterthought or plan.tag or plan.false_start or plan.answers:
        return None
    # What was just announced as news, or sworn to, is not asked back.
    if (rng.announced and plan.first) or any(opener.mark == "?" for opener in plan.openers):
        return None
    if plan.hesitation or any(clause.clause.interruption for clause in plan.clauses):
        return None
    last = plan.clauses[-1]
    if last.link in ("object_relative", "subordinate") or last.clause.quotation:
        return None
    if crowded(plan) or last.role in ("repetition", "restatement"):
        return None
    host = [c for c in plan.clauses if c.link in ("main", "coordinate")][-1]
    if host.frame is not None and not host.frame.inner_tag:
        return None
    if doubtful(plan):
        return None
    # The listener can be asked to agree what somebody is like, but not what happens, nor a plain
    # fact, nor what somebody is not.
    spec = last.clause
    judged = spec.verb == "be" and not (spec.negated or spec.modal) and last.polarity != "neutral"
    if not judged or not describes(last) or last.story:
        return None
    # Not "she's shy and thinks …, isn't she?", nor "he's too shy to …, isn't he?".
    going_on = {lexicon.grammar.words.infinitive}
    going_on.update(marker.text for marker in lexicon.markers["conjunction"])
    judgement = words_after_verb(spec)
    if not going_on.isdisjoint(judgement) or len(judgement) > _SHORT_JUDGEMENT:
        return None
    # "Her husband is shy, isn't it?": of a part nobody knows who or what it is.
    known = _is_somebody(spec.subject)
    agreeing = known and (host.frame is None or host.frame.form == "clause")
    able = [
        marker
        for marker in lexicon.markers["tag_question"]
        if suits(marker, last) and (agreeing or marker.text != "auto")
    ]
    marker = rng.marker(able)
    if marker is None:
        return None
    return plan._replace(tag=marker.text, words=(*plan.words, marker.text))


def exclamation(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
    """End with an exclamation mark; not what is asked or hedged."""
    if plan.fragment is not None or plan.tag or plan.afterthought or plan.terminal != ".":
        return None
    if plan.false_start or STUTTER in plan.words:
        return None
    if doubtful(plan):
        return None
    felt = {clause.feeling for clause in plan.clauses} - {""}
    if "sad" in felt:
        return None  # who is moved says it softly
    # What leaves everybody cold is cried out only by who cries out everything.
    if not felt and rng.uniform("plain") >= rng.parameter("exclamation"):
        return None
    # Made anew: `_replace` takes several times as long.
    return tuple.__new__(SentencePlan, (*plan[:10], "!", *plan[11:]))


def in_group_marker(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Address the listener as one of us: "You guys, …!", "…, buddy!"."""
    if plan.vocative or plan.terminal == "…" or plan.afterthought or crowded(plan):
        return None
    if not plan.clauses:
        return None
    (first, *more) = plan.clauses
    places = set()
    # One nudges a friend after a judgement that there is something to.
    if not more and first.feeling and kind_of(first) == "quality":
        places.add("end")
    if plan.first and opener_fits(plan) and not rng.announced and not plan.answers:
        places.add("opener")
    markers = lexicon.markers["in_group_marker"]
    marker = rng.marker([m for m in markers if m.place in places and suits(m, first)])
    if marker is None:
        return None
    if marker.place == "opener":
        return with_opener(plan, marker)
    return plan._replace(vocative=marker.text, words=(*plan.words, marker.text))


def stuttering(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
    """Repeat the first letters of the name that opens the utterance: "Al-Alice" (figure 7)."""
    if not plan.first or not plan.clauses:
        return None
    first = plan.clauses[0]
    subject = first.clause.subject
    if first.marks or plan.afterthought:
        return None  # a doubt is hesitation enough
    if not isinstance(subject, NounPhrase) or any(opener.mark for opener in plan.openers):
        return None
    if first.frame is not None and _mentions(first.frame.lead):
        return None  # the name has been said before
    times = 2 if rng.uniform("twice") < _TWICE else 1
    owner = subject.possessor
    if isinstance(owner, NounPhrase):
        stuttered = subject._replace(possessor=owner._replace(stutter=times))
    else:
        stuttered = subject._replace(stutter=times)
    clause = first._replace(clause=first.clause._replace(subject=stuttered))
    return replaced(plan, 0, clause, STUTTER)


def object_ellipsis(
    plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
) -> SentencePlan | None:
    """Break off after the verb and start again: "Alice is … Alice is curious"."""
    if not plan.clauses or plan.openers or plan.connective or STUTTER in plan.words:
        return None
    first = plan.clauses[0]
    if first.marks:
        return None
    if first.link != "main" or first.frame is not None or first.clause.interruption:
        return None
    if not _is_somebody(first.clause.subject):
        return None  # "her classics teacher was…" would be said all over again
    if first.clause.preposed:
        return None
    if any(clause.link == "relative" for clause in plan.clauses):
        return None
    # Not "she has… she has to", nor "she has… she even has".
    infinitive = lexicon.grammar.words.infinitive
    if not describes(first) or first.clause.adverbs or says(first.clause, infinitive):
        return None
    if first.clause.negated or len(words_after_verb(first.clause)) < _WORTH_STARTING_AGAIN:
        return None
    return plan._replace(false_start=True, words=(*plan.words, FALSE_START))


def _is_somebody(subject: Phrase | None) -> bool:
    return isinstance(subject, NounPhrase) and subject.entity != ""


def _mentions(text: Text | None) -> bool:
    return text is not None and any(map(_is_mention, text.parts))


def _is_mention(part: Phrase | Cased) -> bool:
    return isinstance(part, Cased)
