"""What a level of X is credited with: the reward or, in real time, where engagement was heading.

An utterance of d seconds shows the share 1 - exp(-d / tau) of the change that it would bring in
the end, where engagement relaxes with the time constant tau: of a short, introvert utterance about
40 %, of a long, extravert one about 80 %. So ΔE says less of X than of how long the robot spoke,
and at an X that keeps the listener as engaged as can be it is 0. Undone, the change leads from
the sensed E before the utterance to the level that E tends to: that is what X is worth.
"""

from __future__ import annotations

import numpy as np

from adaptation.problem import Context, Floats, Outcome, within

# E that tends to this level is worth as much as a reward of 0: less, and X is better changed.
INDIFFERENT = 1.0
# The default time constant, in seconds. Where the listener's is 8, 6 to 12 do as well.
TAU = 8.0


def credited(context: Context, outcome: Outcome, tau: float) -> Floats:
    """Return what the X that was spoken with is credited with; shape (trials,).

    Without a duration that is the reward. With one it is the level that E tends to, sensed E
    plus ΔE / (1 - exp(-duration / `tau`)) kept within -2 to 2, less 1; the reward itself is not
    used then. `tau` is in seconds; 0: the listener is taken to answer at once.

    Measured on the listener `live`, whose time constant is 8 s, with discounted UCB: the share of
    steps with X = preference and the mean true E are .33 and .85 with ΔE as it is, .33 and .87
    with ΔE corrected, .59 and 1.25 with the level; with a `tau` of 0 still .53 and 1.14.

    >>> context = Context(0, np.array([0, 0]), np.array([0.0, 0.0]))
    >>> outcome = Outcome(np.ones(2), np.array([1, 1]), np.array([0.5, -0.8]))
    >>> credited(context, outcome, tau=8)
    array([1., 1.])
    >>> credited(context, outcome._replace(duration=np.array([4.0, 12.0])), tau=8).round(2)
    array([ 0.27, -2.03])
    """
    if outcome.duration is None:
        return outcome.reward
    seen = 1 - np.exp(-outcome.duration / tau) if tau else 1.0
    before = context.engagement
    level = within(before + (outcome.engagement - before) / seen)
    return level - INDIFFERENT
