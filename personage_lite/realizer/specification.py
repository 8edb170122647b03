"""What the realizer is asked to say: immutable, typed deep syntax (Reiter & Dale 2000, ch. 6).

Order, agreement, inflection, pronoun forms and punctuation are the realizer's business: nothing
here is a finished string but the words themselves. Every value can be shared and realized any
number of times.
"""

from __future__ import annotations

from typing import Literal, NamedTuple, TypeAlias

Number: TypeAlias = Literal["singular", "plural"]
Gender: TypeAlias = Literal["masculine", "feminine", "neuter"]
Person: TypeAlias = Literal[1, 2, 3]
Case: TypeAlias = Literal["subjective", "objective", "possessive", "reflexive"]
Tense: TypeAlias = Literal["present", "past", "future"]


class AdjectivePhrase(NamedTuple):
    """An adjective with the degree adverbs before it: "really, really curious"."""

    adjective: str
    adverbs: tuple[str, ...] = ()


class NounPhrase(NamedTuple):
    """A noun or a name, or the pronoun that stands for it.

    `entity` names whom it denotes; it is not said, only carried for those who choose referring
    expressions. `determiner` "a" becomes "an" by sound. `stutter` repeats the name's first
    letters that many times: "Al-Al-Alice". `relative` is a clause without a subject (or, for a
    non-restrictive one, an aside between commas) about this phrase; a pronoun takes none.
    """

    noun: str
    determiner: str = ""
    adjectives: tuple[AdjectivePhrase, ...] = ()
    possessor: NounPhrase | None = None
    number: Number = "singular"
    gender: Gender = "neuter"
    person: Person = 3
    animate: bool = False
    pronoun: bool = False
    relative: Clause | None = None
    restrictive: bool = False
    stutter: int = 0
    entity: str = ""


class Cased(NamedTuple):
    """A noun phrase inside a text, in the case that its place asks for."""

    phrase: NounPhrase
    case: Case = "objective"


class Text(NamedTuple):
    """Fixed words with noun phrases between them: "a present for", [her], "birthday"."""

    parts: tuple[str | Cased, ...]


class Coordination(NamedTuple):
    """Several phrases joined: "kind, curious and brave"; conjunction "," adds by comma alone."""

    items: tuple[Phrase, ...]
    conjunction: str = "and"


Phrase: TypeAlias = "AdjectivePhrase | NounPhrase | Text | Coordination"


class Subordinate(NamedTuple):
    """An adverbial clause and its conjunction: "because she has to know"."""

    conjunction: str
    clause: Clause
    fronted: bool = False


class Clause(NamedTuple):
    """A verb with its arguments, before word order and inflection.

    `adverbs` stand in the middle ("she often shouts"); `emphasizers` too, but never inside a
    negation ("she really isn't patient"). `interruption` is a hesitation in the same place,
    between commas. `quotation` is direct speech. `truncated` stops after the verb. With
    `degree` the complement comes first, after "how": "how curious she is".
    """

    verb: str
    subject: NounPhrase | None = None
    particle: str = ""
    indirect_object: Phrase | None = None
    object: Phrase | None = None
    complement: Phrase | None = None
    adverbials: tuple[Phrase, ...] = ()
    asides: tuple[Phrase, ...] = ()
    adverbs: tuple[str, ...] = ()
    emphasizers: tuple[str, ...] = ()
    interruption: str = ""
    quotation: str = ""
    subordinates: tuple[Subordinate, ...] = ()
    tense: Tense = "present"
    modal: str = ""
    perfect: bool = False
    progressive: bool = False
    passive: bool = False
    negated: bool = False
    negator: str = "not"
    contracted: bool = False
    truncated: bool = False
    degree: bool = False


class Embedded(NamedTuple):
    """A clause inside a fixed main clause: "I think" (that) "she is kind".

    `inner_tag` says that it takes the inner clause's tag question: "I think she's kind, isn't
    she?". Without, it takes none that agrees, since a fixed main clause has no verb to ask with.
    """

    lead: Text
    clause: Clause
    complementizer: str = ""
    inner_tag: bool = True


class Joined(NamedTuple):
    """A clause joined to what comes before it; with `shared_subject` it leaves its own unsaid."""

    conjunction: str
    body: Clause | Embedded
    shared_subject: bool = False


class Opener(NamedTuple):
    """Words before a sentence and the mark after them: "Oh" "," or "I see" "!"."""

    text: str
    mark: str = ","


class Sentence(NamedTuple):
    """One sentence: coordinated clauses and all that speech puts around them.

    A body that is a text is a fragment: words that stand for a sentence by themselves.
    `tag` is "auto" for a tag question that agrees ("isn't she?") or the words of a fixed one; a
    fragment takes none that agrees.
    `terminal` is ".", "!" or "?". `false_start` breaks off after the verb and starts again.
    """

    body: Clause | Embedded | Text
    joined: tuple[Joined, ...] = ()
    openers: tuple[Opener, ...] = ()
    connective: str = ""
    vocative: str = ""
    afterthought: str = ""
    tag: str = ""
    terminal: str = "."
    false_start: bool = False
