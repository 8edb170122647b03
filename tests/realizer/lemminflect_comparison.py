"""Every inflected form against lemminflect's whole vocabulary: who differs, and why.

`python -m tests.realizer.lemminflect_comparison` prints each class of differences with its count
and examples. lemminflect is a second opinion, not the truth: each class says which of us is
right. What no class explains is a fault of ours until it is looked at.
"""

from __future__ import annotations

import gzip
from collections.abc import Callable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

from personage_lite.realizer.inflection import Dialect, Inflection, read_inflection
from personage_lite.realizer.words import inflect_adjective, inflect_verb, pluralize
from personage_lite.yaml_reader import read_yaml

DATA = Path(__file__).parents[2] / "lexicons" / "inflection.yaml"
DIALECTS: tuple[Dialect, ...] = ("british", "american")
PARTS = ("verb", "noun", "adj", "adv")


class Difference(NamedTuple):
    """A form of ours that lemminflect does not list."""

    dialect: Dialect
    part: str
    lemma: str
    form: str
    ours: str
    listed: tuple[str, ...]
    # what it lists as the past, for participles
    past: tuple[str, ...] = ()


class Explanation(NamedTuple):
    """A class of differences that were looked at."""

    why: str
    part: str
    holds: Callable[[Difference], bool]


class Comparison(NamedTuple):
    """What came out for one part of speech."""

    compared: int
    # words that lemminflect lists no form of
    unlisted: int
    differences: list[Difference]

    @property
    def agreement(self) -> float:
        """The share of compared forms that lemminflect lists too, in percent."""
        return 100 * (1 - len(self.differences) / self.compared)


# lemminflect's vocabulary


def _entries() -> Iterator[tuple[str, str, list[tuple[str, ...]]]]:
    """Yield lemma, part of speech and the forms listed for each."""
    found = find_spec("lemminflect")
    if found is None or not found.submodule_search_locations:
        raise ModuleNotFoundError("lemminflect is not installed")
    table = Path(found.submodule_search_locations[0]) / "resources" / "infl_lu.csv.gz"
    for line in gzip.decompress(table.read_bytes()).decode("utf-8").splitlines():
        lemma, part, *cells = line.split(",")
        yield lemma, part, [tuple(filter(None, cell.split("/"))) for cell in cells]


def _forms(
    lemma: str, part: str, cells: list[tuple[str, ...]], inflection: Inflection
) -> Iterator[tuple[str, str, tuple[str, ...], tuple[str, ...]]]:
    """Yield form, ours, what is listed, and the past listed for a participle."""
    if part == "verb":
        past, participle, gerund, third = cells
        yield "past", inflect_verb(lemma, "past", inflection), past, ()
        ours = inflect_verb(lemma, "participle", inflection)
        yield "participle", ours, participle or past, past
        yield "gerund", inflect_verb(lemma, "gerund", inflection), gerund, ()
        yield "third", inflect_verb(lemma, "third", inflection), third, ()
        return
    first, last = (cells[0], cells[-1]) if cells else ((), ())
    if part == "noun":
        # A noun listed as its own only plural is one that lemminflect has seen no plural of.
        yield "plural", pluralize(lemma, inflection), () if first == (lemma,) else first, ()
        return
    ours = inflect_adjective(lemma, "comparative", inflection)
    yield "comparative", ours, first or (f"more {lemma}",), ()
    ours = inflect_adjective(lemma, "superlative", inflection)
    yield "superlative", ours, last or (f"most {lemma}",), ()


def compare(dialect: Dialect) -> dict[str, Comparison]:
    """Return the comparison of each part of speech in one dialect."""
    inflection = read_inflection(read_yaml(DATA), dialect)
    compared = dict.fromkeys(PARTS, 0)
    unlisted = dict.fromkeys(PARTS, 0)
    differences: dict[str, list[Difference]] = {part: [] for part in PARTS}
    for lemma, part, cells in _entries():
        for form, ours, listed, past in _forms(lemma, part, cells, inflection):
            if not listed:
                unlisted[part] += 1
                continue
            compared[part] += 1
            if ours not in listed:
                differences[part].append(Difference(dialect, part, lemma, form, ours, listed, past))
    return {part: Comparison(compared[part], unlisted[part], differences[part]) for part in PARTS}


# The classes: the first that holds counts


def _lemmas(text: str) -> Callable[[Difference], bool]:
    words = frozenset(text.split())
    return lambda found: found.lemma in words


def _doubled_l(found: Difference) -> bool:
    single = found.ours.replace("lled", "led").replace("lling", "ling")
    return found.dialect == "british" and single != found.ours and single in found.listed


def _single_l(found: Difference) -> bool:
    double = found.lemma + "l"
    return found.dialect == "american" and any(form.startswith(double) for form in found.listed)


def _without_hyphens(found: Difference) -> bool:
    plain = found.ours.replace("-", "")
    return plain in [form.replace("-", "").replace(" ", "") for form in found.listed]


def _other_capitals(found: Difference) -> bool:
    """Whether lemminflect's form differs in its capitals: Mcbrides, pH."""
    plain = (found.ours.lower(), found.lemma.lower())
    return any(form.lower() in plain and form != found.lemma for form in found.listed)


def _kept_e(found: Difference) -> bool:
    """Whether lemminflect has added -er to a word that ends in -e or -ey: blueer, noseyer."""
    return found.lemma.endswith(("e", "ey")) and found.listed[0].startswith(
        (found.lemma + "er", found.lemma + "est")
    )


EXPLANATIONS: tuple[Explanation, ...] = (
    Explanation("British doubles the l; only the American form is listed", "verb", _doubled_l),
    Explanation("American keeps one l; only the British form is listed", "verb", _single_l),
    Explanation(
        "our participle is listed as the past; as the participle only a rarer form is",
        "verb",
        lambda found: found.form == "participle" and found.ours in found.past,
    ),
    Explanation("the same but for a hyphen", "verb", _without_hyphens),
    Explanation(
        "a slip of lemminflect (betrode), or two words taken for a verb (log-in)",
        "verb",
        _lemmas(
            "bestride joy-ride joyride lightning log-in login mimic quid torpedo typeset wrought"
        ),
    ),
    Explanation(
        "irregular as the verb within it is, or unchanged; only a rarer -ed is listed",
        "verb",
        _lemmas(
            "broadcast day-dream forecast outspread overcast overspend re-learn relearn "
            "sublet telecast trouble-shoot underlay unmake"
        ),
    ),
    Explanation(
        "nouns that are hardly ever verbs",
        "verb",
        _lemmas("dip-stick Marathon marathon moire rabbit rennet up-take uptake"),
    ),
    Explanation(
        "both are good; the dictionaries give ours first",
        "verb",
        _lemmas("awe enrol fresco halo lassoo outcrop pal program re-program reprogram run tar"),
    ),
    Explanation("a name keeps its capitals", "noun", _other_capitals),
    Explanation(
        "a name in -y adds -s: two Marys",
        "noun",
        _lemmas("Almighty Billy Burgundy Johnny Malagasy Micky Quaternary"),
    ),
    Explanation(
        "a name like a noun inflects as the noun; -ch goes by the rule",
        "noun",
        _lemmas("Wolf Workman Graves Heimlich Koch"),
    ),
    Explanation(
        "both are good; the dictionaries give ours first",
        "noun",
        _lemmas("anthrax aureola charisma crux eucalyptus gusto insigne lemma OK person redo"),
    ),
    Explanation("ours has no singular or no plural", "noun", _lemmas("antics clergy folk pasta")),
    Explanation(
        "Latin words that are no English nouns, or a slip of lemminflect",
        "noun",
        _lemmas("comes dens good-by pars pus via zirconium"),
    ),
    Explanation("lemminflect adds -er to a whole word in -e: blueer", "adj", _kept_e),
    Explanation("lemminflect adds -er to a whole word in -e: freeer", "adv", _kept_e),
    Explanation(
        "both are good, and more is the commoner",
        "adj",
        _lemmas(
            "abrupt acute buxom civil common damned distinct exact golden impure inapt "
            "intense loyal mature minute modern obtuse often overripe rapid real remote right "
            "secure sedate severe sincere sugary threadbare tranquil void wicked"
        ),
    ),
    Explanation(
        "lemminflect adds -er to what never takes it: disputanter",
        "adj",
        _lemmas(
            "Lilliputian lilliputian atonal child-proof childproof clarion disputant emissary "
            "imbecilic infelicitous mellifluous mendicant mere mettlesome minatory palatial "
            "picaresque sedulous sententious thermoplastic"
        ),
    ),
    Explanation("lemminflect adds -er to what never takes it", "adv", _lemmas("correctly")),
    Explanation(
        "less is of amounts, worse is no degree of wrong, slyer and slier are both good",
        "adj",
        _lemmas("little sly wrong"),
    ),
    Explanation(
        "short, or long in -y or -le: -er by the dictionaries; no degree is listed",
        "adj",
        _lemmas(
            "bandy blank blithe bluff callow chary chaste cheery choosy clayey comely croupy "
            "curst daft darn droll edgy false fey fickle fleet floury frisky glossy hale inky "
            "itchy lank lithe meagre measly mucky muggy musky nervy nigh nimble nippy nutty "
            "paltry peak pert phony plane pliant plumb polite privy pushy rank rash rave raw "
            "reedy sallow slippery smudgy snobby snub sombre springy squat staid suave sultry "
            "supple surly swell tacky tingly trite uncanny unholy unlucky unready unstable "
            "unsteady unsubtle unwary unworthy warty weepy wobbly wry"
        ),
    ),
    Explanation(
        "as the adjective of the same form; no degree is listed",
        "adv",
        _lemmas(
            "badly cold darn dead deadly fain fair fine flat ill late likely little loose "
            "mighty nigh plumb pretty prompt prone proud round scarce sharp sheer square "
            "stark stiff still sure wild"
        ),
    ),
)


def explain(differences: list[Difference]) -> tuple[dict[str, list[Difference]], list[Difference]]:
    """Return the differences by the reason of their class, and those without one."""
    classes: dict[str, list[Difference]] = {}
    rest: list[Difference] = []
    for found in differences:
        for explanation in EXPLANATIONS:
            if explanation.part == found.part and explanation.holds(found):
                classes.setdefault(explanation.why, []).append(found)
                break
        else:
            rest.append(found)
    return classes, rest


def _shown(found: Difference) -> str:
    return f"{found.ours} (lists {'/'.join(found.listed)})"


def main() -> None:
    """Print the comparison of both dialects."""
    for dialect in DIALECTS:
        for part, comparison in compare(dialect).items():
            classes, rest = explain(comparison.differences)
            print(
                f"\n{dialect} {part}: {comparison.compared} forms compared, "
                f"{comparison.agreement:.2f} % agree"
                + (f", {comparison.unlisted} have no form listed" if comparison.unlisted else "")
            )
            for why, members in sorted(classes.items(), key=lambda item: -len(item[1])):
                examples = "; ".join(_shown(found) for found in members[:4])
                print(f"  {len(members):4} {why}: {examples}")
            print(f"  {len(rest):4} unexplained" + "".join(f"\n       {_shown(f)}" for f in rest))


if __name__ == "__main__":
    main()
