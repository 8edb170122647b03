"""Two ears at once, a microphone, and the storyteller's own speech recognised back."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from adaptation.storyteller.clocks import SimulatedClock
from adaptation.storyteller.protocols import EndOfInput
from adaptation.voice import ear_from, speaker_from
from adaptation.voice.ears import EitherEar, MicrophoneEar
from adaptation.voice.recogniser import RATE
from adaptation.voice.sound import resampled
from adaptation.voice.voices import Espeak, Hibari
from adaptation.wav import read_wav
from tests.adaptation.hearing import answers_in_order
from tests.adaptation.test_voice_ear import PHRASES, Silent, fit, recogniser, record, say

# Two ears


def test_typed_answers_work_beside_spoken_ones(tmp_path: Path) -> None:
    paths = [record(tmp_path / f"{word}.wav", Espeak(), word) for word in ("no", "yes")]
    clock = SimulatedClock()
    typed = Silent(clock, ends=30)
    typed.typed = [(0.1, "quickly"), (12.0, "later")]
    ear = ear_from(paths, None, clock=clock, typed=typed, say=print)
    assert isinstance(ear, EitherEar)
    ear.expect(PHRASES)
    assert typed.phrases == PHRASES
    texts = []
    while True:
        try:
            heard = ear.listen(5)
        except EndOfInput:
            break
        texts.append(heard.text if heard else None)
    assert texts[:3] == ["quickly", "no", "yes"]
    assert [text for text in texts[3:] if text] == ["later"]
    assert clock.now() >= 30
    ear.close()
    ear.close()


# A microphone


class Tape:
    """A microphone that plays what it is given, 0.1 s of it at each look, and then is gone."""

    def __init__(self, sound: bytes) -> None:
        self.sound = sound
        self.open_now = False

    def open(self) -> None:
        self.open_now = True

    def chunks(self, now: float) -> list[bytes]:
        if not self.sound:
            raise OSError("gone")
        part, self.sound = self.sound[:3200], self.sound[3200:]
        return [part]

    def close(self) -> None:
        self.open_now = False


def tape() -> Tape:
    voice = Hibari()
    faint = np.random.default_rng(0).normal(0, 0.001, RATE)
    parts = [faint]
    for text in ("yes", "the Queen of Hearts"):
        parts += [resampled(say(voice, text), voice.rate, RATE), faint]
    return Tape((np.concatenate(parts).clip(-1, 1) * 32767).astype("<i2").tobytes())


def test_a_microphone_hears_answers_between_silences_until_it_is_gone() -> None:
    lines: list[str] = []
    device = tape()
    ear = MicrophoneEar(None, recogniser(), SimulatedClock(), lines.append, device=device)
    heard = [one.text for one in answers_in_order(ear) if one]
    assert heard == ["yes", "queen of hearts"]
    assert lines == ["the microphone gives no more sound; type the answers"]
    assert not device.open_now
    ear.close()


def test_a_deaf_microphone_hears_nothing() -> None:
    ear = MicrophoneEar(
        None, recogniser(), SimulatedClock(), list[str]().append, lambda: True, tape()
    )
    assert list(answers_in_order(ear)) == []


def test_our_own_speech_is_recognised_back(tmp_path: Path) -> None:
    """The storyteller's WAV file is speech: the name in it is heard by the recogniser."""
    for name in ("hibari", "espeak"):
        path = tmp_path / f"{name}.wav"
        clock = SimulatedClock()
        speaker = speaker_from(
            name,
            str(path),
            clock=clock,
            instead=Silent(clock),
            say=print,
            play=False,
        )
        speaker.speak("The Queen of Hearts!", 1)
        speaker.close()
        assert fit(recogniser().hear(*read_wav(path)), "queen of hearts")
