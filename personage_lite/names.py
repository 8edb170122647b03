"""What a listener may be called: any name that one can read, in any script.

The one rule for all who take names: speech acts, the live storyteller and its memory.
"""

from __future__ import annotations

import unicodedata

from personage_lite.errors import PersonageError, shown
from personage_lite.realizer.features import JOINERS

LONGEST = 100
# Unicode's categories of what cannot be read: controls, formats, surrogates, private, unassigned,
# line and paragraph separators.
_UNREADABLE = frozenset({"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"})


def checked_name(text: str) -> str:
    """Return a name as it is shown: composed letters, single spaces, none around it.

    Raises `PersonageError` for one that is empty, longer than 100 characters, or that holds
    control characters or others that cannot be seen; what joins letters in some scripts may stand.

    >>> checked_name("  Anna   Maria ")
    'Anna Maria'
    """
    bare = text.strip()
    if len(bare) > LONGEST:  # before anything else: what is long is slow, too
        raise _refused(bare, f"is {len(bare)} characters long", f"give at most {LONGEST}")
    for letter in bare:
        if unicodedata.category(letter) in _UNREADABLE and letter not in JOINERS:
            held = f"holds the character U+{ord(letter):04X}, which cannot be seen"
            raise _refused(bare, held, "leave it out")
    name = " ".join(unicodedata.normalize("NFKC", bare).split())
    if not any(letter.isprintable() and not letter.isspace() for letter in name):
        raise PersonageError("the name is empty; give one")
    if len(name) > LONGEST:  # some characters stand for many
        raise _refused(bare, f"is {len(name)} characters long", f"give at most {LONGEST}")
    return name


def _refused(text: str, what: str, remedy: str) -> PersonageError:
    seen = "".join(letter if letter.isprintable() else "?" for letter in text[:60])
    return PersonageError(f"the name '{shown(seen)}' {what}; {remedy}")
