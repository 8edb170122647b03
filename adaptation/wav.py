"""WAV files as numbers, for whoever listens: answers (adaptation/voice), and the sensor of voices.

Samples are floats from -1 to 1, one channel.
"""

from __future__ import annotations

import struct
import wave
from os import PathLike
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from personage_lite.errors import PersonageError

Samples: TypeAlias = NDArray[np.float64]


def read_wav(path: str | PathLike[str]) -> tuple[Samples, int]:
    """Return the samples of a WAV file (PCM of 8 to 32 bits, channels mixed) and their rate.

    Raises `PersonageError` for what is no such file.
    """
    try:
        with wave.open(str(path), "rb") as file:
            channels, width, rate = file.getnchannels(), file.getsampwidth(), file.getframerate()
            content = file.readframes(file.getnframes())
    except OSError as error:
        raise PersonageError(f"{path}: cannot be read ({error.strerror}); check the path") from None
    except (wave.Error, EOFError, struct.error) as error:
        reason = str(error) or "it ends too soon"
        raise PersonageError(f"{path}: no WAV file ({reason}); give one of PCM samples") from None
    if not 1000 <= rate <= 384_000 or not 1 <= channels <= 64 or not 1 <= width <= 4:
        raise PersonageError(f"{path}: no sound ({rate} Hz, {channels} channels); record it anew")
    content = content[: len(content) // (width * channels) * width * channels]
    return _decoded(content, width).reshape(-1, channels).mean(axis=1), rate


def _decoded(content: bytes, width: int) -> Samples:
    """Return PCM samples of 1 to 4 bytes as numbers from -1 to 1."""
    raw = np.frombuffer(content, dtype=np.uint8).reshape(-1, width)
    if width == 1:
        return (raw[:, 0].astype(np.float64) - 128) / 128
    # The highest bytes of 32 bits, little end first.
    padded = np.zeros((len(raw), 4), dtype=np.uint8)
    padded[:, 4 - width :] = raw
    samples: Samples = padded.view("<i4")[:, 0].astype(np.float64) / 2**31
    return samples
