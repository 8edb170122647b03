"""What the listener prefers, step by step."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from adaptation.problem import LEVELS, Floats, Ints

# When the preference is drawn anew, before the utterances with these numbers (the first is 1).
# Source: the paper, section III-B.
PUBLISHED_CHANGES = (15, 26)


def preferences(draws: Floats, steps: int, changes: Collection[int]) -> Ints:
    """Return the preference in each step and trial, shape (steps, trials).

    It is drawn at the start, and anew before the utterances named in `changes`; the same level
    may be drawn again. `draws` has shape (1 + number of changes, trials).

    >>> preferences(np.array([[0.1, 0.9], [0.5, 0.5]]), steps=3, changes=(3,))
    array([[-2,  2],
           [-2,  2],
           [ 0,  0]])
    """
    levels = LEVELS[(draws * len(LEVELS)).astype(np.int64)]
    drawn = np.zeros(steps, dtype=np.int64)
    for change in changes:
        drawn[change - 1 :] += 1
    return levels[drawn]


def drawn_levels(changes: Collection[int], steps: int) -> int:
    """Return how many levels are drawn for a trial."""
    return 1 + sum(change <= steps for change in changes)
