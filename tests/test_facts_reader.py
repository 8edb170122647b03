"""Facts files: what is read, and that every fault is named with file, line and remedy."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from personage_lite.checks import check_path
from personage_lite.data import data_folder
from personage_lite.errors import DataError, PersonageError
from personage_lite.facts_reader import character_files, find_character, identifier, read_character
from tests.mutation import check_message, spoilt

SHIPPED = Path(data_folder("facts")) / "wonderland"
ALICE = (SHIPPED / "alice.yaml").read_text("utf-8")
ENTITIES = (SHIPPED / "entities.yaml").read_text("utf-8")
HEAD = "about: a\nentities:\n  a: {name: Ann}\n  b: {name: Bob}\nfacts:\n"
KIND = "  - {id: kind, attribute: kind, topic: nature}\n"
TALL = "  - {id: tall, attribute: tall, topic: nature}\n"


def _write(folder: Path, content: str, name: str = "a.yaml") -> Path:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content, "utf-8")
    return path


@pytest.fixture(scope="module")
def wonderland(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the shipped facts, to be spoilt."""
    folder = tmp_path_factory.mktemp("facts") / "wonderland"
    shutil.copytree(SHIPPED, folder)
    return folder


@pytest.mark.parametrize(
    "name",
    ["white_rabbit", "White Rabbit", "WHITE-RABBIT", "the White  Rabbit", " The white_Rabbit "],
)
def test_a_name_can_be_written_in_many_ways(name: str) -> None:
    assert identifier(name) == "white_rabbit"
    assert find_character(name, SHIPPED).entity.id == "white_rabbit"


def test_what_a_file_says_is_read(tmp_path: Path) -> None:
    path = _write(
        tmp_path,
        HEAD
        + KIND
        + "  - {id: gift, subject: b, predicate: give, indirect_object: '{a}', object: a hat,"
        + " adverbials: [at noon], tense: past, negated: true, negator: never, polarity: bad,"
        + " strength: extremely, topic: gifts, chapter: 3, source: a letter}\n"
        + "  - {id: hands, part: {noun: hand, number: plural}, attribute: big, topic: nature}\n"
        + "relations: [{kind: contrast, nucleus: kind, satellite: gift}]\nsource: nobody\n",
    )
    about = read_character(path)
    assert [fact.id for fact in about.facts] == ["kind", "gift", "hands"]
    gift = about.by_id["gift"]
    assert (gift.about, gift.polarity, gift.strength) == ("b", "bad", "extremely")
    assert (gift.chapter, gift.source, gift.line) == (3, "a letter", 7)
    assert (gift.clause.tense, gift.clause.negated, gift.clause.negator) == ("past", True, "never")
    assert gift.mentions == {"a", "b"}
    assert [(r.kind, r.nucleus, r.satellite) for r in about.relations] == [
        ("contrast", "kind", "gift")
    ]
    assert check_path(path).faults == []


@pytest.mark.parametrize(
    ("content", "line", "message"),
    [
        ("about: b\nfacts: []\n", 1, "'b' is not the file's name; write about: a"),
        ("about: a\nfacts: []\n", 1, "no entity 'a'; describe it under 'entities:' here or in"),
        (HEAD + KIND + "colour: red\n", 7, "unknown field 'colour'"),
        (HEAD.replace("Ann", "'7'"), 3, "'7' is no name; write one of up to 80 letters"),
        (HEAD.replace("Ann", "A" * 81), 3, f"'{'A' * 40}…' is no name"),
        (HEAD.replace("Ann", "A" * 10_000), 3, f"'{'A' * 40}…' is no name"),
        (
            HEAD.replace("Ann", "Ann 🎩"),
            3,
            "'Ann 🎩' is no name; write one of up to 80 letters, wit",
        ),
        (HEAD.replace("{name: Ann}", "{gender: feminine}"), 3, "'name' is missing; add 'name: …'"),
        (
            HEAD.replace("facts:", "topics: {looks: {}}\nfacts:") + KIND,
            7,
            "no topic 'nature'; list",
        ),
        (
            HEAD.replace("facts:", "topics: {nature: {seting: x}}\nfacts:") + KIND,
            5,
            "unknown field",
        ),
        (
            HEAD.replace("facts:", "topics: {nature: {setting: 'at {c}'}}\nfacts:") + KIND,
            5,
            "no entity 'c'",
        ),
        (
            HEAD.replace("facts:", "topics: {nature: {in_order: true}}\nfacts:")
            + KIND
            + TALL
            + "relations:\n  - {kind: elaboration, nucleus: tall, satellite: kind}\n",
            10,
            "or 'in_order' of a topic",
        ),
        (HEAD.replace("  b:", "  B:") + KIND, 4, "'B' is no id; use small letters, digits and _"),
        (HEAD.replace("  b:", "  a:") + KIND, 4, "the key 'a' stands here a second time; remove"),
        (HEAD + "  []\n", 6, "there is no fact; add at least one"),
        (HEAD + KIND + KIND, 7, "a second fact 'kind'; give it an id of its own"),
        (HEAD + "  - kind\n", 6, "expected 'key: value' pairs"),
        (HEAD + KIND.replace("kind,", "Kind,", 1), 6, "'Kind' is no id"),
        (HEAD + "  - {id: kind, topic: x}\n", 6, "'predicate' is missing; add the verb"),
        (HEAD + "  - {id: kind, attribute: kind}\n", 6, "'topic' is missing; add 'topic: …'"),
        (HEAD + KIND.replace("topic", "topics"), 6, "unknown field 'topics'; did you mean topic?"),
        (HEAD + KIND.replace("kind, t", "yes, t"), 6, "'yes' is a truth value in YAML, not a word"),
        (HEAD + KIND.replace("topic", "complement: x, topic"), 6, "both attribute and complement"),
        (HEAD + KIND.replace("topic", "subject: c, topic"), 6, "no entity 'c'; choose from: a, b"),
        (HEAD + KIND.replace("topic", "object: '{c}', topic"), 6, "no entity 'c'"),
        (HEAD + KIND.replace("topic", "object: '{a', topic"), 6, "a mention in { } cannot be read"),
        (HEAD + KIND.replace("kind, t", "'{a}', t"), 6, "no mention can stand in 'attribute'; use"),
        (HEAD + KIND.replace("topic", "predicate: '{a}', topic"), 6, "can stand in 'predicate'"),
        (HEAD + KIND.replace("topic", "negator: never, topic"), 6, "a negator, but nothing negat"),
        (HEAD + KIND.replace("topic", "negated: 'yes', topic"), 6, "expected true or false"),
        (HEAD + KIND.replace("topic", "polarity: fine, topic"), 6, "'fine' is not possible here"),
        (HEAD + KIND.replace("topic", "chapter: 1.5, topic"), 6, "expected a whole number"),
        (HEAD + KIND.replace("topic", "chapter: 0, topic"), 6, "0 is out of range; write a number"),
        (HEAD + KIND + "relations: [{kind: a, nucleus: b, satellite: c}]", 7, "'a' is not possib"),
        (
            HEAD + KIND + "relations:\n  - {kind: contrast, nucleus: kind, satellite: kid}\n",
            8,
            "no fact 'kid'; did you mean kind?",
        ),
        (
            HEAD + KIND + "relations:\n  - {kind: contrast, nucleus: kind, satellite: kind}\n",
            8,
            "'kind' is related to itself; name two facts",
        ),
        (
            HEAD
            + KIND
            + TALL
            + "relations:\n  - {kind: sequence, nucleus: kind, satellite: tall}\n"
            + "  - {kind: elaboration, nucleus: tall, satellite: kind}\n",
            9,
            "kind, tall wait for each other; remove one elaboration or sequence",
        ),
    ],
)
def test_faults(content: str, line: int, message: str, tmp_path: Path) -> None:
    """Reading raises the fault; `check` names the same one and goes on."""
    path = _write(tmp_path, content)
    with pytest.raises(DataError) as caught:
        read_character(path)
    assert str(caught.value).startswith(f"{path}:{line}: ")
    assert message in str(caught.value)
    assert any(message in fault for fault in check_path(path).faults)


def test_check_names_every_fault(tmp_path: Path) -> None:
    path = _write(
        tmp_path,
        HEAD
        + KIND
        + TALL.replace("topic", "topics")
        + KIND.replace("id: kind", "id: again")
        + KIND.replace("id: kind", "id: unkind, negated: true")
        + KIND.replace("id: kind, attribute: kind", "id: c, predicate: go, modal: cna")
        + "relations:\n"
        + "  - {kind: contrast, nucleus: kind, satellite: again}\n" * 2
        + "  - {kind: contrast, nucleus: kind, satellite: none}\n",
    )
    faults = check_path(path).faults
    wanted = {
        7: "unknown field 'topics'",
        8: "'again' says the same as 'kind'",
        9: "'unkind' contradicts 'again'",
        10: "'cna' is no modal; did you mean can?",
        13: "a second contrast; remove it",
        14: "no fact 'none'",
    }
    for line, message in wanted.items():
        assert any(fault.startswith(f"{path}:{line}: {message}") for fault in faults), faults
    assert len(faults) == len(wanted)


def test_folders(tmp_path: Path) -> None:
    with pytest.raises(PersonageError, match="no such file or folder; check the path"):
        character_files(tmp_path / "none")
    with pytest.raises(PersonageError, match="File name too long; check the path"):
        character_files(tmp_path / ("x" * 5000))
    with pytest.raises(PersonageError, match=r"holds no facts file; see docs/facts\.md"):
        character_files(tmp_path)
    _write(tmp_path, HEAD + KIND, "one/a.yaml")
    assert list(character_files(tmp_path)) == ["a"]
    assert find_character("A", tmp_path / "one" / "a.yaml").entity.name == "Ann"
    _write(tmp_path, HEAD + KIND, "two/a.yaml")
    with pytest.raises(PersonageError, match="rename one of the two files"):
        character_files(tmp_path)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("alcie", "no character 'alcie'; did you mean alice?"),
        ("😀", "no character '😀'; choose from: alice, bill, caterpillar"),
        ("", "no character ''; choose from"),
        ("x" * 10_000, f"no character '{'x' * 40}…'; choose from"),
        ("al\nice", "no character 'al ice'; did you mean alice?"),
        ("../wonderland/alice", "no character '../wonderland/alice'"),
    ],
)
def test_unknown_characters(name: str, message: str) -> None:
    with pytest.raises(PersonageError) as caught:
        find_character(name, SHIPPED)
    assert str(caught.value).startswith(message)


@settings(max_examples=80, deadline=None)
@given(content=spoilt(ALICE))
def test_spoilt_facts_are_read_or_refused(content: bytes, wonderland: Path) -> None:
    path = wonderland / "alice.yaml"
    path.write_bytes(content)
    _read(path)


@settings(max_examples=30, deadline=None)
@given(content=spoilt(ENTITIES))
def test_spoilt_entities_are_read_or_refused(content: bytes, wonderland: Path) -> None:
    path = wonderland / "alice.yaml"
    path.write_text(ALICE, "utf-8")
    path.with_name("entities.yaml").write_bytes(content)
    try:
        _read(path)
    finally:
        path.with_name("entities.yaml").write_text(ENTITIES, "utf-8")


@settings(max_examples=60, deadline=None)
@given(content=st.binary(max_size=200))
def test_random_bytes_are_refused(content: bytes, wonderland: Path) -> None:
    path = wonderland / "alice.yaml"
    path.write_bytes(content)
    assert not _read(path)


@settings(max_examples=25, deadline=None)
@given(content=spoilt(ALICE))
def test_check_names_what_reading_refuses(content: bytes, wonderland: Path) -> None:
    path = wonderland / "alice.yaml"
    path.write_bytes(content)
    faults = check_path(path).faults
    assert all(len(fault.splitlines()) == 1 for fault in faults)
    assert _read(path) or faults


def _read(path: Path) -> bool:
    """Whether a file loads; if not, the fault is one line."""
    try:
        read_character(path)
    except PersonageError as error:
        check_message(error)
        return False
    return True


def test_names_in_other_scripts_are_names(tmp_path: Path) -> None:
    """Letters, vowel signs and accents of any script; no emoji."""
    for name in ("Жабб", "नीला", "Zoë O’Hara", "R2-D2", "Mr. Smith & Co. (2)"):
        path = _write(tmp_path, HEAD.replace("Ann", f'"{name}"') + KIND)
        assert read_character(path).entity.name == name


TOPICS = "topics:\n  story: {setting: at noon, in_order: true}\n  looks: {}\nfacts:\n"


def test_topics(tmp_path: Path) -> None:
    """Their order is the file's, and what is told in order waits for what stands before it."""
    path = _write(
        tmp_path,
        HEAD.replace("facts:\n", TOPICS)
        + KIND.replace("nature", "looks")
        + "".join(f"  - {{id: {key}, predicate: {key}, topic: story}}\n" for key in ("go", "run")),
    )
    about = read_character(path)
    assert list(about.topics) == ["story", "looks"]
    setting = about.topics["story"].setting
    assert setting is not None
    assert setting.parts == ("at noon",)
    assert about.prerequisites == {"run": ("go",)}
    assert about.unlocks == {"go": ("run",)}
    assert check_path(path).faults == []


@pytest.mark.parametrize(
    ("facts", "relations", "line", "message"),
    [
        (KIND + KIND.replace("kind,", "mild,", 1), "", 7, "'mild' says the same as 'kind'"),
        (
            KIND
            + "  - {id: calm, predicate: keep, object: calm, following: {object: that way},"
            + " topic: moods}\n",
            "",
            7,
            "'calm' follows no fact of its topic; remove its 'following', or move it after",
        ),
        (
            KIND + KIND.replace("kind, attribute: kind", "cruel, attribute: cruel"),
            "",
            7,
            "'cruel' contradicts 'kind'; remove one of the two, or choose",
        ),
        (
            KIND + KIND.replace("kind, attribute: kind", "nice, attribute: kind-hearted"),
            "",
            7,
            "'nice' can be said in the words of 'kind' (kind-hearted); choose another",
        ),
        (
            KIND + TALL,
            "  - {kind: justification, nucleus: kind, satellite: tall}\n"
            "  - {kind: concession, nucleus: kind, satellite: tall}\n",
            10,
            "concession of 'kind' and 'tall' goes against the justification",
        ),
        (
            KIND + TALL,
            "  - {kind: justification, nucleus: kind, satellite: tall}\n"
            "  - {kind: justification, nucleus: tall, satellite: kind}\n",
            10,
            "justification of 'tall' and 'kind' goes against the justification",
        ),
        (
            KIND.replace("}", ", chapter: 4}") + TALL.replace("}", ", chapter: 3}"),
            "  - {kind: sequence, nucleus: kind, satellite: tall}\n",
            9,
            "'tall' (chapter 3) is told after 'kind' (chapter 4)",
        ),
        (
            KIND.replace("}", ", polarity: good}") + TALL.replace("}", ", polarity: bad}"),
            "  - {kind: restatement, nucleus: kind, satellite: tall}\n",
            9,
            "'kind' is good news and its restatement 'tall' bad",
        ),
        (
            f"  - {{id: long, predicate: say, object: {'very ' * 25}much, topic: nature}}\n",
            "",
            6,
            "'long' takes 28 words; make it two facts",
        ),
    ],
)
def test_what_check_finds_in_right_files(
    facts: str, relations: str, line: int, message: str, tmp_path: Path
) -> None:
    """Reading takes it; `check` names file, line and remedy."""
    path = _write(tmp_path, HEAD + facts + ("relations:\n" + relations if relations else ""))
    assert read_character(path).entity.id == "a"
    faults = check_path(path).faults
    assert len(faults) == 1
    assert faults[0].startswith(f"{path}:{line}: {message}"), faults


def test_a_topic_without_facts_is_found(tmp_path: Path) -> None:
    path = _write(tmp_path, HEAD.replace("facts:", "topics: {nature: {}, war: {}}\nfacts:") + KIND)
    assert check_path(path).faults == [
        f"{path}:5: no fact has the topic 'war'; remove it, or give it to facts"
    ]
