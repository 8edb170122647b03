"""The packages that only measuring needs, imported when they are: the extra `measure`."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

from personage_lite.errors import PersonageError


def imported(module: str) -> Any:
    """Import a module of the extra; raises `PersonageError` with the pip command if it cannot."""
    try:
        with warnings.catch_warnings():
            # textstat 0.7.4 imports pkg_resources, which warns that it is deprecated.
            warnings.simplefilter("ignore")
            return import_module(module)
    except ImportError as error:
        raise PersonageError(
            f"measuring needs {module.partition('.')[0]}, which cannot be imported ({error}); "
            "run: pip install 'personage-lite[measure]', or '.[measure]' in a checkout"
        ) from None


def emotions() -> Mapping[str, float]:
    """Return each word of VADER's lexicon with its valence, below 0 for a bad feeling.

    C. Hutto and E. Gilbert, "VADER: a parsimonious rule-based model for sentiment analysis of
    social media text", ICWSM 2014, section 3.1.
    """
    vader = imported("vaderSentiment.vaderSentiment")
    lexicon: Mapping[str, float] = vader.SentimentIntensityAnalyzer().lexicon
    return lexicon


def syllable_counter() -> Callable[[str], int]:
    """Return textstat's count of a word's syllables.

    Only that is textstat's: its own Flesch scores are made from words per sentence and syllables
    per word that are both rounded to one decimal (an error of up to 4 points), and its sentences
    leave out those of one or two words ("I see!").
    """
    count: Callable[[str], int] = imported("textstat").syllable_count
    return count
