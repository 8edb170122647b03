"""Proves that spoilt files, random data and any text are read or refused, and tries to break that.

What is read is said as clean text; what is refused is one line that names the file.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite.realizer import (
    Clause,
    Coordination,
    NounPhrase,
    PrepositionalPhrase,
    Sentence,
)
from personage_lite.realizer.reader import MisreadError, read_specification
from personage_lite.realizer.types import FIELDS
from tests.mutation import check_message, spoilt
from tests.realizer.random_data import RandomData
from tests.realizer.reader_helpers import CASE_FILES, case_specs, read_or_refused, say


def _case_rows(path: Path) -> str:
    """Return a case file as `realize` reads it, with those cases that fill one line."""
    head, _, groups = path.read_text("utf-8").partition("\ngroups:\n")
    rows = re.findall(r"(?m)^ +- \{name: .*?, spec: (.*)\}$", groups)
    assert len(rows) > 10, path
    return head + "\nsentences:\n" + "".join(f"  - {row}\n" for row in rows[:: len(rows) // 30 + 1])


SPOILABLE = {path.stem: _case_rows(path) for path in CASE_FILES}
CASES_AS_JSON = {path.stem: json.dumps(case_specs(path)[::40], indent=1) for path in CASE_FILES}


@pytest.mark.parametrize("stem", SPOILABLE)
def test_case_files_can_be_spoilt(stem: str) -> None:
    assert len(say(SPOILABLE[stem])) > 10


@settings(max_examples=120, deadline=None)
@given(data=st.data())
def test_spoilt_files_are_read_or_refused(data: st.DataObject) -> None:
    stem = data.draw(st.sampled_from(sorted(SPOILABLE)))
    content = data.draw(spoilt(SPOILABLE[stem]))
    read_or_refused(content.decode("utf-8", errors="replace"), "spec.yaml")


@settings(max_examples=120, deadline=None)
@given(data=st.data())
def test_spoilt_json_is_read_or_refused(data: st.DataObject) -> None:
    stem = data.draw(st.sampled_from(sorted(CASES_AS_JSON)))
    content = data.draw(spoilt(CASES_AS_JSON[stem]))
    name = data.draw(st.sampled_from(["spec.json", "standard input"]))
    read_or_refused(content.decode("utf-8", errors="replace"), name)


@pytest.mark.parametrize("odd", [0.0, 0.02, 0.3], ids=["right", "nearly right", "wrong"])
def test_random_data_is_read_or_refused(odd: float) -> None:
    """Every error is one line; and of all that breaks this, the shortest is shown."""
    broken = []
    kinds: list[Any] = [Sentence, Clause, NounPhrase, Coordination, PrepositionalPhrase]
    for seed in range(1500):
        random = RandomData(seed, odd)
        content = json.dumps(random.mapping(random.rng.choice(kinds), 4))
        try:
            read_or_refused(content, "spec.json")
        except Exception as error:
            broken.append((len(content), content, f"{type(error).__name__}: {error}"[:200]))
        except AssertionError as error:
            broken.append((len(content), content, f"said badly: {error}"[:200]))
    assert not broken, f"{len(broken)} of 1500: {min(broken)[1:]}"


_SCALARS = st.none() | st.booleans() | st.integers() | st.floats() | st.text()
_KEYS = st.sampled_from(sorted({name for fields in FIELDS.values() for name in fields})) | st.text()


@settings(max_examples=150, deadline=None)
@given(st.recursive(_SCALARS, lambda x: st.lists(x) | st.dictionaries(_KEYS, x), max_leaves=8))
def test_any_data_is_read_or_refused(data: Any) -> None:
    """Data that has nothing to do with specifications, as JSON and as Python values."""
    read_or_refused(json.dumps(data), "spec.json")
    try:
        read_specification(data)
    except MisreadError as error:
        check_message(error)


@settings(max_examples=150, deadline=None)
@given(st.text())
def test_any_text_is_read_or_refused(content: str) -> None:
    for name in ("spec.yaml", "spec.json"):
        read_or_refused(content, name)
