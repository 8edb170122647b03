"""The sentences as compiled Jinja2 templates, made from those of the f-strings."""

from __future__ import annotations

from string import ascii_lowercase

from jinja2 import Environment

from realizers import Builders
from realizers.fstrings import TEMPLATES


def builders() -> Builders:
    """Return a function for each sentence."""
    environment = Environment(autoescape=False)
    found: Builders = {}
    for name, (template, words) in TEMPLATES.items():
        slots = dict(zip(ascii_lowercase, words, strict=False))
        compiled = environment.from_string(template(*(f"{{{{ {slot} }}}}" for slot in slots)))
        found[name] = lambda compiled=compiled, slots=slots: compiled.render(slots)  # type: ignore[misc]
    return found
