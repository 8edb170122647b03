"""Sound as numbers: resampling, level, trimming, and a WAV file that grows.

Samples are floats from -1 to 1, one channel.
"""

from __future__ import annotations

import struct
from contextlib import suppress
from os import PathLike, fsync
from typing import BinaryIO

import numpy as np

from adaptation.wav import Samples
from personage_lite.errors import PersonageError

_HEADER = 44
# A WAV file counts its bytes with 32 bits.
_LARGEST = 2**32 - 1 - _HEADER
# Above this level a limiter bends the wave, so that it never reaches 1.
_KNEE = 0.8


def decibels(samples: Samples) -> float:
    """Return the level (root of the mean square) in dBFS: 0 is the loudest square wave.

    >>> round(decibels(np.full(100, 0.1)), 1), decibels(np.zeros(10))
    (-20.0, -120.0)
    """
    power = float(np.mean(np.square(samples))) if len(samples) else 0.0
    return 10 * float(np.log10(max(power, 1e-12)))


def limited(samples: Samples) -> Samples:
    """Return the sound with peaks bent below 1, what is quieter than 0.8 unchanged.

    >>> limited(np.array([0.5, -0.8, 3.0])).round(3).tolist()
    [0.5, -0.8, 1.0]
    """
    over = np.abs(samples) - _KNEE
    bent = np.sign(samples) * (_KNEE + (1 - _KNEE) * np.tanh(np.maximum(over, 0) / (1 - _KNEE)))
    found: Samples = np.where(over > 0, bent, samples)
    return found


def trimmed(samples: Samples, rate: int, floor: float = 0.01, keep: float = 0.02) -> Samples:
    """Return the sound without the silence at both ends: but for `keep` seconds of it."""
    loud = np.flatnonzero(np.abs(samples) > floor)
    if not len(loud):
        return samples[:0]
    margin = round(keep * rate)
    return samples[max(0, loud[0] - margin) : loud[-1] + margin + 1]


def silence(seconds: float, rate: int) -> Samples:
    """Return so many seconds of nothing."""
    return np.zeros(round(seconds * rate))


def resampled(samples: Samples, rate: int, wanted: int) -> Samples:
    """Return the sound at another rate, by way of its spectrum: nothing is folded back.

    >>> tone = np.sin(np.arange(4800) * 2 * np.pi * 440 / 48000)
    >>> len(resampled(tone, 48000, 16000))
    1600
    """
    if rate == wanted or not len(samples):
        return samples
    count = max(1, round(len(samples) * wanted / rate))
    # A power of two would be faster; the ends are padded, since a spectrum goes round in circles.
    pad = round(rate * 0.05)
    padded = np.concatenate((np.zeros(pad), samples, np.zeros(pad)))
    whole = max(1, round(len(padded) * wanted / rate))
    spectrum = np.fft.rfft(padded)
    kept = whole // 2 + 1
    if kept <= len(spectrum):
        spectrum = spectrum[:kept]
    found = np.fft.irfft(spectrum, whole) * (whole / len(padded))
    start = round(pad * wanted / rate)
    part: Samples = found[start : start + count]
    return part


def pcm(samples: Samples) -> bytes:
    """Return samples as 16-bit PCM, what is beyond ±1 cut."""
    content: bytes = np.rint(np.clip(samples, -1, 1) * 32767).astype("<i2").tobytes()
    return content


class GrowingWav:
    """A WAV file of 16 bits that is whole after every `add`, also when the program is killed.

    The samples are written first, the header's two sizes after them, in one write: whoever reads
    the file in between finds the sound as it was before.
    """

    def __init__(self, path: str | PathLike[str], rate: int) -> None:
        self.path = path
        self.rate = rate
        self._size = 0
        try:
            self._file: BinaryIO | None = open(path, "wb", buffering=0)  # noqa: SIM115
            self._file.write(_header(0, rate))
        except OSError as error:
            raise PersonageError(
                f"{path}: cannot be written ({error.strerror}); choose another path for --wav"
            ) from None

    def add(self, samples: Samples) -> None:
        """Append sound; raises `OSError` if the disk is full, and the file stays as it was."""
        content = pcm(samples)
        if self._file is None or self._size + len(content) > _LARGEST:
            raise OSError("the WAV file is full or closed")
        self._file.seek(_HEADER + self._size)
        written = 0
        while written < len(content):
            written += self._file.write(content[written:]) or 0
        fsync(self._file.fileno())
        self._size += len(content)
        self._file.seek(0)
        self._file.write(_header(self._size, self.rate))

    def fileno(self) -> int:
        """Return the open file's number; raises `OSError` after `close`."""
        if self._file is None:
            raise OSError("the WAV file is closed")
        return self._file.fileno()

    def close(self) -> None:
        """Close the file, without what a failed `add` may have left behind its end."""
        if self._file is not None:
            with suppress(OSError):  # What is left behind the end is not read anyway.
                self._file.truncate(_HEADER + self._size)
            self._file.close()
            self._file = None


def _header(size: int, rate: int) -> bytes:
    form = struct.pack("<4sIHHIIHH", b"fmt ", 16, 1, 1, rate, rate * 2, 2, 16)
    return (
        b"RIFF" + struct.pack("<I", 36 + size) + b"WAVE" + form + b"data" + struct.pack("<I", size)
    )
