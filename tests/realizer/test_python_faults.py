"""Proves that what is wrong in a specification made in Python is one line with a remedy.

A misspelt feature or an impossible value is told when it is written, the rest when it is said, and
then with the path to it.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest

from personage_lite.realizer import (
    AdjectivePhrase,
    Cased,
    Clause,
    Coordination,
    Date,
    Joined,
    NounPhrase,
    Numeral,
    Opener,
    PrepositionalPhrase,
    Question,
    Quotation,
    Relative,
    Sentence,
    SpecificationError,
    Subordinate,
    Text,
)
from personage_lite.realizer.types import FIELDS, choices, options
from tests.mutation import check_message
from tests.realizer.reader_helpers import (
    EVERY_FIELD,
    FIELD_IDS,
    KINDS,
    REALIZER,
    UNFORESEEN,
    clean,
    data_of,
    heard,
    made,
    takes,
)


def needs(kind: Any) -> dict[str, Any]:
    """Return some value for each feature that a type cannot do without."""
    given: dict[str, Any] = {each: "a" for each in kind._fields if each not in kind._field_defaults}
    # Of these a type may ask for more than one word.
    return given | {each: ("a",) for each in ("items", "parts") if each in given}


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: str(kind.__name__))
def test_misspelt_features(kind: Any) -> None:
    """A feature that does not exist is an error as soon as it is written, with the nearest name."""
    for name in kind._fields:
        wrong = f"{name}x"
        with pytest.raises(SpecificationError) as caught:
            kind(**{**needs(kind), wrong: "a"})
        check_message(caught.value)
        start = f"{kind.__name__} has no feature '{wrong}'; did you mean "
        assert str(caught.value).startswith(start)
        assert name in str(caught.value)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: str(kind.__name__))
def test_missing_and_doubled_features(kind: Any) -> None:
    """They are told as Python tells them of any call, with the type's name."""
    first = kind._fields[0]
    calls: list[Callable[[], Any]] = [
        lambda: kind(*["a"] * (len(kind._fields) + 1)),
        lambda: kind("a", **{first: "a"}),
    ]
    if first not in kind._field_defaults:
        calls.append(kind)
    for call in calls:
        with pytest.raises((TypeError, SpecificationError)) as caught:
            call()
        assert len(str(caught.value).splitlines()) == 1
        assert kind.__name__ in str(caught.value)
        assert ".it " not in str(caught.value)


LITERALS = [
    (kind, name) for kind, name in EVERY_FIELD if any(map(choices, options(FIELDS[kind][name])))
]


@pytest.mark.parametrize(
    ("kind", "name"), LITERALS, ids=[f"{kind.__name__}.{name}" for kind, name in LITERALS]
)
def test_wrong_literal_values(kind: Any, name: str) -> None:
    """A value that a feature cannot have is an error as soon as it is written."""
    needed = needs(kind)
    for value in ("zz", "", None, 7, ["plural"], {}, NounPhrase("a"), object()):
        with pytest.raises(SpecificationError) as caught:
            kind(**{**needed, name: value})
        check_message(caught.value)
        assert str(caught.value).startswith(f"{kind.__name__}: {name} cannot be '")
    assert kind(**needed)


def placed(kind: Any, name: str, value: object) -> Any:
    """Return a specification whose one part has a value that nobody checked."""
    least, embed, _ = data_of(kind)

    def put(part: Any) -> Any:
        if type(part) is kind:
            return kind(**{**part._asdict(), name: value})
        if isinstance(part, tuple):
            items = [put(each) for each in part]
            return type(part)(*items) if hasattr(part, "_fields") else tuple(items)
        return part

    return put(made(embed(least)))


@pytest.mark.parametrize(("kind", "name"), EVERY_FIELD, ids=FIELD_IDS)
def test_wrong_types_in_python(kind: Any, name: str) -> None:
    """What is of a wrong type is refused with the path to it, or it does no harm.

    Harmless is a list for a tuple, and whatever is said as if it weren't there; but never a text
    with Python's names, or letters set apart.
    """
    hint = FIELDS[kind][name]
    path = data_of(kind)[2]
    values: tuple[Any, ...] = (
        *(None, 7, 1.5, "zz", b"zz", ["zz"], ("zz",), {"noun": "a"}, object(), {}, []),
        *(NounPhrase("zz"), Relative(Clause("go")), Opener("zz"), Sentence("zz"), (None,), (7,)),
    )
    for value in values:
        if takes(hint, value) or (isinstance(value, tuple) and takes(hint, list(value))):
            continue
        if type(value) in options(hint):
            continue
        try:
            said = heard(placed(kind, name, value))
        except SpecificationError as error:
            check_message(error)
            said = f"refused: {error}".replace(f"{kind.__name__}: ", path, 1)
        if not said.startswith("refused: "):
            assert not re.search(r"(?i)None|z z|z, z|[(\[]|object at", said), (value, said)
        elif bool not in options(hint) or said not in (
            heard(placed(kind, name, False)),
            heard(placed(kind, name, True)),
        ):
            assert said.startswith(f"refused: {path}{name}"), (value, said)


UNSAYABLE: list[tuple[Callable[[], Any], str]] = [
    (lambda: None, "expected a phrase, found nothing; "),
    (lambda: 7, "expected a phrase, found '7'; "),
    (list, "expected a phrase, found a list; "),
    (tuple, "expected a phrase, found a tuple; "),
    (lambda: ("a",), "expected a phrase, found a tuple; "),
    (lambda: {"noun": "cat"}, "expected a phrase, found a mapping; "),
    (lambda: b"cat", "expected a phrase, found a value of type bytes; "),
    (lambda: made({"body": "a"})._replace(body=None), "body: expected a phrase, found nothing; "),
    (lambda: Sentence(Any), "body: expected a phrase, found a value of type "),  # type: ignore[arg-type]
    (
        lambda: Sentence(made({"body": "a"})),
        "body: expected a phrase, found a value of type Sentence",
    ),
    (lambda: Clause("run"), "the clause with the verb 'run' has no subject; add one"),
    (
        lambda: Clause("say", "a", object=Clause("run")),
        "object: the clause with the verb 'run' has no subject; add one",
    ),
    (
        lambda: Sentence("a", joined=(Joined("and", Clause("run")),)),
        "joined[0].body: the clause with the verb 'run' has no subject; add one",
    ),
    (
        lambda: Clause("go", "a", subordinates=(Subordinate("if", Clause("run")),)),
        "subordinates[0].clause: the clause with the verb 'run' has no subject; add one",
    ),
    (lambda: NounPhrase(""), "a noun phrase says nothing; give it a noun"),
    (
        lambda: Clause("see", "a", object=NounPhrase("")),
        "object: a noun phrase says nothing; give it a noun",
    ),
    (
        lambda: Clause("run", "a", mood="interrogative", question=Question("who")),
        "the subject stands twice, in the clause and before it; leave it out of the clause",
    ),
    (
        lambda: NounPhrase("a", relative=Relative(Clause("see", "b", object="c"), role="object")),
        "relative: the object stands twice, in the clause and before it; leave it out of the",
    ),
    (
        # The same word stands before the one at fault.
        lambda: NounPhrase("a", relative=Relative(Coordination(("a", "b")))),
        "relative.clause",
    ),
    (lambda: Coordination(()), ""),
    (lambda: Text(()), ""),
    (lambda: AdjectivePhrase(""), ""),
    (lambda: Numeral(float("nan")), "nan cannot be said; give a finite number"),
    (lambda: Numeral(1.5, ordinal=True), ""),
    (lambda: made({"noun": "a"})._replace(ordinal=1.5), "ordinal: expected a whole number"),
    (lambda: NounPhrase("cat", cardinal=float("inf")), "inf cannot be said; give a finite number"),
    (Date, "the date lacks a month; give a month, a month and a day, or a year"),
    (lambda: Clause("go", "a", adverbials=(Date(2000, 13),)), "adverbials[0]: no calendar has"),
    (lambda: Date(2**70), "no calendar has year "),
    (lambda: NounPhrase("cat", stutter=10**15), "stutter"),
    (lambda: Clause("go", "a", ellipsis=("subj",)), "Clause: ellipsis cannot be 'subj'; did you"),  # type: ignore[arg-type]
]


@pytest.mark.parametrize(("make", "message"), UNSAYABLE, ids=[row[1][:40] for row in UNSAYABLE])
def test_what_cannot_be_said_from_python(make: Callable[[], Any], message: str) -> None:
    """When it is made or when it is said, and then with the path."""
    with pytest.raises(SpecificationError) as caught:
        REALIZER.realize(make())
    check_message(caught.value)
    assert UNFORESEEN not in str(caught.value)
    told = str(caught.value)
    # A feature may be named with its path, or when the value is made with its type.
    path = message.partition(":")[0]
    assert message in told
    assert told.startswith(message) or re.match(rf"[A-Z]\w+: {re.escape(path)}", told), told


@pytest.mark.parametrize("times", [200, 5000])
@pytest.mark.parametrize(
    "level",
    [
        lambda x: NounPhrase("a", possessor=x),
        lambda x: NounPhrase("a", modifiers=(x,)),
        lambda x: NounPhrase("a", relative=Relative(Clause("see", object=x))),
        lambda x: AdjectivePhrase("big", complement=x),
        lambda x: Coordination((x, "a")),
        lambda x: Text((x,)),
        lambda x: Text((Cased(NounPhrase("a", apposition=x)),)),
        lambda x: PrepositionalPhrase("in", x),
        lambda x: Clause("see", "a", object=x),
        lambda x: Clause("see", x),
        lambda x: Clause("say", "a", quotation=Quotation(Sentence(x))),
        lambda x: Clause("go", mood="interrogative", question=Question(x)),
        lambda x: (x,),
        lambda x: [x],
        lambda x: {"noun": x},
    ],
    ids=[
        *("possessor", "modifiers", "relative", "complement", "coordination", "text", "cased"),
        *("prepositional", "object", "subject", "quotation", "question", "tuple", "list", "dict"),
    ],
)
def test_deep_python_values(level: Callable[[Any], Any], times: int) -> None:
    """They are said, or refused: even those that Python itself cannot print."""
    value: Any = NounPhrase("a")
    for _ in range(times):
        value = level(value)
    for spec in (value, Clause("see", "a", object=value), Sentence(value)):
        text = heard(spec)
        assert len(text) < 300 if text.startswith("refused: ") else clean(text)
