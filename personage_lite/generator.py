"""The pipeline: facts and X to a styled utterance (the paper, section IV-C).

Generation is a pure function of the request, the seed and the conversation's state.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from os import PathLike
from typing import TYPE_CHECKING

from personage_lite.content_planner import plan_content
from personage_lite.data import data_folder
from personage_lite.errors import PersonageError
from personage_lite.facts import Character
from personage_lite.facts_reader import character_files, find_character, identifier
from personage_lite.lexicon import RATINGS, Lexicon, Rating, load_lexicon, load_style
from personage_lite.operators import Operator, Turn
from personage_lite.plan import SentencePlan, Utterance
from personage_lite.randomness import Draws
from personage_lite.realizer import Realizer
from personage_lite.sentence_planner import PRAGMATIC_MARKERS, plan_sentences
from personage_lite.sentence_planner.assembly import assemble
from personage_lite.sentence_planner.templates import PlainClauses
from personage_lite.state import ConversationState
from personage_lite.style import Anchored, check_overrides, check_x, noisy

if TYPE_CHECKING:
    from personage_lite.dialog_words import DialogWords
    from personage_lite.speech_acts import Said

DEFAULT_STYLE = "extraversion-v1"
# For how many values of X the parameters are kept.
_KEPT_X = 64
_NEW_CONVERSATION = ConversationState()


class Generator:
    """Says facts with a personality.

    >>> Generator().generate("alice", x=2, seed=7).character
    'alice'

    `facts` and `lexicons` are paths of the user's own data; `style` is the name of a style file
    in `lexicons`; `operators` are the pragmatic markers in the order in which they are offered.
    Raises `PersonageError` (often `DataError`, with file and line) for faults in the data.
    """

    def __init__(
        self,
        facts: str | PathLike[str] | None = None,
        lexicons: str | PathLike[str] | None = None,
        style: str = DEFAULT_STYLE,
        operators: Sequence[Operator] = PRAGMATIC_MARKERS,
    ) -> None:
        self._facts = data_folder("facts") if facts is None else facts
        folder = data_folder("lexicons") if lexicons is None else lexicons
        self.lexicon: Lexicon = load_lexicon(folder)
        self.style = load_style(folder, style)
        self.realizer = Realizer(self.lexicon.grammar)
        self._operators = tuple(operators)
        # The parameters at each X asked for lately: most calls ask for one of few again.
        self._anchored: dict[float, Anchored] = {}
        self._lexicons = folder
        self._dialog: DialogWords | None = None
        self._characters: dict[str, Character] = {}
        self._plain: dict[str, PlainClauses] = {}

    def with_operators(self, operators: Sequence[Operator]) -> Generator:
        """Return a generator with the same data and other pragmatic markers."""
        other = copy(self)
        other._operators = tuple(operators)
        return other

    def character(self, name: str) -> Character:
        """Return a character by id or name, reading its file the first time it is asked for."""
        key = name if name in self._characters else identifier(name)
        if key not in self._characters:
            about = find_character(name, self._facts)
            # In this order: another thread may look for the one as soon as it sees the other.
            self._plain[about.entity.id] = PlainClauses(about, self.lexicon)
            self._characters[key] = about
        return self._characters[key]

    def characters(self) -> list[Character]:
        """Return all characters that can be talked about, by id."""
        return [self.character(key) for key in character_files(self._facts)]

    def generate(
        self,
        character: str,
        x: float = 0.0,
        seed: int = 0,
        *,
        state: ConversationState = _NEW_CONVERSATION,
        overrides: Mapping[str, float] | None = None,
        rating: Rating = "mild",
        trace: bool = False,
    ) -> Utterance:
        """Return one utterance about a character at extraversion X in [-2, 2].

        `state` is the conversation so far: pass `utterance.state` to go on. `overrides` sets
        parameters to values in [0, 1]; `rating` says which expletives are allowed; `trace` adds
        each rewrite's text before and after to the decisions.

        >>> generator = Generator()
        >>> one = generator.generate("alice", x=-1, seed=3)
        >>> two = generator.generate("alice", x=-1, seed=3, state=one.state)
        >>> set(one.facts) & set(two.facts)
        set()
        """
        about = self.character(character)
        plain = self._plain[about.entity.id]
        x = check_x(x)
        if rating not in RATINGS:
            raise PersonageError(f"no rating '{rating}'; choose from: {', '.join(RATINGS)}")
        draws = Draws(int(seed), state.turn)
        anchored = self._anchored.get(x)
        if anchored is None:
            if len(self._anchored) >= _KEPT_X:
                self._anchored.clear()
            anchored = self._anchored[x] = self.style.anchored(x)
        parameters = noisy(anchored, draws)
        if overrides:
            names = [operator.name for operator in self._operators]
            parameters.update(check_overrides(self.style, overrides, names))
        show = self._show if trace else None
        turn = Turn(parameters, draws, x, state, rating, self.lexicon, show)

        content, decisions = plan_content(about, turn)
        planned = plan_sentences(content, about, plain, turn, self._operators)
        text = " ".join([self.realizer.realize(sentence) for sentence in planned.sentences])

        opened = {name for name, _, _, _, status, _, _, _ in decisions if status == "applied"}
        recalled = content.recalled
        told = tuple([fact for fact in planned.facts if fact not in recalled])
        after = state.after(
            about.entity.id,
            told,
            planned.markers | opened,
            planned.mentioned,
            planned.focus,
            planned.focus_subject,
        )
        return Utterance(
            text=text,
            character=about.entity.id,
            x=x,
            seed=seed,
            turn=state.turn,
            facts=told,
            recalled=recalled,
            parameters=parameters,
            made=(*decisions, *planned.made),
            plan=content,
            sentences=planned.sentences,
            state=after,
        )

    def turns(
        self,
        character: str,
        x: float = 0.0,
        seed: int = 0,
        *,
        count: int,
        state: ConversationState = _NEW_CONVERSATION,
        overrides: Mapping[str, float] | None = None,
        rating: Rating = "mild",
        trace: bool = False,
    ) -> Iterator[Utterance]:
        """Yield `count` successive turns about a character; no fact returns before all are told."""
        for _ in range(count):
            utterance = self.generate(
                character,
                x,
                seed,
                state=state,
                overrides=overrides,
                rating=rating,
                trace=trace,
            )
            state = utterance.state
            yield utterance

    @property
    def dialog(self) -> DialogWords:
        """The words of the dialog; `dialog.yaml` is read the first time they are asked for."""
        if self._dialog is None:
            from personage_lite.dialog_words import load_dialog_words

            self._dialog = load_dialog_words(self._lexicons)
        return self._dialog

    def say(
        self,
        act: str,
        *,
        character: str = "",
        name: str = "",
        heard: str = "",
        x: float = 0.0,
        seed: int = 0,
        state: ConversationState = _NEW_CONVERSATION,
        trace: bool = False,
    ) -> Said:
        """Return a speech act beside the facts, such as "greeting", in the style of X in [-2, 2].

        `character` is whom a suggestion is about, `name` the listener's, `heard` what was not
        known. Raises `PersonageError` for an unknown act, or where one of these is missing.
        (The paper, figure 4; the words are in `lexicons/dialog.yaml`.)

        >>> said = Generator().say("suggestion", character="white rabbit", x=0, seed=1)
        >>> "the White Rabbit" in said.text, said.state.turn
        (True, 1)
        """
        from personage_lite.speech_acts import Said, Slots, speech_act

        about = self.character(character) if character else None
        x = check_x(x)
        draws = Draws(int(seed), state.turn)
        parameters = noisy(self.style.anchored(x), draws)
        show = self._show if trace else None
        turn = Turn(parameters, draws, x, state, "mild", self.lexicon, show)
        slots = Slots(about.entity.phrase if about else None, name, heard)
        text, decisions, sentences, markers = speech_act(
            act, self.dialog, slots, turn, self.realizer
        )
        key = about.entity.id if about else ""
        after = state.said(markers, frozenset([key] if key else []))
        return Said(text, act, key, x, seed, state.turn, decisions, sentences, after)

    def _show(self, plan: SentencePlan) -> str:
        return self.realizer.realize(assemble(plan, plan.clauses))
