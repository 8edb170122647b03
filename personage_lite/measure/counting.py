"""Counts the features of one utterance; what they come to is in `personage_lite.measure.report`."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from personage_lite.measure.extras import emotions, syllable_counter
from personage_lite.measure.features import Feature, Features
from personage_lite.measure.lists import Lists
from personage_lite.measure.words import Sentence, Word, take_apart

# Longer than six letters is long, as in LIWC (Pennebaker and King 1999).
_LONG = 7
# What is said again within so many words is a repetition ("so brave, so brave").
_AGAIN = 4


class Counted(NamedTuple):
    """An utterance counted: `totals` by feature and denominator, and its sentences."""

    totals: Mapping[str, int]
    sentences: tuple[Sentence, ...]


class FeatureCounter:
    """Counts utterances; the packages of the extra `measure` are imported here."""

    def __init__(self, features: Features) -> None:
        self._features = features
        self._emotions = emotions()
        self._count_syllables = syllable_counter()
        self._syllables: dict[str, int] = {}

    def count(self, text: str) -> Counted:
        """Return the totals of an utterance; none of its own depends on any other utterance."""
        passage = take_apart(text, self._features.lists)
        totals: Counter[str] = Counter(utterances=1, stutters=passage.stutters)
        for sentence in passage.sentences:
            self._count_sentence(sentence, totals)
        return Counted(totals, passage.sentences)

    def _count_sentence(self, sentence: Sentence, totals: Counter[str]) -> None:
        words = sentence.words
        lists = self._features.lists
        totals["sentences"] += 1
        totals["words"] += len(words)
        for word in words:
            letters = sum(map(str.isalpha, word.text))
            totals["word_length"] += letters
            totals["long_words"] += letters >= _LONG
            totals["syllables"] += self._syllables_of(word.text)
        tag = tag_length(sentence, self._features)
        own = words[: len(words) - tag] if tag else words
        totals["tag_questions"] += tag > 0
        totals["questions"] += sentence.end == "?" and not tag
        totals["exclamations"] += sentence.end == "!"
        totals["repetitions"] += _repetitions(own, lists.closed)
        totals["contractions"] += sum(
            _is_contraction(words, index, self._features) for index in range(len(words))
        )
        markers = self._find_marked(own, sentence.end, totals)
        self._count_content(own, sentence.end, markers, totals)

    def _find_marked(self, words: Sequence[Word], end: str, totals: Counter[str]) -> set[int]:
        """Count the listed features but those of content; return which words are markers."""
        markers: set[int] = set()
        texts = {word.text for word in words} | {word.stem for word in words}
        for feature in self._features.features:
            if feature.finder and not feature.content and feature.finder.may_find(texts):
                spans = feature.finder.find(words, end)
                totals[feature.name] += len(spans)
                if feature.marks:
                    markers.update(*(range(*span) for span in spans))
        return markers

    def _count_content(
        self, words: Sequence[Word], end: str, markers: set[int], totals: Counter[str]
    ) -> None:
        """Count what only words that are no markers count for: "like" in "is, like, pink" is not.

        Nor is a name ("the Mock Turtle") an emotion.
        """
        for feature in self._features.features:
            if feature.finder and feature.content:
                spans = feature.finder.find(words, end)
                totals[feature.name] += sum(markers.isdisjoint(range(*span)) for span in spans)
        for index, word in enumerate(words):
            if index not in markers and not word.quoted and not (word.capital and index):
                valence = self._emotions.get(word.text, 0.0)
                totals["positive_emotion"] += valence > 0
                totals["negative_emotion"] += valence < 0

    def _syllables_of(self, word: str) -> int:
        found = self._syllables.get(word)
        if found is None:
            found = self._syllables[word] = self._count_syllables(word)
        return found


def tag_length(sentence: Sentence, features: Features) -> int:
    """Return how many words the tag of a tag question has ("isn't she": 2), or 0.

    A name or "mate" after the tag belongs to it.
    """
    words, lists = sentence.words, features.lists
    if sentence.end != "?":
        return 0
    commas = [index for index, word in enumerate(words) if index and word.before.endswith(",")]
    for start, end in zip(commas[::-1], [len(words), *commas[::-1]], strict=False):
        texts = tuple(word.text for word in words[start:end])
        if texts in features.tags or _asks_back(texts, lists):
            return len(words) - start
        if end < len(words) or len(texts) > 2:  # Only one address can follow: ", my friend?"
            return 0
    return 0


def _asks_back(words: tuple[str, ...], lists: Lists) -> bool:
    """Whether words are those of a tag: "isn't she", "is she not", "can they"."""
    if len(words) < 2 or words[1] not in lists.tag_subjects:
        return False
    verb, more = words[0], words[2:]
    return verb.removesuffix("n't") in lists.auxiliaries and (
        not more or (len(more) == 1 and more[0] in lists.tag_ends)
    )


def _is_contraction(words: Sequence[Word], index: int, features: Features) -> bool:
    """Whether a word is a short form; 's is one after "she", a genitive before a noun."""
    word, lists = words[index], features.lists
    if word.quoted:
        return False
    if word.clitic != "'s":
        return word.text.endswith("n't") or word.clitic in lists.contracted
    if word.stem in lists.s_is_a_verb_after:
        return True
    following = words[index + 1].stem if index + 1 < len(words) and not word.after else ""
    return following in lists.closed


def _repetitions(words: Sequence[Word], closed: frozenset[str]) -> int:
    """Count the words of open classes that are said again after a comma ("so shy, really shy").

    Without one it is no emphasis: "half lion and half eagle", "the Mock Turtle is a turtle".
    """
    last: dict[str, int] = {}
    heard: dict[str, int] = {}  # how many commas there were before it
    commas = found = 0
    for index, word in enumerate(words):
        commas += word.before == ","
        if not word.quoted and word.stem not in closed:
            near = index - last.get(word.text, -_AGAIN - 1) <= _AGAIN
            found += near and commas > heard[word.text]
            last[word.text], heard[word.text] = index, commas
    return found


def value_of(feature: Feature, totals: Mapping[str, int]) -> float | None:
    """Return a feature's value from totals, of one utterance or of many; None if there is none."""
    words, sentences = totals["words"], totals["sentences"]
    if feature.per == "text":
        if not words:
            return None
        return _READABILITY[feature.quantity](words / sentences, totals["syllables"] / words)
    key = feature.quantity or feature.name
    divisor, scale = {
        "utterance": (totals["utterances"], 1),
        "sentence": (sentences, 1),
        "100 sentences": (sentences, 100),
        "word": (words, 1),
        "100 words": (words, 100),
    }[feature.per]
    return scale * totals[key] / divisor if divisor else None


def reading_ease(sentence_length: float, syllables: float) -> float:
    """Return the reading ease by words per sentence and syllables per word; 100 is very easy.

    R. Flesch, "A new readability yardstick", Journal of Applied Psychology 32(3), 1948.
    """
    return 206.835 - 1.015 * sentence_length - 84.6 * syllables


def grade(sentence_length: float, syllables: float) -> float:
    """Return the school grade by words per sentence and syllables per word.

    J. Kincaid and others, "Derivation of new readability formulas for Navy enlisted personnel",
    Research Branch Report 8-75, 1975.
    """
    return 0.39 * sentence_length + 11.8 * syllables - 15.59


_READABILITY = {"flesch_reading_ease": reading_ease, "flesch_kincaid_grade": grade}
