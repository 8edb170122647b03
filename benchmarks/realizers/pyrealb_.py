"""The sentences in pyrealb's terms; realizing spoils its trees, so it must build them anew."""

# mypy: disable-error-code="import-untyped, import-not-found"

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pyrealb import CP, NO, NP, PP, SP, VP, A, Adv, C, D, N, P, Pro, Q, S, V

from realizers import Builders

Tree = Any


def the(noun: str) -> Tree:
    """Return a noun phrase with its noun from the lexicon."""
    return NP(D("the"), N(noun))


def named(name: str) -> Tree:
    """Return a noun phrase with a name, which pyrealb leaves as it is."""
    return NP(D("the"), Q(name))


def a(*words: Tree) -> Tree:
    """Return a noun phrase with an indefinite article."""
    return NP(D("a"), *words)


def she() -> Tree:
    """Return the pronoun of Alice."""
    return Pro("I").pe(3).g("f")


SPECIFICATIONS: dict[str, Callable[[], Tree]] = {
    "copula": lambda: S(Q("Alice"), VP(V("be"), a(A("imaginative"), N("girl")))),
    "negation": lambda: S(
        named("Queen of Hearts"), VP(V("like"), NP(A("white"), N("rose")).n("p"))
    ).typ({"neg": True}),
    "although": lambda: S(
        SP(C("although"), she(), VP(V("be"), A("small"))).a(","), named("Queen"), VP(V("shout"))
    ),
    "passive_perfect": lambda: S(the("card").n("p"), VP(V("chase"), Pro("me").pe(3).g("f"))).typ(
        {"pas": True, "perf": True}
    ),
    "possessive_pronoun": lambda: S(
        named("White Rabbit"),
        VP(V("lose").t("ps"), NP(D("my").pe(3).ow("s").g("m"), N("glove").n("p"))),
    ),
    "future": lambda: S(named("Cheshire Cat"), VP(V("grin"), PP(P("at"), named("Duchess")))).t("f"),
    "past_progressive": lambda: S(
        named("Hatter"), VP(V("drink").t("ps"), NP(N("tea")), PP(P("with"), named("March Hare")))
    ).typ({"prog": True}),
    "past_perfect": lambda: S(
        Q("Alice"), VP(V("eat").t("ps"), NP(D("the"), A("small"), N("cake")))
    ).typ({"perf": True}),
    "passive_past": lambda: S(named("Knave"), VP(V("steal").t("ps"), the("tart").n("p"))).typ(
        {"pas": True}
    ),
    "modal_negation": lambda: S(named("Dormouse"), VP(V("stay"), A("awake"))).typ(
        {"mod": "poss", "neg": True, "contr": True}
    ),
    "modal_perfect": lambda: S(named("Knave"), VP(V("steal"), the("tart").n("p"))).typ(
        {"mod": "obli", "perf": True}
    ),
    "yes_no": lambda: S(named("Caterpillar"), VP(V("smoke"), a(N("pipe")))).typ({"int": "yon"}),
    "yes_no_past": lambda: S(named("King"), VP(V("forgive").t("ps"), named("Knave"))).typ(
        {"int": "yon"}
    ),
    "who": lambda: S(named("Knave"), VP(V("steal").t("ps"), the("tart").n("p"))).typ(
        {"int": "wos"}
    ),
    "what": lambda: S(named("Rabbit"), VP(V("lose").t("ps"), the("glove").n("p"))).typ(
        {"int": "wad"}
    ),
    "where": lambda: S(named("Duchess"), VP(V("live"))).typ({"int": "whe"}),
    "why": lambda: S(named("Hatter"), VP(V("sing"))).typ({"int": "why", "prog": True}),
    "relative_subject": lambda: S(
        Q("Alice"),
        VP(V("follow"), a(N("rabbit"), SP(Pro("that"), VP(V("wear"), a(N("waistcoat")))))),
    ),
    "relative_object": lambda: S(
        NP(D("the"), N("key"), SP(Pro("that"), Q("Alice"), VP(V("find").t("ps")))),
        VP(V("open"), a(A("little"), N("door"))),
    ),
    "because": lambda: S(
        named("Rabbit"),
        VP(V("hurry"), SP(C("because"), Pro("I").pe(3).g("m"), VP(V("be"), A("late")))),
    ),
    "when": lambda: S(
        SP(C("when"), named("Queen"), VP(V("shout").t("ps"))).a(","),
        the("gardener").n("p"),
        VP(V("fall").t("ps")),
    ),
    "and_names": lambda: S(
        CP(C("and"), named("Hatter"), named("March Hare"), named("Dormouse")),
        VP(V("be"), NP(N("friend")).n("p")),
    ),
    "and_adjectives": lambda: S(
        Q("Alice"), VP(V("be"), CP(C("and"), A("kind"), A("curious"), A("polite")))
    ),
    "and_clauses": lambda: S(
        CP(
            C("and"),
            SP(named("Queen"), VP(V("shout"))),
            SP(the("gardener").n("p"), VP(V("tremble"))),
        )
    ),
    "and_predicates": lambda: S(
        Q("Alice"), CP(C("and"), VP(V("open"), the("bottle")), VP(V("drink"), the("potion")))
    ),
    "irregular_plurals": lambda: S(
        the("child").n("p"),
        VP(V("feed"), CP(C("and"), NP(NO(2).nat(), N("goose")), NP(NO(3).nat(), N("mouse")))),
    ),
    "possessive": lambda: S(NP(Q("Alice").poss(), N("sister")), VP(V("read"), a(N("book")))),
    "plural_possessive": lambda: S(
        NP(D("the"), N("gardener").n("p").poss(), N("brush").n("p")), VP(V("be"), A("red"))
    ),
    "pronouns": lambda: S(
        Pro("I").pe(3).n("p"),
        VP(V("give").t("ps"), Pro("me").pe(3).g("f"), a(A("golden"), N("key"))),
    ),
    "prepositions": lambda: S(
        Q("Alice"),
        VP(V("fall"), PP(P("into"), a(A("deep"), N("hole"), PP(P("under"), the("hedge"))))),
    ),
    "infinitive": lambda: S(
        named("Queen"), VP(V("want"), VP(V("play").t("b-to"), NP(N("croquet"))))
    ),
    "object_infinitive": lambda: S(
        named("Duchess"), VP(V("tell").t("ps"), Q("Alice"), VP(V("leave").t("b-to")))
    ),
    "a_an": lambda: S(a(N("unicorn")), VP(V("wait"), PP(P("for"), a(N("hour"))))),
    "contraction": lambda: S(Q("Alice"), VP(V("be"), A("afraid"))).typ(
        {"neg": True, "contr": True}
    ),
    "imperative": lambda: S(VP(V("wake").t("ip"), named("Dormouse"))).typ({"neg": True}),
    "existential": lambda: S(
        Adv("there"), VP(V("be").n("p"), NP(N("tart")).n("p"), PP(P("on"), the("table")))
    ),
    "comparative": lambda: S(
        Q("Alice"), VP(V("be"), A("tall").f("co"), PP(P("than"), the("mushroom")))
    ),
    "superlative": lambda: S(
        named("Queen"),
        VP(V("be"), NP(D("the"), A("angry").f("su"), N("person")), PP(P("in"), Q("Wonderland"))),
    ),
    "adverbs": lambda: S(named("Cat"), VP(Adv("often"), V("disappear"), Adv("slowly"))),
    "that_clause": lambda: S(
        Q("Alice"), VP(V("think"), SP(C("that"), named("Hatter"), VP(V("be"), A("rude"))))
    ),
}


def builders() -> Builders:
    """Return a function for each sentence."""
    return {
        name: lambda build=build: build().realize()  # type: ignore[misc]
        for name, build in SPECIFICATIONS.items()
    }
