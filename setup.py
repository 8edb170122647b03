"""Compiles the modules that take the most time, if asked to; all else stands in pyproject.toml.

`PERSONAGE_LITE_COMPILE=1 pip install .` makes C extensions of the very same sources with mypyc.
Without the variable nothing is compiled, and neither a compiler nor mypy is needed.
"""

from __future__ import annotations

import os
import sys

from setuptools import setup

# What a styled utterance spends its time in. What is not here stays interpreted:
# - what users hand values to (`Generator`, `Realizer`, `style`, the classes of specifications):
#   compiled code checks types at its door, and would say "float object expected" before we can say
#   what is wrong;
# - what users are handed (`plan`, `state`, `realizer/numerals`) and `realizer/grammar`: mypyc
#   forgets the annotations of named tuples, which the realizer itself reads;
# - `realizer/syntax.py`, through which all nested phrases pass, and the few functions that go down
#   into a phrase by themselves (`realizer/agreement.py`, `realizer/tags.py`): only interpreted
#   code notices that something is nested too deep before the stack overflows;
# - what runs once or seldom: reading files, the command line, the trace, diagnosis.
COMPILED = (
    *("content_planner", "fact_choice", "operators", "randomness"),
    *("sentence_planner/__init__", "sentence_planner/aggregation", "sentence_planner/assembly"),
    *("sentence_planner/cue_words", "sentence_planner/discourse", "sentence_planner/hedges"),
    *("sentence_planner/fitting", "sentence_planner/joining"),
    *("sentence_planner/lexical_choice", "sentence_planner/referring_expressions"),
    *("sentence_planner/rewording", "sentence_planner/speech", "sentence_planner/templates"),
    *("realizer/article", "realizer/clauses", "realizer/inflection"),
    *("realizer/non_finite", "realizer/noun_phrases", "realizer/number", "realizer/orthography"),
    *("realizer/phrases", "realizer/predicates", "realizer/sentences"),
    *("realizer/stutter", "realizer/subordination", "realizer/verb_group", "realizer/words"),
)

# Only when a wheel is built: setuptools runs this file also to ask what a build needs, which is
# before mypy is there, and for an editable install, where what is compiled would hide the edits.
if os.environ.get("PERSONAGE_LITE_COMPILE") == "1" and "bdist_wheel" in sys.argv:
    from mypyc.build import mypycify

    paths = [f"personage_lite/{name}.py" for name in COMPILED]
    setup(ext_modules=mypycify(paths, opt_level="3", debug_level="0", group_name="personage_lite"))
else:
    setup()
