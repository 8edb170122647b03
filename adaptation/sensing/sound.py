"""Where the microphone sensor's sound comes from: a device, or a WAV file.

Sound stays in memory, and only until it has been listened to.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from typing import Any, Protocol

import numpy as np

from adaptation.sensing.cues import EndOfCues
from adaptation.sensing.setup import needs
from adaptation.wav import Samples, read_wav
from personage_lite.errors import PersonageError

# What the detector of voices takes: 16 kHz, one channel, 16 bits, 512 samples at a time.
RATE, CHUNK = 16_000, 512
CHUNK_SECONDS = CHUNK / RATE
# Ten seconds of sound wait at most; older sound is dropped.
_LONGEST_QUEUE = round(10 / CHUNK_SECONDS)
_NEARLY = 1e-9


class SoundSource(Protocol):
    """Where sound comes from."""

    def open(self) -> None:
        """Begin; raises `PersonageError` if that is not possible."""

    def chunks(self, now: float) -> Iterator[bytes]:
        """Yield the sound up to `now`, in chunks of 512 samples; raises `EndOfCues` after all."""

    def close(self) -> None:
        """Let go of device or file."""


class WavFile:
    """A WAV file: PCM of 8 to 32 bits, any rate and number of channels."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._began: float | None = None
        self._sound = b""
        self._given = 0

    def open(self) -> None:
        """Read the file."""
        self._sound = sound_of(self._path)
        self._began, self._given = None, 0

    def chunks(self, now: float) -> Iterator[bytes]:
        """Yield what is due."""
        if self._began is None:
            self._began = now
        size = CHUNK * 2
        if (self._given + 1) * size > len(self._sound):
            raise EndOfCues
        while (self._given + 1) * CHUNK_SECONDS <= now - self._began + _NEARLY:
            start = self._given * size
            if start + size > len(self._sound):
                return
            self._given += 1
            yield self._sound[start : start + size]

    def close(self) -> None:
        """Forget the sound."""
        self._sound = b""


class Device:
    """A microphone of this machine, by its number in `python -m sounddevice`; None: the usual."""

    def __init__(self, index: int | None, sounddevice: Any = None) -> None:
        self._index = index
        self._module = sounddevice
        self._stream: Any = None
        self._queue: deque[bytes] = deque(maxlen=_LONGEST_QUEUE)

    def open(self) -> None:
        """Take hold of the microphone."""
        module = self._module or _sounddevice()
        which = "the microphone" if self._index is None else f"microphone {self._index}"
        self._queue.clear()
        try:
            self._stream = module.RawInputStream(
                samplerate=RATE,
                blocksize=CHUNK,
                device=self._index,
                channels=1,
                dtype="int16",
                callback=self._take,
            )
            self._stream.start()
        except (module.PortAudioError, ValueError) as error:
            self.close()
            raise PersonageError(
                f"{which} cannot be opened ({error}); plug one in, close the program that uses it, "
                "or give a WAV file with --input"
            ) from None

    def _take(self, sound: Any, _frames: int, _time: object, _status: object) -> None:
        self._queue.append(bytes(sound))

    def chunks(self, now: float) -> Iterator[bytes]:
        """Yield what has been heard; raises `OSError` when the device is gone."""
        if self._stream is None or not self._stream.active:
            raise OSError("the microphone gives no more sound")
        while self._queue:
            yield self._queue.popleft()

    def close(self) -> None:
        """Let go of the microphone."""
        if self._stream is not None:
            self._stream.close()
            self._stream = None


def source_of(text: str | None) -> SoundSource:
    """Return the source for a device's number (default: the usual device) or a WAV file."""
    if text is None:
        return Device(None)
    if text.isascii() and text.isdigit() and len(text) < 4:
        return Device(int(text))
    read_wav(text)  # So that faults show at once.
    return WavFile(text)


def sound_of(path: str) -> bytes:
    """Return the sound of a WAV file as the detector takes it, whole chunks of it.

    Raises `PersonageError` for what is no such file.
    """
    samples = _resampled(*read_wav(path))
    rest = -len(samples) % CHUNK
    whole = np.rint(np.concatenate((samples, np.zeros(rest))) * 32767)
    sound: bytes = whole.clip(-32768, 32767).astype("<i2").tobytes()
    return sound


def _resampled(samples: Samples, rate: int) -> Samples:
    """Return the sound at the detector's rate, in memory that grows with its length alone."""
    if rate == RATE or not len(samples):
        return samples
    if rate > RATE:
        # A running mean takes away most of what a lower rate cannot hold.
        count = round(rate / RATE)
        samples = np.convolve(samples, np.full(count, 1 / count), mode="same")
    at = np.arange(int(len(samples) * RATE / rate)) * (rate / RATE)
    found: Samples = np.interp(at, np.arange(len(samples)), samples)
    return found


def _sounddevice() -> Any:
    try:
        import sounddevice
    except ModuleNotFoundError as error:
        raise needs("the microphone", error.name, "microphone") from None
    except OSError:
        # The package is there, the library that it calls is not.
        raise PersonageError(
            "the microphone cannot load PortAudio; apt-get install libportaudio2"
        ) from None
    return sounddevice
