"""Discourse: what ties a sentence to the talk before it, put in front of its first clause.

A setting ("at the trial") opens a topic, a shift ("anyway") leaves one, and "as I said" takes up
what was told before. All three are ours; compare Reiter & Dale 2000, section 4.3, on discourse
structure, and Mairesse & Walker 2011, section 4.3, on cue words.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Final

from personage_lite.facts import Character, entity_of
from personage_lite.lexicon import Marker
from personage_lite.operators import Turn
from personage_lite.plan import ClausePlan, ContentPlan, Made, SentencePlan, Status
from personage_lite.realizer.specification import Cased, Text
from personage_lite.sentence_planner import hedges, speech
from personage_lite.sentence_planner.fitting import suits
from personage_lite.sentence_planner.joining import words_after_verb
from personage_lite.sentence_planner.templates import lead_text, topic_told

STAGE: Final = "aggregation"
# The letters of a word that is heard when it comes twice.
_HEARD: Final = 4


def with_openings(
    sentences: list[SentencePlan], plan: ContentPlan, character: Character, turn: Turn
) -> tuple[list[SentencePlan], list[Made]]:
    """Tie each sentence to what came before it, and open with what the content plan asks for.

    Returns the sentences and the decisions.
    """
    placed = [sentences[0]]
    for earlier, sentence in pairwise(sentences):
        subjects = {entity_of(clause.clause.subject) for clause in earlier.clauses}
        if len(subjects) == 1:
            # Made anew: `_replace` takes twice as long.
            fields = (*sentence[:4], subjects.pop(), *sentence[5:])
            sentence = tuple.__new__(SentencePlan, fields)
        placed.append(sentence)
    decisions: list[Made] = []
    topic_before = topic_told(character, turn)
    topic, unset, shifted = topic_before, "", False
    plain = not (plan.mitigation or plan.rejection or plan.confirmation)
    for index, sentence in enumerate(placed):
        first = sentence.clauses[0]
        again = not index and _told_before(sentence, character, turn)
        if again or first.role == "recall":
            placed[index] = _recalling(sentence, turn)
        elif first.topic != topic or topic == unset:
            follows = bool(topic) and topic != unset and (index > 0 or plain) and not shifted
            placed[index], made = _new_topic(sentence, character, turn, index, follows)
            decisions += made
            done = {name for name, _, _, _, status, _, _, _ in made if status == "applied"}
            shifted = shifted or "topic_shift" in done
            # A setting that did not fit this sentence is said with the next.
            unset = "" if done else first.topic
        topic = sentence.clauses[-1].topic
    first = placed[0].clauses[0]
    announced, noted = (None, None)
    if plain and turn.state.topic == character.entity.id:
        announced, noted = _anticipated(placed, turn)
    decisions += [noted] if noted is not None else []
    if announced is not None:
        placed.insert(0, announced)
    if plan.mitigation:
        rng = turn.rng("competence_mitigation/place")
        opened = speech.competence_mitigation(placed[0], rng=rng, lexicon=turn.lexicon)
        placed[0] = opened or placed[0]
    if plan.rejection:
        marker = turn.rng("initial_rejection").marker(turn.lexicon.markers["initial_rejection"])
        if marker is not None:
            placed[0] = hedges.with_opener(hedges.hedged(placed[0]), marker)
    if plan.confirmation:
        marker = _confirming(placed, turn)
        if marker is not None:
            words = lead_text(marker.text, character.entity.phrase)
            if marker.after == "?":
                placed[0] = placed[0]._replace(answers=True)
            asked = SentencePlan(fragment=words, terminal=marker.after, words=(marker.text,))
            placed.insert(0, asked)
    return placed, decisions


def _confirming(sentences: list[SentencePlan], turn: Turn) -> Marker | None:
    """Choose the words that confirm the topic; not "I love him! … I love how …"."""
    framed = [c.frame.lead for s in sentences for c in s.clauses if c.frame and c.frame.lead]
    said = {word for lead in framed for part in lead.parts for word in str(part).split(" ")}
    able = list(turn.lexicon.markers["request_confirmation"])
    for word in said:
        if len(word) >= _HEARD:
            able = [marker for marker in able if word not in marker.text]
    return turn.rng("request_confirmation").marker(able)


def _told_before(sentence: SentencePlan, character: Character, turn: Turn) -> bool:
    """Whether the talk goes round again, and this is drawn to be said of the turn's first fact."""
    told = turn.state.told_of(character.entity.id)
    again = sentence.clauses[0].facts[0] in told and _plain_start(sentence.clauses[0])
    return again and turn.draws.uniform("recall/again") < turn.probability("recall")


def _anticipated(
    sentences: list[SentencePlan], turn: Turn
) -> tuple[SentencePlan | None, Made | None]:
    """Announce, if drawn, what the speaker looks forward to telling: "Wait till you hear this!"."""
    probability = turn.probability("anticipation")
    first = sentences[0].clauses[0]
    if probability <= 0.0:
        return None, None
    draw = turn.draws.uniform("anticipation")
    status: Status = "not_drawn"
    said = None
    if draw < probability:
        status = "not_applicable"
        # What is promised must come, and at once: not "this is the funny part" before what nobody
        # laughs at, nor before what somebody said, which is no point without its occasion.
        told = [clause for clause in sentences[0].clauses if not clause.clause.quotation]
        # Nor does one fact live up to it.
        told = told if len(sentences) > 1 or len(told) > 1 else []
        able = [
            marker
            for marker in turn.lexicon.markers["anticipation"]
            if any(suits(marker, clause) for clause in told)
        ]
        marker = turn.rng("anticipation").marker(able)
        plain = first.role == "assertion" and first.frame is None  # not "the best bit! I love …"
        if marker is not None and plain and not sentences[0].openers:
            said = _fragment(marker)
            status = "applied"
    return said, ("anticipation", STAGE, probability, draw, status, "", "", "")


def with_reaction(
    sentences: list[SentencePlan], turn: Turn
) -> tuple[list[SentencePlan], list[Made]]:
    """Say, if drawn, what one feels about what was told last: "Can you believe it?".

    It comes after all other operators, because it needs a sentence that does not ask back itself.
    """
    probability = turn.probability("reaction")
    if probability <= 0.0:
        return sentences, []
    draw = turn.draws.uniform("reaction")
    status: Status = "not_drawn"
    if draw < probability:
        status = "not_applicable"
        last = sentences[-1]
        clause = last.clauses[-1]
        asks = last.tag or last.afterthought or last.fragment or clause.role != "assertion"
        felt = {part.feeling for part in last.clauses if part.feeling}
        # "I love how …" is reaction enough; and nobody laughs at one half and weeps at the other,
        # nor says "Oh, I love him! … It's so sad!".
        clear = felt == {clause.feeling} and not any(map(_reacting, sentences))
        clear = clear and not (clause.feeling == "sad" and sentences[0].fragment is not None)
        if clear and not asks and not hedges.doubtful(last):
            able = [marker for marker in turn.lexicon.markers["reaction"] if suits(marker, clause)]
            # Not "he gets really sad. Isn't that sad?".
            heard = words_after_verb(clause.clause)
            able = [marker for marker in able if heard.isdisjoint(marker.text.split(" "))]
            words = {word for sentence in sentences for word in sentence.words}
            marker = turn.rng("reaction", words).marker(able)
            if marker is not None:
                sentences = [*sentences, _fragment(marker)]
                status = "applied"
    return sentences, [("reaction", "pragmatic_markers", probability, draw, status, "", "", "")]


def _reacting(sentence: SentencePlan) -> bool:
    """Whether a sentence announces, or says by a frame, what the speaker thinks or feels of it."""
    if sentence.fragment is not None:
        return not any(isinstance(part, Cased) for part in sentence.fragment.parts)
    return any(clause.frame is not None for clause in sentence.clauses)


def _fragment(marker: Marker) -> SentencePlan:
    words = (marker.text,)
    return SentencePlan(fragment=Text(words), terminal=marker.after or ".", words=words)


def _recalling(sentence: SentencePlan, turn: Turn) -> SentencePlan:
    """Say of something that it was told before: "As I said, …"."""
    marker = turn.rng("recall").marker(turn.lexicon.markers["recall"])
    return sentence if marker is None else hedges.with_opener(sentence, marker)


def _new_topic(
    sentence: SentencePlan, character: Character, turn: Turn, index: int, follows: bool
) -> tuple[SentencePlan, list[Made]]:
    """Open a topic with its setting, or leave the topic before with a word, if drawn.

    `follows` says whether there was a topic before in this talk.
    """
    decisions: list[Made] = []
    placed = character.topics[sentence.clauses[0].topic].setting is not None
    for name, due in (("setting", placed), ("topic_shift", follows)):
        probability = turn.probability(name) if due else 0.0
        if probability <= 0.0:
            continue
        draw = turn.draws.uniform(f"{name}/{index}")
        changed = None
        status: Status = "not_drawn"
        if draw < probability:
            if name == "setting":
                changed = _with_setting(sentence, character)
            else:
                changed = _with_shift(sentence, turn, index)
            status = "not_applicable" if changed is None else "applied"
        place = f"sentence {index + 1}"
        decisions.append((name, STAGE, probability, draw, status, place, "", ""))
        if changed is not None:
            return changed, decisions
    return sentence, decisions


def _with_setting(sentence: SentencePlan, character: Character) -> SentencePlan | None:
    """Put the topic's setting before the first clause; it must hold of all that is said with it."""
    first = sentence.clauses[0]
    setting = character.topics[first.topic].setting
    if setting is None or any(clause.topic != first.topic for clause in sentence.clauses):
        return None
    if not _plain_start(first):
        return None
    clause = first._replace(clause=first.clause._replace(preposed=(setting,)))
    # "Near the end of the trial, …" says more than "Then, …".
    return sentence._replace(clauses=(clause, *sentence.clauses[1:]), connective="")


def _plain_start(first: ClausePlan) -> bool:
    return first.frame is None and first.link == "main" and first.role == "assertion"


def _with_shift(sentence: SentencePlan, turn: Turn, index: int) -> SentencePlan | None:
    """Put a word before the sentence that says that something else comes now: "Anyway, …"."""
    if not hedges.opener_fits(sentence) or not _plain_start(sentence.clauses[0]):
        return None
    rng = turn.rng(f"topic_shift/{index}", set(sentence.words))
    able = [m for m in turn.lexicon.markers["topic_shift"] if suits(m, sentence.clauses[0])]
    marker = rng.marker(able)
    return None if marker is None else hedges.with_opener(sentence, marker)
