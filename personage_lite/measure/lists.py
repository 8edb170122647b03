"""Closed classes of words and the contexts of ambiguous ones: data of lexicons/features.yaml."""

# No `from __future__ import annotations` here: the reader goes through the annotations.

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from personage_lite.lexicon import Concept
from personage_lite.yaml_reader import Node


class Context(NamedTuple):
    """Where an ambiguous word is a hedge: what must not stand beside it, and what must follow."""

    not_after: frozenset[str] = frozenset()
    not_before: frozenset[str] = frozenset()
    adjective: bool = False


class Lists(NamedTuple):
    """The words that the counting rules ask for; all in lower case."""

    determiners: frozenset[str]
    pronouns: frozenset[str]
    prepositions: frozenset[str]
    conjunctions: frozenset[str]
    auxiliaries: frozenset[str]
    tag_subjects: frozenset[str]
    tag_ends: frozenset[str]
    tags: frozenset[str]
    s_is_a_verb_after: frozenset[str]
    contracted: frozenset[str]
    adjectives: frozenset[str]
    adjective_endings: frozenset[str]
    numbers: frozenset[str]
    abbreviations: frozenset[str]
    reporting_verbs: frozenset[str]
    no_stutters: frozenset[str]
    closed: frozenset[str]
    contexts: Mapping[str, Context]


# The classes that no adjective is of.
_CLOSED = ("determiners", "pronouns", "prepositions", "conjunctions", "auxiliaries")


def read_lists(node: Node, adjectives: Iterable[Concept]) -> Lists:
    """Read `lists` and `contexts` of a file; `adjectives` are known besides those listed."""
    listed = node.need("lists")
    found = {
        name: _words(listed.need(name))
        for name, kind in Lists.__annotations__.items()
        if kind == frozenset[str] and name != "closed"
    }
    listed.done()
    found["adjectives"] |= frozenset(
        word.lower()
        for concept in adjectives
        for word in (concept.name, *concept.antonyms, *(word.text for word in concept.words))
    )
    found["closed"] = frozenset().union(*(found[name] for name in _CLOSED))
    contexts = {text.lower(): _context(item) for text, item in node.need("contexts").items()}
    return Lists(**found, contexts=contexts)


def _words(node: Node) -> frozenset[str]:
    return frozenset(node.text().lower().split())


def _context(node: Node) -> Context:
    not_after, not_before = node.get("not_after"), node.get("not_before")
    context = Context(
        _words(not_after) if not_after else frozenset(),
        _words(not_before) if not_before else frozenset(),
        node.flag_of("adjective"),
    )
    node.done()
    return context
