"""The realizer's data: closed words and exceptions, read from `lexicons/grammar.yaml`."""

from __future__ import annotations

from typing import NamedTuple

from personage_lite.yaml_reader import Node

CASES = ("subjective", "objective", "possessive", "reflexive")
PRONOUNS = (
    *("first singular", "first plural", "second singular", "second plural"),
    *("masculine", "feminine", "neuter", "third plural"),
)
RELATIVE_PRONOUNS = ("animate", "inanimate", "inanimate_restrictive")
BE = ("present_first", "present_third", "present_other", "past_singular", "past_other")


class Grammar(NamedTuple):
    """Closed word classes and exceptions to rules; never changed after loading."""

    pronouns: dict[str, dict[str, str]]
    relative_pronouns: dict[str, str]
    degree_word: str
    be: dict[str, str]
    modals: frozenset[str]
    contractions: dict[str, str]
    negative_contractions: dict[str, str]
    tag_negatives: dict[str, str]
    fused_negatives: dict[str, str]
    negators: frozenset[str]
    not_negative: tuple[str, ...]
    plural_in_tags: frozenset[str]
    prepositions: frozenset[str]
    irregular_verbs: dict[str, tuple[str, ...]]
    third_person: dict[str, str]
    doubling: frozenset[str]
    irregular_plurals: dict[str, str]
    invariable_plurals: frozenset[str]
    vowel_sound: tuple[str, ...]
    consonant_sound: tuple[str, ...]
    vowel_sound_again: tuple[str, ...]
    vowel_letters: str
    numerals: frozenset[str]


def _words(node: Node, needed: tuple[str, ...] = ()) -> dict[str, str]:
    for key in needed:
        node.need(key)
    return {key: value.text() for key, value in node.items()}


def read_grammar(node: Node) -> Grammar:
    """Read the grammar file; every fault names its line.

    Raises `DataError` for a missing table, an unknown one or a word that is not text.
    """
    pronouns = {}
    rows = node.need("pronouns")
    for name in PRONOUNS:
        row = rows.need(name)
        pronouns[name] = {case: row.need(case).text() for case in CASES}
        row.done()
    rows.done()
    verbs = {lemma: forms.texts() for lemma, forms in node.need("irregular_verbs").items()}
    grammar = Grammar(
        pronouns=pronouns,
        relative_pronouns=_words(node.need("relative_pronouns"), RELATIVE_PRONOUNS),
        degree_word=node.need("degree_word").text(),
        be=_words(node.need("be"), BE),
        modals=frozenset(node.need("modals").texts()),
        contractions=_words(node.need("contractions")),
        negative_contractions=_words(node.need("negative_contractions")),
        tag_negatives=_words(node.need("tag_negatives")),
        fused_negatives=_words(node.need("fused_negatives")),
        negators=frozenset(node.need("negators").texts()),
        not_negative=node.need("not_negative").texts(),
        plural_in_tags=frozenset(node.need("plural_in_tags").texts()),
        prepositions=frozenset(node.need("prepositions").texts()),
        irregular_verbs=verbs,
        third_person=_words(node.need("third_person")),
        doubling=frozenset(node.need("doubling").texts()),
        irregular_plurals=_words(node.need("irregular_plurals")),
        invariable_plurals=frozenset(node.need("invariable_plurals").texts()),
        vowel_sound=node.need("vowel_sound").texts(),
        consonant_sound=node.need("consonant_sound").texts(),
        vowel_sound_again=node.need("vowel_sound_again").texts(),
        vowel_letters=node.need("vowel_letters").text(),
        numerals=frozenset(node.need("numerals").texts()),
    )
    node.done()
    return grammar
