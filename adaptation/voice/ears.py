"""Ears for spoken answers: WAV files in order, a microphone, and either of two ears."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from adaptation.sensing.sound import Device
from adaptation.storyteller.protocols import Clock, Ear, EndOfInput, Heard
from adaptation.voice.recogniser import LONGEST, RATE
from adaptation.wav import Samples, read_wav
from personage_lite.errors import PersonageError

# How long one ear is listened to before it is the other's turn.
_SLICE = 0.05


class Recognises(Protocol):
    """What an ear needs of a recogniser."""

    def expect(self, phrases: Sequence[str]) -> None:
        """Take note of what can be said now."""
        ...

    def hear(self, samples: Samples, rate: int) -> Heard | None:
        """Return the expected phrase in a sound, or None."""
        ...


class WavEar:
    """Hears WAV files one after the other: each is an answer, and takes as long as its sound.

    A file begins when somebody listens for longer than no time at all: nothing is heard while the
    storyteller only looks whether there is an answer. What is not understood is None, with a line
    through `say`; after the last file `listen` raises `EndOfInput`.
    """

    def __init__(
        self,
        paths: Sequence[str],
        recogniser: Recognises,
        clock: Clock,
        say: Callable[[str], None],
    ) -> None:
        self._paths = wav_files(paths)
        for path in self._paths:
            read_wav(path)  # So that faults show at once.
        self._recogniser = recogniser
        self._clock = clock
        self._say = say
        self._sound: tuple[Samples, int] | None = None
        self._began = 0.0

    def expect(self, phrases: Sequence[str]) -> None:
        """Take note of what can be said now."""
        self._recogniser.expect(phrases)

    def listen(self, seconds: float | None) -> Heard | None:
        """Return the answer of the next file, or None if it is not over in time or not clear."""
        if not self._paths:
            raise EndOfInput
        if self._sound is None:
            if seconds is not None and seconds <= 0:
                return None
            self._sound = read_wav(self._paths[0])
            self._began = self._clock.now()
        samples, rate = self._sound
        left = self._began + len(samples) / rate - self._clock.now()
        if seconds is not None and left > seconds:
            self._clock.sleep(seconds)
            return None
        self._clock.sleep(max(0.0, left))
        path, self._paths, self._sound = self._paths[0], self._paths[1:], None
        heard = self._recogniser.hear(samples, rate)
        if heard is None:
            self._say(f"{path}: not understood")
        return heard

    def close(self) -> None:
        """Hear no more."""
        self._paths = []


def wav_files(paths: Sequence[str]) -> list[str]:
    """Return the WAV files among paths: files, and folders of them in order of their names.

    Raises `PersonageError` for what is neither, or for a folder without any.
    """
    found: list[str] = []
    for text in paths:
        path = Path(text)
        if path.is_dir():
            inside = sorted(item for item in path.iterdir() if item.suffix.lower() == ".wav")
            if not inside:
                raise PersonageError(f"{text}: no WAV file in it; name a folder with answers")
            found += [str(item) for item in inside]
        elif path.is_file():
            found.append(text)
        else:
            raise PersonageError(f"{text}: no such file or folder; check the path")
    return found


class MicrophoneEar:
    """Hears a microphone: what is said between two silences is an answer.

    `deaf` says when not to listen: while the storyteller itself is heard. `device` is for another
    source of sound in tests.
    """

    def __init__(
        self,
        index: int | None,
        recogniser: Recognises,
        clock: Clock,
        say: Callable[[str], None],
        deaf: Callable[[], bool] = lambda: False,
        device: Any = None,
    ) -> None:
        self._recogniser = recogniser
        self._clock = clock
        self._say = say
        self._deaf = deaf
        self._device: Any = device or Device(index)
        try:
            self._device.open()
        except PersonageError as error:
            reason = str(error).split("; ", 1)[0]
            raise PersonageError(f"{reason}; plug one in, or type the answers") from None
        self._answers = spoken_answers()
        next(self._answers)

    def expect(self, phrases: Sequence[str]) -> None:
        """Take note of what can be said now."""
        self._recogniser.expect(phrases)

    def listen(self, seconds: float | None) -> Heard | None:
        """Return the next answer within so many seconds, or None."""
        until = None if seconds is None else self._clock.now() + seconds
        while True:
            heard = self._heard()
            if heard is not None:
                return heard
            now = self._clock.now()
            if until is not None and now >= until:
                return None
            self._clock.sleep(_SLICE if until is None else min(_SLICE, until - now))

    def _heard(self) -> Heard | None:
        if self._device is None:
            raise EndOfInput
        try:
            chunks = list(self._device.chunks(self._clock.now()))
        except OSError:
            self._say("the microphone gives no more sound; type the answers")
            self.close()
            raise EndOfInput from None
        if self._deaf():
            chunks = []
        for chunk in chunks:
            answer = self._answers.send(chunk)
            if answer is not None:
                heard = self._recogniser.hear(answer, RATE)
                if heard is not None:
                    return heard
        return None

    def close(self) -> None:
        """Give the microphone back; may be called twice."""
        if self._device is not None:
            self._device.close()
            self._device = None


def spoken_answers() -> Any:
    """Make a generator that takes chunks of sound (16 kHz, 16 bits) and gives answers, or None.

    Start and end of speech are found by pocketsphinx's detector of voices.
    """
    from pocketsphinx import Endpointer

    # The strictest of its modes: the others take the noise after a word for more of it.
    ends: Any = Endpointer(sample_rate=RATE, vad_mode=3)
    size = int(ends.frame_bytes)
    waiting, speech = b"", b""
    answer: Samples | None = None
    while True:
        waiting += yield answer
        answer = None
        while len(waiting) >= size:
            frame, waiting = waiting[:size], waiting[size:]
            part = ends.process(frame)
            if part is not None:
                speech += part
            over = part is not None and not ends.in_speech
            if over or len(speech) > LONGEST * RATE * 2:
                answer = np.frombuffer(speech, "<i2").astype(np.float64) / 32768
                speech = b""


class EitherEar:
    """Two ears at once: the first is asked first, and the session ends when both are at their end.

    Both take the time by the session's clock, in turns.
    """

    def __init__(self, first: Ear, second: Ear, clock: Clock) -> None:
        self._ears: list[Ear] = [first, second]
        self._all = (first, second)
        self._clock = clock

    def expect(self, phrases: Sequence[str]) -> None:
        """Take note of what can be said now, in both."""
        for ear in self._all:
            ear.expect(phrases)

    def listen(self, seconds: float | None) -> Heard | None:
        """Return the next answer of either ear within so many seconds, or None."""
        until = None if seconds is None else self._clock.now() + seconds
        while True:
            if not self._ears:
                raise EndOfInput
            if len(self._ears) == 1:
                heard = self._ask(self._ears[0], None if until is None else self._left(until))
                if heard is not None or self._ears:
                    return heard
                continue
            for ear in list(self._ears):
                wait = _SLICE if until is None else min(_SLICE, self._left(until))
                heard = self._ask(ear, wait)
                if heard is not None:
                    return heard
            if until is not None and self._clock.now() >= until:
                return None

    def _ask(self, ear: Ear, seconds: float | None) -> Heard | None:
        try:
            return ear.listen(seconds)
        except EndOfInput:
            self._ears.remove(ear)
            return None

    def _left(self, until: float) -> float:
        return max(0.0, until - self._clock.now())

    def close(self) -> None:
        """Give both back, even if one refuses."""
        try:
            self._all[0].close()
        finally:
            self._all[1].close()
