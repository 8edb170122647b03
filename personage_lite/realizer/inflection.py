"""The exceptions to the rules of English inflection, read from `lexicons/inflection.yaml`.

The file serves two dialects: `burnt/burned` is British before the slash and American after it.
"""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from collections.abc import Iterator
from typing import Literal, NamedTuple, TypeAlias

from personage_lite.errors import DataError, shown
from personage_lite.yaml_reader import Node

Dialect: TypeAlias = Literal["british", "american"]
Countability: TypeAlias = Literal["countable", "uncountable", "plural_only", "pair"]


class Inflection(NamedTuple):
    """The exceptions of one dialect; never changed after reading."""

    # lemma: past, participle
    verbs: dict[str, tuple[str, str]]
    # what a verb may begin with and still be inflected as its rest: overtake, rewrite
    verb_prefixes: tuple[str, ...]
    third_person: dict[str, str]
    gerunds: dict[str, str]
    # verbs of more than one syllable that double their last consonant
    doubling: frozenset[str]
    # verbs that look as if they did
    not_doubling: frozenset[str]
    # whether an l after one vowel doubles whatever the stress: travelled
    doubles_l: bool
    # nouns and verbs in -o that take -es
    o_es: frozenset[str]
    plurals: dict[str, str]
    # last parts of compounds with their plurals: snowman, snowmen
    compounds: dict[str, str]
    compound_ends: tuple[str, ...]
    # adjectives that follow certain nouns: attorney general
    postpositives: dict[str, frozenset[str]]
    # what ends the head of a noun phrase, and is no particle after an object
    prepositions: frozenset[str]
    # what else ends the head of a noun phrase
    noun_phrase_ends: frozenset[str]
    # whether a noun has two numbers, where that is not plain
    countability: dict[str, Countability]
    uncountable_ends: tuple[str, ...]
    # comparative, superlative
    degrees: dict[str, tuple[str, str]]
    # adjectives of two syllables that take -er, of one syllable that take "more"
    with_er: frozenset[str]
    with_more: frozenset[str]
    # what stands before an adjective that takes neither
    more: str
    most: str
    # the other dialect's spelling: this one's
    spellings: dict[str, str]


class _Tables:
    """The tables of the file, each a block of text with one entry a line."""

    def __init__(self, node: Node, dialect: Dialect) -> None:
        self._node = node
        self._side = 0 if dialect == "british" else -1

    def rows(self, key: str, least: int, most: int) -> Iterator[list[str]]:
        """Yield the words of each line, which must be `least` to `most`, in the dialect."""
        block = self._node.need(key)
        text = block.text()
        if "\n" not in text:
            raise block.fault(
                f"'{key}' is not a block of lines", f"write '{key}: |' and each entry in a line"
            )
        seen: set[str] = set()
        for index, line in enumerate(text.splitlines()):
            words = line.split()
            if not words:
                continue
            if not least <= len(words) <= most:
                count = str(least) if least == most else f"{least} to {most}"
                raise self._fault(
                    block,
                    index,
                    f"'{shown(line.strip())}' has {len(words)} words",
                    f"write {count} words",
                )
            if "/" in line:
                sides = [word.split("/") for word in words]
                if not all(all(side) and len(side) <= 2 for side in sides):
                    raise self._fault(
                        block,
                        index,
                        f"'{shown(line.strip())}' has more or less than a word beside each slash",
                        "write British/American",
                    )
                words = [word[self._side] for word in sides]
            if words[0] in seen:
                raise self._fault(
                    block, index, f"'{words[0]}' stands in '{key}' twice", "remove one of the two"
                )
            seen.add(words[0])
            yield words

    @staticmethod
    def _fault(block: Node, index: int, what: str, remedy: str) -> DataError:
        """Return the error of the block's line `index`; the block begins after its key."""
        return DataError(block.file, block.line + 1 + index, what, remedy)

    def pairs(self, key: str) -> dict[str, str]:
        """Return lines such as `mouse mice`."""
        return {lemma: form for lemma, form in self.rows(key, 2, 2)}  # noqa: C416 - typed

    def triples(self, key: str) -> dict[str, tuple[str, str]]:
        """Return lines such as `take took taken`, or `buy bought` for two equal forms."""
        return {row[0]: (row[1], row[-1]) for row in self.rows(key, 2, 3)}

    def words(self, key: str) -> list[str]:
        """Return words that may stand in any number a line."""
        return self._node.need(key).text().split()


def read_inflection(node: Node, dialect: Dialect = "british") -> Inflection:
    """Read the file for one dialect; every fault names its line.

    Raises `DataError` for a missing table, an unknown one and a line of the wrong shape.
    """
    tables = _Tables(node, dialect)
    invariable = tables.words("invariable_plurals")
    uncountable = tables.words("uncountable")
    plural_only = tables.words("plural_only")
    pairs = tables.words("pairs")
    compounds = tables.pairs("compound_plurals")
    # What stays, and what looks like a compound and is none.
    plurals = {
        word: word for words in (invariable, uncountable, plural_only, pairs) for word in words
    }
    plurals |= {word: f"{word}s" for word in tables.words("regular_plurals")}
    plurals |= compounds
    plurals |= tables.pairs("irregular_plurals")
    periphrastic = node.need("periphrastic_degrees")
    if "positive" not in tables.triples("periphrastic_degrees"):
        raise periphrastic.fault("no line for 'positive'", "write '  positive more most'")
    more, most = tables.triples("periphrastic_degrees")["positive"]
    inflection = Inflection(
        verbs=tables.triples("irregular_verbs"),
        verb_prefixes=tuple(tables.words("verb_prefixes")),
        third_person=tables.pairs("third_person"),
        gerunds=tables.pairs("gerunds"),
        doubling=frozenset(tables.words("doubling")),
        not_doubling=frozenset(tables.words("not_doubling")),
        doubles_l=dialect == "british",
        o_es=frozenset(tables.words("o_es")),
        plurals=plurals,
        compounds=compounds,
        compound_ends=tuple(compounds),
        postpositives={
            last: frozenset(heads) for last, *heads in tables.rows("postpositives", 2, 99)
        },
        prepositions=frozenset(tables.words("prepositions")),
        noun_phrase_ends=frozenset(tables.words("noun_phrase_ends")),
        countability={
            **dict.fromkeys(tables.words("countable"), "countable"),
            **dict.fromkeys(uncountable, "uncountable"),
            **dict.fromkeys(plural_only, "plural_only"),
            **dict.fromkeys(pairs, "pair"),
        },
        uncountable_ends=tuple(tables.words("uncountable_ends")),
        degrees=tables.triples("degrees"),
        with_er=frozenset(tables.words("with_er")),
        with_more=frozenset(tables.words("with_more")),
        more=more,
        most=most,
        spellings=_spellings(tables, dialect),
    )
    node.done()
    return inflection


def _spellings(tables: _Tables, dialect: Dialect) -> dict[str, str]:
    """Return the other dialect's spellings with this one's.

    A one-way pair has an American word that is British too, in another sense: tyre, tire.
    """
    both = tables.pairs("spellings")
    both |= {f"{stem}ise": f"{stem}ize" for stem in tables.words("ise_ize")}
    one_way = tables.pairs("spellings_to_american")
    if dialect == "american":
        return both | one_way
    return {american: british for british, american in both.items()}
