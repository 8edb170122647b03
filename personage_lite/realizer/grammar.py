"""The realizer's data: the closed words of English, read from `lexicons/`."""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from os import PathLike
from typing import NamedTuple, get_args

from personage_lite.errors import PersonageError, shown
from personage_lite.realizer.article import ArticleSounds, read_article_sounds
from personage_lite.realizer.inflection import Dialect, Inflection, read_inflection
from personage_lite.realizer.numerals import NumberWords, read_numerals
from personage_lite.yaml_reader import Node, read_yaml

CASES = ("subjective", "objective", "possessive", "reflexive", "independent")
# Person, number and gender of each row of the pronoun table; "" is any gender.
PRONOUNS = {
    "first singular": (1, "singular", ""),
    "first plural": (1, "plural", ""),
    "second singular": (2, "singular", ""),
    "second plural": (2, "plural", ""),
    "masculine": (3, "singular", "masculine"),
    "feminine": (3, "singular", "feminine"),
    "neuter": (3, "singular", "neuter"),
    "third plural": (3, "plural", ""),
}
GENDERS = ("masculine", "feminine", "neuter")
RELATIVE_ROLES = (
    *("subject", "object", "restrictive_subject", "restrictive_object", "after_preposition"),
)
DETERMINER_FIELDS = ("number", "plural", "uncountable")


class FunctionWords(NamedTuple):
    """The words that constructions need: auxiliaries, "to", "by", "than" and the like."""

    future: str
    perfect: str
    progressive: str
    passive: str
    copula: str
    support: str
    negator: str
    infinitive: str
    agent: str
    possession: str
    pair: str
    definite: str
    comparative: str
    equative: str
    existential: str
    whether: str
    exclamative_degree: str
    exclamative_noun: str


class DeterminerForms(NamedTuple):
    """The number that a determiner asks for (if any), and its forms where they differ."""

    number: str = ""
    plural: str | None = None
    uncountable: str | None = None
    singly: bool = False  # whether it counts single things, as "a" and "another" do


class Grammar(NamedTuple):
    """Closed word classes, exceptions to rules and options; never changed after loading."""

    words: FunctionWords
    pronouns: dict[tuple[int, str, str], dict[str, str]]
    object_pronouns: tuple[str, ...]
    relative_pronouns: dict[str, dict[str, str]]
    relative_possessive: str
    be: dict[tuple[int, bool, bool], str]  # by person, plural, past
    modals: dict[str, str]
    negated_as_a_whole: frozenset[str]
    prospective: frozenset[str]
    auxiliary_semi_modals: frozenset[str]
    never_backshifted: frozenset[str]
    contractions: dict[str, str]
    contracting: frozenset[str]
    contracted_after: frozenset[str]
    contracted_in_text: frozenset[str]
    full_after: frozenset[str]
    negative_contractions: dict[str, str]
    question_negatives: dict[str, str]
    tag_negatives: dict[str, str]
    fused_negatives: dict[str, str]
    let_full: str
    let_contracted: str
    imperative_tags: dict[str, str]
    negators: frozenset[str]
    not_negative: tuple[str, ...]
    negative_determiners: frozenset[str]
    inverting: frozenset[str]
    inverting_beginnings: tuple[str, ...]
    inverting_with_ellipsis: frozenset[str]
    approximators: frozenset[str]
    plural_in_tags: frozenset[str]
    repeated_in_tags: frozenset[str]
    indefinite_articles: frozenset[str]
    determiners: dict[str, DeterminerForms]
    correlatives: dict[str, str]
    additive: frozenset[str]
    disjunctive: frozenset[str]
    adjective_order: dict[str, int]
    indefinite_pronouns: frozenset[str]
    abbreviations: frozenset[str]
    inflection: Inflection
    numerals: NumberWords
    sounds: ArticleSounds
    oxford_comma: bool = False
    curly_apostrophes: bool = False


# The fields that are plain sets of words.
_SETS = tuple(name for name, kind in Grammar.__annotations__.items() if kind == frozenset[str])
# Ranks of adjectives: those that limit ("other"), the opinions, and those that no class names.
LIMITING, OPINION, UNLISTED = 0, 1, 2


def load_grammar(
    folder: str | PathLike[str],
    dialect: Dialect = "british",
    oxford_comma: bool = False,
    curly_apostrophes: bool = False,
) -> Grammar:
    """Read the four grammar files of a lexicon folder; every fault names its file and line.

    Raises `DataError` for a missing table, an unknown one or a word that is not text.
    """
    if dialect not in get_args(Dialect):
        remedy = f"choose from: {', '.join(get_args(Dialect))}"
        raise PersonageError(f"no dialect '{shown(str(dialect))}'; {remedy}")
    inflection = read_inflection(read_yaml(f"{folder}/inflection.yaml"), dialect)
    numerals = read_numerals(read_yaml(f"{folder}/numerals.yaml"), dialect)
    sounds = read_article_sounds(read_yaml(f"{folder}/articles.yaml"), dialect)
    closed = _closed_words(read_yaml(f"{folder}/grammar.yaml"))
    return Grammar(
        **closed,  # type: ignore[arg-type]
        inflection=inflection,
        numerals=numerals,
        sounds=sounds,
        oxford_comma=oxford_comma,
        curly_apostrophes=curly_apostrophes,
    )


def _closed_words(node: Node) -> dict[str, object]:
    """Return what grammar.yaml holds, by the fields of `Grammar`."""
    words = _words(node.need("function_words"), FunctionWords._fields)
    pronouns = _pronouns(node.need("pronouns"))
    relative = node.need("relative_pronouns")
    let = _words(node.need("let"), ("full", "contracted"))
    found: dict[str, object] = {
        "words": FunctionWords(**words),
        "pronouns": pronouns,
        "object_pronouns": tuple({forms["objective"]: "" for forms in pronouns.values()}),
        "relative_pronouns": {
            kind: _words(relative.need(kind), RELATIVE_ROLES) for kind in ("animate", "inanimate")
        },
        "relative_possessive": relative.need("possessive").text(),
        "be": _be(node.need("be")),
        "modals": _words(node.need("modals")),
        **{name: frozenset(node.need(name).texts()) for name in _SETS},
        "contractions": _words(node.need("contractions")),
        "negative_contractions": _words(node.need("negative_contractions")),
        "question_negatives": _words(node.need("question_negatives")),
        "tag_negatives": _words(node.need("tag_negatives")),
        "fused_negatives": _words(node.need("fused_negatives")),
        "let_full": let["full"],
        "let_contracted": let["contracted"],
        "imperative_tags": _words(node.need("imperative_tags"), ("first", "second")),
        "not_negative": node.need("not_negative").texts(),
        "inverting_beginnings": node.need("inverting_beginnings").texts(),
        "determiners": {
            name: _determiner(forms) for name, forms in node.need("determiners").items()
        },
        "correlatives": _words(node.need("correlatives")),
        "adjective_order": _order(node.need("adjective_order")),
    }
    relative.done()
    node.done()
    return found


def _words(node: Node, needed: tuple[str, ...] = ()) -> dict[str, str]:
    """Return a table of words; with `needed`, exactly those."""
    for key in needed:
        node.need(key)
    if needed:
        node.done()
    return {key: value.text() for key, value in node.items()}


def _pronouns(node: Node) -> dict[tuple[int, str, str], dict[str, str]]:
    """Return the cases of each pronoun by person, number and gender."""
    found = {}
    for name, (person, number, gender) in PRONOUNS.items():
        row = _words(node.need(name), CASES)
        for each in (gender,) if gender else GENDERS:
            found[person, number, each] = row
    node.done()
    return found


def _be(node: Node) -> dict[tuple[int, bool, bool], str]:
    """Return the finite forms of the copula by person, plural and past."""
    needed = ("present_first", "present_third", "present_other", "past_singular", "past_other")
    forms = _words(node, needed)
    singular = {1: forms["present_first"], 2: forms["present_other"], 3: forms["present_third"]}
    found = {}
    for person, present in singular.items():
        found[person, False, False] = present
        found[person, True, False] = forms["present_other"]
        found[person, False, True] = forms["past_other" if person == 2 else "past_singular"]
        found[person, True, True] = forms["past_other"]
    return found


def _determiner(node: Node) -> DeterminerForms:
    node.only(DETERMINER_FIELDS)
    number = node.choice_of("number", ("singular", "plural"), "")
    forms = {}
    for key in ("plural", "uncountable"):
        found = node.get(key)
        # An empty form is said by leaving the determiner out.
        forms[key] = None if found is None else found.text(empty=True)
    plural, uncountable = forms["plural"], forms["uncountable"]
    singly = plural is not None and uncountable is not None
    return DeterminerForms(number, plural, uncountable, singly)


def _order(node: Node) -> dict[str, int]:
    """Return the rank of each adjective; the class of those not listed is kept free."""
    found = {}
    for place, (_, words) in enumerate(node.items()):
        for word in words.text().split():
            found[word] = place if place < UNLISTED else place + 1
    return found
