"""Style: what every generation parameter is worth at an extraversion X, as data.

Source: Mairesse & Walker 2011, section 4 (parameters and their links to extraversion); the
paper, section IV-C ("X does not set or activate parameters directly, but increases or decreases
their probability").
"""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from collections.abc import Iterable, Mapping
from typing import Literal, NamedTuple, TypeAlias, cast

from personage_lite.errors import PersonageError, nearest, shown
from personage_lite.randomness import GAUSS_SCALE, Draws
from personage_lite.yaml_reader import Node

Direction: TypeAlias = Literal["rises", "falls", "steady", "split"]
Stage: TypeAlias = Literal[
    "content_planning",
    "syntactic_template_selection",
    "aggregation",
    "pragmatic_markers",
    "lexical_choice",
    "referring_expressions",
]

STAGES: tuple[str, ...] = (
    "content_planning",
    "syntactic_template_selection",
    "aggregation",
    "pragmatic_markers",
    "lexical_choice",
    "referring_expressions",
)
# What generation cannot do without. An operator without a parameter is only never applied.
NEEDED: tuple[str, ...] = (
    *("verbosity", "content_polarity", "polarization", "concessions", "repetition_polarity"),
    *("template_polarity", "period", "conjunction", "merge", "relative_clause"),
    *("object_relative_clause", "with_cue_word"),
    *("also_cue_word", "contrast_cue_word", "justify_cue_word", "concede_cue_word"),
    *("sequence_cue_word", "merge_with_comma", "lexicon_frequency", "lexicon_word_length"),
    *("verb_strength", "positive_emotion_words", "contractions", "pronominalization"),
)
LOWEST_X, HIGHEST_X = -2.0, 2.0
_ANCHORS = 5


class Parameter(NamedTuple):
    """One generation parameter: its anchors are its values at X = -2, -1, 0, 1 and 2."""

    name: str
    stage: Stage
    direction: Direction
    anchors: tuple[float, ...]
    does: str


class Anchored(NamedTuple):
    """The parameters' values at one X, and the noise on them: deviations as `Draws` takes them."""

    names: tuple[str, ...]
    values: tuple[float, ...]
    deviations: tuple[float, ...]


class Style(NamedTuple):
    """A versioned set of parameters, with the deviation of the noise on their values."""

    name: str
    noise: float
    parameters: dict[str, Parameter]

    def anchored(self, x: float) -> Anchored:
        """Return the parameters' values at X, interpolated, with the deviations of their noise.

        Near 0 and 1 there is less noise, so that what is rare does not become common by chance
        and no value leaves [0, 1]; a value of 0 or 1 means never or always and stays so.
        """
        left = min(int(x - LOWEST_X), _ANCHORS - 2)
        share = x - LOWEST_X - left
        noise = self.noise
        values = []
        for parameter in self.parameters.values():
            low, high = parameter.anchors[left : left + 2]
            values.append(low + (high - low) * share)
        deviations = [min(noise, value / 3, (1 - value) / 3) / GAUSS_SCALE for value in values]
        return Anchored(tuple(self.parameters), tuple(values), tuple(deviations))


def noisy(anchored: Anchored, draws: Draws) -> dict[str, float]:
    """Return the parameters' values for one utterance, with Gaussian noise as in PERSONAGE.

    The noise goes by place in the file: a new parameter goes to its end, so that the others stay.
    """
    names, values, deviations = anchored
    return dict(zip(names, draws.around(values, deviations), strict=True))


def check_x(x: float | str) -> float:
    """Return X as a float; raises `PersonageError` unless it is a number in [-2, 2]."""
    try:
        number = float(x)
    except (TypeError, ValueError, OverflowError):
        number = float("nan")
    if not LOWEST_X <= number <= HIGHEST_X:
        what = shown(str(x)) or "empty"
        raise PersonageError(f"X is {what}; give a number from -2 (introvert) to 2 (extravert)")
    return number


def check_overrides(
    style: Style, overrides: Mapping[str, float], more: Iterable[str] = ()
) -> dict[str, float]:
    """Return the overrides as given; raises `PersonageError` for an unknown name or value.

    `more` are names that count as parameters too: those of a user's own operators.
    """
    known = {*style.parameters, *more}
    for name, value in overrides.items():
        if name not in known:
            raise PersonageError(f"no parameter '{shown(name)}'; {nearest(name[:200], known)}")
        if not 0.0 <= value <= 1.0:
            raise PersonageError(f"{name} is {value:g}; give a number from 0 to 1")
    return dict(overrides)


def read_style(node: Node) -> Style:
    """Read a style file; raises `DataError` for a value out of range or against its direction."""
    listed = node.need("parameters")
    for name in NEEDED:
        listed.need(name)
    parameters = {name: _parameter(name, item) for name, item in listed.items()}
    style = Style(node.need("name").text(), node.need("noise").number(0, 1), parameters)
    node.done()
    return style


def _parameter(name: str, item: Node) -> Parameter:
    listed = item.need("anchors")
    anchors = tuple(value.number(0, 1) for value in listed.sequence())
    if len(anchors) != _ANCHORS:
        raise listed.fault(f"{len(anchors)} anchors", "give five, for X = -2, -1, 0, 1 and 2")
    direction = item.need("direction").choice(("rises", "falls", "steady", "split"))
    steps = [anchors[place + 1] - anchors[place] for place in range(_ANCHORS - 1)]
    if (direction == "rises" and min(steps) < 0) or (direction == "falls" and max(steps) > 0):
        raise listed.fault(f"the anchors do not go with '{direction}'", "mend one or the other")
    if direction == "steady" and any(steps):
        raise listed.fault("the anchors differ", "write 'rises', 'falls' or 'split' instead")
    parameter = Parameter(
        name=name,
        stage=cast(Stage, item.need("stage").choice(STAGES)),
        direction=cast(Direction, direction),
        anchors=anchors,
        does=item.need("does").text(),
    )
    item.done()
    return parameter
