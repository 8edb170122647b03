"""By what listeners are found again; what they may be called, the core says.

A name is only ever compared and shown, never run as SQL (it is a parameter) nor used as a path, so
`Robert'); DROP TABLE listener;--` and `../../etc/passwd` are names like others.
"""

from __future__ import annotations

import unicodedata

from personage_lite.names import checked_name


def key(text: str) -> str:
    """Return by what a listener is found: the name whatever its case and spaces.

    Raises `PersonageError` for what is no name.

    >>> key(" ANNA  Straße") == key("anna strasse")
    True
    """
    return unicodedata.normalize("NFKC", checked_name(text).casefold())
