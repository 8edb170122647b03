"""The values that pass between the stages: content plan, sentence plans, decisions, utterance."""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from typing import Literal, NamedTuple, TypeAlias

from personage_lite.facts import Fact, RelationKind
from personage_lite.realizer.specification import Clause, Opener, Sentence, Text
from personage_lite.state import ConversationState

Role: TypeAlias = Literal["assertion", "repetition", "restatement", "recall"]
Status: TypeAlias = Literal["applied", "not_applicable", "not_drawn"]
LinkKind: TypeAlias = Literal[
    "main", "coordinate", "subordinate", "fronted", "relative", "object_relative"
]


# What says how something is or what it has, and not what it does.
STATES: tuple[str, ...] = ("be", "have")


class Decision(NamedTuple):
    """One decision of the generator: what was drawn, with which chance, and what came of it.

    `before` and `after` hold the text of the place that was rewritten, when a trace is asked for.
    """

    operator: str
    stage: str
    probability: float
    draw: float
    status: Status
    target: str = ""
    before: str = ""
    after: str = ""


# A decision's fields in their order: a turn makes dozens, and few are ever looked at.
Made: TypeAlias = tuple[str, str, float, float, Status, str, str, str]


class Message(NamedTuple):
    """A fact chosen to be said, to be said again at once, or recalled from an earlier turn."""

    fact: Fact
    role: Role = "assertion"


class Link(NamedTuple):
    """What holds between a message and the one before it: a relation, or only a shared topic.

    `satellite_first` is true where the earlier message is the relation's satellite;
    `fixed_order` where the later one makes no sense before the earlier one.
    """

    kind: RelationKind | Literal["infer", "none"]
    satellite_first: bool = False
    fixed_order: bool = False


class ContentPlan(NamedTuple):
    """What to say, in order; `links[i]` joins messages i and i + 1 (Reiter & Dale 2000, ch. 4).

    `confirmation`, `rejection` and `mitigation` say whether the utterance opens with them.
    """

    messages: tuple[Message, ...]
    links: tuple[Link, ...]
    confirmation: bool = False
    rejection: bool = False
    mitigation: bool = False

    @property
    def recalled(self) -> tuple[str, ...]:
        """The facts that are taken up from an earlier turn."""
        return tuple([message.fact.id for message in self.messages if message.role == "recall"])


class Frame(NamedTuple):
    """The template a clause is said in: a lead with "that" or "how", or "someone who"."""

    form: str
    lead: Text | None
    complementizer: str = ""
    inner_tag: bool = False


class ClausePlan(NamedTuple):
    """One clause of a sentence plan, with what the operators' constraints ask about.

    `story` marks a step of what is told in order. `link` says how it joins the sentence, with the
    cue word `cue`; a `fronted` clause belongs to the main clause after it, all others to the main
    clause before. `following` marks one whose words lean on the fact that was told just before.
    """

    clause: Clause
    facts: tuple[str, ...]
    polarity: str
    strength: str
    gradable: bool = True
    link: LinkKind = "main"
    cue: str = ""
    shared_subject: bool = False
    frame: Frame | None = None
    topic: str = ""
    role: Role = "assertion"
    marks: tuple[str, ...] = ()
    story: bool = False
    feeling: str = ""
    following: bool = False


class SentencePlan(NamedTuple):
    """A sentence before assembly: its clauses in spoken order and what stands around them.

    A `fragment` has words instead of clauses ("you want to hear about Alice"). `first` is true
    for the first sentence that states a fact; `subject_before` is the entity that the sentence
    before it was about; `answers` is true after an opening question. `words` collects the marker
    words used, for the conversation's memory.
    """

    clauses: tuple[ClausePlan, ...] = ()
    fragment: Text | None = None
    first: bool = False
    answers: bool = False
    subject_before: str = ""
    openers: tuple[Opener, ...] = ()
    connective: str = ""
    vocative: str = ""
    afterthought: str = ""
    tag: str = ""
    terminal: str = "."
    false_start: bool = False
    hesitation: str = ""
    words: tuple[str, ...] = ()


class Utterance(NamedTuple):
    """One turn: the text and all that explains it.

    `facts` are the ids of the facts stated, in order, `recalled` those that are taken up from an
    earlier turn ("as I said, …"); `state` is the conversation afterwards; `sentences` is what the
    realizer was given. `made` holds the decisions as they were noted, without names.
    """

    text: str
    character: str
    x: float
    seed: int
    turn: int
    facts: tuple[str, ...]
    recalled: tuple[str, ...]
    parameters: dict[str, float]
    made: tuple[Made, ...]
    plan: ContentPlan
    sentences: tuple[Sentence, ...]
    state: ConversationState

    @property
    def decisions(self) -> tuple[Decision, ...]:
        """What was decided, in the order in which it was decided."""
        return tuple(map(Decision._make, self.made))

    def record(self) -> dict[str, object]:
        """Return the utterance as a JSON-ready record (docs/commands.md)."""
        return {
            "text": self.text,
            "character": self.character,
            "x": self.x,
            "seed": self.seed,
            "turn": self.turn,
            "facts": list(self.facts),
            "recalled": list(self.recalled),
            "parameters": {name: round(value, 4) for name, value in self.parameters.items()},
            "decisions": [
                {
                    "operator": decision.operator,
                    "stage": decision.stage,
                    "probability": round(decision.probability, 4),
                    "draw": round(decision.draw, 6),
                    "status": decision.status,
                    "target": decision.target,
                }
                for decision in self.decisions
            ],
        }
