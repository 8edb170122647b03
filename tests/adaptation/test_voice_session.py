"""A spoken session without hardware: WAV answers in, the story as WAV out, by the command."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

from adaptation.voice.measures import measured
from adaptation.voice.sound import GrowingWav
from adaptation.voice.spoken import spoken
from adaptation.voice.voices import Hibari
from adaptation.wav import read_wav

ROOT = Path(__file__).parents[2]


def test_spoken_answers_are_heard_and_the_story_is_spoken(tmp_path: Path) -> None:
    voice = Hibari()
    quiet = np.zeros(voice.rate // 3)
    answers = tmp_path / "answers"
    answers.mkdir()
    for number, text in enumerate(("The Queen of Hearts.", "Yes.")):
        file = GrowingWav(answers / f"{number}.wav", voice.rate)
        file.add(np.concatenate((quiet, voice.say(spoken(text, 0)), quiet)))
        file.close()
    options = ["--wav", "story.wav", "--voice", "espeak", "--ear", "answers", "--log", "s.jsonl"]
    options += ["--sensor", "none", "--plain", "--speed", "0", "--turns", "1", "--seed", "4"]
    done = subprocess.run(
        [sys.executable, "-m", "personage_lite", "live", *options],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT), "HOME": str(tmp_path)},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    lines = [json.loads(line) for line in (tmp_path / "s.jsonl").read_text("utf-8").splitlines()]
    heard = [line for line in lines if line["line"] == "heard"]
    assert (heard[0]["text"], heard[0]["source"]) == ("queen of hearts", "spoken")
    turns = [line for line in lines if line["line"] == "turn"]
    assert turns[0]["character"] == "queen_of_hearts"
    told = " ".join(line["text"] for line in lines if "text" in line and line["line"] != "heard")
    found = measured(*read_wav(tmp_path / "story.wav"), told)
    assert found.seconds > 5
    assert 2.5 < found.syllables < 5.5
    assert -30 < found.loudness < -15
