"""Lexical choice: the word for each concept, by how common, long, strong and positive it is.

Source: Mairesse & Walker 2011, section 4.5 (lexicon frequency, word length, verb strength); the
paper, section IV-C (positive emotion words).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import exp
from typing import Final

from personage_lite.lexicon import Concept, Word
from personage_lite.operators import Turn
from personage_lite.plan import ClausePlan, Made, Status
from personage_lite.randomness import pick
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    NounPhrase,
    Phrase,
    Text,
)
from personage_lite.sentence_planner.rewording import ANTONYM

STAGE: Final = "lexical_choice"
# How strongly each property of a word counts, per unit that its parameter is off the middle.
_FREQUENCY: Final = 8.0
_LENGTH: Final = 0.4
_STRENGTH: Final = 4.0
_EMOTION: Final = 3.0
_WORN: Final = 0.4
# What a complement must be to hold concepts. (Joined here: "|" takes its time.)
_WORDED: Final = (AdjectivePhrase, Coordination)


class LexicalChoice:
    """Chooses words for one utterance; the same concept gets the same word throughout it."""

    def __init__(self, turn: Turn) -> None:
        parameters = turn.parameters
        self._frequency = _FREQUENCY * (parameters["lexicon_frequency"] - 0.5)
        self._length = _LENGTH * (parameters["lexicon_word_length"] - 0.5)
        self._strength = _STRENGTH * (parameters["verb_strength"] - 0.5)
        self._emotion = _EMOTION * (parameters["positive_emotion_words"] - 0.5)
        self._contractions = parameters["contractions"]
        self._draws = turn.draws
        self._worn = turn.state.worn
        self._lexicon = turn.lexicon
        self._chosen: dict[str, Word] = {}
        self.decisions: list[Made] = []
        self.words: list[str] = []

    def _weights(self, words: Sequence[Word], verb: bool) -> list[float]:
        strength = self._strength if verb else 0.0
        frequency, length, emotion = self._frequency, self._length, self._emotion
        weights = [
            exp(
                frequency * word.frequency
                + length * len(word.text)
                + emotion * word.emotion
                + strength * word.strength
            )
            for word in words
        ]
        worn = self._worn
        if worn:
            for index, word in enumerate(words):
                weights[index] *= _WORN ** worn.get(word.text, 0)
        return weights

    def _choose(self, concept: Concept, verb: bool, other_than: str = "") -> Word:
        words: Sequence[Word] = concept.words
        if other_than:
            words = [word for word in words if word.text != other_than] or words
        if len(words) == 1:
            return words[0]
        weights = self._weights(words, verb)
        draw = self._draws.uniform(f"lexical_choice/{concept.name}{'/again' * bool(other_than)}")
        word = pick(draw, words, weights)
        chance = weights[words.index(word)] / sum(weights)
        name = concept.name
        self.decisions.append(
            ("lexical_choice", STAGE, chance, draw, "applied", name, name, word.text)
        )
        self.words.append(word.text)
        return word

    def word(self, concept: Concept, verb: bool = False) -> Word:
        """Return the word for a concept in this utterance."""
        found = self._chosen.get(concept.name)
        if found is None:
            found = self._chosen[concept.name] = self._choose(concept, verb)
        return found

    def adjective(self, phrase: AdjectivePhrase) -> AdjectivePhrase:
        """Return an adjective phrase with its concept's word."""
        concept = self._lexicon.adjectives.get(phrase.adjective)
        if concept is None:
            return phrase
        word = self.word(concept).text
        if phrase.adverbs and any(word in adverb.split(" ") for adverb in phrase.adverbs):
            # "A little little", "kind of kind": another word, if there is one.
            word = self._choose(concept, False, word).text
        return AdjectivePhrase(word, phrase.adverbs)

    def phrase(self, phrase: Phrase, restated: bool) -> Phrase:
        """Return a phrase with words for its concepts; a restatement gets another word."""
        if isinstance(phrase, AdjectivePhrase):
            return self.adjective(phrase)
        if isinstance(phrase, Coordination):
            items = [self.phrase(item, False) for item in phrase.items]
            last, concept = phrase.items[-1], None
            if restated and phrase.conjunction == "," and isinstance(last, AdjectivePhrase):
                concept = self._lexicon.adjectives.get(last.adjective)
            if concept is not None and isinstance(last, AdjectivePhrase):
                other = self._choose(concept, False, self.word(concept).text)
                items[-1] = last._replace(adjective=other.text)
            return Coordination(tuple(items), phrase.conjunction)
        return phrase

    def clause(self, plan: ClausePlan) -> ClausePlan:
        """Return a clause plan in words; most often that is the plan itself."""
        clause = plan.clause
        verb, particle = clause.verb, clause.particle
        said, asides = clause.complement, clause.asides
        concept = self._lexicon.verbs.get(verb)
        if concept is not None and not particle:
            word = self.word(concept, verb=True)
            verb, particle = word.text, word.particle
        if isinstance(said, _WORDED) and ANTONYM not in plan.marks:
            said = self.phrase(said, plan.role == "restatement")
        if asides:
            asides = tuple(self._aside(aside) for aside in asides)
        elif said is clause.complement and verb == clause.verb and particle == clause.particle:
            return plan
        # Made anew, here and below, and unchecked: that is several times as fast.
        head = (verb, clause.subject, particle, clause.indirect_object, clause.object, said)
        worded = tuple.__new__(Clause, (*head, clause.adverbials, asides, *clause[8:]))
        return tuple.__new__(ClausePlan, (worded, *plan[1:]))

    def _aside(self, phrase: Phrase) -> Phrase:
        """Choose the adjectives inside "with pink eyes"."""
        if not isinstance(phrase, Text):
            return phrase
        parts: list[Cased | Phrase] = []
        for part in phrase.parts:
            if isinstance(part, Cased) and part.phrase.adjectives:
                chosen = tuple(self.phrase(item, False) for item in part.phrase.adjectives)
                noun: NounPhrase = part.phrase._replace(adjectives=chosen)
                parts.append(Cased(noun, part.case))
            else:
                parts.append(part)
        return Text(tuple(parts))

    def clauses(
        self, plans: tuple[ClausePlan, ...], index: int
    ) -> tuple[tuple[ClausePlan, ...], bool]:
        """Return the clauses of a sentence in words, and whether they are contracted."""
        chance = self._contractions
        contracted = chance >= 1.0
        if 0.0 < chance < 1.0:
            draw = self._draws.uniform(f"contractions/{index}")
            contracted = draw < chance
            status: Status = "applied" if contracted else "not_drawn"
            target = f"sentence {index + 1}"
            self.decisions.append(("contractions", STAGE, chance, draw, status, target, "", ""))
        return tuple([self.clause(plan) for plan in plans]), contracted
