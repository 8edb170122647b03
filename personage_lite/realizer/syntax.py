"""Deep syntax to a row of words: order, agreement, auxiliaries, negation, pronoun forms."""

from __future__ import annotations

from personage_lite.realizer.grammar import Grammar
from personage_lite.realizer.morphology import pluralize, stutter
from personage_lite.realizer.orthography import INDEFINITE
from personage_lite.realizer.specification import (
    AdjectivePhrase,
    Case,
    Cased,
    Clause,
    Coordination,
    Embedded,
    NounPhrase,
    Phrase,
    Subordinate,
    Text,
)
from personage_lite.realizer.verb_group import NOBODY, VerbGroup, verb_group


def pronoun_row(phrase: NounPhrase) -> str:
    """Return which row of the pronoun table a noun phrase takes."""
    if phrase.person == 1:
        return "first plural" if phrase.number == "plural" else "first singular"
    if phrase.person == 2:
        return "second plural" if phrase.number == "plural" else "second singular"
    return "third plural" if phrase.number == "plural" else phrase.gender


class Syntax:
    """Emits the words of phrases and clauses in order; holds nothing but the grammar's data."""

    __slots__ = ("grammar",)

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar

    # Phrases

    def noun_phrase(self, out: list[str], phrase: NounPhrase, case: Case = "objective") -> None:
        """Add a noun phrase or its pronoun."""
        if phrase.pronoun:
            out.append(self.grammar.pronouns[pronoun_row(phrase)][case])
            return
        if case == "reflexive":
            out.append(self.grammar.pronouns[pronoun_row(phrase)]["reflexive"])
            return
        if phrase.possessor is not None:
            self.noun_phrase(out, phrase.possessor, "possessive")
        elif phrase.determiner:
            out.append(INDEFINITE if phrase.determiner in ("a", "an") else phrase.determiner)
        for adjective in phrase.adjectives:
            self.phrase(out, adjective)
        noun = phrase.noun
        if phrase.number == "plural" and not phrase.entity:
            noun = pluralize(noun, self.grammar)
        out.append(stutter(noun, phrase.stutter) if phrase.stutter else noun)
        if case == "possessive":
            plural = phrase.number == "plural" and noun.endswith("s")
            out[-1] += "'" if plural else "'s"
        if phrase.relative is not None:
            self.relative(out, phrase)

    def relative(self, out: list[str], phrase: NounPhrase) -> None:
        """Add "who …"; between commas unless it is restrictive."""
        assert phrase.relative is not None
        mark = [] if phrase.restrictive else [","]
        if phrase.animate:
            kind = "animate"
        else:
            kind = "inanimate_restrictive" if phrase.restrictive else "inanimate"
        out.extend(mark)
        out.append(self.grammar.relative_pronouns[kind])
        bare = phrase._replace(relative=None, pronoun=False)
        clause = phrase.relative._replace(subject=bare)
        self.predicate(out, clause, after_pronoun=False)
        # Nothing can stand before "who", so all its subordinate clauses follow.
        for subordinate in clause.subordinates:
            self._subordinate(out, clause, subordinate)
        out.extend(mark)

    def phrase(self, out: list[str], phrase: Phrase, case: Case = "objective") -> None:
        """Add any phrase."""
        if isinstance(phrase, Text):
            for part in phrase.parts:
                if isinstance(part, Cased):
                    self.noun_phrase(out, part.phrase, part.case)
                else:
                    out.append(part)
        elif isinstance(phrase, AdjectivePhrase):
            out.extend(phrase.adverbs)
            out.append(phrase.adjective)
        elif isinstance(phrase, NounPhrase):
            self.noun_phrase(out, phrase, case)
        else:
            self._coordination(out, phrase, case)

    def _coordination(self, out: list[str], phrase: Coordination, case: Case) -> None:
        last = len(phrase.items) - 1
        for index, item in enumerate(phrase.items):
            if index:
                if index < last or phrase.conjunction == ",":
                    out.append(",")
                else:
                    out.append(phrase.conjunction)
            self.phrase(out, item, case)

    # Clauses

    def clause(self, out: list[str], clause: Clause, shared_subject: bool = False) -> None:
        """Add a finite clause with its subordinate clauses before and after it."""
        for subordinate in clause.subordinates:
            if subordinate.fronted:
                out.append(subordinate.conjunction)
                self.clause(out, subordinate.clause)
                out.append(",")
        subject = clause.subject
        if clause.degree and clause.complement is not None:
            out.append(self.grammar.degree_word)
            self.phrase(out, clause.complement)
        if subject is not None and not shared_subject:
            self.noun_phrase(out, subject, "subjective")
        pronoun = subject is not None and subject.pronoun and not shared_subject
        self.predicate(out, clause, after_pronoun=pronoun)
        for subordinate in clause.subordinates:
            if not subordinate.fronted:
                self._subordinate(out, clause, subordinate)

    def _subordinate(self, out: list[str], host: Clause, subordinate: Subordinate) -> None:
        """Add a subordinate clause that follows its host; a comma parts it from speech."""
        if host.quotation:
            out.append(",")
        out.append(subordinate.conjunction)
        self.clause(out, subordinate.clause)

    def predicate(self, out: list[str], clause: Clause, after_pronoun: bool) -> None:
        """Add all of a clause that follows its subject, but for subordinate clauses."""
        negator = clause.negator if clause.negated else ""
        plain_not = negator == "not"
        group = verb_group(clause, self.grammar, emphatic=plain_not)
        if clause.negated and clause.emphasizers:
            out.extend(clause.emphasizers)
            after_pronoun = False
        self._finite_words(out, clause, group, negator, after_pronoun)
        middle = [] if clause.negated else list(clause.emphasizers)
        middle.extend(clause.adverbs)
        if negator and not plain_not:
            middle.insert(0, negator)
        if clause.interruption:
            middle.extend([",", clause.interruption, ","])
        if group.auxiliary:
            out.extend(middle)
        else:
            finite = out.pop()
            out.extend(middle)
            out.append(finite)
        out.extend(group.rest)
        if clause.truncated:
            return
        self._arguments(out, clause)

    def _finite_words(
        self, out: list[str], clause: Clause, group: VerbGroup, negator: str, after_pronoun: bool
    ) -> None:
        """Add the finite verb and "not", shortened where the clause and its place allow it."""
        grammar = self.grammar
        short: str | None = None
        if (
            clause.contracted
            and after_pronoun
            and group.auxiliary
            and not clause.interruption
            and not clause.truncated
            and not clause.degree
            # Nothing is shortened at a clause's end: "Yes, she is".
            and (group.rest or clause.complement is not None or clause.adverbials)
        ):
            short = grammar.contractions.get(group.finite)
        if negator != "not":
            if short:
                out[-1] += short
            else:
                out.append(group.finite)
        elif clause.contracted and group.finite in grammar.negative_contractions:
            out.append(grammar.negative_contractions[group.finite])
        elif short:
            out[-1] += short
            out.append(negator)
        elif group.finite in grammar.fused_negatives:
            out.append(grammar.fused_negatives[group.finite])
        else:
            out.extend((group.finite, negator))

    def _arguments(self, out: list[str], clause: Clause) -> None:
        particle_last = (
            clause.particle
            and _is_pronoun(clause.object)
            and clause.particle not in self.grammar.prepositions
        )
        if clause.particle and not particle_last:
            out.append(clause.particle)
        if clause.indirect_object is not None:
            self.phrase(out, clause.indirect_object)
        if clause.object is not None:
            self.phrase(out, clause.object)
        if particle_last:
            out.append(clause.particle)
        if clause.complement is not None and not clause.degree:
            self.phrase(out, clause.complement)
        for adverbial in clause.adverbials:
            self.phrase(out, adverbial)
        for aside in clause.asides:
            out.append(",")
            self.phrase(out, aside)
            out.append(",")
        if clause.quotation:
            out.extend((",", f"“{clause.quotation}”"))

    def body(
        self, out: list[str], body: Clause | Embedded | Text, shared_subject: bool = False
    ) -> None:
        """Add a clause, a main clause with the clause inside it, or the words of a fragment."""
        if isinstance(body, Embedded):
            self.phrase(out, body.lead)
            if body.complementizer:
                out.append(body.complementizer)
            self.clause(out, body.clause)
        elif isinstance(body, Text):
            self.phrase(out, body)
        else:
            self.clause(out, body, shared_subject)

    def tag(self, out: list[str], clause: Clause) -> None:
        """Add the tag question that agrees with a clause: "isn't she?", "did they?"."""
        subject = clause.subject or NOBODY
        if subject.noun in self.grammar.plural_in_tags and not subject.pronoun:
            subject = subject._replace(number="plural")
            clause = clause._replace(subject=subject)
        finite = verb_group(clause, self.grammar, emphatic=True).finite
        if not self._sounds_negative(clause):
            finite = (
                self.grammar.tag_negatives.get(finite)
                or self.grammar.negative_contractions.get(finite)
                or finite
            )
        out.extend((",", finite))
        self.noun_phrase(out, subject._replace(pronoun=True, relative=None), "subjective")

    def _sounds_negative(self, clause: Clause) -> bool:
        """Whether a tag must be positive: "she never runs, does she?", "… nobody, does she?"."""
        if clause.negated or self._negative_adverbs(clause.adverbs):
            return True
        return (
            self._negative(clause.subject)
            or self._negative(clause.indirect_object)
            or self._negative(clause.object)
            or self._negative(clause.complement)
        )

    def _negative(self, phrase: Phrase | None) -> bool:
        """Whether a phrase begins with a negator: "nobody", "no friends", "hardly curious"."""
        if phrase is None:
            return False
        if isinstance(phrase, AdjectivePhrase):
            return self._negative_adverbs(phrase.adverbs)
        if isinstance(phrase, Coordination):
            return self._negative(phrase.items[0])
        if isinstance(phrase, Text):
            part = phrase.parts[0]
            if isinstance(part, Cased):
                return self._negative(part.phrase)
            first = part
        else:
            if phrase.pronoun or phrase.possessor is not None:
                return not phrase.pronoun and self._negative(phrase.possessor)
            first = phrase.determiner or phrase.noun
        word = first.split(" ", 1)[0]
        return word in self.grammar.negators and not first.startswith(self.grammar.not_negative)

    def _negative_adverbs(self, adverbs: tuple[str, ...]) -> bool:
        negators = self.grammar.negators
        return any(
            not negators.isdisjoint(adverb.split())
            for adverb in adverbs
            if adverb not in self.grammar.not_negative
        )


def _is_pronoun(phrase: Phrase | None) -> bool:
    if isinstance(phrase, NounPhrase):
        return phrase.pronoun
    if isinstance(phrase, Text) and len(phrase.parts) == 1:
        part = phrase.parts[0]
        return isinstance(part, Cased) and (part.phrase.pronoun or part.case == "reflexive")
    return False
