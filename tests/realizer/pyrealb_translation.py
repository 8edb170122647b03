"""What pyrealb and our realizer are both asked to say: neutral descriptions and their two forms.

A description is a `Thing`, a `Joint`, an `Event` or a `Word`. `ours` and `theirs` say it, each
realizer in its own terms. Realizing spoils pyrealb's trees, so they are built anew each time.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any, NamedTuple, TypeAlias

from personage_lite import english
from personage_lite.realizer import (
    AdjectivePhrase,
    Clause,
    Coordination,
    Date,
    NounPhrase,
    Numeral,
    Phrase,
    PrepositionalPhrase,
    Question,
    Relative,
    Sentence,
)
from personage_lite.realizer.specification import Degree, Gender, Mood, Person, Role, Tense


class Thing(NamedTuple):
    """A noun phrase: without a noun a pronoun, with a capital a name; `owner` has it."""

    noun: str = ""
    determiner: str = ""
    plural: bool = False
    gender: Gender = "neuter"
    person: Person = 3
    adjectives: tuple[str, ...] = ()
    owner: Thing | None = None
    cardinal: int | None = None
    reflexive: bool = False
    relative: tuple[str, Event] | None = None


class Joint(NamedTuple):
    """Several noun phrases or adjectives joined."""

    items: tuple[Thing | str, ...]
    conjunction: str = "and"


class Event(NamedTuple):
    """A clause in the active voice; a passive one turns subject and object round."""

    verb: str
    subject: Thing | Joint | None = None
    object: Thing | Joint | None = None
    complement: Thing | Joint | str = ""
    place: tuple[str, Thing] | None = None
    adverb: str = ""
    tense: Tense = "present"
    modal: str = ""
    perfect: bool = False
    progressive: bool = False
    passive: bool = False
    negated: bool = False
    contracted: bool = False
    question: str = ""
    tag: bool = False
    exclaimed: bool = False
    imperative: bool = False


class Word(NamedTuple):
    """A number, a date or a graded adjective by itself: its kind and the word."""

    kind: str
    word: str


Described: TypeAlias = Thing | Joint | Event | Word
# Of a question: pyrealb's word for it, its words in ours, and what they are in the clause.
QUESTIONS: dict[str, tuple[str, Phrase, Role]] = {
    "who": ("wos", "who", "subject"),
    "what": ("was", "what", "subject"),
    "who object": ("wod", "who", "object"),
    "what object": ("wad", "what", "object"),
    "to whom": ("woi", PrepositionalPhrase("to", "whom"), "adverbial"),
    "with what": ("wai", PrepositionalPhrase("with", "what"), "adverbial"),
    "where": ("whe", "where", "adverbial"),
    "when": ("whn", "when", "adverbial"),
    "why": ("why", "why", "adverbial"),
    "how": ("how", "how", "adverbial"),
    "how much": ("muc", "how much", "adverbial"),
}
# Of a modal: pyrealb's word for what it means, and its tense.
_PRESENT = {"can": "poss", "may": "perm", "shall": "nece", "must": "obli", "will": "will"}
_PAST = {"could": "poss", "might": "perm", "should": "nece", "would": "will"}
MODALS = {
    **{modal: (meant, "p") for modal, meant in _PRESENT.items()},
    **{modal: (meant, "ps") for modal, meant in _PAST.items()},
}
TENSES: dict[Tense, str] = {"present": "p", "past": "ps", "future": "f"}
_DEGREES: dict[str, Degree] = {"more": "comparative", "most": "superlative"}
_OBJECTS = ("who object", "what object")


# Ours


@cache
def _realizer(american: bool) -> Callable[[Sentence | Phrase], str]:
    return english("american" if american else "british").realize


def ours(said: Described) -> str:
    """Return what our realizer says; numbers and dates in American English, as pyrealb does."""
    if isinstance(said, Event):
        tag = "auto" if said.tag else ""
        return _realizer(False)(Sentence(_clause(said), tag=tag, terminal="!" * said.exclaimed))
    american = isinstance(said, Word) and said.kind in ("cardinal", "ordinal", "date")
    return _realizer(american)(_phrase(said)).removesuffix(".")


def _phrase(said: Thing | Joint | Word | str) -> Phrase:
    if isinstance(said, Joint):
        return Coordination(tuple(_phrase(item) for item in said.items), said.conjunction)
    if isinstance(said, str):
        return AdjectivePhrase(said)
    if isinstance(said, Word):
        if said.kind == "date":
            year, month, day = (int(part) for part in said.word.split("-"))
            return Date(year, month, day, weekday=True)
        if said.kind in ("cardinal", "ordinal"):
            return Numeral(int(said.word), ordinal=said.kind == "ordinal")
        return AdjectivePhrase(said.word, degree=_DEGREES[said.kind])
    relative = None
    if said.relative is not None:
        word, event = said.relative
        role: Role = "subject" if event.subject is None else "object"
        relative = Relative(_clause(event), role, restrictive=True, word=word)
    return NounPhrase(
        said.noun,
        said.determiner,
        tuple(AdjectivePhrase(word) for word in said.adjectives),
        _phrase(said.owner) if said.owner else None,
        "plural" if said.plural else "singular",
        said.gender,
        said.person,
        pronoun=not said.noun,
        reflexive=said.reflexive,
        cardinal=said.cardinal,
        relative=relative,
    )


def _clause(event: Event) -> Clause:
    place = None if event.question == "where" else event.place
    subject = _phrase(event.subject) if event.subject else None
    object_ = _phrase(event.object) if event.object else None
    question = None
    if event.question in QUESTIONS:
        _, words, role = QUESTIONS[event.question]
        question = Question(words, role)
        if role == "subject":
            subject, object_ = (subject, None) if event.passive else (None, object_)
    agent = None
    if event.passive:
        subject, object_, agent = object_, None, subject
    mood: Mood = "interrogative" if event.question else "declarative"
    return Clause(
        event.verb,
        subject,
        object=None if event.question in _OBJECTS else object_,
        complement=_phrase(event.complement) if event.complement else None,
        adverbials=(PrepositionalPhrase(place[0], _phrase(place[1])),) if place else (),
        adverbs=(event.adverb,) if event.adverb else (),
        tense=event.tense,
        modal=event.modal,
        perfect=event.perfect,
        progressive=event.progressive,
        passive=event.passive,
        negated=event.negated,
        contracted=event.contracted,
        mood="imperative" if event.imperative else mood,
        question=question,
        agent=agent,
    )


# Theirs


@cache
def pyrealb() -> Any:
    """Return pyrealb, imported when it is first asked for."""
    with warnings.catch_warnings(action="ignore"):
        return import_module("pyrealb")


def theirs(said: Described) -> str:
    """Return what pyrealb says; it has no capital for a phrase."""
    text: str = _tree(said).realize().rstrip()
    return text if isinstance(said, Event) else text[:1].upper() + text[1:]


def _tree(said: Described | str, pronoun: str = "me") -> Any:
    """Return pyrealb's tree; `pronoun` is I for a subject, me for an object."""
    p = pyrealb()
    if isinstance(said, Event):
        return _sentence(said, p)
    if isinstance(said, str):
        return p.A(said)
    if isinstance(said, Joint):
        return p.CP(p.C(said.conjunction), *(_tree(item, pronoun) for item in said.items))
    if isinstance(said, Word):
        if said.kind == "date":
            parts = dict.fromkeys(("hour", "minute", "second", "det"), False)
            return p.DT(said.word).dOpt(parts)
        if said.kind in ("cardinal", "ordinal"):
            return p.NO(int(said.word)).dOpt({"nat" if said.kind == "cardinal" else "ord": True})
        return p.A(said.word).f("co" if said.kind == "more" else "su")
    number, gender = "p" if said.plural else "s", said.gender[0]
    if not said.noun:
        tree = p.Pro(pronoun).pe(said.person).n(number).g(gender)
        return tree.tn("refl") if said.reflexive else tree
    words = [p.D(said.determiner)] if said.determiner else []
    if said.owner:
        words.extend(_owner(said.owner, p))
    if said.cardinal is not None:
        words.append(p.NO(said.cardinal).nat())
    words.extend(p.A(word) for word in said.adjectives)
    words.append(p.Q(said.noun) if said.noun[0].isupper() else p.N(said.noun))
    if said.relative is not None:
        word, event = said.relative
        subject = [_tree(event.subject, "I")] if event.subject else []
        inner = p.SP(p.Pro(word), *subject, _verbs(event, p))
        words.append(inner.typ({"perf": True}) if event.perfect else inner)
    tree = p.NP(*words).g(gender)
    return tree if said.cardinal is not None else tree.n(number)


def _owner(owner: Thing, p: Any) -> list[Any]:
    """Return the words that stand for the owner."""
    number = "p" if owner.plural else "s"
    if not owner.noun:
        return [p.D("my").pe(owner.person).ow(number).g(owner.gender[0])]
    if owner.noun[0].isupper():
        return [p.Q(owner.noun).poss()]
    return [p.D(owner.determiner), p.N(owner.noun).n(number).poss()]


def _verbs(event: Event, p: Any) -> Any:
    """Return the verb phrase; an adverb goes after the verb if it is to follow an auxiliary."""
    tense = MODALS[event.modal][1] if event.modal else TENSES[event.tense]
    words = [p.V(event.verb).t("ip" if event.imperative else tense)]
    if event.adverb:
        after = event.modal or event.perfect or event.progressive or event.tense == "future"
        words.insert(1 if after else 0, p.Adv(event.adverb))
    if event.object:
        words.append(_tree(event.object))
    if event.complement:
        words.append(_tree(event.complement))
    if event.place:
        words.append(p.PP(p.P(event.place[0]), _tree(event.place[1])))
    elif event.question in ("to whom", "with what"):
        words.append(p.PP(p.P(event.question.split(" ")[0]), p.Pro("me").pe(3)))
    return p.VP(*words)


def _sentence(event: Event, p: Any) -> Any:
    """Return the sentence; what is asked for must stand in it, and pyrealb takes it out."""
    if event.question in ("who", "what"):
        asked = Thing("Alice")
        event = event._replace(object=asked) if event.passive else event._replace(subject=asked)
    verbs = _verbs(event, p)
    if event.imperative and isinstance(event.subject, Thing):
        verbs.elements[0].pe(event.subject.person).n("p" if event.subject.plural else "s")
    options = {
        "neg": event.negated,
        "pas": event.passive,
        "prog": event.progressive,
        "perf": event.perfect,
        "contr": event.contracted,
        "exc": event.exclaimed,
        "mod": event.modal and MODALS[event.modal][0],
    }
    if event.tag:
        options["int"] = "tag"
    elif event.question:
        options["int"] = QUESTIONS[event.question][0] if event.question in QUESTIONS else "yon"
    subject = [_tree(event.subject, "I")] if event.subject and not event.imperative else []
    return p.S(*subject, verbs).typ({key: value for key, value in options.items() if value})
