"""The classes of differences between pyrealb's texts and ours, each a rule that mends one point.

A rule takes pyrealb's text and returns it with what its class says of it put as ours puts it; the
text is unchanged if the pair is not of that class. pyrealb_differences.yaml says who is right.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import NamedTuple, TypeAlias

from tests.realizer.pyrealb_translation import Described, Event, Joint, Thing


class Pair(NamedTuple):
    """One description, the part of the grid that it is from, and both texts."""

    part: str
    said: Described
    ours: str
    theirs: str


Rule: TypeAlias = Callable[[Pair, str], str]
EventRule: TypeAlias = Callable[[Pair, Event, str], str]
FINITE = "is are was were do does did has have had could would should might must can will shall"
SHORT = {word: f"{word}n't" for word in FINITE.split(" ")}
SHORT.update(can="can't", will="won't", shall="shan't")
SINGULAR = {"are": "is", "were": "was", "have": "has", "do": "does"}
PLURAL = {singular: plural for plural, singular in SINGULAR.items()}
SUPPORT = {"has": "does", "have": "do", "had": "did"}


def listed(words: Mapping[str, str]) -> Rule:
    """Return the rule of a class that lists pyrealb's words, or whole texts, with ours."""

    def rule(pair: Pair, text: str) -> str:
        if words.get(_bare(text)) == _bare(pair.ours):
            return pair.ours
        return _aligned(text, pair, lambda its, mine: words.get(its) == mine)

    return rule


def _aligned(text: str, pair: Pair, same: Callable[[str, str], bool]) -> str:
    """Return a text with our word wherever it has another one that counts as the same."""
    said, wanted = text.split(" "), pair.ours.split(" ")
    if len(said) != len(wanted):
        return text
    return " ".join(
        mine if mine != its and same(_bare(its), _bare(mine)) else its
        for its, mine in zip(said, wanted, strict=True)
    )


def _bare(word: str) -> str:
    return word.strip(",.?!").lower()


def _positive(word: str) -> str:
    return word.removesuffix("n't")


def _cap(text: str) -> str:
    return text[:1].upper() + text[1:]


def _asks_inside(event: Event) -> bool:
    """Whether the auxiliary stands before the subject."""
    return event.question not in ("", "who", "what")


# Tags


def _tag_in_full(pair: Pair, event: Event, text: str) -> str:
    tag = r", (could|might|shall) not (\w+)\?$"
    return re.sub(tag, lambda match: f", {SHORT[match[1]]} {match[2]}?", text)


def _tag_of_may(pair: Pair, event: Event, text: str) -> str:
    return re.sub(r", may not (\w+)\?$", r", mightn't \1?", text)


def _joint_tag(pair: Pair, event: Event, text: str) -> str:
    if not (event.tag and isinstance(event.subject, Joint) and text.endswith(" it?")):
        return text
    said, _, tag = text.rpartition(", ")
    word = tag.split(" ")[0]
    finite = PLURAL.get(_positive(word), _positive(word)) + word[len(_positive(word)) :]
    return f"{said}, {finite} they?"


# Auxiliaries


def _passive_pronoun(pair: Pair, event: Event, text: str) -> str:
    patient = event.object
    if not (event.passive and isinstance(patient, Thing) and not patient.noun):
        return text
    if patient.person == 3 and not patient.plural:
        return text
    return _aligned(
        text,
        pair,
        lambda its, mine: (
            (its, mine) in (("it", "i"), ("i", "we"), ("is", "am"), ("am", "are"))
            or PLURAL.get(_positive(its)) == _positive(mine)
        ),
    )


def _lost_do(pair: Pair, event: Event, text: str) -> str:
    if event.verb != "do" or not event.negated:
        return text
    return re.sub(r"\b(do|does|did)( not|n't)(?! (do|be|have)\b)", r"\1\2 do", text, flags=re.I)


def _perfect_have(pair: Pair, event: Event, text: str) -> str:
    if event.verb != "have" or not (event.perfect and event.negated):
        return text
    had = {support: auxiliary for auxiliary, support in SUPPORT.items()}

    def auxiliary(match: re.Match[str]) -> str:
        found = had[match[1].lower()]
        return _cap(found) if match[1][0].isupper() else found

    mended = re.sub(r"\b(does|do|did)(?=n't| )", auxiliary, text, flags=re.I)
    return text if mended == text else re.sub(r" have (?=had|been)", " ", mended)


def _main_have(pair: Pair, event: Event, text: str) -> str:
    aspect = event.perfect or event.progressive or event.passive
    if event.verb != "have" or aspect or event.modal or event.tense == "future":
        return text
    if event.tag:
        tag = r", (has|have|had)(n't)? (\w+)\?$"
        return re.sub(tag, lambda match: f", {SUPPORT[match[1]]}{match[2] or ''} {match[3]}?", text)
    words, wanted = text[:-1].split(" "), pair.ours[:-1].split(" ")
    spot = next((i for i, word in enumerate(words[:2]) if word.lower() in SUPPORT), -1)
    if not _asks_inside(event) or "have" not in wanted or spot < 0:
        return text
    auxiliary = SUPPORT[words[spot].lower()]
    words[spot] = auxiliary if spot else _cap(auxiliary)
    words.insert(wanted.index("have"), "have")
    return " ".join(words) + "?"


def _cannot(pair: Pair, event: Event, text: str) -> str:
    words, wanted = text.split(" "), pair.ours.split(" ")
    spot = next((i for i, word in enumerate(words[:4]) if word.lower() == "cannot"), -1)
    if not _asks_inside(event) or "not" not in wanted or spot < 0:
        return text
    words[spot] = words[spot][:3]
    words.insert(wanted.index("not"), "not")
    return " ".join(words)


def _inverted_have(pair: Pair, event: Event, text: str) -> str:
    return re.sub(r"\b(\w+)'ve\b", r"\1 have", text) if _asks_inside(event) else text


def _not_behind(pair: Pair, event: Event, text: str) -> str:
    if not (_asks_inside(event) and event.contracted and event.negated):
        return text

    def short(match: re.Match[str]) -> str:
        form = "aren't" if match[2].lower() == "am" else SHORT[match[2].lower()]
        return f"{match[1]}{form if match[1] else _cap(form)} {match[3]}"

    finite = "|".join(("am", *SHORT))
    return re.sub(rf"^(|\S+ |\S+ \S+ )({finite}) (.+?) not\b", short, text, flags=re.I)


def _in_full(pair: Pair, event: Event, text: str) -> str:
    if not event.contracted:
        return text
    text = re.sub(r"^It has\b", "It's", text)
    return re.sub(r"\b(could|might|shall) not\b", lambda match: SHORT[match[1]], text)


def _question_word(words: str) -> EventRule:
    def rule(pair: Pair, event: Event, text: str) -> str:
        if not (event.contracted and event.question):
            return text
        return re.sub(rf"^({words}) (is|has)\b(?! not)", r"\1's", text)

    return rule


# Other words of clauses


def _let_us(pair: Pair, event: Event, text: str) -> str:
    return text.replace("Let's", "Let us") if event.imperative and not event.contracted else text


def _adverb(*words: str) -> EventRule:
    def rule(pair: Pair, event: Event, text: str) -> str:
        return re.sub(r"(\w+ing) (\w+)\.$", r"\2 \1.", text) if event.adverb in words else text

    return rule


def _nearest(pair: Pair, event: Event, text: str) -> str:
    if not _disjoint(event) or _asks_inside(event) or "cats or the dog " not in text:
        return text
    return _aligned(
        text,
        pair,
        lambda its, mine: (
            _positive(mine) == SINGULAR.get(_positive(its))
            or mine in (its + "s", its + "es", its[:-1] + "ies")
        ),
    )


def _nearest_asked(pair: Pair, event: Event, text: str) -> str:
    if not _disjoint(event) or not _asks_inside(event):
        return text
    plural = r"^(|With |To |How )(|\S+ )(are|were|have|do)(?=n't| )"
    found = re.match(plural, text, flags=re.I)
    if found is None or "cat or the dogs" not in text:
        return text
    single = SINGULAR[found[3].lower()]
    start = found[1] + found[2]
    return start + (single if start else _cap(single)) + text[found.end() :]


def _disjoint(event: Event) -> bool:
    return isinstance(event.subject, Joint) and event.subject.conjunction == "or"


# Noun phrases


def _glued(pair: Pair, text: str) -> str:
    return re.sub(r"s'(?=\w\w)", "s' ", text)


def _owner_in_s(pair: Pair, text: str) -> str:
    owner = pair.said.owner if isinstance(pair.said, Thing) else None
    if owner is None or owner.plural:
        return text
    return _aligned(text, pair, lambda its, mine: its.endswith("s'") and mine == its + "s")


def _adjective_order(pair: Pair, text: str) -> str:
    return text.replace("A small honest", "An honest small").replace("small honest", "honest small")


def _hundred_and(pair: Pair, text: str) -> str:
    return text.replace("hundred and ", "hundred ")


_EVENTS: dict[str, EventRule] = {
    "tag with not in full": _tag_in_full,
    "tag of may": _tag_of_may,
    "tag after several": _joint_tag,
    "pronoun of a passive": _passive_pronoun,
    "do lost": _lost_do,
    "perfect of have with do": _perfect_have,
    "have as an auxiliary": _main_have,
    "cannot before the subject": _cannot,
    "have shortened after the subject": _inverted_have,
    "nearest of or in a question": _nearest_asked,
    "not after the subject": _not_behind,
    "not in full": _in_full,
    "question word": _question_word("Who|What|Where|When|How"),
    "let us": _let_us,
    "often at the end": _adverb("often"),
    "never at the end": _adverb("never"),
    "nearest of or": _nearest,
}


def _of_events(rule: EventRule) -> Rule:
    return lambda pair, text: rule(pair, pair.said, text) if isinstance(pair.said, Event) else text


# In the order in which they are tried.
RULES: dict[str, Rule] = {
    **{name: _of_events(rule) for name, rule in _EVENTS.items()},
    "owner glued": _glued,
    "owner in s": _owner_in_s,
    "order of adjectives": _adjective_order,
    "hundred and": _hundred_and,
}
