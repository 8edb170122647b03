"""The sentences as f-strings with their content words as slots: no grammar at all, the floor.

Every form of a word is the template's own affair: another number or tense is another template.
"""

from __future__ import annotations

from collections.abc import Callable

from realizers import Builders

TEMPLATES: dict[str, tuple[Callable[..., str], tuple[str, ...]]] = {
    "copula": (lambda a, b, c: f"{a} is an {b} {c}.", ("Alice", "imaginative", "girl")),
    "negation": (
        lambda a, b, c, d: f"The {a} does not {b} {c} {d}s.",
        ("Queen of Hearts", "like", "white", "rose"),
    ),
    "although": (
        lambda a, b, c: f"Although she is {a}, the {b} {c}s.",
        ("small", "Queen", "shout"),
    ),
    "passive_perfect": (lambda a, b: f"She has been {a}d by the {b}s.", ("chase", "card")),
    "possessive_pronoun": (
        lambda a, b, c: f"The {a} {b} his {c}s.",
        ("White Rabbit", "lost", "glove"),
    ),
    "future": (
        lambda a, b, c: f"The {a} will {b} at the {c}.",
        ("Cheshire Cat", "grin", "Duchess"),
    ),
    "past_progressive": (
        lambda a, b, c, d: f"The {a} was {b}ing {c} with the {d}.",
        ("Hatter", "drink", "tea", "March Hare"),
    ),
    "past_perfect": (
        lambda a, b, c, d: f"{a} had {b} the {c} {d}.",
        ("Alice", "eaten", "small", "cake"),
    ),
    "passive_past": (lambda a, b, c: f"The {a}s were {b} by the {c}.", ("tart", "stolen", "Knave")),
    "modal_negation": (lambda a, b, c: f"The {a} can't {b} {c}.", ("Dormouse", "stay", "awake")),
    "modal_perfect": (
        lambda a, b, c: f"The {a} must have {b} the {c}s.",
        ("Knave", "stolen", "tart"),
    ),
    "yes_no": (lambda a, b, c: f"Does the {a} {b} a {c}?", ("Caterpillar", "smoke", "pipe")),
    "yes_no_past": (lambda a, b, c: f"Did the {a} {b} the {c}?", ("King", "forgive", "Knave")),
    "who": (lambda a, b: f"Who {a} the {b}s?", ("stole", "tart")),
    "what": (lambda a, b: f"What did the {a} {b}?", ("Rabbit", "lose")),
    "where": (lambda a, b: f"Where does the {a} {b}?", ("Duchess", "live")),
    "why": (lambda a, b: f"Why is the {a} {b}ing?", ("Hatter", "sing")),
    "relative_subject": (
        lambda a, b, c, d, e: f"{a} {b}s a {c} that {d}s a {e}.",
        ("Alice", "follow", "rabbit", "wear", "waistcoat"),
    ),
    "relative_object": (
        lambda a, b, c, d, e, f: f"The {a} that {b} {c} {d}s a {e} {f}.",
        ("key", "Alice", "found", "open", "little", "door"),
    ),
    "because": (
        lambda a, b, c: f"The {a} {b} because he is {c}.",
        ("Rabbit", "hurries", "late"),
    ),
    "when": (
        lambda a, b, c, d: f"When the {a} {b}ed, the {c}s {d}.",
        ("Queen", "shout", "gardener", "fell"),
    ),
    "and_names": (
        lambda a, b, c, d: f"The {a}, the {b} and the {c} are {d}s.",
        ("Hatter", "March Hare", "Dormouse", "friend"),
    ),
    "and_adjectives": (
        lambda a, b, c, d: f"{a} is {b}, {c} and {d}.",
        ("Alice", "kind", "curious", "polite"),
    ),
    "and_clauses": (
        lambda a, b, c, d: f"The {a} {b}s and the {c}s {d}.",
        ("Queen", "shout", "gardener", "tremble"),
    ),
    "and_predicates": (
        lambda a, b, c, d, e: f"{a} {b}s the {c} and {d}s the {e}.",
        ("Alice", "open", "bottle", "drink", "potion"),
    ),
    "irregular_plurals": (
        lambda a, b, c, d: f"The {a} {b} two {c} and three {d}.",
        ("children", "feed", "geese", "mice"),
    ),
    "possessive": (
        lambda a, b, c, d: f"{a}'s {b} {c}s a {d}.",
        ("Alice", "sister", "read", "book"),
    ),
    "plural_possessive": (
        lambda a, b, c: f"The {a}s' {b}es are {c}.",
        ("gardener", "brush", "red"),
    ),
    "pronouns": (lambda a, b, c: f"They {a} her a {b} {c}.", ("gave", "golden", "key")),
    "prepositions": (
        lambda a, b, c, d, e: f"{a} {b}s into a {c} {d} under the {e}.",
        ("Alice", "fall", "deep", "hole", "hedge"),
    ),
    "infinitive": (
        lambda a, b, c, d: f"The {a} {b}s to {c} {d}.",
        ("Queen", "want", "play", "croquet"),
    ),
    "object_infinitive": (
        lambda a, b, c, d: f"The {a} {b} {c} to {d}.",
        ("Duchess", "told", "Alice", "leave"),
    ),
    "a_an": (lambda a, b, c: f"A {a} {b}s for an {c}.", ("unicorn", "wait", "hour")),
    "contraction": (lambda a, b: f"{a} isn't {b}.", ("Alice", "afraid")),
    "imperative": (lambda a, b: f"Do not {a} the {b}.", ("wake", "Dormouse")),
    "existential": (lambda a, b: f"There are {a}s on the {b}.", ("tart", "table")),
    "comparative": (
        lambda a, b, c: f"{a} is {b}er than the {c}.",
        ("Alice", "tall", "mushroom"),
    ),
    "superlative": (
        lambda a, b, c, d: f"The {a} is the {b} {c} in {d}.",
        ("Queen", "angriest", "person", "Wonderland"),
    ),
    "adverbs": (
        lambda a, b, c, d: f"The {a} {b} {c}s {d}.",
        ("Cat", "often", "disappear", "slowly"),
    ),
    "that_clause": (
        lambda a, b, c, d: f"{a} {b}s that the {c} is {d}.",
        ("Alice", "think", "Hatter", "rude"),
    ),
}


def builders() -> Builders:
    """Return a function for each sentence."""
    return {
        name: lambda template=template, words=words: template(*words)  # type: ignore[misc]
        for name, (template, words) in TEMPLATES.items()
    }
