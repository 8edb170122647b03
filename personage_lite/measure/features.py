"""Features: what is counted and how it is published to move, read from lexicons/features.yaml."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from os import PathLike
from os.path import join
from typing import NamedTuple

from personage_lite.data import data_folder
from personage_lite.errors import nearest
from personage_lite.lexicon import Marker, load_lexicon
from personage_lite.measure.lists import Lists, read_lists
from personage_lite.measure.patterns import PLACES, Finder, Names, Pattern, pattern_of
from personage_lite.yaml_reader import Node, read_yaml

DIRECTIONS = ("rises", "falls", "none")
# What a quantity is divided by, and what a hundredth of it is.
UNITS = ("utterance", "sentence", "100 sentences", "100 words", "word", "window", "text")
# What `personage_lite.measure.counting` counts without a list.
QUANTITIES = (
    *("words", "sentences", "word_length", "long_words", "type_token_ratio", "repetitions"),
    *("flesch_reading_ease", "flesch_kincaid_grade", "positive_emotion", "negative_emotion"),
    *("stutters", "tag_questions", "exclamations", "questions", "contractions"),
)
# What is divided by nothing: a ratio of each 50 words, and what is of all words together.
_WHOLE = {
    "type_token_ratio": "window",
    "flesch_reading_ease": "text",
    "flesch_kincaid_grade": "text",
}
# The kinds whose markers are counted at one place, whatever `place` they are put at.
_PLACES_OF_KINDS = {"in_group_marker": "vocative"}
_LEANS: Mapping[str, Callable[[float], bool]] = {
    "": lambda lean: lean is not None,
    "introvert": lambda lean: lean < 0,
    "extravert": lambda lean: lean > 0,
}
_TOPIC = "{topic}"


class Feature(NamedTuple):
    """A feature of style, and how it is published to move as extraversion rises.

    `quantity` is one of `QUANTITIES`, or empty if `finder` counts words; those are markers if
    `marks`, and only words that are no markers if `content`. `direction` is "rises", "falls" or
    "none" (no source says); `contrary` are sources that found the opposite.
    """

    name: str
    label: str
    per: str
    quantity: str
    finder: Finder | None
    marks: bool
    content: bool
    direction: str
    sources: tuple[str, ...]
    finding: str
    contrary: tuple[str, ...]


class Features(NamedTuple):
    """All features, the sources that they name by key, and the words that counting asks for.

    `tags` are what a tag question can be besides an auxiliary and its subject.
    """

    features: tuple[Feature, ...]
    sources: Mapping[str, str]
    lists: Lists
    tags: frozenset[tuple[str, ...]]


def load_features(folder: str | PathLike[str] | None = None) -> Features:
    """Read features.yaml, and the markers that it names, from a folder of lexicons.

    Raises `DataError` that names file, line and remedy for anything unknown or missing.

    >>> load_features().features[0].direction
    'rises'
    """
    folder = data_folder("lexicons") if folder is None else folder
    lexicon = load_lexicon(folder)
    node = read_yaml(join(folder, "features.yaml"))
    lists = read_lists(node, lexicon.adjectives.values())
    sources = {key: item.text() for key, item in node.need("sources").items()}
    features = tuple(
        _feature(name, item, lexicon.markers, lists, sources)
        for name, item in node.need("features").items()
    )
    node.done()
    tags = {pattern_of(marker.text).words for marker in lexicon.markers["tag_question"]}
    tags |= {pattern_of(tag).words for tag in lists.tags}
    return Features(features, sources, lists, frozenset(tags))


def _feature(
    name: str,
    item: Node,
    markers: Mapping[str, tuple[Marker, ...]],
    lists: Lists,
    sources: Mapping[str, str],
) -> Feature:
    quantity = item.choice_of("count", QUANTITIES, "")
    patterns = [*_marker_patterns(item, markers), *_listed_patterns(item)]
    if bool(quantity) == bool(patterns):
        raise item.fault(
            f"'{name}' counts {'two things' if quantity else 'nothing'}",
            "give either 'count', or 'words' and 'markers'",
        )
    per = item.need("per").choice(UNITS)
    if per != _WHOLE.get(quantity, per) or (per in _WHOLE.values() and quantity not in _WHOLE):
        remedy = f"write {_WHOLE[quantity]}" if quantity in _WHOLE else "write 100 words"
        raise item.need("per").fault(f"'{name}' cannot be counted per {per}", remedy)
    direction = item.need("direction").choice(DIRECTIONS)
    named = item.texts_of("sources")
    if (direction == "none") == bool(named):
        raise item.fault(
            f"'{name}' has {'sources' if named else 'no sources'} for the direction '{direction}'",
            "give the sources of a direction, and none for none",
        )
    contrary = item.texts_of("contrary")
    for key in (*named, *contrary):
        if key not in sources:
            raise item.fault(f"no source '{key}'", nearest(key, sources))
    feature = Feature(
        name,
        item.need("label").text(),
        per,
        quantity,
        Finder(patterns, lists, _names(item, markers)) if patterns else None,
        item.get("markers") is not None,
        item.flag_of("content"),
        direction,
        named,
        item.text_of("finding"),
        contrary,
    )
    item.done()
    return feature


def _marker_patterns(item: Node, markers: Mapping[str, tuple[Marker, ...]]) -> list[Pattern]:
    """Return the patterns of the kinds of markers that a feature names."""
    leans = _LEANS[item.choice_of("lean", tuple(_LEANS)[1:], "")]
    listed = item.get("markers")
    patterns = []
    for kind in listed.sequence() if listed else ():
        name = kind.text()
        if name not in markers:
            raise kind.fault(f"no markers '{name}'", nearest(name, markers))
        for marker in markers[name]:
            if leans(marker.lean):
                patterns += _patterns_of(name, marker)
    return [pattern for pattern in patterns if pattern.words]


def _patterns_of(kind: str, marker: Marker) -> list[Pattern]:
    """Return what a marker can look like in a text."""
    text, place = marker.text, _PLACES_OF_KINDS.get(kind, marker.place)
    if _TOPIC in text:
        # Whatever stands for the topic, the words beside it are the same, if there are enough.
        words = pattern_of(text.replace(_TOPIC, ""), "asks" if marker.after == "?" else "")
        return [words] if len(words.words) > 1 else []
    found = [pattern_of(text, place, marker.after)]
    if place == "lead" and text.endswith(" that"):
        found.append(pattern_of(text.removesuffix(" that"), place))
    return found


def _names(item: Node, markers: Mapping[str, tuple[Marker, ...]]) -> Names | None:
    """Return the sentences that are but the topic, if a feature's markers can be ("Oh, Pluto!")."""
    kinds = item.texts_of("markers")
    topics = [
        (pattern_of(marker.text.replace(_TOPIC, "")).words, marker.after)
        for kind in kinds
        for marker in markers[kind]
        if _TOPIC in marker.text
    ]
    short = [(words, end) for words, end in topics if len(words) < 2]
    if not short:
        return None
    set_off = [
        {pattern_of(marker.text).words for marker in markers[kind]}
        for kind in ("acknowledgments", "in_group_marker")
    ]
    leads = {*(words for words, _ in short), *set_off[0]}
    return Names(frozenset(end for _, end in short), frozenset(leads), frozenset(set_off[1]))


def _listed_patterns(item: Node) -> list[Pattern]:
    """Return the patterns of a feature's own list of words."""
    listed = item.get("words")
    patterns = []
    for word in listed.sequence() if listed else ():
        if word.is_text():
            patterns.append(pattern_of(word.text()))
        else:
            patterns.append(pattern_of(word.need("text").text(), word.need("place").choice(PLACES)))
            word.done()
        *others, stars = patterns[-1].text.split("*")
        if not patterns[-1].words or len(others) > 1 or (others and not others[0] + stars):
            raise word.fault("this is no word", "write letters, with one * at an end if at all")
    return patterns
