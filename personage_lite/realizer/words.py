"""English inflection: rules in code, exceptions in data. A word unknown goes by rule."""

from __future__ import annotations

from typing import Final, Literal, TypeAlias

from personage_lite.realizer.inflection import Countability, Inflection

VerbForm: TypeAlias = Literal["base", "third", "past", "participle", "gerund"]
Degree: TypeAlias = Literal["positive", "comparative", "superlative"]

_VOWELS: Final = "aeiou"
_AEIOU: Final = frozenset(_VOWELS)
_AEIOUL: Final = frozenset("aeioul")
_AEIOUY: Final = frozenset("aeiouy")
# Consonants become the spaces between runs of vowels.
_VOWELS_ALONE: Final = {ord(letter): " " for letter in "bcdfghjklmnpqrstvwxz'.-"}
_NATIONALS: Final = ("woman", "chman", "shman", "tsman")
# Endings of words made from a verb in -ise or -ize.
_DERIVED: Final = ("ation", "er")
_HISSES: Final = ("s", "x", "z", "ch", "sh")
# Two vowels in spelling that are two in sound: dial, duel, victual.
_HIATUS: Final = ("ial", "uel", "ual")


# Syllables and spelling


def _is_one_syllable(word: str) -> bool:
    """Whether one run of vowels is all there is, but for a silent e: stop, brave, free."""
    if "y" in word[:-1]:
        # A y before a vowel is a consonant: yap, loyal.
        word = "".join(
            "w" if letter == "y" and after in _AEIOU else letter
            for letter, after in zip(word, word[1:] + " ", strict=True)
        )
    runs = len(word.translate(_VOWELS_ALONE).split())
    if runs == 2 and word.endswith("e"):
        if word.endswith(("que", "gue")):
            return True
        # A silent e; that of "little" is none.
        before = word[-2]
        return before not in "aeiouy" and (before != "l" or word[-3:-2] in _AEIOU or len(word) < 3)
    return runs <= 1


def _ends_short(word: str) -> bool:
    """Whether one vowel letter and one consonant end the word: stop, quit, visit, travel."""
    if word[-2:-1] not in _AEIOU or word[-1] in "aeiouwxyh" or len(word) < 3:
        return False
    before = word[-3]
    if before in "aeiouy":  # rain, layer; but quit, yap
        return word[-4:-2] == "qu" or (before == "y" and len(word) == 3)
    return True


def _doubles(word: str, inflection: Inflection) -> bool:
    """Whether the last consonant doubles: stop, stopping; it does after a stressed vowel."""
    while word not in inflection.doubling:
        if not _ends_short(word):
            return inflection.doubles_l and word.endswith(_HIATUS)
        if word in inflection.not_doubling:
            return False
        if inflection.doubles_l and word[-1] == "l":
            return True
        start = word[:-3] if word[-4:-2] == "qu" else word[:-2]
        if start[0] not in _AEIOU and _AEIOUY.isdisjoint(start[1:]):
            return True  # one syllable; a y that begins it is a consonant
        if not word.startswith(inflection.verb_prefixes):
            return False
        word = _without_prefix(word, inflection)
    return True


def _without_prefix(word: str, inflection: Inflection) -> str:
    """Return what follows the prefix of a verb that has one: overtake, take."""
    return next(word[len(start) :] for start in inflection.verb_prefixes if word.startswith(start))


def _ends_in_consonant_y(word: str) -> bool:
    return word[-1:] == "y" and len(word) > 1 and (word[-2] not in _VOWELS or word[-3:-1] == "qu")


def _s_form(word: str, inflection: Inflection) -> str:
    """Add the -s of verbs and plurals: cries, watches, plays, heroes, MPs."""
    last = word[-1]
    if last in "aeptnrdlkgm":  # at once, for most words
        return word + "s"
    if last == "y":
        return word[:-1] + "ies" if _ends_in_consonant_y(word) else word + "s"
    if word.endswith(_HISSES):
        if last == "z" and word[0].islower() and _ends_short(word) and _is_one_syllable(word):
            return word + "zes"
        return word + "es"
    if last == "o" and word in inflection.o_es:
        return word + "es"
    return word + "s"


# Verbs


def inflect_verb(lemma: str, form: VerbForm, inflection: Inflection) -> str:
    """Return the form of a verb; `be` has more of its own, see `verb_group`.

    Of a phrase its first word changes, of a hyphened word its last: gave up, baby-sat.
    """
    if form == "base" or not lemma:
        return lemma
    if " " in lemma:
        head, _, rest = lemma.partition(" ")
        return f"{inflect_verb(head, form, inflection)} {rest}"
    if form == "third":
        found = inflection.third_person.get(lemma)
    elif form == "gerund":
        found = inflection.gerunds.get(lemma)
    else:
        forms = inflection.verbs.get(lemma)
        found = forms and forms[form == "participle"]
    if found:
        return found
    if "-" in lemma:
        head, hyphen, rest = lemma.rpartition("-")
        return head + hyphen + inflect_verb(rest, form, inflection)
    if form == "third":
        return _s_form(lemma, inflection)
    if form == "gerund":
        return _gerund(lemma, inflection)
    rest = lemma
    while rest.startswith(inflection.verb_prefixes):
        rest = _without_prefix(rest, inflection)
        forms = inflection.verbs.get(rest)
        if forms:
            return lemma[: -len(rest)] + forms[form == "participle"]
    if lemma[-1] == "e":
        return lemma + "d"
    if lemma[-1] == "y" and _ends_in_consonant_y(lemma):
        return lemma[:-1] + "ied"
    return _stem(lemma, inflection) + "ed"


def _gerund(lemma: str, inflection: Inflection) -> str:
    """Return the form in -ing: dying, seeing, dyeing, making, stopping."""
    if lemma.endswith("e"):
        if lemma.endswith("ie"):
            return lemma[:-2] + "ying"
        if not lemma.endswith(("ee", "oe", "ye")) and len(lemma) > 2:
            return lemma[:-1] + "ing"
        return lemma + "ing"
    return _stem(lemma, inflection) + "ing"


def _stem(lemma: str, inflection: Inflection) -> str:
    """Return a verb as it stands before -ed and -ing: stopp, panick, rain."""
    if lemma[-2:-1] not in "aeiouy":  # at once, for most words
        return lemma
    if lemma.endswith(("ic", "ac")) and not _is_one_syllable(lemma):
        return lemma + "k"
    return lemma + lemma[-1] if _doubles(lemma, inflection) else lemma


# Nouns


def pluralize(noun: str, inflection: Inflection) -> str:
    """Return the plural of a noun; of a phrase, the plural of its head: packs of cards.

    The head is the last word before the first preposition. What has no other plural stays.
    """
    found = inflection.plurals.get(noun)
    if found or not noun:
        return found or noun
    if " " in noun or "-" in noun:
        start, head, end = _head(noun, inflection)
        if start or end:
            return start + pluralize(head, inflection) + end
    if noun.endswith(inflection.compound_ends):
        # Freeman and Rothschild are names, Frenchman is none.
        if noun[0].islower() or noun.endswith(_NATIONALS):
            part = next(part for part in inflection.compound_ends if noun.endswith(part))
            return noun[: -len(part)] + inflection.compounds[part]
    elif noun.endswith(("sis", "xis", "ics", "itis")):
        # crises; physics and bronchitis stay
        return noun[:-2] + "es" if noun[-3] in "sx" else noun
    if not noun.islower():
        if not noun[-1].islower():
            return noun + "s"  # MPs, 1860s
        found = inflection.plurals.get(noun.lower())
        if found:
            return noun[0] + found[1:]
        if noun.endswith("ese"):
            return noun  # the Chinese
        if noun[-1] == "y" or (noun[-3:] in ("ach", "och") and noun[-4:-3] not in _AEIOU):
            return noun + "s"  # the two Marys, the Bachs
    return _s_form(noun, inflection)


def _head(noun: str, inflection: Inflection) -> tuple[str, str, str]:
    """Return what stands before the head of a phrase, the head and what follows it."""
    if " " in noun:
        words = noun.split(" ")
        for index in range(1, len(words)):
            if words[index] in inflection.prepositions:
                break
            # As the last word, "inside" and "opposite" may be nouns.
            if words[index] in inflection.noun_phrase_ends and index < len(words) - 1:
                break
        else:
            index = len(words)
            heads = inflection.postpositives.get(words[-1])
            if heads and (words[-2] in heads or "*" in heads):
                index -= 1
        return (
            " ".join((*words[: index - 1], "")) if index > 1 else "",
            words[index - 1],
            " ".join(("", *words[index:])) if index < len(words) else "",
        )
    if "-" in noun:
        parts = noun.split("-")
        ends = parts[1] in inflection.prepositions or parts[1] in inflection.noun_phrase_ends
        if len(parts) > 2 and ends:
            return "", parts[0], noun[len(parts[0]) :]
        if len(parts) == 2 and parts[0].endswith("er") and (ends or parts[1] == "up"):
            return "", parts[0], noun[len(parts[0]) :]
        return noun[: -len(parts[-1])] if parts[-1] else "", parts[-1] or noun, ""
    return "", noun, ""


def countability(noun: str, inflection: Inflection) -> Countability:
    """Return whether a noun has a plural, only a plural, or comes in pairs: furniture, scissors."""
    if " " in noun or "-" in noun:
        noun = _head(noun, inflection)[1]
    found = inflection.countability.get(noun)
    if found:
        return found
    return "uncountable" if noun.endswith(inflection.uncountable_ends) else "countable"


# Adjectives and adverbs


def inflect_adjective(adjective: str, degree: Degree, inflection: Inflection) -> str:
    """Return the degree of an adjective or adverb: braver, happiest, more quickly, better."""
    if degree == "positive" or not adjective:
        return adjective
    forms = inflection.degrees.get(adjective)
    if forms:
        return forms[degree == "superlative"]
    if not _takes_er(adjective, inflection):
        return f"{inflection.more if degree == 'comparative' else inflection.most} {adjective}"
    ending = "er" if degree == "comparative" else "est"
    if adjective.endswith("e"):
        return adjective[:-1] + ending
    if _ends_in_consonant_y(adjective):
        return adjective[:-1] + "i" + ending
    if adjective.endswith("ey") and len(adjective) > 4:
        return adjective[:-2] + "i" + ending  # pricier, but greyer
    if _doubles(adjective, inflection):
        return adjective + adjective[-1] + ending
    return adjective + ending


def _takes_er(word: str, inflection: Inflection) -> bool:
    """Whether -er and -est are the word's own: short words, and longer ones in -y, -le, -ow."""
    if word in inflection.with_er:
        return True
    if word in inflection.with_more or not (word.isalpha() and word.islower()):
        return False
    if _is_one_syllable(word):
        return len(word) < 5 or not word.endswith(("ed", "ing"))
    rest = word.removeprefix("un")
    if rest.endswith("y"):
        stem = rest[:-1].removesuffix("e")
        return stem[-1:] not in _AEIOUL and _is_one_syllable(stem)
    if rest.endswith(("le", "ow")) and not rest.endswith(("able", "ible")):
        return rest[-3:-2] not in _AEIOU and _is_one_syllable(rest[:-2])
    return False


# Spelling


def spell(word: str, inflection: Inflection) -> str:
    """Return a lemma as the dialect writes it: colour or color, organisation or organization.

    Names stay as they are: Mr Gray, Pearl Harbor.
    """
    spellings = inflection.spellings
    found = spellings.get(word)
    if found:
        return found
    if word.endswith(_DERIVED):
        for ending in _DERIVED:
            found = spellings.get(word.removesuffix(ending) + "e")
            if found:
                return found[:-1] + ending
    return word
