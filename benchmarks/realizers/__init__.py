"""The realizers, one module each: `builders` returns a function for each sentence it can try.

A function builds its sentence from its parts and realizes it, anew with every call.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

Builders = dict[str, Callable[[], str]]

MODULES = {
    "personage-lite": "ours",
    "pyrealb": "pyrealb_",
    "simplenlg (Python port)": "simplenlg_",
    "Jinja2 (no grammar)": "jinja_",
    "f-strings (no grammar)": "fstrings",
}

# What must be installed for a peer, under the name that is imported.
PACKAGES = {
    "pyrealb": "pyrealb",
    "simplenlg (Python port)": "simplenlg",
    "Jinja2 (no grammar)": "jinja2",
}


def builders(name: str) -> Builders:
    """Return the named realizer's functions by sentence."""
    found: Builders = import_module(f"realizers.{MODULES[name]}").builders()
    return found


def said(functions: Builders) -> dict[str, str]:
    """Return what these functions say; where one fails, its error in angle brackets."""
    texts = {}
    for name, build in functions.items():
        try:
            texts[name] = build().rstrip()
        except Exception as error:  # Any failure of a peer is one sentence less.
            texts[name] = f"<{type(error).__name__}: {error}>"
    return texts
