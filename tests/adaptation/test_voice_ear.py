"""Spoken answers: recognised from WAV files of synthetic voices, or rejected."""

from __future__ import annotations

import wave
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from adaptation.storyteller.clocks import SimulatedClock
from adaptation.storyteller.protocols import EndOfInput, Heard
from adaptation.voice import ear_from
from adaptation.voice.ears import WavEar
from adaptation.voice.recogniser import RATE, Recogniser, read_numbers
from adaptation.voice.sound import GrowingWav, resampled
from adaptation.voice.spoken import spoken
from adaptation.voice.voices import Espeak, Hibari, Voice
from adaptation.wav import Samples, read_wav
from personage_lite.errors import DataError, PersonageError
from tests.adaptation.hearing import answers_in_order

PHRASES = (
    *("yes", "yeah", "yes please", "no", "no thanks", "sure", "y", "n", "?", "alice", "dinah"),
    *("white rabbit", "queen of hearts", "hatter", "cheshire cat", "march hare", "caterpillar"),
    *("gryphon", "mock turtle", "goodbye", "another one"),
)
ANSWERS = ("yes", "no", "the White Rabbit", "the Queen of Hearts", "Caterpillar", "the March Hare")
OTHERS = ("what time is it", "good morning", "banana", "the weather is nice today", "orange juice")


def say(voice: Voice, text: str, x: float = 0) -> Samples:
    """Return a text spoken, with the silence around it that a recording has."""
    quiet = np.zeros(voice.rate // 3)
    return np.concatenate((quiet, voice.say(spoken(f"{text}.", x)), quiet))


def record(path: Path, voice: Voice, text: str, x: float = 0) -> str:
    """Write a spoken text to a WAV file; return its path."""
    file = GrowingWav(path, voice.rate)
    file.add(say(voice, text, x))
    file.close()
    return str(path)


def recogniser(said: list[str] | None = None) -> Recogniser:
    found = Recogniser((said if said is not None else []).append)
    found.expect(PHRASES)
    return found


def fit(heard: Heard | None, text: str) -> bool:
    return heard is not None and heard.text == text.lower().removeprefix("the ")


class Silent:
    """A typed ear where nobody types; it ends after so many seconds."""

    def __init__(self, clock: SimulatedClock, ends: float = float("inf")) -> None:
        self.clock, self.ends = clock, ends
        self.typed: list[tuple[float, str]] = []
        self.phrases: Sequence[str] = ()
        self.closed = 0

    def listen(self, seconds: float | None) -> Heard | None:
        if self.clock.now() >= self.ends:
            raise EndOfInput
        self.clock.sleep(min(seconds if seconds is not None else 60, self.ends - self.clock.now()))
        if self.typed and self.clock.now() >= self.typed[0][0]:
            return Heard(self.typed.pop(0)[1])
        return None

    def expect(self, phrases: Sequence[str]) -> None:
        self.phrases = phrases

    def close(self) -> None:
        self.closed += 1

    def speak(self, text: str, x: float) -> None:
        raise AssertionError(text)


# The recogniser


def test_most_answers_are_recognised_and_most_else_rejected() -> None:
    ear = recogniser()
    right = wrong = accepted = answers = others = 0
    for voice in (Hibari(), Espeak(), Espeak(variant="en-us+f3")):
        for x in (-1, 1):
            for text in ANSWERS:
                heard = ear.hear(say(voice, text, x), voice.rate)
                answers += 1
                right += fit(heard, text)
                wrong += heard is not None and not fit(heard, text)
            for text in OTHERS:
                others += 1
                accepted += ear.hear(say(voice, text, x), voice.rate) is not None
    assert answers + others >= 60
    assert right >= 0.8 * answers, (right, wrong, answers)
    assert wrong <= 0.05 * answers
    assert accepted <= 0.2 * others


def test_the_same_sound_is_heard_the_same() -> None:
    ear, voice = recogniser(), Hibari()
    first = ear.score(say(voice, "yes"), voice.rate)
    ear.score(say(voice, "the Queen of Hearts"), voice.rate)
    assert ear.score(say(voice, "yes"), voice.rate) == first
    assert first.phrase == "yes"
    assert first.confidence > 0.5


def test_words_around_a_phrase_are_left_out() -> None:
    ear, voice = recogniser(), Hibari()
    heard = ear.hear(say(voice, "Tell me about the Caterpillar please"), voice.rate)
    assert heard is not None
    assert (heard.text, heard.source) == ("caterpillar", "spoken")


@pytest.mark.parametrize(
    "sound",
    [
        np.zeros(0),
        np.zeros(RATE),
        np.random.default_rng(0).normal(0, 1e-4, RATE),
        np.random.default_rng(0).normal(0, 0.2, RATE),
        np.sin(np.arange(RATE) * 0.2) * 0.5,
        np.eye(1, RATE)[0],
        np.ones(RATE),
    ],
    ids=["nothing", "silence", "faint noise", "noise", "a tone", "a click", "direct current"],
)
def test_what_is_no_speech_is_rejected(sound: Samples) -> None:
    assert recogniser().hear(sound, RATE) is None


def test_nothing_is_heard_before_anything_is_expected() -> None:
    lines: list[str] = []
    ear, voice = Recogniser(lines.append), Espeak()
    assert ear.hear(say(voice, "yes"), voice.rate) is None
    ear.expect(["y", "n", "?", "…"])
    assert ear.hear(say(voice, "yes"), voice.rate) is None
    ear.expect(["yes", "Zzyzxqua the Great"])
    assert lines == ["no pronunciation known, so type it: Zzyzxqua the Great"]
    assert fit(ear.hear(say(voice, "yes"), voice.rate), "yes")


def test_grammar_marks_in_a_phrase_are_harmless() -> None:
    ear = recogniser()
    ear.expect(["yes); public <x> = no", "a|b*", "[no]", "x" * 10_000])


def test_a_fault_of_the_numbers_names_its_line(tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text("words: {}\nbefore: [the]\nafter: 3\n", "utf-8")
    with pytest.raises(DataError, match=r"mine\.yaml:3: expected a list"):
        read_numbers(str(path))


# WAV files


def test_files_are_heard_in_order_at_any_rate_and_width(tmp_path: Path) -> None:
    voice = Hibari()
    record(tmp_path / "1.wav", voice, "yes")
    sound = say(voice, "the Queen of Hearts")
    with wave.open(str(tmp_path / "2.wav"), "wb") as file:  # 8 bits, two channels, 44.1 kHz
        file.setnchannels(2)
        file.setsampwidth(1)
        file.setframerate(44_100)
        loud = resampled(sound, voice.rate, 44_100)
        file.writeframes(np.repeat(loud * 127 + 128, 2).astype(np.uint8).tobytes())
    clock, lines = SimulatedClock(), list[str]()
    ear = WavEar([str(tmp_path)], recogniser(), clock, lines.append)
    heard = [one.text if one else None for one in answers_in_order(ear)]
    assert heard == ["yes", "queen of hearts"]
    assert lines == []
    length = sum(len(s) / rate for s, rate in (read_wav(p) for p in sorted(tmp_path.iterdir())))
    assert clock.now() == pytest.approx(length)


def test_a_file_takes_its_time_and_a_glance_hears_nothing(tmp_path: Path) -> None:
    path = record(tmp_path / "1.wav", Espeak(), "yes")
    clock = SimulatedClock()
    ear = WavEar([path], recogniser(), clock, print)
    assert ear.listen(0) is None
    clock.sleep(100)
    assert ear.listen(0) is None
    assert ear.listen(0.1) is None
    assert clock.now() == pytest.approx(100.1)
    assert fit(ear.listen(10), "yes")
    with pytest.raises(EndOfInput):
        ear.listen(0)


def test_what_is_not_understood_is_told(tmp_path: Path) -> None:
    path = record(tmp_path / "1.wav", Espeak(), "the weather is nice today")
    lines: list[str] = []
    ear = WavEar([path], recogniser(), SimulatedClock(), lines.append)
    assert ear.listen(None) is None
    assert lines == [f"{path}: not understood"]


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        (b"", "no WAV file"),
        (b"hello", "no WAV file"),
        (b"RIFF\x00\x00\x00\x00WAVE", "no WAV file"),
        (b"RIFF" + bytes(60), "no WAV file"),
    ],
)
def test_a_corrupt_file_is_refused_at_once(content: bytes, fault: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.wav"
    path.write_bytes(content)
    clock = SimulatedClock()
    with pytest.raises(PersonageError, match=f"bad.wav: {fault}.+; "):
        ear_from([str(path)], None, clock=clock, typed=Silent(clock), say=print)


def test_faults_of_what_is_asked_for_are_told(tmp_path: Path) -> None:
    clock = SimulatedClock()
    typed = Silent(clock)
    for wavs, microphone, fault in (
        (["/no/such"], None, "no such file or folder; check"),
        ([str(tmp_path)], None, "no WAV file in it"),
        (["x.wav"], "", "choose one"),
        ([], "the red one", "no microphone 'the red one'; "),
    ):
        with pytest.raises(PersonageError, match=fault):
            ear_from(wavs, microphone, clock=clock, typed=typed, say=print)
    assert ear_from([], None, clock=clock, typed=typed, say=print) is typed
