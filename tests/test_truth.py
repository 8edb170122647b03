"""Truth: what is said is what was planned, with truth and polarity kept; and the checker bites."""

from __future__ import annotations

from pathlib import Path

import pytest

from personage_lite import Generator
from personage_lite.plan import Utterance
from personage_lite.realizer.specification import AdjectivePhrase, Clause, Embedded, Sentence
from personage_lite.truth import truth_faults

CHARACTERS = ("alice", "white_rabbit", "queen_of_hearts")
SEEDS = range(80)


@pytest.mark.parametrize("x", [-2, -1, 0, 1, 2])
@pytest.mark.parametrize("character", CHARACTERS)
def test_every_utterance_is_true(character: str, x: int) -> None:
    """A sample of what `python tests/sweep.py` runs over 5,000 turns: three turns a seed."""
    generator = Generator()
    about = generator.character(character)
    for seed in SEEDS:
        for utterance in generator.turns(character, x, seed, count=3):
            faults = truth_faults(utterance, about, generator.lexicon)
            assert not faults, (seed, utterance.turn, utterance.text)


@pytest.mark.parametrize("x", [-2, 0, 2])
def test_everything_at_once_is_true(x: int) -> None:
    """With every parameter at 1, whatever can be combined is, and still nothing is untrue."""
    generator = Generator()
    everything = dict.fromkeys(generator.style.parameters, 1.0)
    for character in CHARACTERS:
        about = generator.character(character)
        for seed in range(40):
            said = generator.generate(
                character, x, seed, overrides=everything | {"verbosity": 0.9}, rating="strong"
            )
            assert not truth_faults(said, about, generator.lexicon), said.text


def _clause(sentence: Sentence) -> Clause:
    body = sentence.body
    assert isinstance(body, Clause | Embedded)
    return body.clause if isinstance(body, Embedded) else body


def _with_first_clause(utterance: Utterance, clause: Clause) -> Utterance:
    first, *rest = utterance.sentences
    return utterance._replace(sentences=(first._replace(body=clause), *rest))


class TestTheCheckerBites:
    """A checker that cannot fail proves nothing: each planted fault must be found."""

    generator = Generator()
    about = generator.character("alice")
    plain = dict.fromkeys(generator.style.parameters, 0.0) | {
        "content_polarity": 0.5,
        "polarization": 0.5,
    }

    def said(self, fact: str) -> Utterance:
        """Return a plain utterance that states just one fact."""
        for utterance in self.generator.turns("alice", 0, 1, count=99, overrides=self.plain):
            if utterance.facts == (fact,) and not utterance.recalled:
                assert not self.faults(utterance)
                return utterance
        raise AssertionError(f"no turn says {fact}")

    def faults(self, utterance: Utterance) -> list[str]:
        """Return what the checker finds."""
        return truth_faults(utterance, self.about, self.generator.lexicon)

    def test_dropped_negation(self) -> None:
        """ "Alice is scared any more" is found out."""
        said = self.said("fears_nobody")
        clause = _clause(said.sentences[0])._replace(negated=False)
        assert self.faults(_with_first_clause(said, clause))

    def test_added_negation(self) -> None:
        """ "Alice isn't curious" is found out."""
        said = self.said("curious")
        clause = _clause(said.sentences[0])._replace(negated=True)
        assert self.faults(_with_first_clause(said, clause))

    def test_antonym_without_negation(self) -> None:
        """An antonym said of somebody as if it were a synonym is found out."""
        kind = Path(__file__).parent / "facts" / "wonderland"
        teller = Generator(facts=kind)
        said = next(
            utterance
            for utterance in teller.turns("alice", 0, 1, count=99, overrides=self.plain)
            if utterance.facts == ("kind",)
        )
        about = teller.character("alice")
        assert not truth_faults(said, about, teller.lexicon)
        antonym = teller.lexicon.adjectives["kind"].antonyms[0]
        clause = _clause(said.sentences[0])._replace(complement=AdjectivePhrase(antonym))
        assert truth_faults(_with_first_clause(said, clause), about, teller.lexicon)

    def test_wrong_subject(self) -> None:
        """What Alice does, said of Dinah, is found out."""
        said = self.said("cat")
        clause = _clause(said.sentences[0])._replace(subject=self.about.entities["dinah"].phrase)
        assert self.faults(_with_first_clause(said, clause))

    def test_wrong_tense_and_verb(self) -> None:
        """Another tense or another verb is found out."""
        said = self.said("cat")
        clause = _clause(said.sentences[0])
        assert self.faults(_with_first_clause(said, clause._replace(tense="past")))
        assert self.faults(_with_first_clause(said, clause._replace(verb="eat")))

    def test_missing_and_added_fact(self) -> None:
        """A sentence left out, and one too many, are found out."""
        said = self.said("cat")
        other = self.said("curious")
        assert self.faults(said._replace(sentences=()))
        assert self.faults(said._replace(sentences=said.sentences + other.sentences))

    def test_cue_without_relation(self) -> None:
        """ "… because …" between facts of which neither is a reason is found out."""
        for seed in range(3000):
            said = self.generator.generate("alice", 0, seed)
            for place, sentence in enumerate(said.sentences):
                if sentence.joined and sentence.joined[0].conjunction == "and":
                    joined = (sentence.joined[0]._replace(conjunction="so"),)
                    forged = list(said.sentences)
                    forged[place] = sentence._replace(joined=joined)
                    assert self.faults(said._replace(sentences=tuple(forged)))
                    return
        raise AssertionError("no seed joins two clauses with 'and'")
