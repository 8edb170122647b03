"""What a fact leans on: its words for right after the fact above it, and only there."""

from __future__ import annotations

from pathlib import Path

import pytest

from personage_lite import Generator
from personage_lite.errors import DataError
from personage_lite.facts_reader import read_character
from personage_lite.plan import Utterance
from personage_lite.truth import truth_faults

HEAD = "about: a\nentities:\n  a: {name: Ann, gender: feminine, animate: true}\n"
POEM = "  - {id: poem, predicate: write, object: a poem, topic: verse}\n"
LOSES = (
    "  - {id: loses, predicate: lose, object: her poem, adverbials: [on the bus],"
    " following: {object: it, adverbials: [], adverb: even}, topic: verse}\n"
)
SINGS = "  - {id: sings, predicate: sing, topic: verse}\n"
SEEDS = range(200)


def _written(folder: Path, facts: str, relations: str = "") -> Path:
    path = folder / "a.yaml"
    path.write_text(HEAD + "facts:\n" + facts + relations, "utf-8")
    return path


def _told(path: Path, x: float, verbosity: float) -> list[Utterance]:
    """Say it with nothing around it: what is looked at here is the words of the facts."""
    generator = Generator(facts=path)
    quiet = dict.fromkeys(generator.style.parameters, 0.0)
    quiet |= {"content_polarity": 0.5, "polarization": 0.5, "pronominalization": 1.0}
    quiet |= {"verbosity": verbosity, "period": 1.0, "justify_cue_word": 1.0}
    return [generator.generate("a", x, seed, overrides=quiet) for seed in SEEDS]


def test_right_after_it_leans_and_alone_it_does_not(tmp_path: Path) -> None:
    path = _written(tmp_path, POEM + LOSES + SINGS)
    found = {said.text for said in _told(path, 0, 0.9)} | {said.text for said in _told(path, 0, 0)}
    assert any("She even loses it." in text for text in found)
    assert any(text == "Ann loses her poem on the bus." for text in found)
    for text in found:
        assert ("even loses it" in text) == ("writes a poem. She even" in text), text


def test_it_is_the_fact_above_it_in_the_file_that_counts(tmp_path: Path) -> None:
    path = _written(tmp_path, POEM + SINGS + LOSES)
    for said in _told(path, 0, 0.9):
        assert ("even loses it" in said.text) == ("sings. She even loses it" in said.text)


def test_what_is_turned_round_is_said_in_full(tmp_path: Path) -> None:
    """ "Because" puts the second fact first: "it" would come before the poem."""
    because = "relations: [{kind: justification, nucleus: loses, satellite: poem}]\n"
    path = _written(tmp_path, POEM + LOSES, because)
    texts = {said.text for said in _told(path, 0, 0.9)}
    assert "Ann writes a poem, so she even loses it." in texts
    assert not any(text.startswith("Ann even loses it") for text in texts)


def test_the_truth_checker_wants_what_it_leans_on(tmp_path: Path) -> None:
    path = _written(tmp_path, POEM + LOSES)
    generator = Generator(facts=path)
    about = generator.character("a")
    for said in _told(path, 0, 0.9):
        assert not truth_faults(said, about, generator.lexicon), said.text
        if said.text.endswith("She even loses it."):
            turned = said._replace(sentences=said.sentences[::-1])
            assert any(
                "states no fact" in f for f in truth_faults(turned, about, generator.lexicon)
            )
            break
    else:
        pytest.fail("the two were never told together")


@pytest.mark.parametrize(
    ("given", "fault"),
    [
        ("{verb: find}", "unknown field 'verb'; did you mean adverb"),
        ("it", "expected 'key: value' pairs"),
        ("{adverb: '{a}'}", "no mention can stand in 'adverb'"),
        ("{object: '{b}'}", "no entity 'b'"),
    ],
)
def test_its_faults_are_named(tmp_path: Path, given: str, fault: str) -> None:
    broken = LOSES.replace("{object: it, adverbials: [], adverb: even}", given)
    with pytest.raises(DataError) as raised:
        read_character(_written(tmp_path, POEM + broken))
    assert fault in str(raised.value)
    assert "a.yaml:6" in str(raised.value)
