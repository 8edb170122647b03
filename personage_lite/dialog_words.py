"""The words of the dialog, read from `lexicons/dialog.yaml` and never changed.

Whoever adds a greeting or another word for "yes" edits the YAML; the code knows acts, not words.
"""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from os.path import join
from types import MappingProxyType
from typing import NamedTuple

from personage_lite.lexicon import Marker, marker_basics
from personage_lite.yaml_reader import Node, read_yaml

# Every act, and the slots that its sentences can have: for the character ({topic}), the listener
# ({name}), and words of the listener's ({heard}).
ACTS: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "greeting": (),
        "greeting_named": ("{name}",),
        "greeting_again": ("{name}",),
        "suggestion": ("{topic}",),
        "another": ("{topic}",),
        "exhausted": ("{topic}",),
        "told_already": ("{topic}",),
        "all_told": (),
        "none_wanted": (),
        "unknown_name": ("{heard}",),
        "not_understood": (),
        "asked_again": ("{topic}",),
        "silence": ("{topic}",),
        "pause": (),
        "resume": (),
        "farewell": (),
        "farewell_named": ("{name}",),
    }
)
# What is understood of what a listener says.
MEANINGS = ("yes", "no", "quit", "pause", "resume", "who")
# What is understood of remarks about how it is told, and the words that turn them around.
REMARKS = ("less", "more", "less_of_that", "more_of_that", "praise", "blame", "negation")
# The operators that put words around a sentence, and the places that these can have.
AROUND: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "filled_pauses": ("opener", "topic"),
        "acknowledgments": (),
        "softener_hedges": (),
        "in_group_marker": (),
    }
)


class Part(NamedTuple):
    """One sentence of an act: the lines that it is chosen from, and how often it is said.

    `parameter` is the style parameter that holds that probability; empty for always.
    """

    lines: tuple[Marker, ...]
    parameter: str


class DialogWords(NamedTuple):
    """All words of the dialog; read-only, threads may share it.

    `acts` are the parts of each act, `around` the words of the operators, `heard` what a
    listener can say, by meaning (one of `MEANINGS`), `remarks` what they can say about how it is
    told (by one of `REMARKS`).
    """

    acts: Mapping[str, tuple[Part, ...]]
    around: Mapping[str, tuple[Marker, ...]]
    heard: Mapping[str, tuple[str, ...]]
    remarks: Mapping[str, tuple[str, ...]]


def load_dialog_words(folder: str | PathLike[str]) -> DialogWords:
    """Read `dialog.yaml` of a folder of lexicons.

    Raises `DataError` that names file, line and remedy for anything unknown, missing or empty.

    >>> from personage_lite.data import data_folder
    >>> "yeah" in load_dialog_words(data_folder("lexicons")).heard["yes"]
    True
    """
    node = read_yaml(join(folder, "dialog.yaml"))
    listed = node.need("lines")
    lines = {name: _markers(item, ()) for name, item in listed.items()}
    acts = _acts(node.need("acts"), listed, lines)
    around = {}
    markers = node.need("markers")
    for kind, places in AROUND.items():
        around[kind] = _markers(markers.need(kind), places)
    markers.done()
    heard = _heard(node.need("heard"))
    remarks = _remarks(node.need("remarks"))
    node.done()
    return DialogWords(
        MappingProxyType(acts),
        MappingProxyType(around),
        MappingProxyType(heard),
        MappingProxyType(remarks),
    )


def _acts(
    node: Node, listed: Node, lines: Mapping[str, tuple[Marker, ...]]
) -> dict[str, tuple[Part, ...]]:
    acts = {}
    for act, slots in ACTS.items():
        parts = []
        for item in node.need(act).sequence():
            name = item.need("say").choice(tuple(lines))
            parts.append(Part(lines[name], item.text_of("parameter")))
            item.done()
            _check_slots(act, slots, listed.need(name))
        if not parts:
            raise node.need(act).fault(f"'{act}' is empty", "add at least one 'say: …'")
        acts[act] = tuple(parts)
    node.done()
    return acts


def _check_slots(act: str, slots: tuple[str, ...], lines: Node) -> None:
    """Refuse a line with a slot that nothing could be put into."""
    for item in lines.sequence():
        text = item.text() if item.is_text() else item.need("text").text()
        plain = text
        for slot in slots:
            plain = plain.replace(slot, "")
        if "{" in plain or "}" in plain:
            can = f"use {' or '.join(slots)} only" if slots else "use none here"
            raise item.fault(f"'{act}' has no such {{…}}", can)


def _markers(node: Node, places: tuple[str, ...]) -> tuple[Marker, ...]:
    items = node.sequence()
    if not items:
        raise node.fault("the list is empty", "add at least one entry")
    return tuple(_marker(item, places) for item in items)


def _marker(item: Node, places: tuple[str, ...]) -> Marker:
    if item.is_text() and not places:
        return Marker(item.text())
    marker = Marker(*marker_basics(item, places))
    item.done()
    return marker


def _heard(node: Node) -> dict[str, tuple[str, ...]]:
    """Read what can be heard; a word may mean two things only where the state decides."""
    heard = {meaning: node.need(meaning).texts() for meaning in MEANINGS}
    node.done()
    return heard


def _remarks(node: Node) -> dict[str, tuple[str, ...]]:
    """Read what is said about how it is told; a phrase that means two things is an error."""
    remarks: dict[str, tuple[str, ...]] = {}
    meant: dict[str, str] = {}
    for kind in REMARKS:
        listed = node.need(kind)
        remarks[kind] = listed.texts()
        for item in listed.sequence():
            other = meant.setdefault(item.text().lower(), kind)
            if other != kind:
                raise item.fault(f"'{item.text()}' is {other} as well", "keep it in one of the two")
    node.done()
    return remarks
