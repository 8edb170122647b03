"""What the realizer is asked to say: immutable, typed deep syntax (Reiter & Dale 2000, ch. 6).

Order, agreement, inflection, pronoun forms and punctuation are the realizer's business: nothing
here is a finished string but the words themselves. Every value can be shared and realized any
number of times. A feature that does not exist, or a value that it cannot have, is an error as
soon as it is written. Terms are those of Huddleston & Pullum 2002.
"""

# No `from __future__ import annotations` here: typing compiles each annotation of a named tuple
# that is a string, at every start.

from typing import Literal, NamedTuple, TypeAlias

from personage_lite.realizer.features import checked
from personage_lite.realizer.numerals import Date

Number: TypeAlias = Literal["singular", "plural"]
Gender: TypeAlias = Literal["masculine", "feminine", "neuter"]
Person: TypeAlias = Literal[1, 2, 3]
Case: TypeAlias = Literal["subjective", "objective", "possessive", "independent", "reflexive"]
Tense: TypeAlias = Literal["present", "past", "future"]
Degree: TypeAlias = Literal["positive", "comparative", "superlative", "equative"]
Mood: TypeAlias = Literal[
    "declarative", "interrogative", "imperative", "exclamative", "subjunctive"
]
Form: TypeAlias = Literal[
    "finite", "infinitive", "bare_infinitive", "present_participle", "past_participle"
]
Role: TypeAlias = Literal["subject", "indirect_object", "object", "complement", "adverbial"]
Elided: TypeAlias = Literal["subject", "auxiliary", "verb", "main_verb", "predicate"]


@checked(degree=Degree)
class AdjectivePhrase(NamedTuple):
    """An adjective or an adverb, graded: "really curious", "braver than a lion", "as brave".

    `compared` is what stands after "than" or "as"; `complement` what the adjective governs:
    "proud of her", "eager to go".
    """

    adjective: str
    adverbs: tuple[str, ...] = ()
    degree: Degree = "positive"
    compared: "Phrase | None" = None
    complement: "Phrase | None" = None


@checked(number=Number, gender=Gender, person=Person)
class NounPhrase(NamedTuple):
    """A noun or a name, or the pronoun that stands for it.

    `determiner` agrees ("this" and "these", "many" and "much"); "a" becomes "an" by sound.
    `predeterminer` stands before it ("all the cats"), `ordinal` and `cardinal` after it, as words
    or `figures`; a cardinal decides the number. Adjectives are put in the usual order. `modifiers`
    follow the noun, then `apposition` between commas, then `relative`. A possessor too heavy for
    "'s" follows with "of"; with "a" it makes "a friend of hers". An empty noun leaves the
    determiner, adjective or possessor alone: "these", "the brave", "hers".

    `pronoun` says its pronoun, `reflexive` the one in -self; a pronoun that is the object and
    denotes the same `entity` as the subject is reflexive by itself. `entity` names whom the
    phrase denotes; it is not said, and the noun of an entity is never inflected. `stutter`
    repeats the name's first letters that many times ("Al-Al-Alice"); `interruption` is a
    hesitation after the phrase: "Alice, um, is late".
    """

    noun: str
    determiner: str = ""
    adjectives: "tuple[Phrase, ...]" = ()
    possessor: "Phrase | None" = None
    number: Number = "singular"
    gender: Gender = "neuter"
    person: Person = 3
    animate: bool = False
    pronoun: bool = False
    relative: "Relative | None" = None
    stutter: int = 0
    entity: str = ""
    reflexive: bool = False
    predeterminer: str = ""
    cardinal: int | float | None = None
    ordinal: int | None = None
    figures: bool = False
    modifiers: "tuple[Phrase, ...]" = ()
    apposition: "Phrase | None" = None
    interruption: str = ""


@checked(role=Role)
class Relative(NamedTuple):
    """A relative clause, which lacks what the relative pronoun stands for.

    `role` is what the pronoun is in it: "who came" (subject), "whom she saw" (object), "to whom
    she spoke" (adverbial, with its `preposition`; `stranded`: "whom she spoke to"), "where she
    lives" (adverbial, with `word` "where"). With `possessed` it is the owner of what has that
    role: "whose cat sleeps". Without `restrictive` it stands between commas. `word` replaces the
    pronoun that would be chosen, and `omitted` leaves it out: "the cake she ate". Several clauses
    can be joined: "who sells hats and drinks tea".
    """

    clause: "Clause | Coordination"
    role: Role = "subject"
    restrictive: bool = False
    possessed: bool = False
    preposition: str = ""
    stranded: bool = False
    word: str = ""
    omitted: bool = False


@checked(case=Case)
class Cased(NamedTuple):
    """A noun phrase inside a text, in the case that its place asks for."""

    phrase: NounPhrase
    case: Case = "objective"


@checked()
class Text(NamedTuple):
    """Fixed words with phrases between them: "a present for", [her], "birthday".

    `contracted` shortens what follows a pronoun that is a subject among them: "that she's late".
    """

    parts: "tuple[Cased | Phrase, ...]"
    contracted: bool = False


@checked()
class PrepositionalPhrase(NamedTuple):
    """A preposition and its object: "by the cards", "without asking", "with her"."""

    preposition: str
    object: "Phrase"


@checked()
class Numeral(NamedTuple):
    """A number by itself, as words or figures: "forty-two", "42", "first"."""

    value: int | float
    ordinal: bool = False
    figures: bool = False


@checked()
class Coordination(NamedTuple):
    """Several phrases or clauses joined: "kind, curious and brave".

    `conjunction` "," adds by comma alone; `correlative` puts the other half of a pair before the
    first: "both … and", "either … or", "neither … nor", "not only … but also". Owners have a
    thing in common ("Alice and Bill's house") unless `separate` ("Alice's and Bill's"). `relative`
    is a relative clause about all of them: "the King and the Queen, who are late".
    """

    items: "tuple[Phrase, ...]"
    conjunction: str = "and"
    correlative: bool = False
    separate: bool = False
    relative: "Relative | None" = None


@checked(role=Role)
class Question(NamedTuple):
    """What a question asks for: words with "who", "what", "how", and their role in the clause.

    `preposition` is left at the end: "Who did she talk to?"; for "To whom …" the words are a
    prepositional phrase.
    """

    phrase: "Phrase"
    role: Role = "subject"
    preposition: str = ""


@checked()
class Quotation(NamedTuple):
    """Direct speech; `first` puts it before its clause, `inverted` the verb before the subject.

    "“I am late,” says the White Rabbit." With `first`, `rest` is what goes on after the clause:
    "“Well,” says Alice, “I am not.”"
    """

    speech: "str | Sentence"
    first: bool = False
    inverted: bool = False
    rest: "str | Sentence" = ""


@checked()
class Subordinate(NamedTuple):
    """An adverbial clause and its conjunction: "because she has to know", "before leaving".

    `inverted` puts the auxiliary first, in place of a conjunction: "had she known".
    """

    conjunction: str
    clause: "Clause"
    fronted: bool = False
    inverted: bool = False


@checked(tense=Tense, mood=Mood, form=Form, ellipsis=tuple[Elided, ...])
class Clause(NamedTuple):
    """A verb with its arguments, before word order and inflection.

    `adverbs` stand in the middle ("she often shouts"); `emphasizers` too, but never inside a
    negation ("she really isn't patient"). `preposed` phrases stand before the subject, `asides`
    between commas at the end. `interruption` is a hesitation in the middle, between commas.

    `modal` is any auxiliary or what works like one: "can", "ought to", "have to", "be going to".
    `agent` is who acts in a passive. `negator` may be "never". `backshifted` turns the tense of
    reported speech: "(she said that) she was late". `existential` puts "there" before the verb.

    In the interrogative mood, `question` says what is asked for; without one it is a yes/no
    question. In the exclamative mood the complement comes first, or what `question` names: "how
    curious she is", "what eyes she has". The subjunctive is "(that) she go" and "(if) I were
    you". As a phrase inside another clause, a clause is a content clause ("that she is kind",
    "who came") or has one of the non-finite forms ("to go", "running"). `emphatic` says "does go".

    `ellipsis` leaves out what was said before: the subject ("and runs"), subject and first
    auxiliary ("and drunk"), the verb group ("and the Hatter tea"), the main verb and what follows
    it ("she could have"), or all that follows the first auxiliary ("she does"). `truncated`
    breaks off after the verb. `contracted` shortens what can be shortened: "she's", "isn't".
    """

    verb: str
    subject: "Phrase | None" = None
    particle: str = ""
    indirect_object: "Phrase | None" = None
    object: "Phrase | None" = None
    complement: "Phrase | None" = None
    adverbials: "tuple[Phrase, ...]" = ()
    asides: "tuple[Phrase, ...]" = ()
    adverbs: tuple[str, ...] = ()
    emphasizers: tuple[str, ...] = ()
    interruption: str = ""
    quotation: str | Quotation = ""
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
    mood: Mood = "declarative"
    form: Form = "finite"
    question: Question | None = None
    existential: bool = False
    agent: "Phrase | None" = None
    preposed: "tuple[Phrase, ...]" = ()
    complementizer: str = ""
    backshifted: bool = False
    ellipsis: tuple[Elided, ...] = ()
    emphatic: bool = False


Phrase: TypeAlias = (
    str
    | AdjectivePhrase
    | NounPhrase
    | PrepositionalPhrase
    | Numeral
    | Date
    | Text
    | Coordination
    | Clause
)


@checked()
class Embedded(NamedTuple):
    """A clause inside a fixed main clause: "I think" (that) "she is kind".

    `inner_tag` says that it takes the inner clause's tag question: "I think she's kind, isn't
    she?". Without, it takes none that agrees, since a fixed main clause has no verb to ask with.
    """

    lead: Text
    clause: Clause
    complementizer: str = ""
    inner_tag: bool = True


@checked()
class Joined(NamedTuple):
    """A clause joined to what comes before it; with `shared_subject` it leaves its own unsaid."""

    conjunction: str
    body: Clause | Embedded
    shared_subject: bool = False


@checked()
class Opener(NamedTuple):
    """Words before a sentence and the mark after them: "Oh" "," or "I see" "!"."""

    text: str
    mark: str = ","


@checked()
class Sentence(NamedTuple):
    """One sentence: coordinated clauses and all that speech puts around them.

    A body that is neither a clause nor clauses joined is a fragment: words that stand for a
    sentence by themselves. `tag` is "auto" for a tag question that agrees ("isn't she?") or the
    words of a fixed one; a fragment takes none that agrees. `terminal` is the end mark; none
    given is "?" for a question, "!" for an exclamative and "." for all else.

    `false_start` breaks off after the verb and starts again, with a pronoun for whom it has
    named. `hesitation` is what is said there ("Alice is… um, she is kind"); without a false
    start the sentence breaks off after its subject ("Alice… um, she is kind"), and before one
    that is a pronoun, or has none, it begins with the hesitation ("Um… she is kind").
    """

    body: Embedded | Phrase
    joined: tuple[Joined, ...] = ()
    openers: tuple[Opener, ...] = ()
    connective: str = ""
    vocative: str = ""
    afterthought: str = ""
    tag: str = ""
    terminal: str = ""
    false_start: bool = False
    hesitation: str = ""
