"""Recognises one of the expected phrases in a sound, and rejects everything else.

pocketsphinx with a grammar finds the expected phrase that is most like a sound, however unlike; it
gives no confidence with a grammar. So a second pass looks how well any sequence of phones would
explain the same sound: the difference of the two log-likelihoods, over the root of the number of
frames, is the score, and below a threshold nothing was heard (a phone loop as filler model, as is
usual in keyword spotting). The numbers stand in `ear.yaml`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from os.path import dirname, join
from typing import Any, NamedTuple

import numpy as np

from adaptation.sensing.setup import needs
from adaptation.storyteller.protocols import Heard
from adaptation.voice.sound import decibels, pcm, resampled, trimmed
from adaptation.wav import Samples
from personage_lite.yaml_reader import Node, read_yaml

# What pocketsphinx's model takes.
RATE = 16_000
# The longest answer, in seconds: of what is longer, the beginning counts.
LONGEST = 8.0
# An answer has at least so many seconds of sound.
_SHORTEST = 0.12
# pocketsphinx gives scores as probabilities of a logarithm divided by 1024.
_SCALE = 1024.0
_WORD = re.compile(r"[a-z]+(?:'[a-z]+)*")
# The phone loop's beams: so narrow that it takes no longer than the grammar.
_LOOP = {"lw": 2.0, "beam": 1e-20, "pbeam": 1e-20}
_LEVEL = -20.0


class Numbers(NamedTuple):
    """What `ear.yaml` holds; see there."""

    words: Mapping[str, str]
    before: tuple[str, ...]
    after: tuple[str, ...]
    unheard: frozenset[str]
    threshold: float
    spread: float
    quietest: float


def read_numbers(path: str | None = None) -> Numbers:
    """Return the numbers of a file, by default of the one that ships.

    Raises `DataError` with file, line and remedy for what is missing, unknown or out of range.
    """
    top = read_yaml(path or join(dirname(__file__), "ear.yaml"), None if path else "ear.yaml")
    found = Numbers(
        words={word: node.text() for word, node in top.need("words").items()},
        before=top.need("before").texts(),
        after=top.need("after").texts(),
        unheard=frozenset(phrase.lower() for phrase in top.need("unheard").texts()),
        threshold=_number(top.need("threshold"), -100, 100),
        spread=_number(top.need("spread"), 0.01, 100),
        quietest=_number(top.need("quietest"), -120, 0),
    )
    top.done()
    return found


def _number(node: Node, low: float, high: float) -> float:
    node.need("why").text()
    value = node.need("value").number(low, high)
    node.done()
    return value


class Score(NamedTuple):
    """What was found in a sound: an expected phrase ("" if none fits at all) and how well."""

    phrase: str
    score: float
    confidence: float


class Recogniser:
    """Finds expected phrases in sounds. Raises `PersonageError` if pocketsphinx is missing.

    `say` takes a line for the user about phrases that cannot be recognised.
    """

    def __init__(self, say: Callable[[str], None], numbers: Numbers | None = None) -> None:
        try:
            import pocketsphinx
        except ModuleNotFoundError as error:
            raise needs("hearing answers", error.name, "ear") from None
        self._numbers = numbers or read_numbers()
        self._say = say
        model = pocketsphinx.get_model_path()
        common: dict[str, Any] = {"lm": None, "samprate": RATE, "loglevel": "FATAL"}
        self._grammar: Any = pocketsphinx.Decoder(**common)
        phones = join(model, "en-us", "en-us-phone.lm.bin")
        self._loop: Any = pocketsphinx.Decoder(**common, allphone=phones, **_LOOP)
        for word, sound in self._numbers.words.items():
            if self._grammar.lookup_word(word) is None:
                self._grammar.add_word(word, sound, True)
        self._phrases: dict[str, str] = {}
        self._count = 0

    def expect(self, phrases: Sequence[str]) -> None:
        """Make the grammar from what can be said now; typing shortcuts ("y") are left out."""
        known: dict[str, str] = {}
        unknown = []
        for phrase in phrases:
            words = _words(phrase)
            if len("".join(words)) < 2 or phrase.lower() in self._numbers.unheard:
                continue
            if all(self._grammar.lookup_word(word) for word in words):
                known.setdefault(" ".join(words), phrase)
            else:
                unknown.append(phrase)
        if unknown:
            shown = ", ".join(unknown[:5]) + (" …" if len(unknown) > 5 else "")
            self._say(f"no pronunciation known, so type it: {shown}")
        if known == self._phrases:
            return
        self._phrases = known
        if known:
            # Each grammar has a name of its own: one in use cannot be replaced.
            self._count += 1
            name = f"answers{self._count}"
            self._grammar.add_jsgf_string(
                name, jsgf(name, tuple(known), self._numbers.before, self._numbers.after)
            )
            self._grammar.activate_search(name)

    def hear(self, samples: Samples, rate: int) -> Heard | None:
        """Return the expected phrase in a sound, or None: nothing was said, or something else."""
        found = self.score(samples, rate)
        if found.confidence < 0.5:
            return None
        return Heard(found.phrase, round(found.confidence, 3), "spoken")

    def score(self, samples: Samples, rate: int) -> Score:
        """Return the most likely phrase in a sound, with its score; confidence 0.5 is enough."""
        nothing = Score("", -math.inf, 0.0)
        sound = prepared(resampled(samples, rate, RATE), self._numbers.quietest)
        if not self._phrases or not len(sound):
            return nothing
        content = pcm(sound)
        words, by_grammar = _decoded(self._grammar, content)
        phrase = self._phrases.get(self._bare(words))
        if phrase is None:
            return nothing
        frames = sum(
            part.end_frame - part.start_frame + 1
            for part in self._grammar.seg()
            if not part.word.startswith("<")
        )
        _, by_loop = _decoded(self._loop, content)
        score = (by_grammar - by_loop) / math.sqrt(max(frames, 1))
        steps = (score - self._numbers.threshold) / self._numbers.spread
        return Score(phrase, score, 1 / (1 + math.exp(-max(-40.0, min(40.0, steps)))))

    def _bare(self, words: str) -> str:
        """Return a hypothesis without what may stand around a phrase."""
        if words in self._phrases:
            return words
        for before in ("", *sorted(self._numbers.before, key=len, reverse=True)):
            for after in ("", *self._numbers.after):
                bare = words.removeprefix(f"{before} ").removesuffix(f" {after}")
                if bare in self._phrases:
                    return bare
        return ""


def jsgf(name: str, phrases: Sequence[str], before: Sequence[str], after: Sequence[str]) -> str:
    """Return a grammar of the expected phrases, in the Java Speech Grammar Format.

    >>> print(jsgf("g", ["yes", "white rabbit"], ["the"], ["please"]))
    #JSGF V1.0;
    grammar g;
    public <answer> = [the] (yes | white rabbit) [please];
    <BLANKLINE>
    """
    around = [" | ".join(words) for words in (before, after)]
    answer = f"[{around[0]}] ({' | '.join(phrases)}) [{around[1]}]"
    return f"#JSGF V1.0;\ngrammar {name};\npublic <answer> = {answer};\n"


def prepared(samples: Samples, quietest: float) -> Samples:
    """Return the part of a sound (16 kHz) that may be an answer, at the usual level, or nothing."""
    peak = float(np.abs(samples).max()) if len(samples) else 0.0
    part = trimmed(samples, RATE, floor=peak / 20, keep=0.25)[: round(LONGEST * RATE)]
    level = decibels(part)
    if level < quietest or len(trimmed(part, RATE, peak / 20, 0.0)) < _SHORTEST * RATE:
        return samples[:0]
    louder = min(10 ** ((_LEVEL - level) / 20), 0.99 / peak)
    edge = np.zeros(RATE // 5)
    found: Samples = np.concatenate((edge, part * louder, edge))
    # A decoder cannot stand perfect silence: a faint, always equal noise.
    return found + np.random.default_rng(0).normal(0, 0.001, len(found))


def _words(phrase: str) -> list[str]:
    return _WORD.findall(phrase.lower().replace("’", "'"))


def _decoded(decoder: Any, content: bytes) -> tuple[str, float]:
    """Return the words of the best path and its log-likelihood in nats."""
    # The noise that was heard before is forgotten: the same sound always has the same score.
    decoder.reinit_feat()
    decoder.start_utt()
    decoder.process_raw(content, full_utt=True)
    decoder.end_utt()
    found = decoder.hyp()
    if found is None or not found.score:
        return "", -math.inf
    return str(found.hypstr), math.log(found.score) * _SCALE
