"""Proves that faults of YAML and JSON themselves are told with their line and a remedy.

For YAML every fault has its line, also one of fields and types.
"""

from __future__ import annotations

import pytest

from personage_lite.errors import DataError
from tests.mutation import check_message
from tests.realizer.reader_helpers import refusal, say


@pytest.mark.parametrize(
    ("content", "line", "message"),
    [
        ("noun: cat\n\n# more\ndeterminr: a\n", 4, "determinr: NounPhrase has no field 'determi"),
        ("- a\n- noun: cat\n  adjectives:\n    - big\n    - 7\n", 5, "[1].adjectives[1]: expected"),
        ("- a\n-\n- b\n", 2, "[1]: expected a phrase, found nothing; "),
        ("verb: go\nsubject:\n  noun:\n    7\n", 4, "subject.noun: expected a text, found '7'; "),
        (
            "- a\n- {verb: see, subject: a,\n   object:\n    {verb: go}}\n",
            4,
            "[1].object: the clause",
        ),
        ("sentences:\n  - a\nshare: 1\n", 3, "share: unknown field 'share' beside 'sentences'; "),
        (
            "shared: &a {noun: cat}\nsentences:\n  - *a\n  - {<<: *a,\n     nown: 1}\n",
            5,
            "].nown: ",
        ),
        ("shared: [&a {noun: 5}]\nsentences:\n  - *a\n", 1, "sentences[0].noun: expected a text, "),
        (
            "noun: cat\ndeterminer: a\nnoun: dog\n",
            3,
            "the key 'noun' stands here a second time; re",
        ),
        ("- a\n- items:\n  - {noun: x,\n     noun: y}\n", 4, "the key 'noun' stands here a second"),
        ("- a\n- {? [x] : y}\n", 2, "a key is no single word; write 'key: value'"),
        ("- a\n- {? {x: y} : y}\n", 2, "a key is no single word; write 'key: value'"),
        ("- a\n- {<<: cat}\n", 2, "'<<' takes over no mapping; name one, as in '<<: *alice'"),
        ("- a\n- {<<: [cat]}\n", 2, "'<<' takes over no mapping; name one, as in '<<: *alice'"),
        ("- a\n- {<<: }\n", 2, "'<<' takes over no mapping; name one, as in '<<: *alice'"),
        ("- a\n- noun: *x\n", 2, "not valid YAML (found undefined alias); mend the syntax"),
        ("noun: a\n--- \nnoun: b\n", 2, "not valid YAML (but found another document); mend the"),
        ("noun: [\n", 2, "not valid YAML (did not find expected node content); mend the syntax"),
        ("a: b\n\tc: d\n", 2, "not valid YAML (found a tab character that violates indentation)"),
        ("- a\n- b\x07\n", 2, "not valid YAML (control characters are not allowed); remove it"),
        ("", 1, "the file is empty; "),
        ("# nothing\n", 1, "the file is empty; "),
        ("---\n...\n", 2, "expected a phrase, found nothing; "),
        ("- a\n- !!python/name:os.system x\n- 7\n", 3, "[2]: expected a phrase, found '7'; "),
        ("- a\n- year: 2000\n  month: 13\n", 2, "[1]: no calendar has year 2000, month 13; "),
        ("- a\n- value: .inf\n", 2, "[1].value: "),
        ("- a\n- value: .nan\n", 2, "[1].value: "),
        ("- a\n- value: 1.0e+999\n", 2, "[1]"),
        (f"- a\n- value: {'9' * 5000}\n", 2, "[1].value: "),
    ],
)
def test_lines(content: str, line: int, message: str) -> None:
    """For YAML the error names the very line, and no part of it is half said."""
    with pytest.raises(DataError) as caught:
        say(content)
    check_message(caught.value)
    assert (caught.value.file, caught.value.line) == ("spec.yaml", line)
    assert str(caught.value).startswith(f"spec.yaml:{line}: ")
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("content", "line", "message"),
    [
        ('{"noun": "a"', 1, "not valid JSON (Expecting ',' delimiter); mend the syntax"),
        ('{"noun": "a",\n}', 2, "not valid JSON (Expecting property name enclosed in double quo"),
        ("[\n1,\n", 3, "not valid JSON (Expecting value); mend the syntax"),
        ('["a"]\n"b"', 2, "not valid JSON (Extra data); mend the syntax"),
        ("{'noun': 'a'}", 1, "not valid JSON (Expecting property name enclosed in double quotes"),
        ('["a\n"]', 1, "not valid JSON (Invalid control character at); mend the syntax"),
        ('["\\x"]', 1, "not valid JSON (Invalid \\escape); mend the syntax"),
        (
            '[\n"a",\n{"noun": "a", "noun": "b"}]',
            3,
            "the key 'noun' stands here a second time; remove one of the two",
        ),
        ('["a", {"value": NaN}]', None, "[1]"),
        ('["a", {"value": -Infinity}]', None, "[1]"),
        ('["a", {"value": 1e999}]', None, "[1]"),
        ('["a", {"noun": "b", "cardinal": NaN}]', None, "[1]"),
        (f'["a", {{"value": {"9" * 5000}}}]', None, "; "),
        ("", None, "the file is empty; "),
        (" \n", None, "the file is empty; "),
    ],
)
def test_json_faults(content: str, line: int | None, message: str) -> None:
    said = refusal(content, "spec.json")
    if line:
        assert said.startswith(f"spec.json:{line}: ")
    assert message in said


def test_equal_json_keys_are_found_where_they_are() -> None:
    """In a long file "somewhere" helps nobody."""
    said = refusal('["a",\n{"noun": "b", "possessor":\n{"noun": "c", "noun": "d"}}]', "spec.json")
    assert said.startswith(("spec.json:3: ", "spec.json: [1].possessor"))
