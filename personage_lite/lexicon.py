"""The lexicon: markers, templates and synonyms, read from `lexicons/` and never changed.

Whoever adds a hedge or a synonym edits the YAML; the code knows operators, not words.
"""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from collections.abc import Iterable
from os import PathLike
from os.path import join
from typing import Literal, NamedTuple, TypeAlias

from personage_lite.facts import FEELINGS, POLARITIES
from personage_lite.realizer.grammar import Grammar, load_grammar
from personage_lite.style import Style, read_style
from personage_lite.yaml_reader import Node, read_yaml

ATTACHMENTS: tuple[str, ...] = ("coordinate", "subordinate", "fronted", "connective", "beginning")
KINDS_OF_CLAUSE: tuple[str, ...] = ("qualities", "states", "deeds", "habits")
RATINGS: tuple[str, ...] = ("clean", "mild", "strong")
Rating: TypeAlias = Literal["clean", "mild", "strong"]
TOPIC = "{topic}"


class Marker(NamedTuple):
    """Words that an operator can insert, and where they can stand.

    `lean` in [-1, 1] says who uses them, introverts (-1) or extraverts (1). For cue words,
    `attach` is how they join, `role` which side they introduce, and `own_subject` keeps the
    subject of the joined clause from being left out. `verbs`, if any, are the only ones that the
    marker goes with; `first` is the degree of what a restatement says again. `polarity`,
    `feelings` and `only`, if any, are the only news, the only feelings and the only kind of
    clause (one of `KINDS_OF_CLAUSE`) that it goes with.
    """

    text: str
    place: str = ""
    after: str = ""
    lean: float = 0.0
    weight: float = 1.0
    attach: str = ""
    role: str = ""
    own_subject: bool = False
    verbs: tuple[str, ...] = ()
    first: str = ""
    polarity: str = ""
    feelings: tuple[str, ...] = ()
    only: str = ""


class Template(NamedTuple):
    """A syntactic frame for a proposition; see lexicons/templates.yaml for the fields.

    `marker` stands for it in choices: its name, lean and weight, and what it can be said of.
    """

    name: str
    parameter: str
    form: str
    lead: str
    complementizer: str
    connotation: str
    inner_tag: bool
    emphatic: bool
    hedging: bool
    marker: Marker


class Word(NamedTuple):
    """One word for a concept: how common (0-1), how strong (0-1), how positive (-1 to 1)."""

    text: str
    particle: str = ""
    frequency: float = 0.5
    strength: float = 0.5
    emotion: float = 0.0


class Concept(NamedTuple):
    """What a fact names and the words that can say it.

    `antonyms` are words whose negation says the same ("isn't dull" for imaginative). An
    adjective that is not gradable takes no "somewhat" or "so".
    """

    name: str
    words: tuple[Word, ...]
    antonyms: tuple[str, ...] = ()
    gradable: bool = True


class Once(NamedTuple):
    """Markers of which an utterance needs but one, and the words that they begin with."""

    texts: frozenset[str]
    beginnings: frozenset[str]


class Lexicon(NamedTuple):
    """All words that generation can choose from; read-only, threads may share it.

    `attention` are the markers that announce something ("guess what?"), `doubts` those that
    doubt a whole sentence ("as far as I know"): of each an utterance needs but one.
    """

    markers: dict[str, tuple[Marker, ...]]
    templates: dict[str, tuple[Template, ...]]
    someone: dict[str, str]
    adjectives: dict[str, Concept]
    verbs: dict[str, Concept]
    attention: Once
    doubts: Once
    grammar: Grammar


# The kinds of markers that the operators ask for, each with the places that it can stand in
# (no place: there is but one).
MARKER_PLACES: dict[str, tuple[str, ...]] = {
    "softener_hedges": ("degree", "pause", "quantity", "lead", "end"),
    "informal_softeners": ("degree", "pause", "quantity", "lead", "end"),
    "weakened_positive_content": ("degree",),
    "emphasizer_hedges": ("degree", "middle", "alone", "opener"),
    "acknowledgments": ("utterance", "sentence", "question", "answer"),
    "filled_pauses": ("pause", "opener", "answer"),
    "expletives": ("degree", "opener"),
    "near_expletives": ("degree", "opener"),
    "tag_question": (),
    "in_group_marker": ("opener", "end"),
    "competence_mitigation": ("lead", "opener"),
    "request_confirmation": (),
    "initial_rejection": (),
    "contrast_cue_word": (),
    "justify_cue_word": (),
    "concede_cue_word": (),
    "sequence_cue_word": (),
    "conjunction": (),
    "with_cue_word": (),
    "also_cue_word": ("middle", "connective"),
    "merge_with_comma": (),
    "recall": (),
    "anticipation": (),
    "reaction": (),
    "topic_shift": (),
}


def load_lexicon(folder: str | PathLike[str]) -> Lexicon:
    """Read the lexicon's files from a folder.

    Raises `DataError` that names file, line and remedy for anything unknown, missing or empty.
    """
    templates, someone = _read_templates(read_yaml(join(folder, "templates.yaml")))
    markers = _read_markers(read_yaml(join(folder, "markers.yaml")))
    announcing = [
        *(marker for marker in markers["request_confirmation"] if marker.after == "!"),
        *markers["anticipation"],
        *(marker for marker in markers["topic_shift"] if marker.after == "?"),
        *(marker for marker in markers["emphasizer_hedges"] if marker.place == "opener"),
        *(marker for marker in markers["near_expletives"] if marker.place == "opener"),
        *(marker for marker in markers["reaction"] if "surprising" in marker.feelings),
    ]
    doubting = [
        *(marker.text for marker in markers["softener_hedges"] if marker.place in ("lead", "end")),
        *(marker.text for marker in markers["initial_rejection"]),
        *(each.lead for offered in templates.values() for each in offered if each.hedging),
    ]
    return Lexicon(
        markers=markers,
        doubts=_once(text.rstrip(",") for text in doubting if text),
        attention=_once(marker.text for marker in announcing),
        templates=templates,
        someone=someone,
        adjectives=_read_concepts(read_yaml(join(folder, "adjectives.yaml")), verbs=False),
        verbs=_read_concepts(read_yaml(join(folder, "verbs.yaml")), verbs=True),
        grammar=load_grammar(folder),
    )


def _once(texts: Iterable[str]) -> Once:
    listed = frozenset(texts)
    return Once(listed, frozenset(text.partition(" ")[0].rstrip(",") for text in listed))


def load_style(folder: str | PathLike[str], name: str) -> Style:
    """Read the style file `name`.yaml of a folder."""
    return read_style(read_yaml(join(folder, f"{name}.yaml")))


def _read_markers(node: Node) -> dict[str, tuple[Marker, ...]]:
    found: dict[str, tuple[Marker, ...]] = {}
    for kind, places in MARKER_PLACES.items():
        listed = node.need(kind)
        items = listed.sequence()
        if not items:
            raise listed.fault(f"'{kind}' is empty", "add at least one marker")
        found[kind] = tuple(_marker(item, kind, places) for item in items)
    node.done()
    return found


def _marker(item: Node, kind: str, places: tuple[str, ...]) -> Marker:
    cue = kind.endswith("cue_word") and not places and kind != "with_cue_word"
    if item.is_text() and not places and not cue:
        return Marker(item.text())
    marker = Marker(
        *marker_basics(item, places),
        attach=item.need("attach").choice(ATTACHMENTS) if cue else "",
        role=item.choice_of("role", ("nucleus", "satellite"), ""),
        own_subject=item.flag_of("own_subject"),
        verbs=item.texts_of("verbs"),
        first=item.text_of("first"),
        polarity=item.choice_of("polarity", POLARITIES, ""),
        feelings=_feelings(item),
        only=item.choice_of("only", KINDS_OF_CLAUSE, ""),
    )
    item.done()
    return marker


def marker_basics(item: Node, places: tuple[str, ...]) -> tuple[str, str, str, float, float]:
    """Read what every marker has: text, place, the mark after it, lean and weight.

    The caller reads what else there can be, and refuses the rest with `done`.
    """
    return (
        item.need("text").text(),
        item.need("place").choice(places) if places else "",
        item.choice_of("after", (",", "!", "?", "…", "."), ""),
        item.number_of("lean", -1, 1, 0.0),
        item.number_of("weight", 0, 100, 1.0),
    )


def _feelings(item: Node) -> tuple[str, ...]:
    """Return the feelings that an entry lists, each one that facts can have."""
    listed = item.get("feelings")
    return () if listed is None else tuple(each.choice(FEELINGS) for each in listed.sequence())


def _read_templates(node: Node) -> tuple[dict[str, tuple[Template, ...]], dict[str, str]]:
    """Return the templates by the parameter that makes them likelier, and the words "someone"."""
    templates: dict[str, tuple[Template, ...]] = {}
    for name, item in node.need("templates").items():
        form = item.need("form").choice(("clause", "exclamative", "someone_who"))
        parameter = item.need("parameter").text()
        template = Template(
            name=name,
            parameter=parameter,
            form=form,
            lead="" if form == "someone_who" else item.need("lead").text(),
            complementizer=item.text_of("complementizer"),
            connotation=item.choice_of("connotation", POLARITIES, ""),
            inner_tag=item.choice_of("tag", ("inner",), "") == "inner",
            emphatic=item.flag_of("emphatic"),
            hedging=item.flag_of("hedging"),
            marker=Marker(
                name,
                lean=item.number_of("lean", -1, 1, 0.0),
                weight=item.number_of("weight", 0, 100, 1.0),
                polarity=item.choice_of("polarity", POLARITIES, ""),
                feelings=_feelings(item),
                only=item.choice_of("only", KINDS_OF_CLAUSE, ""),
            ),
        )
        item.done()
        templates[parameter] = (*templates.get(parameter, ()), template)
    listed = node.need("someone")
    someone = {kind: listed.need(kind).text() for kind in ("animate", "inanimate")}
    listed.done()
    node.done()
    return templates, someone


def _read_concepts(node: Node, verbs: bool) -> dict[str, Concept]:
    found: dict[str, Concept] = {}
    for name, item in node.items():
        listed = item.need("words")
        words = tuple(_word(word, verbs) for word in listed.sequence())
        if not words:
            raise listed.fault(f"'{name}' has no words", "add at least one")
        antonyms = item.texts_of("antonyms")
        gradable = item.get("gradable")
        found[name] = Concept(name, words, antonyms, gradable is None or gradable.flag())
        item.done()
    return found


def _word(item: Node, verbs: bool) -> Word:
    """Read "word", or [word, frequency, strength, emotion] to save the newcomer's typing."""
    if item.is_text():
        return Word(item.text())
    if item.is_sequence():
        values = item.sequence()
        if len(values) != 4:
            raise item.fault(f"{len(values)} values", "write [word, frequency, strength, emotion]")
        text, particle = values[0].text(), ""
        if verbs:
            text, _, particle = text.partition(" ")
        return Word(
            text,
            particle,
            values[1].number(0, 1),
            values[2].number(0, 1),
            values[3].number(-1, 1),
        )
    raise item.fault("this is no word", "write a word or [word, frequency, strength, emotion]")
