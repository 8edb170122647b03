"""Voices: what turns sentences into sound. `hibari` is a neural one, `espeak` the system's."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable, Mapping, Sequence
from tempfile import TemporaryDirectory
from typing import Any, Protocol

import numpy as np

from adaptation.sensing.setup import needs
from adaptation.voice.sound import limited, silence, trimmed
from adaptation.voice.spoken import Pause, SpokenSentence
from adaptation.voice.ssml import document
from adaptation.wav import Samples, read_wav
from personage_lite.errors import PersonageError, nearest

# How long one utterance may take espeak-ng: a second is enough for minutes of speech.
_PATIENCE = 60.0
# espeak-ng 1.51 raises its pitch by about half of what it is asked: measured, +20% and +40%.
_ESPEAK_PITCH = 2.0
# hibari is about so much quieter than espeak-ng: measured over utterances at X = 0.
_HIBARI_GAIN = 10 ** (4.7 / 20)
_LOWEST_VOICED = 40.0
# hibari reads "No." as "number"; "know" sounds as "no" should.
_NO = re.compile(r"\b[Nn]o(?=\.(?!\s*\d))")


class Voice(Protocol):
    """Turns sentences into sound."""

    name: str
    rate: int

    def say(self, sentences: Sequence[SpokenSentence]) -> Samples:
        """Return the sound, -1 to 1 at `rate` samples a second; raises `PersonageError`."""
        ...


class Hibari:
    """The neural American voice of `hibari-tts`: it downloads nothing, the model is in its wheel.

    The network gives the pitch of each 12.5 ms beside the spectrum, and the sound is made from
    both; so pitch and its range are changed between the two, and the vowels stay as they are.
    Rate is the network's own input; loudness is a gain with a soft limiter. `seed` decides about
    the breath's noise, so that the same words are the same sound.
    """

    name = "hibari"

    def __init__(self, seed: int = 0) -> None:
        try:
            from hibari import SAMPLE_RATE, dsp
            from hibari import Hibari as Model
        except ModuleNotFoundError as error:
            raise needs("the voice hibari", error.name, "voice") from None
        self._model: Any = Model()
        self._synthesis: Callable[..., Any] = dsp.synth
        self.rate = int(SAMPLE_RATE)
        self._seed = seed

    def say(self, sentences: Sequence[SpokenSentence]) -> Samples:
        """Return the sound of sentences."""
        parts: list[Samples] = []
        for index, sentence in enumerate(sentences):
            if index:
                parts.append(silence(sentence.style.sentence_pause, self.rate))
            text = ""
            for piece in sentence.pieces:
                if isinstance(piece, Pause):
                    parts += [self._words(text, sentence), silence(piece.seconds, self.rate)]
                    text = ""
                else:
                    text += piece.sound
            parts.append(self._words(text, sentence))
        sound = np.concatenate(parts) if parts else silence(0, self.rate)
        return limited(sound)

    def _words(self, text: str, sentence: SpokenSentence) -> Samples:
        style = sentence.style
        found = [silence(0, self.rate)]
        text = _NO.sub("know", text)
        for phonemes in self._model.phonemize(text) if text.strip() else []:
            inputs = {
                "ids": np.asarray([self._model.ids(phonemes)], np.int64),
                "speed": np.asarray([style.rate], np.float32),
            }
            *spectrum, pitch = (output[0] for output in self._model.sess.run(None, inputs))
            moved = pitch_moved(pitch, style.pitch, style.range)
            sound = self._synthesis(*spectrum, moved, np.random.default_rng(self._seed))
            found.append(trimmed(np.asarray(sound, np.float64), self.rate))
        return np.concatenate(found) * (_HIBARI_GAIN * style.volume / 100)


def pitch_moved(pitch: Any, semitones: float, spread: float) -> Any:
    """Return a pitch curve (Hz; below 40: no voice) higher by `semitones`, its range `spread`-fold.

    The range is about the curve's median, in semitones.

    >>> pitch_moved(np.array([0.0, 100.0, 200.0, 400.0]), 12, 0.5).round().tolist()
    [0.0, 283.0, 400.0, 566.0]
    """
    voiced = pitch > _LOWEST_VOICED
    if not voiced.any():
        return pitch
    middle = float(np.median(pitch[voiced]))
    moved = middle * 2 ** (semitones / 12) * (np.where(voiced, pitch, middle) / middle) ** spread
    return np.where(voiced, np.clip(moved, 60, 600), pitch).astype(pitch.dtype)


class Espeak:
    """The system's `espeak-ng`, run as a program of its own, with SSML (`-m`)."""

    name = "espeak"
    rate = 22_050

    def __init__(self, program: str | None = None, variant: str = "en-us") -> None:
        found = shutil.which(program or "espeak-ng")
        if found is None:
            raise PersonageError("the voice espeak needs espeak-ng; apt-get install espeak-ng")
        self._program = found
        self._variant = variant

    def say(self, sentences: Sequence[SpokenSentence]) -> Samples:
        """Return the sound of sentences."""
        if not sentences:
            return silence(0, self.rate)
        with TemporaryDirectory(prefix="personage-lite-") as folder:
            path = f"{folder}/said.wav"
            # The text is given on standard input: it is too long for arguments, and never one.
            command = [self._program, "-v", self._variant, "-m", "-b", "1", "-w", path, "--stdin"]
            try:
                done = subprocess.run(
                    command,
                    input=document(sentences, _ESPEAK_PITCH).encode("utf-8"),
                    capture_output=True,
                    timeout=_PATIENCE,
                    check=False,
                )
            except (OSError, subprocess.TimeoutExpired) as error:
                reason = getattr(error, "strerror", None) or "it takes too long"
                raise PersonageError(f"espeak-ng cannot speak ({reason})") from None
            if done.returncode:
                said = done.stderr.decode("utf-8", "replace").strip().splitlines()[-1:]
                raise PersonageError(
                    f"espeak-ng cannot speak ({' '.join(said) or done.returncode})"
                )
            samples, rate = read_wav(path)
        if rate != self.rate:
            raise PersonageError(f"espeak-ng speaks at {rate} Hz; its voice {self._variant} is odd")
        return limited(trimmed(samples, rate))


VOICES: Mapping[str, Callable[[], Voice]] = {"hibari": Hibari, "espeak": Espeak}


def voice_named(name: str | None) -> Voice:
    """Return a voice; None or "auto": `hibari` if it is installed, else `espeak`.

    Raises `PersonageError` for an unknown name, or if it is not installed.
    """
    if name in (None, "auto"):
        try:
            return Hibari()
        except PersonageError:
            if shutil.which("espeak-ng"):
                return Espeak()
            raise
    if name not in VOICES:
        raise PersonageError(f"no voice '{name}'; {nearest(str(name), VOICES)}")
    return VOICES[name]()
