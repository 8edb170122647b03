"""Measures the voice: style by X of both voices, and how answers are recognised and rejected.

Run as `python benchmarks/voice.py`; it prints the tables of docs/voice.md (with the argument
`recognition` only that of the answers). All clips are synthetic
voices: what a microphone hears of people is not measured here.
"""

from __future__ import annotations

import sys
from typing import NamedTuple

import numpy as np

from adaptation.storyteller.understanding import Understanding, names_of
from adaptation.voice.measures import measured
from adaptation.voice.recogniser import Recogniser, read_numbers
from adaptation.voice.spoken import spoken
from adaptation.voice.voices import Espeak, Hibari, Voice
from adaptation.wav import Samples
from personage_lite import Generator

TEXT = (
    "Alice is a little girl who ends up in Wonderland, and she meets all kinds of talking animals. "
    "She gets bossed around by animals all day. Is she, um, curious? She never stops asking!"
)
ANSWERS = (
    *("yes", "yes please", "no thanks", "no", "goodbye", "Alice", "the White Rabbit", "Dinah"),
    *("the Queen of Hearts", "the Cheshire Cat", "the Hatter", "the March Hare", "the Duchess"),
    *("the Caterpillar", "the Gryphon", "the Mock Turtle"),
)
OTHERS = (
    *("what time is it", "I would like some tea", "good morning", "banana", "orange juice", "note"),
    *("the weather is nice today", "my telephone is ringing", "seven", "palace", "elephant"),
    *("Robin Hood", "football", "how are you", "yesterday", "the prince of Denmark"),
)

# The share of other utterances that may pass as answers where the threshold is chosen.
MOST_PASSING = 0.1


class Speaking(NamedTuple):
    """A synthetic speaker: a voice at an X, higher by some semitones."""

    name: str
    voice: Voice
    x: float
    semitones: float = 0.0

    def says(self, text: str) -> Samples:
        """Return a text spoken, with faint noise and silence around it."""
        sentences = [
            sentence._replace(
                style=sentence.style._replace(pitch=sentence.style.pitch + self.semitones)
            )
            for sentence in spoken(f"{text}.", self.x)
        ]
        quiet = np.zeros(self.voice.rate // 3)
        sound = np.concatenate((quiet, self.voice.say(sentences), quiet))
        noisy: Samples = sound + np.random.default_rng(1).normal(0, 0.001, len(sound))
        return noisy


def speakers() -> tuple[list[Speaking], list[Speaking]]:
    """Return the speakers by whom the threshold is chosen, and those by whom it is tried."""
    hibari = Hibari()
    chosen_by = [
        Speaking("hibari", hibari, 0),
        Speaking("hibari, very low", hibari, 0, -6),
        Speaking("espeak", Espeak(), 0),
        Speaking("espeak, other woman", Espeak(variant="en-us+f2"), -1),
    ]
    held_out = [
        Speaking("hibari, X = 2, high", hibari, 2, 2),
        Speaking("hibari, X = -2, low", hibari, -2, -3),
        Speaking("espeak, woman", Espeak(variant="en-us+f3"), 0),
        Speaking("espeak, other man", Espeak(variant="en-us+m3"), 1),
    ]
    return chosen_by, held_out


def style_by_x() -> None:
    """Print what is measured of the same text at each X."""
    print("voice   X   loudness dBFS  syllables/s  pitch Hz  range st  pauses s")
    for voice in (Hibari(), Espeak()):
        for x in (-2, -1, 0, 1, 2):
            found = measured(voice.say(spoken(TEXT, x)), voice.rate, TEXT)
            print(
                f"{voice.name:7} {x:2}   {found.loudness:10.1f} {found.syllables:14.2f} "
                f"{found.pitch:9.0f} {found.pitch_range:9.1f} {found.pauses:9.1f}"
            )


def recognition() -> None:
    """Print how many answers are recognised, and how much else is accepted, by threshold.

    The threshold is chosen on one half of the speakers; the other half shows what it is worth.
    """
    generator = Generator()
    meaning = Understanding(generator.dialog.heard, names_of(generator.characters()))
    ear = Recogniser(print)
    ear.expect(meaning.phrases)
    chosen_by, held_out = (_tried(half, ear, meaning) for half in speakers())
    best = chosen(chosen_by)
    print(f"\nthreshold chosen on the first half: {best}; that of ear.yaml: "
          f"{read_numbers().threshold:g}")  # fmt: skip
    for title, found in (("chosen on", chosen_by), ("held out", held_out)):
        print(f"\n{title}: {len(found)} clips")
        print("threshold  right  wrong  rejected  of answers   accepted  of others")
        for threshold in sorted({-30, -27, -24, -21, -18, best}):
            print(f"{threshold:9}  {_row(found, threshold)}")
        for name in dict.fromkeys(row.speaker for row in found):
            one = [row for row in found if row.speaker == name]
            print(f"{name:20} {_row(one, read_numbers().threshold)}")


class Tried(NamedTuple):
    """A clip: who said it, whether it is an answer, whether it was understood, and its score."""

    speaker: str
    answer: bool
    understood: bool
    score: float


def _tried(half: list[Speaking], ear: Recogniser, meaning: Understanding) -> list[Tried]:
    found = []
    for speaker in half:
        for text in (*ANSWERS, *OTHERS):
            score = ear.score(speaker.says(text), speaker.voice.rate)
            means = meaning.meaning(score.phrase) == meaning.meaning(text)
            found.append(Tried(speaker.name, text in ANSWERS, means, score.score))
    return found


def chosen(found: list[Tried]) -> int:
    """Return the lowest threshold that lets no more than a tenth of other utterances pass."""
    others = [row.score for row in found if not row.answer]
    passing = {
        threshold: sum(score >= threshold for score in others) / len(others)
        for threshold in range(-40, 1)
    }
    return min(threshold for threshold, share in passing.items() if share <= MOST_PASSING)


def _row(found: list[Tried], threshold: float) -> str:
    answers = [row for row in found if row.answer]
    others = [row for row in found if not row.answer]
    right = sum(row.understood and row.score >= threshold for row in answers)
    wrong = sum(not row.understood and row.score >= threshold for row in answers)
    accepted = sum(row.score >= threshold for row in others)
    rejected = len(answers) - right - wrong
    return f"{right:5} {wrong:6} {rejected:9} {len(answers):11} {accepted:10} {len(others):10}"


if __name__ == "__main__":
    if sys.argv[1:] != ["recognition"]:
        style_by_x()
    recognition()
