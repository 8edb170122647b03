"""Spoken sessions killed with SIGKILL at random moments: what is left of log and WAV file."""

from __future__ import annotations

import os
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from adaptation.storyteller.session_log import Session, read_sessions
from adaptation.wav import read_wav

ROOT = Path(__file__).parents[2]
KILLS = 10
ARGUMENTS = (
    *(
        "-m",
        "personage_lite",
        "live",
        "--wav",
        "story.wav",
        "--voice",
        "espeak",
        "--log",
        "s.jsonl",
    ),
    *("--listener", "match", "--plain", "--speed", "0", "--turns", "8", "--seed", "2"),
)


def started(folder: Path) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, *ARGUMENTS],
        cwd=folder, env={**os.environ, "PYTHONPATH": str(ROOT)},
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip


def spoken(session: Session) -> int:
    """Return how many utterances were begun: acts are logged before, facts after they are said."""
    return sum(line.kind in ("say", "turn") for line in session.lines)


@pytest.mark.skipif(shutil.which("espeak-ng") is None, reason="espeak-ng is not installed")
def test_log_and_sound_are_whole_to_where_they_came(tmp_path: Path) -> None:
    whole = started(tmp_path)
    log, wav = tmp_path / "s.jsonl", tmp_path / "story.wav"
    while not (log.exists() and log.stat().st_size):
        time.sleep(0.01)
    began = time.monotonic()
    assert whole.wait(120) == 0
    lasting = time.monotonic() - began
    everything, rate = read_wav(wav)
    (session,) = read_sessions(str(log))
    assert spoken(session) == 3 + 8
    chance, lengths = random.Random(1), []
    for _ in range(KILLS):
        log.unlink()
        wav.unlink()
        talk = started(tmp_path)
        while not (log.exists() and log.stat().st_size):
            time.sleep(0.005)
        time.sleep(chance.uniform(0, lasting))
        talk.kill()
        talk.wait()
        # What is there of the sound is what the whole session begins with, to the last sample.
        samples, found = read_wav(wav)
        assert found == rate
        assert np.array_equal(samples, everything[: len(samples)])
        lengths.append(len(samples))
        for left in read_sessions(str(log)):
            texts = [line.fields["text"] for line in left.lines if line.kind in ("say", "turn")]
            before = [line.fields["text"] for line in session.lines if line.kind in ("say", "turn")]
            assert texts == before[: len(texts)]
    assert len(set(lengths)) > 2
