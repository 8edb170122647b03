"""A readable account of how an utterance came about: facts, decisions, rewrites."""

from __future__ import annotations

from personage_lite.generator import Generator
from personage_lite.plan import Decision, Utterance
from personage_lite.realizer.specification import Sentence
from personage_lite.style import STAGES


def explain(utterance: Utterance, generator: Generator) -> str:
    """Return the trace of a generator's utterance as indented text, a stage at a time.

    Rewrites are shown before and after if the utterance was generated with `trace=True`.
    """
    realizer = generator.realizer
    name = generator.character(utterance.character).entity.name
    lines = [
        f"  {name}, X = {utterance.x:g}, seed {utterance.seed}, turn {utterance.turn + 1}",
        "  facts chosen:",
    ]
    for message in utterance.plan.messages:
        fact = message.fact
        plain = realizer.realize(Sentence(fact.clause))
        where = f", chapter {fact.chapter}" if fact.chapter else ""
        role = "" if message.role == "assertion" else f", {message.role}"
        lines.append(f"    {fact.id}: {plain} ({fact.polarity}, {fact.topic}{where}{role})")
    for index, link in enumerate(utterance.plan.links):
        if link.kind != "none":
            lines.append(f"    {link.kind} between {index + 1} and {index + 2}")
    for stage in STAGES:
        made = [decision for decision in utterance.decisions if decision.stage == stage]
        if not made:
            continue
        lines.append(f"  {stage.replace('_', ' ')}:")
        applied = [decision for decision in made if decision.status == "applied"]
        lines.extend(line for decision in applied for line in _applied(decision))
        for status in ("not_applicable", "not_drawn"):
            rest = [_short(decision) for decision in made if decision.status == status]
            if rest:
                lines.append(f"    {status.replace('_', ' ')}: {', '.join(rest)}")
    return "\n".join(lines)


def _short(decision: Decision) -> str:
    return f"{decision.operator} {decision.draw:.2f}/{decision.probability:.2f}"


def _applied(decision: Decision) -> list[str]:
    chance = f"drew {decision.draw:.2f} of {decision.probability:.2f}"
    if decision.stage == "aggregation" or decision.operator == "lexical_choice":
        chance = f"chance {decision.probability:.2f}"
    where = f"{decision.target}, " if decision.target else ""
    lines = [f"    {decision.operator} ({where}{chance})"]
    if decision.before or decision.after:
        lines.append(f"      {decision.before}")
        lines.append(f"      → {decision.after}")
    return lines
