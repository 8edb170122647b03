"""Ours against pyrealb's."""

from __future__ import annotations

import contextlib
import io
from collections.abc import Callable, Iterator
from itertools import count, product
from typing import Any, NamedTuple

from personage_lite.realizer.files import read_data
from tests.realizer.pyrealb_grid import *


def _thing(node: dict[str, Any]) -> Thing:
    fields = dict(node)
    if "owner" in fields:
        fields["owner"] = _thing(fields["owner"])
    fields["adjectives"] = tuple(fields.get("adjectives", ()))
    return Thing(**fields)


def grid() -> Iterator[tuple[str, Described]]:
    """Yield every description, with its kind."""
    data = read_data(str(FILE))
    words = {key: tuple(block.split()) for key, block in data["words"].items()}
    things = [_thing(node) for node in data["subjects"]]
    joints = [Joint(tuple(map(_thing, node["items"])), node["conjunction"]) for node in data["joints"]]
    objects = [_thing(node) for node in data["objects"]]
    subjects = [*things, *joints]
    for described in _verb_groups(words, things, objects):
        yield "verb group", described
    for described in _copulas(words, subjects):
        yield "copula", described
    for described in _agreement(words, subjects, objects):
        yield "agreement", described
    for described in _questions(words, subjects):
        yield "question", described
    for described in _others(words, subjects, objects):
        yield "other clause", described
    for described in _phrases(words, things):
        yield "noun phrase", described
    for described in _words(words):
        yield "word", described


TIMES = [*({"tense": tense} for tense in TENSES), *({"modal": modal} for modal in MODALS)]
FLAGS = (False, True)


def _verb_groups(words, subjects, objects):
    """Every tense and modal with each aspect, voice, negation, question and contraction."""
    turn = count()
    axes = product(TIMES, FLAGS, FLAGS, FLAGS, ("", "tag", "yes/no", "who", "what object", "why"), FLAGS, FLAGS)
    for time, perfect, progressive, passive, question, negated, contracted in axes:
        if passive and question == "what object":
            continue
        i = next(turn)
        event = Event(
            words["transitive"][i % 15],
            subjects[i % len(subjects)],
            objects[i % len(objects)],
            perfect=perfect, progressive=progressive, passive=passive, negated=negated, contracted=contracted,
            **time,
        )
        yield event._replace(tag=True) if question == "tag" else event._replace(question=question)


def _copulas(words, subjects):
    place = ("in", Thing("garden", "the"))
    turn = count()
    for time, perfect, question, negated, contracted in product(TIMES, FLAGS, ("", "tag", "yes/no", "why", "where", "who"), FLAGS, FLAGS):
        for _ in range(2):
            i = next(turn)
            event = Event("be", subjects[i % len(subjects)], complement=words["complements"][i % 5], perfect=perfect, negated=negated, contracted=contracted, **time)
            if question == "where":
                event = event._replace(complement="", place=place)
            yield event._replace(tag=True) if question == "tag" else event._replace(question=question)


def _agreement(words, subjects, objects):
    turn = count()
    verbs = [*((verb, True) for verb in words["transitive"]), *((verb, False) for verb in words["intransitive"])]
    for subject, (verb, transitive), tense in product(subjects, verbs, TENSES):
        i = next(turn)
        object_ = objects[i % len(objects)] if transitive else None
        event = Event(verb, subject, object_, tense=tense)
        yield event
        yield (event._replace(negated=True, contracted=True), event._replace(tag=True), event._replace(question="yes/no", contracted=True), event._replace(tag=True, negated=True))[i % 4]


def _questions(words, subjects):
    turn = count()
    place = ("in", Thing("house", "the"))
    for time, perfect, progressive, negated, contracted, question in product(TIMES, FLAGS, FLAGS, FLAGS, FLAGS, ("", "where", "when", "how", "to whom", "with what", "how much", "what")):
        i = next(turn)
        event = Event(words["intransitive"][i % 10], subjects[i % len(subjects)], perfect=perfect, progressive=progressive, negated=negated, contracted=contracted, question=question, **time)
        yield event._replace(place=place) if question in ("", "what") else event


def _others(words, subjects, objects):
    for i, (verb, person, negated, contracted) in enumerate(product(words["transitive"], ((2, False), (1, True)), FLAGS, FLAGS)):
        yield Event(verb, Thing(person=person[0], plural=person[1]), objects[i % len(objects)], imperative=True, negated=negated, contracted=contracted)
    for subject, verb in product(subjects, ("sleep", "run")):
        yield Event(verb, subject, exclaimed=True)
        for adverb, perfect, progressive, modal in product(("often", "never", "always"), FLAGS, FLAGS, ("", "can")):
            yield Event(verb, subject, adverb=adverb, perfect=perfect, progressive=progressive, modal=modal)
    for subject in subjects[:7]:
        yield Event("wash", subject, subject._replace(reflexive=True))
        yield Event("see", Thing("Alice", gender="feminine"), subject, tense="past")
        yield Event("play", Thing("Alice", gender="feminine"), place=("with", subject))
        yield Event("see", Thing("Alice", gender="feminine"), subject, tense="past", passive=True)
        yield Event("see", subject, Thing("Alice", gender="feminine"), tense="past", passive=True)
    girl, cake = Thing("girl", "the", gender="feminine"), Thing("cake", "the")
    for tense, perfect, plural, word in product(TENSES, FLAGS, FLAGS, ("that", "who", "which")):
        for verb in ("eat", "see", "stop", "be"):
            inner = Event(verb, None, None if verb == "be" else cake, "happy" if verb == "be" else "", tense=tense, perfect=perfect)
            head = girl if word == "who" else Thing("dog", "a")
            yield Event("come", head._replace(plural=plural, relative=(word, inner)), tense="past")
            if verb != "be":
                yield Event("come", head._replace(plural=plural, relative=(word, inner._replace(subject=Thing(plural=plural, gender="feminine"), object=None))), tense="past")
    for conjunction, number in product(("and", "or", "but"), (2, 3, 4)):
        for start in range(0, 12, 2):
            yield Event("be", subjects[start], complement=Joint(words["adjectives"][start : start + number], conjunction))


def _phrases(words, things):
    for noun in words["nouns"]:
        yield Thing(noun, "the", plural=True)
    for determiner, noun, plural, adjectives in product(("the", "a", "this", "that", "some", "every", "no"), ("cat", "hour", "child", "furniture", "box", "wolf"), FLAGS, ((), ("old",), ("small", "honest"), ("ugly", "black"))):
        if noun == "furniture" and (plural or determiner in ("a", "every")) or plural and determiner == "every":
            continue
        yield Thing(noun, determiner, plural=plural, adjectives=adjectives)
    for noun in words["after_a"]:
        yield Thing(noun, "a") if pyrealb().getLemma(noun) and "N" in pyrealb().getLemma(noun) else Thing("thing", "a", adjectives=(noun,))
    owners = (*things[:7], Thing("Alice"), Thing("James"), *(Thing(noun, "the", plural) for noun, plural in product(("cat", "child", "boss", "lady"), FLAGS)))
    for owner, noun, plural in product(owners, ("hat", "foot", "party"), FLAGS):
        yield Thing(noun, owner=owner, plural=plural)
    for number, noun in product((1, 2, 3, 10, 21), ("mouse", "box", "party", "sheep")):
        yield Thing(noun, count=number)
        yield Thing(noun, "the", count=number)
    for conjunction, number, start in product(("and", "or"), (2, 3, 4), range(0, 16, 2)):
        yield Joint((*things, *things)[start : start + number], conjunction)


def _words(words):
    for verb in words["verbs"]:
        for tense, perfect, progressive in (("present", False, False), ("past", False, False), ("present", True, False), ("present", False, True)):
            yield Event(verb, Thing(gender="feminine"), tense=tense, perfect=perfect, progressive=progressive)
    for word, kind in product(words["adjectives"], ("more", "most")):
        yield Word(kind, word)
    for kind in ("cardinal", "ordinal", "date"):
        for word in words[kind + "s"]:
            yield Word(kind, word)


if __name__ == "__main__":
    import time
    from collections import Counter
    t0=time.time()
    n=Counter(); d={}; tt=0
    for kind, said in grid():
        n[kind]+=1
        err=io.StringIO()
        with contextlib.redirect_stderr(err):
            try: o=ours(said)
            except Exception as e: o=f"<{e}>"
            t1=time.time()
            try: th=theirs(said)
            except Exception as e: th=f"<{type(e)} {e}>"
            tt+=time.time()-t1
        if err.getvalue(): th=f"<<{err.getvalue().strip()}>> "+th
        if o!=th: d.setdefault(kind,[]).append((said,o,th))
    print(n,sum(n.values()),time.time()-t0,tt,{k:len(v) for k,v in d.items()})
    import pickle
    pickle.dump(d,open("/tmp/diffs.pkl","wb"))
