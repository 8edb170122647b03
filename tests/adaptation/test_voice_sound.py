"""Two voices, measured; the WAV file that grows; the speaker, whatever breaks."""

from __future__ import annotations

import functools
import os
import signal
import subprocess
import sys
import time
import wave
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adaptation.storyteller.clocks import SimulatedClock
from adaptation.voice import speaker_from
from adaptation.voice.measures import Measured, measured
from adaptation.voice.sound import GrowingWav, decibels, limited, resampled
from adaptation.voice.speaker import Loudspeaker, VoiceSpeaker
from adaptation.voice.spoken import SpokenSentence, spoken
from adaptation.voice.voices import Espeak, Hibari, voice_named
from adaptation.wav import Samples, read_wav
from personage_lite.errors import PersonageError

TEXT = (
    "Alice is a little girl who ends up in Wonderland, and she meets all kinds of talking animals. "
    "She gets bossed around by animals all day. Is she, um, curious? She never stops asking!"
)


class Page:
    """A speaker of text that keeps what it was given."""

    def __init__(self) -> None:
        self.said: list[str] = []
        self.closed = 0

    def speak(self, text: str, x: float) -> None:
        self.said.append(text)

    def close(self) -> None:
        self.closed += 1


@functools.cache
def measures(name: str, folder: Path) -> dict[float, Measured]:
    """Return what is measured of the same text at each X, from the WAV files that were written."""
    found = {}
    for x in (-2.0, 0.0, 2.0):
        path = folder / f"{name}{x:g}.wav"
        speaker = speaker_from(
            name, str(path), clock=SimulatedClock(), instead=Page(), say=print, play=False
        )
        speaker.speak(TEXT, x)
        speaker.close()
        found[x] = measured(*read_wav(path), TEXT)
    return found


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("spoken")


# As stated: volume 50 against 100 is 6 dB, rate 0.85 against 1.15 a factor 1.35 (with the shorter
# pauses 1.4 or so), pitch 3 semitones, range 0.6 against 1.4. The margins are for what a voice
# makes of it.
@pytest.mark.parametrize("name", ["hibari", "espeak"])
def test_loudness_rate_pitch_and_pauses_go_with_x(name: str, folder: Path) -> None:
    low, middle, high = (measures(name, folder)[x] for x in (-2.0, 0.0, 2.0))
    assert 4.5 <= high.loudness - low.loudness <= 8
    assert low.loudness + 1.5 < middle.loudness < high.loudness - 1.5
    assert 1.25 <= high.syllables / low.syllables <= 1.65
    assert low.syllables * 1.08 < middle.syllables < high.syllables / 1.05
    assert 2 <= 12 * np.log2(high.pitch / low.pitch) <= 6
    assert low.pitch * 1.04 < middle.pitch < high.pitch / 1.04
    assert 1.3 <= high.pitch_range / low.pitch_range <= 3
    assert high.pauses < middle.pauses < low.pauses
    assert low.pauses - high.pauses > 1.5


def test_the_measures_are_right_for_known_sounds() -> None:
    rate = 16_000
    at = np.arange(rate * 2) / rate
    for pitch in (90, 210, 400):
        tone = sum(np.sin(2 * np.pi * pitch * k * at) / k for k in range(1, 6)) * 0.2
        sound = np.concatenate((tone[:rate], np.zeros(rate // 2), tone[:rate]))
        found = measured(sound, rate, "la la la la la")
        assert found.pitch == pytest.approx(pitch, rel=0.02)
        assert found.pauses == pytest.approx(0.5, abs=0.06)
        assert found.syllables == pytest.approx(2, rel=0.03)
        assert found.loudness == pytest.approx(decibels(tone), abs=0.5)


def test_silence_and_nothing_are_measured_too() -> None:
    assert measured(np.zeros(16_000), 16_000, "x").loudness == -120
    assert measured(np.zeros(0), 16_000).seconds == 0


def test_resampling_keeps_a_tone_and_folds_nothing_back() -> None:
    def tone(hertz: float, rate: int) -> Samples:
        found: Samples = np.sin(np.arange(rate) * 2 * np.pi * hertz / rate) * 0.5
        return found

    inside = slice(800, -800)
    down = resampled(tone(440, 44_100), 44_100, 16_000)
    assert np.abs(down[inside] - tone(440, 16_000)[inside]).max() < 0.02
    assert np.abs(resampled(tone(440, 8000), 8000, 16_000)[inside]).max() > 0.45
    assert np.abs(resampled(tone(12_000, 48_000), 48_000, 16_000)[inside]).max() < 0.02


def test_the_limiter_never_reaches_one() -> None:
    assert np.abs(limited(np.linspace(-5, 5, 101))).max() <= 1


def test_the_same_words_are_the_same_sound() -> None:
    for voice in (Hibari(), Espeak()):
        sentences = spoken("Al-Alice is here!", -1)
        assert np.array_equal(voice.say(sentences), voice.say(sentences))
        assert len(voice.say(())) == 0


def test_no_is_not_a_number() -> None:
    voice = Hibari()
    assert len(voice.say(spoken("No.", 0))) < 0.9 * len(voice.say(spoken("Number.", 0)))


def test_markup_and_odd_signs_are_no_danger() -> None:
    for voice in (Hibari(), Espeak()):
        for text in ("<break time='9s'/>", "-w /tmp/x", "a\x00b", "&amp; ]]>", "日本", "x" * 500):
            assert len(voice.say(spoken(text, 0))) < 60 * voice.rate


# The WAV file


def test_the_file_is_whole_after_every_utterance(tmp_path: Path) -> None:
    path = tmp_path / "story.wav"
    file = GrowingWav(path, 8000)
    for count in range(1, 5):
        file.add(np.full(800, 0.5))
        with wave.open(str(path)) as read:
            assert (read.getnframes(), read.getframerate()) == (800 * count, 8000)
            assert len(read.readframes(10_000)) == 1600 * count
    file.close()
    file.close()
    with pytest.raises(OSError, match="closed"):
        file.add(np.zeros(1))


_WRITER = """
import sys, numpy as np
from adaptation.voice.sound import GrowingWav
file = GrowingWav(sys.argv[1], 8000)
while True:
    file.add(np.full(4000, 0.25))
    print(flush=True)
"""


def test_killed_at_any_moment_the_file_is_whole(tmp_path: Path) -> None:
    root = Path(__file__).parents[2]
    for number in range(8):
        path = tmp_path / f"{number}.wav"
        command = [sys.executable, "-c", _WRITER, str(path)]
        environment = {**os.environ, "PYTHONPATH": str(root)}
        with subprocess.Popen(command, stdout=subprocess.PIPE, env=environment) as writer:
            assert writer.stdout is not None
            for _ in range(number + 1):
                writer.stdout.readline()
            time.sleep(0.001 * number)
            writer.send_signal(signal.SIGKILL)
        samples, rate = read_wav(path)
        assert rate == 8000
        assert len(samples) >= 4000 * (number + 1)
        assert len(samples) % 4000 == 0
        assert np.allclose(samples, 0.25, atol=1e-3)


def test_a_file_that_cannot_be_written_is_refused_at_once(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "no" / "x.wav"):
        with pytest.raises(PersonageError, match=r"cannot be written \(.+\); choose another path"):
            speaker_from(
                "espeak", str(path), clock=SimulatedClock(), instead=Page(), say=print, play=False
            )


# The speaker


class Shouting:
    """A voice of ones; its third utterance breaks it."""

    name = "shouting"
    rate = 8000

    def __init__(self) -> None:
        self.times = 0

    def say(self, sentences: Sequence[SpokenSentence]) -> Samples:
        self.times += 1
        if self.times == 3:
            raise RuntimeError("hoarse")
        return np.ones(8000)


class Played:
    """A sound device that keeps what it is given; `PortAudioError` is as sounddevice's."""

    class PortAudioError(Exception):
        """A fault of the device."""

    def __init__(self, there: bool = True, breaks: bool = False) -> None:
        self.there, self.breaks = there, breaks
        self.log: list[Any] = []

    def query_devices(self, kind: str) -> None:
        if not self.there:
            raise self.PortAudioError("Error querying device -1")

    def play(self, samples: Samples, rate: int) -> None:
        if self.breaks:
            raise self.PortAudioError("unplugged")
        self.log.append((len(samples), rate))

    def stop(self) -> None:
        self.log.append("stop")


def test_a_voice_that_breaks_never_stops_the_story(tmp_path: Path) -> None:
    lines: list[str] = []
    page, clock = Page(), SimulatedClock()
    wav = GrowingWav(tmp_path / "x.wav", 8000)
    speaker = VoiceSpeaker(Shouting(), clock, page, lines.append, None, wav)
    for number in range(5):
        speaker.speak(f"This is {number}.", 0)
    assert page.said == ["This is 2.", "This is 3.", "This is 4."]
    assert lines == ["the voice shouting broke (hoarse); the story goes on as text"]
    assert clock.now() == 2.0
    speaker.close()
    speaker.close()
    assert len(read_wav(tmp_path / "x.wav")[0]) == 2 * 8000 + 2 * 4000


def test_a_device_is_played_to_stopped_and_lost() -> None:
    lines: list[str] = []
    module, page = Played(), Page()
    speaker = VoiceSpeaker(Shouting(), SimulatedClock(), page, lines.append, Loudspeaker(module))
    assert speaker.begin("One.", 0) == 1.0
    assert speaker.speaking
    speaker.stop()
    assert not speaker.speaking
    module.breaks = True
    assert speaker.begin("Two.", 0) is None
    assert module.log == [(8000, 8000), "stop"]
    assert lines[0].startswith("no more is heard: the sound device does not play (unplugged)")
    assert len(lines) == 2
    speaker.speak("Three.", 0)
    assert page.said == ["Three."]


def test_no_device_is_one_line() -> None:
    with pytest.raises(PersonageError, match="no sound device, so nothing is heard; "):
        Loudspeaker(Played(there=False))


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_ends_the_file_with_one_line(tmp_path: Path) -> None:
    lines: list[str] = []
    wav = GrowingWav(tmp_path / "x.wav", 8000)
    page = Page()
    speaker = VoiceSpeaker(Shouting(), SimulatedClock(), page, lines.append, None, wav)
    speaker.speak("One.", 0)
    with open("/dev/full", "wb", buffering=0) as full:
        os.dup2(full.fileno(), wav.fileno())
    speaker.speak("Two.", 0)
    assert "no more is written (No space left on device)" in lines[0]
    speaker.speak("Three.", 0)
    assert page.said == ["Two.", "Three."]
    speaker.close()


def test_an_unknown_voice_and_a_missing_program_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(PersonageError, match="no voice 'hibary'; did you mean hibari"):
        voice_named("hibary")
    monkeypatch.setenv("PATH", "")
    with pytest.raises(PersonageError, match="needs espeak-ng; apt-get install espeak-ng"):
        voice_named("espeak")
    monkeypatch.setitem(sys.modules, "hibari", None)
    with pytest.raises(PersonageError, match=r"pip install 'personage-lite\[voice\]'"):
        voice_named("auto")
