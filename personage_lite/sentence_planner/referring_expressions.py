"""Referring expressions: full name, short name, description or pronoun, never ambiguous.

A pronoun is allowed where nobody else it could mean was mentioned in this sentence or the one
before; or where it is a subject that goes on with the subject of the clause before (Grosz,
Joshi & Weinstein 1995; Reiter & Dale 2000, section 5.4).
"""

from __future__ import annotations

from typing import Final

from personage_lite.facts import Character, Entity, entity_of
from personage_lite.operators import Turn
from personage_lite.plan import ClausePlan, Made
from personage_lite.realizer.specification import Cased, Clause, NounPhrase, Phrase, Text

STAGE: Final = "referring_expressions"
# Across turns a pronoun is rarer than within one.
_ACROSS_TURNS: Final = 0.6
_DESCRIPTION: Final = 0.005
_SHORT_AGAIN: Final = 0.85


class ReferringExpressions:
    """Chooses the forms of one utterance's mentions in the order in which they are heard."""

    def __init__(self, character: Character, turn: Turn) -> None:
        state = turn.state
        self._entities = character.entities
        self._topic = character.entity.id
        self._going_on = state.topic if state.topic == character.entity.id else ""
        self._pronominalization = turn.parameters["pronominalization"]
        self._draws = turn.draws
        self._known = state.introduced
        # Whom the sentence before, and this one so far, have mentioned.
        self._before: frozenset[str] = state.focus
        self._here: list[str] = []
        # Of those, who was named only as an owner: "the Rabbit's house".
        self._owners: set[str] = set()
        self._said: set[str] = set()
        self._pronouns: set[str] = set()
        self._subject = state.focus_subject
        self._clause_subject = ""
        self._contracted = False
        # The part ("the Moon's rings") that the last clause of this sentence was about.
        self._part: NounPhrase | None = None
        self._turn_before = True
        self._count = 0
        self.decisions: list[Made] = []

    @property
    def focus(self) -> frozenset[str]:
        """Whom the last sentence mentioned."""
        return self._before

    @property
    def focus_subject(self) -> str:
        """Whom the last clause was about."""
        return self._subject

    @property
    def said(self) -> frozenset[str]:
        """Whom the utterance has named."""
        return frozenset(self._said)

    # Choosing

    def _has_rivals(self, entity: Entity, objective: bool) -> bool:
        """Whether the pronoun could mean somebody else who was mentioned lately.

        An object is never its clause's subject: that would be "herself".
        """
        own = entity.phrase
        # Who was named in this sentence is nearer than all of the sentence before.
        near = self._here if entity.id in self._here else (*self._here, *self._before)
        for key in near:
            if objective and key == self._clause_subject:
                continue
            other = self._entities[key].phrase
            alike = own.number == "plural" or other.gender == own.gender
            if alike and other.number == own.number and key != entity.id:
                return True
        return False

    def _may_be_pronoun(self, entity: Entity, subjective: bool, objective: bool) -> bool:
        if entity.id not in self._here and entity.id not in self._before:
            return False
        # Across turns only the one who is talked about stays clear, and only as a subject.
        resumed = entity.id == self._going_on and subjective
        if self._turn_before and entity.id not in self._here and not resumed:
            return False
        if subjective and entity.id in self._owners and entity.id != self._subject:
            return False  # not "in the Rabbit's house, and he …"
        # "It" is taken for the last thing named, whichever was the subject.
        neuter = entity.phrase.gender == "neuter" and entity.phrase.number == "singular"
        if subjective and self._subject == entity.id and not neuter:
            return True
        # He who is talked about, and was the last clause's subject, is meant by "him" as well.
        central = entity.id == self._subject == self._topic and not self._turn_before
        if objective and central and not neuter:
            return entity.id != self._clause_subject
        return not self._has_rivals(entity, objective)

    def form(
        self,
        phrase: NounPhrase,
        subjective: bool,
        bound: bool = False,
        possessive: bool = False,
        objective: bool = False,
    ) -> NounPhrase:
        """Return a mention in the form in which it is said here."""
        entity = self._entities.get(phrase.entity)
        if entity is None:
            return phrase
        if bound:
            return phrase._replace(pronoun=True)
        chosen = self._form(entity, phrase.stutter > 0, subjective, objective)
        if possessive and not chosen.pronoun:
            chosen = entity.short_phrase  # "the Queen's guests", not "the Queen of Hearts's"
        if phrase.stutter and not chosen.pronoun:
            chosen = chosen._replace(stutter=phrase.stutter)
        if phrase.relative is not None:
            chosen = chosen._replace(relative=phrase.relative)
        if possessive and entity.id not in self._here:
            self._owners.add(entity.id)
        elif not possessive:
            self._owners.discard(entity.id)
        self._here.append(entity.id)
        self._said.add(entity.id)
        return chosen

    def _form(self, entity: Entity, named: bool, subjective: bool, objective: bool) -> NounPhrase:
        self._count += 1
        if not named and self._may_be_pronoun(entity, subjective, objective):
            probability = self._pronominalization
            if entity.id in self._here or entity.id in self._pronouns:
                # Within a sentence, and where it was a pronoun before: no way back to the name.
                probability = 1.0
            elif self._turn_before:
                probability *= _ACROSS_TURNS
            draw = 0.0
            if probability < 1.0:
                draw = self._draws.uniform(f"pronominalization/{self._count}")
            applied = draw < probability
            self.decisions.append(
                (
                    "pronominalization",
                    STAGE,
                    probability,
                    draw,
                    "applied" if applied else "not_drawn",
                    f"mention {self._count}",
                    entity.name if applied else "",
                    "pronoun" if applied else "",
                )
            )
            if applied:
                self._pronouns.add(entity.id)
                return entity.pronoun
        return self._name(entity, named, subjective)

    def _name(self, entity: Entity, named: bool, subjective: bool = True) -> NounPhrase:
        """Return the full name at the first mention, then a shorter one or a description."""
        if entity.id not in self._said and entity.id not in self._known:
            return entity.phrase
        draw = self._draws.uniform(f"name/{self._count}")
        if entity.id in self._said:
            able = [] if named or not subjective else self._descriptions(entity)
            if able and draw < _DESCRIPTION:
                return able[int(draw / _DESCRIPTION * len(able))]
            return entity.short_phrase
        return entity.short_phrase if draw < _SHORT_AGAIN else entity.phrase

    def _descriptions(self, entity: Entity) -> list[NounPhrase]:
        """Return the descriptions that fit nobody else who was mentioned lately."""
        others = [self._entities[key] for key in {*self._here, *self._before} if key != entity.id]
        taken = {noun for other in others for noun in other.nouns}
        return [
            phrase
            for noun, phrase in zip(entity.nouns, entity.descriptions, strict=True)
            if noun not in taken
        ]

    # Walking through what is said

    def fragment(self, fragment: Text) -> None:
        """Note whom a sentence without clauses mentions."""
        self._here = [part.phrase.entity for part in fragment.parts if isinstance(part, Cased)]
        self._said.update(self._here)
        self._end()

    def clauses(self, plans: tuple[ClausePlan, ...], contracted: bool) -> tuple[ClausePlan, ...]:
        """Return the clauses of a sentence with their mentions in their forms.

        They are made anew here, `contracted` if that is so.
        """
        self._contracted = contracted
        self._here = []
        self._part = None
        resolved = self._clauses(plans)
        self._end()
        return resolved

    def _end(self) -> None:
        self._before = frozenset(self._here)
        self._turn_before = False

    def _clauses(self, plans: tuple[ClausePlan, ...]) -> tuple[ClausePlan, ...]:
        """Resolve clauses in spoken order: a relative clause comes before its host's verb."""
        done: list[ClausePlan] = []
        for index, plan in enumerate(plans):
            if plan.link == "relative":
                continue
            inner = plans[index + 1] if index + 1 < len(plans) else None
            if inner is not None and inner.link != "relative":
                inner = None
            frame = plan.frame
            if frame is not None and frame.lead is not None:
                self._clause_subject = ""
                lead = self._text(frame.lead)
                if lead is not frame.lead:
                    # "One thing to know about the Knave is that he …"
                    self._subject = self._here[-1]
                    frame = frame._replace(lead=lead)
            clause = plan.clause
            if clause.preposed:
                preposed = tuple([self._phrase(phrase) for phrase in clause.preposed])
                clause = clause._replace(preposed=preposed)
            subject = clause.subject
            if isinstance(subject, NounPhrase) and plan.link != "object_relative":
                subject = self._mention(subject, named=inner is not None)
            inside = None
            if inner is not None:
                inside = self._resolved(inner.clause, inner.clause.subject)
            clause = self._resolved(clause, subject)
            # Made anew, here and below, and unchecked: that is several times as fast.
            done.append(tuple.__new__(ClausePlan, (clause, *plan[1:8], frame, *plan[9:])))
            if inner is not None and inside is not None:
                done.append(ClausePlan(inside, *inner[1:]))
        return tuple(done)

    def _mention(self, subject: NounPhrase, named: bool) -> NounPhrase:
        """Resolve a clause's subject; `named` asks for a name, to hang a relative clause on."""
        if isinstance(subject.possessor, NounPhrase):
            if self._is_last_part(subject):
                return subject._replace(pronoun=True)  # "her rings are wide, but they're thin"
            self._part = subject
            # "Her rings" goes on with the subject before, but not from one turn to the next.
            goes_on = not self._turn_before
            owner = self.form(subject.possessor, subjective=goes_on, possessive=True)
            return subject._replace(possessor=owner)
        self._part = None
        if not subject.entity:
            return subject
        if not named or subject.stutter:
            return self.form(subject, subjective=True)
        self._here.append(subject.entity)
        name = self._name(self._entities[subject.entity], named=True)
        self._said.add(subject.entity)
        return name

    def _is_last_part(self, subject: NounPhrase) -> bool:
        """Whether the last clause was about this part, and "they" or "it" means nothing else."""
        if subject != self._part or entity_of(subject.possessor) != self._subject:
            return False
        others = [self._entities[key].phrase for key in self._here]
        if subject.number == "plural":
            return not any(other.number == "plural" for other in others)
        return not any(other.gender == "neuter" for other in others)

    def _resolved(self, clause: Clause, subject: Phrase | None) -> Clause:
        """Return a clause with its resolved subject, after resolving what follows that."""
        owner = ""
        if isinstance(subject, NounPhrase):
            owner = subject.entity or entity_of(subject.possessor)
        self._clause_subject = owner
        indirect, direct, complement = clause.indirect_object, clause.object, clause.complement
        if isinstance(indirect, Text):
            indirect = self._text(indirect, alone=len(indirect.parts) == 1)
        if isinstance(direct, Text):
            direct = self._text(direct, alone=len(direct.parts) == 1)
        if isinstance(complement, Text):
            complement = self._text(complement, alone=True)
        adverbials, asides = clause.adverbials, clause.asides
        if adverbials:
            adverbials = tuple([self._phrase(phrase) for phrase in adverbials])
        if asides:
            asides = tuple([self._phrase(phrase) for phrase in asides])
        self._subject = owner or self._subject
        head = (clause.verb, subject, clause.particle, indirect, direct, complement)
        tail = (self._contracted or clause.contracted, *clause[21:])
        return tuple.__new__(Clause, (*head, adverbials, asides, *clause[8:20], *tail))

    def _phrase(self, phrase: Phrase) -> Phrase:
        return self._text(phrase) if isinstance(phrase, Text) else phrase

    def _text(self, text: Text, alone: bool = False) -> Text:
        """Resolve the mentions among words.

        `alone` says that none of them is the subject's: so it is in a complement, and in an object
        that is nothing but a mention.
        """
        parts: list[Cased | Phrase] = []
        changed = embedded = False
        for part in text.parts:
            if isinstance(part, Cased) and part.phrase.entity and part.case != "reflexive":
                bound = part.phrase.entity == self._clause_subject
                embedded = embedded or part.case == "subjective"
                # A subject inside a clause does not go on with the clause before.
                objective = part.case == "objective" and not embedded
                # "Alice doesn't like standing close to her", if it was she who was talked about.
                objective = objective and (alone or part.phrase.entity == self._subject)
                form = self.form(part.phrase, False, bound, part.case == "possessive", objective)
                parts.append(tuple.__new__(Cased, (form, part.case)))
                changed = True
            else:
                parts.append(part)
        return tuple.__new__(Text, (tuple(parts), self._contracted)) if changed else text
