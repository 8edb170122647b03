"""How loud, fast and high a voice is: measured from the sound, whatever made it."""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np

from adaptation.voice.sound import decibels
from adaptation.wav import Samples

_FRAME, _HOP = 0.04, 0.01
# What is this much quieter than the loudest frames is silence.
_SILENT_DB = 35.0
# Shorter silences belong to speech: the closures of "p", "t", "k".
_SHORTEST_PAUSE = 0.15
_LOWEST, _HIGHEST = 60.0, 500.0
# YIN's threshold: how much of the wave may differ from the one a period later (de Cheveigné &
# Kawahara 2002, step 4).
_YIN = 0.15
_SYLLABLE = re.compile(r"[aeiouy]+")
_WORD = re.compile(r"[a-z]+(?:['’][a-z]+)?")


class Measured(NamedTuple):
    """What was measured of speech.

    `seconds` in all; `loudness` of the voiced and unvoiced sound without pauses, dBFS; `pitch`,
    the median, Hz; `pitch_range`, from the 10th to the 90th percentile, semitones; `pauses`,
    seconds of silence between words, in all; `syllables` a second, pauses included, and
    `articulation`, without them (0 if the text is unknown).
    """

    seconds: float
    loudness: float
    pitch: float
    pitch_range: float
    pauses: float
    syllables: float
    articulation: float


def measured(samples: Samples, rate: int, text: str = "") -> Measured:
    """Return what is measured of speech; `text` is what was said.

    >>> tone = np.sin(np.arange(16000) * 2 * np.pi * 200 / 16000) * 0.5
    >>> found = measured(tone, 16000, "la la la")
    >>> round(found.pitch), round(found.loudness), found.syllables
    (200, -9, 3.0)
    """
    frames = _frames(samples, rate)
    levels = np.array([decibels(frame) for frame in frames]) if len(frames) else np.array([-120.0])
    heard = levels > max(float(np.percentile(levels, 95)) - _SILENT_DB, -70.0)
    if not heard.any():
        return Measured(len(samples) / rate, -120.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    first, last = np.flatnonzero(heard)[[0, -1]]
    seconds = min(len(samples) / rate, float(last - first) * _HOP + _FRAME)
    pauses = _pauses(heard[first : last + 1])
    pitches = np.array([_pitch(frame, rate) for frame in frames[heard]])
    voiced = pitches[pitches > 0]
    low, middle, high = np.percentile(voiced, [10, 50, 90]) if len(voiced) else (1.0, 0.0, 1.0)
    count = syllables(text)
    return Measured(
        seconds=len(samples) / rate,
        loudness=decibels(frames[heard].reshape(-1)),
        pitch=float(middle),
        pitch_range=12 * float(np.log2(high / low)),
        pauses=pauses,
        syllables=count / seconds,
        articulation=count / max(seconds - pauses, _FRAME),
    )


def syllables(text: str) -> int:
    """Return about how many syllables a text has: groups of vowels, without a silent e.

    >>> syllables("Alice meets a white rabbit.")
    7
    """
    total = 0
    for word in _WORD.findall(text.lower()):
        groups = len(_SYLLABLE.findall(word))
        silent = word.endswith("e") and not word.endswith(("le", "ee", "ie")) and groups > 1
        total += max(1, groups - silent)
    return total


def _frames(samples: Samples, rate: int) -> Samples:
    size, hop = round(_FRAME * rate), round(_HOP * rate)
    if len(samples) < size:
        return np.zeros((0, size))
    found: Samples = np.lib.stride_tricks.sliding_window_view(samples, size)[::hop]
    return found


def _pauses(heard: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> float:
    """Return the seconds of silence in stretches that are long enough to be pauses."""
    edges = np.flatnonzero(np.diff(np.concatenate(([1], heard.astype(int), [1]))))
    lengths = [(end - start) * _HOP for start, end in zip(edges[::2], edges[1::2], strict=True)]
    return float(sum(length for length in lengths if length >= _SHORTEST_PAUSE))


def _pitch(frame: Samples, rate: int) -> float:
    """Return a frame's pitch in Hz by YIN, 0 if it has none."""
    longest, shortest = round(rate / _LOWEST), round(rate / _HIGHEST)
    longest = min(longest, len(frame) * 2 // 3)
    window = len(frame) - longest
    head = frame[:window]
    spectrum = np.fft.rfft(frame, 2 * len(frame))
    product = np.fft.irfft(spectrum * np.conj(np.fft.rfft(head, 2 * len(frame))))[: longest + 1]
    squares = np.concatenate(([0.0], np.cumsum(frame**2)))
    energies = squares[window : window + longest + 1] - squares[: longest + 1]
    difference = np.maximum(energies[0] + energies - 2 * product, 0)
    running = np.cumsum(difference[1:])
    normal = np.ones(longest + 1)
    normal[1:] = difference[1:] * np.arange(1, longest + 1) / np.maximum(running, 1e-12)
    below = np.flatnonzero(normal[shortest:] < _YIN)
    if not len(below):
        return 0.0
    lag = int(below[0]) + shortest
    while lag < longest and normal[lag + 1] < normal[lag]:
        lag += 1
    return rate / lag
