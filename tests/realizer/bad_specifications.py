"""Specifications that are refused, with the path to the fault and what is said of it.

They are for the reader, and for the JSON Schema, which must know of those that it can express.
"""

from __future__ import annotations

from typing import Any, NamedTuple


class Bad(NamedTuple):
    """A specification that is refused: its data, the path to the fault, and what is said of it.

    `expressible` says whether a JSON Schema can know it too.
    """

    data: Any
    path: str
    message: str
    expressible: bool = True


NOTHING = "nothing says what this is; give it one of: adjective, "
EMPTY_LIST = "the list is empty; add words, or remove the field"
# Numbers with nothing after the point are whole in a JSON Schema, not here.
WHOLE = False
BAD = [
    # what it is
    Bad({}, "", NOTHING),
    Bad({"a": 1}, "", NOTHING),
    Bad({"shared": ["a"]}, "shared", "'shared' without 'sentences'; put what is to be said under"),
    Bad({"weekday": True}, "", NOTHING),
    Bad({"speech": "a"}, "", NOTHING),
    Bad({"phrase": {"noun": "a"}}, "", NOTHING),
    Bad(None, "", "expected a phrase, found nothing; "),
    Bad(7, "", "expected a phrase, found '7'; put it in quotes"),
    Bad(1.5, "", "expected a phrase, found '1.5'; put it in quotes"),
    Bad(True, "", "expected a phrase, found "),
    Bad([], "", "no sentence to say; add one"),
    Bad([[]], "[0]", EMPTY_LIST),
    Bad({"sentences": []}, "sentences", "no sentence to say; add one"),
    Bad({"sentences": None}, "sentences", "expected a phrase, found nothing; "),
    Bad({"sentences": {}}, "sentences", NOTHING),
    Bad({"sentences": ["a"], "share": 1}, "share", "unknown field 'share' beside 'sentences'; put"),
    Bad({"sentences": ["a", {"noun": 1}]}, "sentences[1].noun", "expected a text, found '1'; "),
    Bad(["a", ["b", {"noun": 1}]], "[1][1].noun", "expected a text, found '1'; put it in quotes"),
    # fields
    Bad({"noun": "a", "determinr": "a"}, "determinr", "NounPhrase has no field 'determinr'; did"),
    Bad({"noun": "a", "xyz": 1}, "xyz", "NounPhrase has no field 'xyz'; choose from: adjectives"),
    Bad({"noun": "a", "verb": "go"}, "verb", "NounPhrase has no field 'verb'; "),
    Bad({"verb": "go", "subjct": "a"}, "subjct", "Clause has no field 'subjct'; did you mean sub"),
    Bad({"body": "a", "connectiv": "b"}, "connectiv", "has no field 'connectiv'; did you mean con"),
    Bad(
        {"verb": "go", "subject": {"noun": "a", "relative": {"clause": {"vreb": "go"}}}},
        "subject.relative.clause",
        "nothing says what this is; give it one of: items, verb",
    ),
    Bad(
        {"verb": "go", "subject": "a", "question": {"phrse": "who"}}, "question.phrse", "mean phra"
    ),
    Bad({"preposition": "in"}, "", "'object' is missing; add 'object: …'"),
    Bad({"lead": "I think"}, "", "'clause' is missing; add 'clause: …'"),
    Bad({"noun": "a", "relative": {}}, "relative", "'clause' is missing; add 'clause: …'"),
    Bad({"body": "a", "joined": [{"conjunction": "and"}]}, "joined[0]", "'body' is missing; add"),
    Bad({"body": "a", "openers": [{"mark": ","}]}, "openers[0]", "'text' is missing; add"),
    Bad(
        {"verb": "go", "subordinates": [{"conjunction": "if"}]},
        "subordinates[0]",
        "'clause' is missing; add 'clause: …'",
    ),
    Bad({"verb": "go", "quotation": {"first": True}}, "quotation", "'speech' is missing; add"),
    # texts
    Bad({"noun": 7}, "noun", "expected a text, found '7'; put it in quotes"),
    Bad({"noun": True}, "noun", "expected a text, found "),
    Bad({"noun": None}, "noun", "expected a text, found nothing; "),
    Bad({"noun": {"noun": "a"}}, "noun", "expected a text, found a mapping; "),
    Bad({"noun": ["a"]}, "noun", "expected a text, found a list; "),
    Bad({"noun": "a", "determiner": None}, "determiner", "expected a text, found nothing; "),
    Bad({"verb": "go", "subject": "a", "modal": 1}, "modal", "expected a text, found '1'; put it"),
    Bad({"body": "a", "tag": False}, "tag", "expected a text, found "),
    # flags
    Bad({"noun": "a", "animate": "yes"}, "animate", "expected true or false, found 'yes'; "),
    Bad({"noun": "a", "animate": 1}, "animate", "expected true or false, found '1'; "),
    Bad({"noun": "a", "animate": None}, "animate", "expected true or false, found nothing; "),
    Bad({"noun": "a", "animate": []}, "animate", "expected true or false, found a list; "),
    Bad({"value": 1, "ordinal": 2}, "ordinal", "expected true or false, found '2'; "),
    # numbers
    Bad({"noun": "a", "stutter": "2"}, "stutter", "expected a whole number, found '2'; "),
    Bad({"noun": "a", "stutter": 1.5}, "stutter", "expected a whole number, found '1.5'; "),
    Bad({"noun": "a", "stutter": 1.0}, "stutter", "expected a whole number, found '1.0'; ", WHOLE),
    Bad({"noun": "a", "stutter": True}, "stutter", "expected a whole number, found "),
    Bad({"noun": "a", "stutter": None}, "stutter", "expected a whole number, found nothing; "),
    Bad({"noun": "a", "ordinal": 1.5}, "ordinal", "expected a whole number, found '1.5'; "),
    Bad({"noun": "a", "cardinal": "two"}, "cardinal", "a number, found 'two'; "),
    Bad({"noun": "a", "cardinal": True}, "cardinal", "a number, found "),
    Bad({"value": "2"}, "value", "a number, found '2'; "),
    Bad({"value": None}, "value", "a number, found nothing; "),
    Bad({"year": "2000"}, "year", "expected a whole number, found '2000'; "),
    Bad({"year": 2000, "month": "July"}, "month", "expected a whole number, found 'July'; "),
    # one of several values
    Bad(
        {"noun": "a", "number": "plurl"}, "number", "'plurl' is not possible here; did you mean pl"
    ),
    Bad({"noun": "a", "number": ""}, "number", "'' is not possible here; choose from: plural, sin"),
    Bad({"noun": "a", "number": 2}, "number", "'2' is not possible here; choose from: plural, "),
    Bad({"noun": "a", "number": ["plural"]}, "number", "found a list; "),
    Bad({"noun": "a", "gender": None}, "gender", "; "),
    Bad({"noun": "a", "person": 4}, "person", "'4' is not possible here; choose from: 1, 2, 3"),
    Bad({"noun": "a", "person": "1"}, "person", "'1' is not possible here; "),
    Bad({"noun": "a", "person": True}, "person", "is not possible here; choose from: 1, 2, 3"),
    Bad({"noun": "a", "person": 1.0}, "person", "'1.0' is not possible here; ", WHOLE),
    Bad({"verb": "go", "subject": "a", "tense": "pst"}, "tense", "did you mean past"),
    Bad({"verb": "go", "mood": "askng"}, "mood", "'askng' is not possible here; choose from: de"),
    Bad({"verb": "go", "form": "finit"}, "form", "'finit' is not possible here; did you mean fin"),
    Bad({"adjective": "a", "degree": "more"}, "degree", "'more' is not possible here; choose from"),
    Bad(
        {"year": 2000, "style": "wrds"}, "style", "'wrds' is not possible here; did you mean words"
    ),
    Bad(
        {"verb": "go", "ellipsis": ["subjct"]},
        "ellipsis[0]",
        "'subjct' is not possible here; did you mean subject?",
    ),
    Bad(
        {"parts": [{"phrase": {"noun": "a"}, "case": "objectiv"}]},
        "parts[0].case",
        "'objectiv' is not possible here; did you mean objective",
    ),
    # lists
    Bad({"noun": "a", "adjectives": "big"}, "adjectives", "expected a list, found 'big'; write it"),
    Bad(
        {"noun": "a", "adjectives": None}, "adjectives", "expected a list, found nothing; write it"
    ),
    Bad(
        {"noun": "a", "adjectives": {"adjective": "big"}}, "adjectives", "found a mapping; write it"
    ),
    Bad({"noun": "a", "adjectives": [None]}, "adjectives[0]", "expected a phrase, found nothing; "),
    Bad(
        {"noun": "a", "adjectives": [7]}, "adjectives[0]", "expected a phrase, found '7'; put it in"
    ),
    Bad({"noun": "a", "adjectives": [[]]}, "adjectives[0]", EMPTY_LIST),
    Bad({"noun": "a", "modifiers": "b"}, "modifiers", "expected a list, found 'b'; write it as"),
    Bad({"verb": "go", "adverbs": "often"}, "adverbs", "expected a list, found 'often'; write it"),
    Bad(
        {"verb": "go", "adverbs": ["often", 1]}, "adverbs[1]", "expected a text, found '1'; put it"
    ),
    Bad({"verb": "go", "adverbs": [["often"]]}, "adverbs[0]", "expected a text, found a list; "),
    Bad({"verb": "go", "ellipsis": "subject"}, "ellipsis", "expected a list, found 'subject'; "),
    Bad({"items": "a"}, "items", "expected a list, found 'a'; write it as a list, [ … ]"),
    Bad({"items": None}, "items", "expected a list, found nothing; write it as a list, [ … ]"),
    Bad({"parts": "a"}, "parts", "expected a list, found 'a'; write it as a list, [ … ]"),
    Bad(
        {"body": "a", "joined": {"conjunction": "and", "body": "b"}}, "joined", "expected a list, "
    ),
    # phrases
    Bad({"verb": "go", "subject": 7}, "subject", "expected a phrase, found '7'; put it in quotes"),
    Bad({"verb": "go", "subject": False}, "subject", "expected a phrase, found "),
    Bad({"verb": "go", "subject": []}, "subject", EMPTY_LIST),
    Bad({"verb": "go", "subject": {}}, "subject", NOTHING),
    Bad({"noun": "a", "possessor": [{}]}, "possessor[0]", "nothing says what this is; give it one"),
    Bad({"lead": [], "clause": {"verb": "go", "subject": "a"}}, "lead", EMPTY_LIST),
    Bad({"preposition": "in", "object": None}, "object", "expected a phrase, found nothing; "),
    # other types
    Bad({"noun": "a", "relative": "b"}, "relative", "expected a Relative, found 'b'; "),
    Bad({"noun": "a", "relative": {"clause": "b"}}, "relative.clause", "found 'b'; "),
    Bad({"noun": "a", "relative": {"clause": {"noun": "b"}}}, "relative.clause", "items, verb"),
    Bad({"verb": "go", "question": "who"}, "question", "expected a Question, found 'who'; "),
    Bad({"verb": "go", "question": ["who"]}, "question", "expected a Question, found a list; "),
    Bad({"verb": "go", "quotation": 1}, "quotation", "expected a text or a Quotation, found '1'; "),
    Bad({"verb": "go", "quotation": ["a"]}, "quotation", "a text or a Quotation, found a list; "),
    Bad({"verb": "go", "quotation": {"verb": "go"}}, "quotation.verb", "Quotation has no field"),
    Bad(
        {"verb": "go", "subordinates": ["if so"]}, "subordinates[0]", "a Subordinate, found 'if so'"
    ),
    Bad({"body": "a", "openers": ["Oh"]}, "openers[0]", "Opener, found 'Oh'; "),
    Bad({"body": {"body": "a"}}, "body", NOTHING),
    Bad({"parts": [{"phrase": "a"}]}, "parts[0].phrase", "expected a NounPhrase, found 'a'; "),
    Bad(
        {"body": "a", "joined": [{"conjunction": "and", "body": "b"}]},
        "joined[0].body",
        "found 'b'",
    ),
]
# What reads and cannot be said.
UNSAID = [
    Bad({"verb": "go"}, "", "the clause with the verb 'go' has no subject; add one"),
    Bad({"verb": "say", "subject": "a", "object": {"verb": "go"}}, "object", "has no subject; add"),
    Bad({"noun": ""}, "", "a noun phrase says nothing; give it a noun"),
    Bad({"verb": "see", "subject": "a", "object": {"noun": ""}}, "object", "says nothing; give it"),
    Bad(
        {
            "verb": "go",
            "subject": "a",
            "mood": "interrogative",
            "question": {"phrase": "who", "role": "subject"},
        },
        "",
        "the subject stands twice, in the clause and before it; leave it out of the clause",
    ),
    Bad(
        {"noun": "a", "relative": {"clause": {"verb": "go", "object": "b"}, "role": "object"}},
        "relative",
        "the object stands twice, in the clause and before it; leave it out of the clause",
    ),
    Bad(
        {"noun": "a", "relative": {"clause": {"items": ["a"]}}},
        "relative.clause",
        "only clauses can be joined in a relative clause; ",
    ),
    Bad({"noun": "a", "relative": {"clause": {"items": []}}}, "relative.clause", "; "),
    # numbers and dates that nobody can say
    Bad({"year": 2000, "month": 13}, "", "no calendar has year 2000, month 13; give a date of the"),
    Bad(
        {"verb": "go", "subject": "a", "adverbials": [{"day": 3}]}, "adverbials[0]", "lacks a month"
    ),
    Bad({"year": 10000}, "", "no calendar has year 10000; give a date of the years 1-9999"),
    Bad({"year": 2**31}, "", "no calendar has year 2147483648; give a date of the years 1-9999"),
    Bad({"year": 2**64}, "", "no calendar has year "),
    Bad({"year": 2000, "month": 2, "day": 30}, "", "no calendar has year 2000, month 2, day 30; "),
    Bad({"year": 2000, "weekday": True}, "", "a weekday needs a whole date; give year, month and"),
    Bad({"value": 1.5, "ordinal": True}, "", "; "),
    Bad({"noun": "cat", "stutter": 10**15}, "stutter", "; "),
    Bad({"noun": "cat", "stutter": 10**30}, "stutter", "; "),
    # nothing to say
    Bad("", "", "; "),
    Bad({"body": ""}, "body", "; "),
    Bad({"adjective": ""}, "adjective", "; "),
    Bad({"items": []}, "items", "; "),
    Bad({"items": [""]}, "items[0]", "; "),
    Bad({"parts": []}, "parts", "; "),
]
BLANKS: tuple[Any, ...] = (
    *(
        " ",
        {"verb": " ", "subject": "a"},
        {"verb": "", "subject": "a"},
        {"noun": " "},
        {"verb": "go", "subject": ""},
    ),
    *({"verb": "go", "subject": {"parts": []}}, {"verb": "see", "subject": "a", "object": ""}),
    *({"verb": "see", "subject": "a", "adverbs": [""]}, {"noun": "a", "adjectives": [""]}),
    *({"preposition": "", "object": "a"}, {"body": "a", "openers": [{"text": ""}]}),
    *({"lead": "", "clause": {"verb": "go", "subject": "a"}}, {"body": "a", "tag": " "}),
    *({"verb": "say", "subject": "a", "quotation": {"speech": ""}}, {"items": ["a", "", "b"]}),
    *({"verb": "go", "subject": "a", "modal": " "}, {"noun": "cat", "determiner": " "}),
    {"verb": "go", "subject": "a", "subordinates": [{"conjunction": "", "clause": {"verb": "go"}}]},
    *({"noun": "cat", "stutter": -1}, "…", {"body": "!"}, {"noun": ","}, {"parts": ["a", "…"]}),
)
