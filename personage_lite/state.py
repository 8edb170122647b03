"""What a conversation remembers from turn to turn: an immutable value that generation returns."""

from __future__ import annotations

from dataclasses import dataclass, field

# How many past turns still damp a marker that was used in them.
MEMORY_TURNS = 3
# What is left of a probability for each of those turns that used the same operator: a marker
# used too often annoys the listener (the paper, section V).
_WORN = 0.7


@dataclass(frozen=True, slots=True)
class ConversationState:
    """The state before a turn; a new conversation starts with `ConversationState()`.

    `told` counts how often each fact was told, by (character, fact). `recent` holds, for each of
    the last turns, the operators applied and the marker words used. `topic` is the character of
    the last turn and `last_fact` what was told last. `introduced` are the entities named so far;
    `focus` those of the last sentence, `focus_subject` the one that its last clause was about.
    """

    turn: int = 0
    told: dict[tuple[str, str], int] = field(default_factory=dict)
    recent: tuple[frozenset[str], ...] = ()
    topic: str = ""
    last_fact: str = ""
    introduced: frozenset[str] = frozenset()
    focus: frozenset[str] = frozenset()
    focus_subject: str = ""

    def times_told(self, character: str, fact: str) -> int:
        """Return how often a fact was told."""
        return self.told.get((character, fact), 0)

    def times_recent(self, marker: str) -> int:
        """Return in how many of the last turns an operator or a marker word was used."""
        return sum(1 for turn in self.recent if marker in turn)

    def after(
        self,
        character: str,
        facts: tuple[str, ...],
        markers: frozenset[str],
        introduced: frozenset[str],
        focus: frozenset[str],
        focus_subject: str,
    ) -> ConversationState:
        """Return the state after a turn that told `facts` with `markers`."""
        told = dict(self.told)
        for fact in facts:
            told[character, fact] = told.get((character, fact), 0) + 1
        return ConversationState(
            turn=self.turn + 1,
            told=told,
            recent=(markers, *self.recent[: MEMORY_TURNS - 1]),
            topic=character,
            last_fact=facts[-1] if facts else "",
            introduced=self.introduced | introduced,
            focus=focus,
            focus_subject=focus_subject,
        )


def damping(state: ConversationState, operator: str) -> float:
    """Return the factor, 1 or less, on the probability of an operator that was used lately."""
    return float(_WORN ** state.times_recent(operator))
