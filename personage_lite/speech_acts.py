"""Speech acts beside the facts: greetings, suggestions, farewells, in the style of X.

The words stand in `lexicons/dialog.yaml`; one is chosen by lean and freshness, and then the
pragmatic operators of the style run over the sentence, with the probabilities that they have for
facts. Source: the paper, section IV-A and figure 4; Mairesse & Walker 2011, section 4.4.
"""

from __future__ import annotations

import re
from math import exp
from typing import NamedTuple, TypeVar

from personage_lite.dialog_words import DialogWords, Part
from personage_lite.errors import PersonageError, shown
from personage_lite.lexicon import Lexicon, Marker
from personage_lite.names import checked_name
from personage_lite.operators import Operator, OperatorDraws, SentenceRewrite, Turn, run_operators
from personage_lite.plan import Decision, Made, SentencePlan, Status
from personage_lite.realizer import Realizer
from personage_lite.realizer.specification import Cased, NounPhrase, Phrase, Sentence, Text
from personage_lite.sentence_planner.assembly import assemble
from personage_lite.sentence_planner.hedges import with_opener
from personage_lite.sentence_planner.speech import STUTTER
from personage_lite.state import ConversationState

T = TypeVar("T")
STAGE = "pragmatic_markers"
_SLOT = re.compile(r"(\{topic\}|\{name\}|\{heard\})")
_MARK = re.compile(r"^([,.!?…])\s*(.*)$")
# How much rarer a line is that leans: a factor e^(-_RARE * lean²) before X is weighed.
_RARE = 4.0


class Said(NamedTuple):
    """A speech act: the text and all that explains it, as an `Utterance` has it for facts."""

    text: str
    act: str
    character: str
    x: float
    seed: int
    turn: int
    decisions: tuple[Decision, ...]
    sentences: tuple[Sentence, ...]
    state: ConversationState


class Slots(NamedTuple):
    """What stands in place of {topic}, {name} and {heard}."""

    topic: NounPhrase | None = None
    name: str = ""
    heard: str = ""


def speech_act(
    act: str, words: DialogWords, slots: Slots, turn: Turn, realizer: Realizer
) -> tuple[str, tuple[Decision, ...], tuple[Sentence, ...], frozenset[str]]:
    """Return text, decisions, sentences and marker words of one act.

    Raises `PersonageError` for an unknown act, and where a topic or name is needed but not given.
    """
    if act not in words.acts:
        raise PersonageError(f"no act '{shown(act)}'; choose from: {', '.join(words.acts)}")
    made: list[Made] = []
    plans: list[SentencePlan] = []
    for index, part in enumerate(words.acts[act]):
        said, decision = _part_said(part, act, index, turn)
        made += decision
        if said:
            line = _line(part.lines, turn.rng(f"{act}/{index}"))
            plans.append(_plan(line, act, slots))
    made += run_operators(plans, operators(words), STAGE, turn)
    sentences = tuple(assemble(plan, ()) for plan in plans)
    text = " ".join(realizer.realize(sentence) for sentence in sentences)
    marked = {word for plan in plans for word in plan.words}
    decisions = tuple(map(Decision._make, made))
    marked.update(decision.operator for decision in decisions if decision.status == "applied")
    return text, decisions, sentences, frozenset(marked)


def _part_said(part: Part, act: str, index: int, turn: Turn) -> tuple[bool, list[Made]]:
    """Return whether a part is said this time, and the decision about it if there is one."""
    if not part.parameter:
        return True, []
    probability = turn.probability(part.parameter)
    draw = turn.draws.uniform(f"{act}/{index}/said")
    status: Status = "applied" if draw < probability else "not_drawn"
    target = f"sentence {index + 1}"
    return draw < probability, [(part.parameter, STAGE, probability, draw, status, target, "", "")]


def _line(lines: tuple[Marker, ...], rng: OperatorDraws) -> Marker:
    """Return a line that suits X, rather a fresh one.

    Unlike a marker, which a speaker in the middle hardly ever says, one line must be said: so
    those who lean to one side are rarer the nearer X is to the middle.
    """
    able = [line for line in lines if rng.sounds_right(line)] or list(lines)
    pairs = zip(rng.weights(able), able, strict=True)
    return rng.choose("line", able, [weight * exp(-_RARE * line.lean**2) for weight, line in pairs])


def _plan(line: Marker, act: str, slots: Slots) -> SentencePlan:
    """Return a line as a plan, its slots filled."""
    parts: list[Phrase | Cased] = []
    for piece in _SLOT.split(line.text):
        if piece == "{topic}":
            parts.append(Cased(_given(slots.topic, act, "character")))
        elif piece == "{name}":
            name = checked_name(_given(slots.name or None, act, "name"))
            parts.append(Cased(NounPhrase(name, entity="listener", animate=True)))
        elif piece == "{heard}":
            words = _given(slots.heard or None, act, "heard")
            kept = "".join(sign for sign in words if sign.isprintable())
            parts.append(f"“{shown(' '.join(kept.split()))}”")
        elif piece.strip():
            parts += _spaced(piece.strip(), parts)
    return SentencePlan(fragment=Text(tuple(parts)), terminal=line.after or ".", words=(line.text,))


def _spaced(piece: str, before: list[Phrase | Cased]) -> list[Phrase | Cased]:
    """Return words after a slot, with a mark that they begin with by itself."""
    found = _MARK.match(piece) if before else None
    if found is None:
        return [piece]
    return [part for part in found.groups() if part]


def _given(value: T | None, act: str, what: str) -> T:
    if value is None:
        raise PersonageError(f"'{act}' says a {what}; give one")
    return value


# The operators, in the order in which they are offered.


def operators(words: DialogWords) -> tuple[Operator, ...]:
    """Return the operators on sentences of speech acts, with these words."""
    made: dict[str, SentenceRewrite] = {
        "stuttering": _stuttering,
        "softener_hedges": _softening(words.around["softener_hedges"]),
        "filled_pauses": _hesitating(words.around["filled_pauses"]),
        "acknowledgments": _opening(words.around["acknowledgments"]),
        "exclamation": _exclaiming,
        "in_group_marker": _addressing(words.around["in_group_marker"]),
    }
    return tuple(Operator(name, apply, limit=1) for name, apply in made.items())


def _slots_in(plan: SentencePlan) -> list[int]:
    assert plan.fragment is not None
    return [place for place, part in enumerate(plan.fragment.parts) if isinstance(part, Cased)]


def _hesitant(plan: SentencePlan) -> bool:
    return len(plan.words) > 1


def _stuttering(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
    """Repeat the first letters of the name: "the Wh-White Rabbit"."""
    found = _slots_in(plan)
    if not found or plan.fragment is None:
        return None
    parts = list(plan.fragment.parts)
    part = parts[found[0]]
    assert isinstance(part, Cased)
    parts[found[0]] = Cased(part.phrase._replace(stutter=1))
    return plan._replace(fragment=Text(tuple(parts)), words=(*plan.words, STUTTER))


def _softening(markers: tuple[Marker, ...]) -> SentenceRewrite:
    def soften(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
        """Leave it to the listener: "…, if you like?"; only after an offer that ends with it."""
        if not plan.words[0].endswith("{topic}") or plan.terminal != "?":
            return None
        marker = rng.marker([each for each in markers if each.text not in plan.words[0]])
        if marker is None:
            return None
        return plan._replace(afterthought=marker.text, words=(*plan.words, marker.text))

    return soften


def _hesitating(markers: tuple[Marker, ...]) -> SentenceRewrite:
    def hesitate(
        plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
    ) -> SentencePlan | None:
        """Look for words: "Um, hello.", "something about, err, Alice"."""
        topic = _slots_in(plan) if "{topic}" in plan.words[0] else []
        inside = bool(topic) and topic[0] > 0
        able = [each for each in markers if each.place == "opener" or inside]
        marker = rng.marker(able)
        if marker is None or plan.terminal == "!" or plan.fragment is None:
            return None
        if marker.place == "opener":
            return with_opener(plan, marker)
        place = topic[0]
        parts = plan.fragment.parts
        parts = (*parts[:place], ",", marker.text, ",", *parts[place:])
        return plan._replace(fragment=Text(parts), words=(*plan.words, marker.text))

    return hesitate


def _opening(markers: tuple[Marker, ...]) -> SentenceRewrite:
    def open_with(
        plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon
    ) -> SentencePlan | None:
        """Begin with a word of contact: "Oh, do you want to …"; not where there is one already."""
        first, *more = plan.words[0].split(" ")
        if plan.openers or _hesitant(plan) or "{topic}" not in plan.words[0]:
            return None
        if "," in first or "," in "".join(more[:1]):
            return None  # "Okay, so what about …" has its own
        marker = rng.marker([each for each in markers if each.text != first])
        return None if marker is None else with_opener(plan, marker)

    return open_with


def _exclaiming(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
    """End with an exclamation mark; not what is asked or said with hesitation."""
    if plan.terminal != "." or plan.afterthought or _hesitant(plan):
        return None
    return plan._replace(terminal="!")


def _addressing(markers: tuple[Marker, ...]) -> SentenceRewrite:
    def address(plan: SentencePlan, *, rng: OperatorDraws, lexicon: Lexicon) -> SentencePlan | None:
        """Call the listener one of us: "…, mate?"; not beside the own name."""
        if "{name}" in plan.words[0] or plan.afterthought or "{heard}" in plan.words[0]:
            return None
        marker = rng.marker(markers)
        if marker is None:
            return None
        return plan._replace(vocative=marker.text, words=(*plan.words, marker.text))

    return address
