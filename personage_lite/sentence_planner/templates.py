"""Syntactic template selection: the frame each message is said in.

Source: Mairesse & Walker 2011, section 4.2 (self-references, syntactic complexity, template
polarity).
"""

from __future__ import annotations

from itertools import pairwise
from typing import Final

from personage_lite.facts import TELLING_KINDS, Character, Fact, entity_of
from personage_lite.lexicon import TOPIC, Lexicon, Template
from personage_lite.operators import OperatorDraws, Turn
from personage_lite.plan import STATES, ClausePlan, ContentPlan, Frame, Made, Status
from personage_lite.realizer.specification import AdjectivePhrase, Cased, NounPhrase, Text
from personage_lite.sentence_planner.fitting import suits
from personage_lite.sentence_planner.hedges import EMPHASIZED, HEDGED

STAGE: Final = "syntactic_template_selection"
# In this order a message is offered a template; the first that is drawn and fits is taken.
_PARAMETERS: Final = ("self_references", "template_polarity", "syntactic_complexity")
# Positive templates of no person are rarer than first-person ones.
_IMPERSONAL: Final = 0.12
# One frame after another tires: this many messages on, the next can stand.
_FRAMES_APART: Final = 3


class PlainClauses:
    """A character's facts as plain clauses, and the templates that fit each.

    The latter are found when they are first asked for, and kept: they depend on nothing else.
    """

    def __init__(self, character: Character, lexicon: Lexicon) -> None:
        self.clauses = plain_clauses(character, lexicon)
        self._following = following_clauses(character, self.clauses)
        self._topic = character.entity.id
        self._templates = lexicon.templates
        self._fitting: dict[tuple[str, str], tuple[Template, ...]] = {}

    def clause(self, fact: str, before: str) -> ClausePlan:
        """Return a fact's clause, as it is said right after the fact `before` it."""
        said = self._following.get((before, fact))
        return self.clauses[fact] if said is None else said

    def fitting(self, parameter: str, fact: str) -> tuple[Template, ...]:
        """Return a parameter's templates that a fact can be said in.

        One that names the character goes only with what is about them.
        """
        found = self._fitting.get((parameter, fact))
        if found is None:
            clause = self.clauses[fact]
            found = self._fitting[parameter, fact] = tuple(
                template
                for template in self._templates.get(parameter, ())
                if (TOPIC not in template.lead or entity_of(clause.clause.subject) == self._topic)
                and fits(template, clause)
            )
        return found


def plain_clauses(character: Character, lexicon: Lexicon) -> dict[str, ClausePlan]:
    """Return each fact of a character as a plain clause, with no frame around it."""
    return {
        fact.id: _plain_clause(fact, lexicon, character.topics[fact.topic].in_order)
        for fact in character.facts
    }


def following_clauses(
    character: Character, clauses: dict[str, ClausePlan]
) -> dict[tuple[str, str], ClausePlan]:
    """Return, by the fact before and the fact, the clauses that lean on what came just before."""
    return {
        (before.id, fact.id): clauses[fact.id]._replace(clause=fact.following, following=True)
        for before, fact in pairwise(character.facts)
        if fact.following is not None and fact.topic == before.topic
    }


def _plain_clause(fact: Fact, lexicon: Lexicon, story: bool) -> ClausePlan:
    complement = fact.clause.complement
    gradable = False
    if isinstance(complement, AdjectivePhrase):
        concept = lexicon.adjectives.get(complement.adjective)
        gradable = concept is None or concept.gradable
    return ClausePlan(
        clause=fact.clause,
        facts=(fact.id,),
        polarity=fact.polarity,
        strength=fact.strength,
        gradable=gradable,
        topic=fact.topic,
        # How somebody is stays true, also where it is told in order.
        story=story and fact.clause.verb not in STATES,
        feeling=fact.feeling,
    )


def lead_text(words: str, topic: NounPhrase) -> Text:
    """Return a template's or opener's words with the character in place of {topic}.

    >>> lead_text("you know {topic}", NounPhrase("Alice")).parts[0]
    'you know'
    """
    before, mention, after = words.partition(TOPIC)
    if not mention:
        return Text((words,))
    parts: list[str | Cased] = [before.strip()] if before.strip() else []
    parts.append(Cased(topic))
    for piece in after.replace(",", " , ").split("  "):
        parts.extend(word for word in (piece.strip(),) if word)
    return Text(tuple(parts))


def fits(template: Template, plan: ClausePlan) -> bool:
    """Whether a template of a clause's polarity is grammatical and true of it."""
    clause, form = plan.clause, template.form
    if template.hedging and form == "clause" and (plan.polarity == "neutral" or clause.negated):
        return False  # nobody has a view on a plain fact; one says "I don't think she is"
    quality = isinstance(clause.complement, AdjectivePhrase)
    if not suits(template.marker, plan):
        return False
    if form == "clause" and template.connotation == "good" and plan.polarity == "bad":
        return False  # nobody loves how somebody is left out
    if template.emphatic and quality and plan.strength != "extremely":
        return False  # much ado about a plain word
    if form == "exclamative":
        striking = plan.strength == "extremely" or plan.polarity != "neutral"
        return plan.gradable and not clause.negated and striking and plan.strength != "somewhat"
    if form == "someone_who":
        # Someone who is kind; not "someone who is a little girl", "who falls down a well".
        subject = clause.subject
        alone = isinstance(subject, NounPhrase) and subject.number == "singular"
        view = plan.gradable and not clause.negated and plan.polarity != "neutral"
        return alone and bool(entity_of(subject)) and view
    # "I love that she loves …", "it makes me so sad that he's sad" says the same word twice.
    said = clause.complement.adjective if isinstance(clause.complement, AdjectivePhrase) else ""
    if {clause.verb, said} & set(template.lead.split(" ")):
        return False
    return not clause.quotation


def framed(plan: ClausePlan, template: Template, lexicon: Lexicon, topic: NounPhrase) -> ClausePlan:
    """Return a clause in a template's frame."""
    if template.form == "someone_who":
        subject = plan.clause.subject
        animate = isinstance(subject, NounPhrase) and subject.animate
        who = lexicon.someone["animate" if animate else "inanimate"]
        lead: Text | None = Text((who,))
    else:
        lead = lead_text(template.lead, topic)
    frame = Frame(template.form, lead, template.complementizer, template.inner_tag)
    clause = plan.clause
    if template.form == "exclamative":
        clause = clause._replace(mood="exclamative")
    # What is sworn to is not hedged, nor stressed a second time.
    marks = plan.marks
    if template.emphatic:
        marks = (*marks, EMPHASIZED)
    if template.hedging:
        marks = (*marks, HEDGED)
    return ClausePlan(clause, *plan[1:8], frame, *plan[9:11], marks, *plan[12:14], plan.following)


def select_templates(
    plan: ContentPlan, character: Character, plain: PlainClauses, turn: Turn
) -> tuple[list[ClausePlan], list[Made], list[str]]:
    """Give each message its clause, plain or framed; frames stand some messages apart.

    Returns the clauses, the decisions, and the templates and parameters used.
    """
    clauses: list[ClausePlan] = []
    decisions: list[Made] = []
    used: list[str] = []
    topic_before = topic_told(character, turn)
    # What the utterance opens with is frame enough for the first message; and who somebody is
    # comes plain: nobody loves that "she's a little girl".
    opened = plan.rejection or plan.mitigation or plan.confirmation
    framed_before = opened or not topic_before
    since = _FRAMES_APART
    before = ""
    offers = []
    for name in _PARAMETERS:
        probability = turn.probability(name)
        if name == "template_polarity":
            probability *= _IMPERSONAL
        if probability > 0.0:
            offers.append((name, probability, turn.draws.numbers(name, len(plan.messages))))
    for index, message in enumerate(plan.messages):
        clause = plain.clause(message.fact.id, before if message.role == "assertion" else "")
        before = message.fact.id
        if message.role != "assertion":
            # What was said before is not doubted now, nor cried out.
            marks = (*clause.marks, HEDGED) if message.role == "recall" else clause.marks
            clause = clause._replace(role=message.role, marks=marks)
        target = f"message {index + 1}"
        # What opens a topic is said with its setting: "at the trial, …", not "I love how …".
        topic = character.topics[message.fact.topic]
        opens = topic.setting is not None and topic.name != topic_before
        topic_before = topic.name
        # "But", "so" and "because" want both their sides plain.
        beside = plan.links[max(index - 1, 0) : index + 1]
        bound = any(link.kind in TELLING_KINDS for link in beside)
        for name, probability, row in offers:
            draw = row[index]
            status: Status = "not_drawn"
            if draw < probability:
                status = "not_applicable"
                template = None
                free = not (framed_before or opens or bound or since < _FRAMES_APART)
                if free and message.role == "assertion":
                    able = plain.fitting(name, message.fact.id)
                    if plan.rejection:  # "I might be wrong, but …" is doubt enough
                        able = tuple(template for template in able if not template.hedging)
                    template = _choose(able, used, turn, turn.rng(f"{name}/{index}"))
                if template is not None:
                    clause = framed(clause, template, turn.lexicon, character.entity.phrase)
                    used.extend((template.name, name))
                    status, since = "applied", 0
            decisions.append((name, STAGE, probability, draw, status, target, "", ""))
        # What is taken up needs its "so" or "but" right after it.
        framed_before = message.role == "recall"
        since += 1
        clauses.append(clause)
    return clauses, decisions, used


def topic_told(character: Character, turn: Turn) -> str:
    """Return the topic of what was told last, if it was about the same character."""
    if turn.state.topic != character.entity.id:
        return ""
    last = character.by_id.get(turn.state.last_fact)
    return last.topic if last is not None else ""


def _choose(
    fitting: tuple[Template, ...], used: list[str], turn: Turn, rng: OperatorDraws
) -> Template | None:
    """Choose among the templates that fit, by lean, freshness and connotation."""
    able = [
        template
        for template in fitting
        if template.name not in used and rng.sounds_right(template.marker)
    ]
    if not able:
        return None
    weights = rng.weights([template.marker for template in able])
    liking = turn.parameters["template_polarity"]
    factors = {"good": 2 * liking, "bad": 2 * (1 - liking)}
    for index, template in enumerate(able):
        if template.connotation in factors:
            weights[index] *= factors[template.connotation]
    return rng.choose("template", able, weights) if any(weights) else None
