"""What pyrealb and our realizer are both asked to say, built systematically from word lists."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import count, product
from typing import Any, NamedTuple

from tests.realizer.pyrealb_translation import MODALS, TENSES, Described, Event, Joint, Thing, Word

FLAGS = (False, True)
TIMES: list[dict[str, Any]] = [
    *({"tense": tense} for tense in TENSES),
    *({"modal": modal} for modal in MODALS),
]


class Words(NamedTuple):
    """What the grid is built of, from the file."""

    lists: dict[str, tuple[str, ...]]
    things: list[Thing]
    objects: list[Thing]
    subjects: list[Thing | Joint]


# The grid


def _thing(node: dict[str, Any]) -> Thing:
    owner = _thing(node["owner"]) if "owner" in node else None
    return Thing(**{**node, "owner": owner, "adjectives": tuple(node.get("adjectives", ()))})


def read_words(data: dict[str, Any]) -> Words:
    things = [_thing(node) for node in data["subjects"]]
    joints = (Joint(tuple(map(_thing, row["items"])), row["conjunction"]) for row in data["joints"])
    lists = {key: tuple(block.split()) for key, block in data["words"].items()}
    return Words(lists, things, [_thing(node) for node in data["objects"]], [*things, *joints])


def _asked(event: Event, question: str) -> Event:
    return event._replace(tag=True) if question == "tag" else event._replace(question=question)


def _verb_groups(words: Words) -> Iterator[Described]:
    """Every tense and modal with each aspect, voice, negation, question and contraction."""
    turn = count()
    questions = ("", "tag", "yes/no", "who", "what object", "why")
    transitive, objects = words.lists["transitive"], words.objects
    for time, question, *flags in product(TIMES, questions, *[FLAGS] * 5):
        perfect, progressive, passive, negated, contracted = flags
        if passive and question == "what object":
            continue
        i = next(turn)
        object_ = objects[i // 3 % len(objects)]
        if passive and not object_.noun and object_.gender == "neuter":
            object_ = objects[0]  # pyrealb's passive of I and they has a class of its own
        event = Event(
            transitive[(i + i // 32) % len(transitive)],
            words.things[i % len(words.things)],
            object_,
            perfect=perfect,
            progressive=progressive,
            passive=passive,
            negated=negated,
            contracted=contracted,
            **time,
        )
        yield _asked(event, question)


def _copulas(words: Words) -> Iterator[Described]:
    """`be` with a complement or a place, with every subject in turn."""
    turn = count()
    questions = ("", "tag", "yes/no", "why", "where", "who")
    for time, question, *flags, _ in product(TIMES, questions, *[FLAGS] * 4):
        i = next(turn)
        complement = "" if question == "where" else words.lists["complements"][i % 5]
        event = Event("be", words.subjects[i % len(words.subjects)], None, complement, **time)
        perfect, negated, contracted = flags
        event = event._replace(perfect=perfect, negated=negated, contracted=contracted)
        yield _asked(event, question)


def _agreement(words: Words) -> Iterator[Described]:
    """Every verb with every subject in every tense, plain and in one other way in turn."""
    turn = count()
    verbs = [*((verb, True) for verb in words.lists["transitive"])]
    verbs += [(verb, False) for verb in words.lists["intransitive"]]
    for subject, (verb, transitive), tense in product(words.subjects, verbs, TENSES):
        i = next(turn)
        object_ = words.objects[i % len(words.objects)] if transitive else None
        event = Event(verb, subject, object_, tense=tense)
        yield event
        if i % 4 == 0:
            yield event._replace(negated=True, contracted=True)
        elif i % 4 == 2:
            yield event._replace(question="yes/no", contracted=True)
        else:
            yield event._replace(tag=True, negated=i % 8 == 1)


def _questions(words: Words) -> Iterator[Described]:
    """Questions of verbs without an object."""
    asked = ("where", "when", "how", "to whom", "with what", "how much", "what")
    place = ("in", Thing("house", "the"))
    for i, (time, question, *flags) in enumerate(product(TIMES, asked, *[FLAGS] * 4)):
        perfect, progressive, negated, contracted = flags
        yield Event(
            words.lists["intransitive"][i % 10],
            words.subjects[i % len(words.subjects)],
            place=place if question == "what" else None,
            perfect=perfect,
            progressive=progressive,
            negated=negated,
            contracted=contracted,
            question=question,
            **time,
        )


def _other_clauses(words: Words) -> Iterator[Described]:
    """Imperatives, exclamations, adverbs, pronouns in every place, relatives, coordination."""
    alice, objects = Thing("Alice", gender="feminine"), words.objects
    persons = (Thing(person=2), Thing(person=1, plural=True))
    for i, (verb, you, *flags) in enumerate(
        product(words.lists["transitive"], persons, FLAGS, FLAGS)
    ):
        event = Event(verb, you, objects[i % len(objects)], imperative=True)
        yield event._replace(negated=flags[0], contracted=flags[1])
    for i, (verb, tense, perfect) in enumerate(product(words.lists["transitive"], TENSES, FLAGS)):
        event = Event(verb, words.things[i % len(words.things)], alice, tense=tense)
        yield event._replace(perfect=perfect, question="who object")
    for subject in words.subjects:
        yield Event("sleep", subject, exclaimed=True)
        for adverb, *flags, modal in product(("often", "never"), FLAGS, FLAGS, ("", "can")):
            event = Event("sleep", subject, adverb=adverb, modal=modal)
            yield event._replace(perfect=flags[0], progressive=flags[1])
    for thing in words.things[:7]:
        yield Event("wash", thing, thing._replace(reflexive=True))
        yield Event("play", alice, place=("with", thing))
        yield Event("see", alice, thing, tense="past")
        yield Event("see", thing, alice, tense="past", passive=True)
        for tense, question in product(TENSES, ("", "yes/no", "tag")):
            yield _asked(Event("see", alice, thing, tense=tense, passive=True), question)
    cake = Thing("cake", "the")
    for tense, perfect, plural, word in product(TENSES, FLAGS, FLAGS, ("that", "who", "which")):
        head = Thing("girl" if word == "who" else "dog", "the", plural)
        she = Thing(plural=plural, gender="feminine")
        whole = Event("be", None, None, "happy", tense=tense, perfect=perfect)
        for inner in (
            whole,
            *(whole._replace(verb=verb, object=cake, complement="") for verb in ("eat", "stop")),
            *(whole._replace(verb=verb, subject=she, complement="") for verb in ("see", "have")),
        ):
            yield Event("come", head._replace(relative=(word, inner)), tense="past")
    adjectives = words.lists["adjectives"]
    for i, word, number in product(range(0, 12, 2), ("and", "or", "but"), (2, 3, 4)):
        yield Event("be", words.subjects[i], None, Joint(adjectives[i : i + number], word))


def _noun_phrases(words: Words) -> Iterator[Described]:
    """Plurals, determiners and adjectives, "a" and "an", owners, counts, coordination."""
    for noun in words.lists["nouns"]:
        yield Thing(noun, "the", plural=True)
    determiners = ("the", "a", "this", "that", "some", "every", "no")
    nouns = ("cat", "hour", "child", "furniture", "box", "wolf")
    lists: tuple[tuple[str, ...], ...] = ((), ("old",), ("small", "honest"), ("ugly", "black"))
    for determiner, noun, plural, adjectives in product(determiners, nouns, FLAGS, lists):
        single = plural or noun == "furniture"
        if not (single and determiner in ("a", "every")) and not (plural and noun == "furniture"):
            yield Thing(noun, determiner, plural, adjectives=adjectives)
    for word in words.lists["a_nouns"]:
        yield Thing(word, "a")
    for word in words.lists["a_adjectives"]:
        yield Thing("thing", "a", adjectives=(word,))
    owners = [*words.things[:7], Thing("Alice"), Thing("James")]
    owners += [Thing(*row) for row in product(("cat", "child", "boss", "lady"), ("the",), FLAGS)]
    for owner, noun, plural in product(owners, ("hat", "foot", "party"), FLAGS):
        yield Thing(noun, owner=owner, plural=plural)
    for number, noun, determiner in product((1, 2, 3, 10, 21), nouns[2:], ("", "the")):
        if noun != "furniture":
            yield Thing(noun, determiner, cardinal=number)
    named = tuple(thing for thing in words.things if thing.noun) * 2
    for word, number, start in product(("and", "or"), (2, 3, 4), range(12)):
        yield Joint(named[start : start + number], word)


def _single_words(words: Words) -> Iterator[Described]:
    """Verb forms, degrees, numbers and dates."""
    she, lists = Thing(gender="feminine"), words.lists
    for verb in lists["verbs"]:
        yield Event(verb, she)
        yield Event(verb, she, tense="past")
        yield Event(verb, she, perfect=True)
        yield Event(verb, she, progressive=True)
    for word, kind in product(lists["adjectives"], ("more", "most")):
        yield Word(kind, word)
    for kind in ("cardinal", "ordinal", "date"):
        for word in lists[kind + "s"]:
            yield Word(kind, word)


# Each part of the grid, by its name.
GRID: dict[str, Callable[[Words], Iterator[Described]]] = {
    "verb groups": _verb_groups,
    "copulas": _copulas,
    "agreement": _agreement,
    "questions": _questions,
    "other clauses": _other_clauses,
    "noun phrases": _noun_phrases,
    "single words": _single_words,
}
