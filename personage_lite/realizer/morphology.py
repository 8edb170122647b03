"""Inflection: rules in code, exceptions in the grammar's data. A word unknown goes by rule."""

from __future__ import annotations

from typing import Literal, TypeAlias

from personage_lite.realizer.grammar import Grammar

VerbForm: TypeAlias = Literal["base", "third", "past", "participle", "gerund"]

_VOWELS = "aeiou"


def _doubles(word: str, grammar: Grammar) -> bool:
    """One-syllable words in consonant-vowel-consonant double the last: stop, stopping."""
    if word in grammar.doubling:
        return True
    if len(word) < 3 or word[-1] in _VOWELS or word[-1] in "wxy" or word[-2] not in _VOWELS:
        return False
    head = word[:-2]
    if head.endswith("qu"):
        head = head[:-1]
    # A y that begins the word is a consonant: yap, yapping.
    return head[:1] not in _VOWELS and not any(letter in "aeiouy" for letter in head[1:])


def _stem(lemma: str, grammar: Grammar) -> str:
    """Return a verb as it stands before -ed and -ing: stopp, panick, rain."""
    if _doubles(lemma, grammar):
        return lemma + lemma[-1]
    return lemma + "k" if lemma.endswith("ic") else lemma


def _s_form(word: str) -> str:
    """Add the -s of verbs and plurals: cries, watches, plays."""
    if word.endswith(("s", "x", "z", "ch", "sh")):
        return word + "es"
    if word.endswith("y") and len(word) > 1 and word[-2] not in _VOWELS:
        return word[:-1] + "ies"
    return word + "s"


def inflect_verb(lemma: str, form: VerbForm, grammar: Grammar) -> str:
    """Return the form of a verb; `be` has more of its own, see `verb_group`."""
    if form == "base":
        return lemma
    if form == "third":
        if lemma in grammar.third_person:
            return grammar.third_person[lemma]
        takes_e = lemma.endswith("o") and not lemma.endswith("oo")
        return lemma + "es" if takes_e else _s_form(lemma)
    if form == "gerund":
        if lemma.endswith("ie"):
            return lemma[:-2] + "ying"
        if lemma.endswith("e") and not lemma.endswith(("ee", "oe", "ye")) and len(lemma) > 2:
            return lemma[:-1] + "ing"
        return _stem(lemma, grammar) + "ing"
    forms = grammar.irregular_verbs.get(lemma)
    if forms:
        return forms[0] if form == "past" else forms[-1]
    if lemma.endswith("e"):
        return lemma + "d"
    if lemma.endswith("y") and len(lemma) > 1 and lemma[-2] not in _VOWELS:
        return lemma[:-1] + "ied"
    return _stem(lemma, grammar) + "ed"


def pluralize(noun: str, grammar: Grammar) -> str:
    """Return the plural of a noun; of a phrase, the plural of its head: packs of cards.

    The head is the last word before the first preposition. What has no other plural stays.
    """
    if " " in noun:
        words = noun.split(" ")
        for index in range(1, len(words)):
            if words[index] in grammar.prepositions:
                head = pluralize(" ".join(words[:index]), grammar)
                return " ".join((head, *words[index:]))
    head, space, last = noun.rpartition(" ")
    if last in grammar.invariable_plurals:
        return noun
    return head + space + (grammar.irregular_plurals.get(last) or _s_form(last))


def indefinite_article(word: str, grammar: Grammar) -> str:
    """Return "a" or "an" for the word that follows, by its sound.

    Letters mislead in an hour, a unicorn, a one-eyed cat, an FBI agent, an 8.
    """
    word = word.lstrip("“\"'‘(")
    # Letters said by their names: an FBI agent, a T-shirt.
    first = word.split(" ", 1)[0].split("-", 1)[0]
    if first.isupper() and first.isalpha():
        return "an" if first[0] in grammar.vowel_letters else "a"
    lower = word.lower() + " "
    if lower.startswith(grammar.vowel_sound):
        return "an"
    if lower.startswith(grammar.consonant_sound):
        return "an" if lower.startswith(grammar.vowel_sound_again) else "a"
    return "an" if lower[:1] in _VOWELS else "a"


def stutter(name: str, times: int) -> str:
    """Repeat the first letters of a name: Al-Al-Alice, Qu-Queen, Wh-White Rabbit, M-Mr Fox.

    Source: the paper, figure 7; PERSONAGE's stuttering operator.
    """
    word = name.split(" ", 1)[0].split("-", 1)[0].lower()
    length = 1
    if word[:1] in _VOWELS:
        while length < len(word) - 1 and word[length] in _VOWELS:
            length += 1
        length += 1
    else:
        while length < len(word) - 1 and word[length] not in "aeiouy":
            length += 1
        if length == len(word) - 1 and word[length] not in "aeiouy":
            length = 1
        elif word[:length].endswith("q"):
            length += 1
    return f"{name[: min(length, len(word))]}-" * times + name
