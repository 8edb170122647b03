import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import simplenlg.features.ClauseStatus;
import simplenlg.features.Feature;
import simplenlg.features.Form;
import simplenlg.features.Gender;
import simplenlg.features.InternalFeature;
import simplenlg.features.InterrogativeType;
import simplenlg.features.LexicalFeature;
import simplenlg.features.Tense;
import simplenlg.framework.CoordinatedPhraseElement;
import simplenlg.framework.LexicalCategory;
import simplenlg.framework.NLGElement;
import simplenlg.framework.NLGFactory;
import simplenlg.framework.PhraseElement;
import simplenlg.lexicon.Lexicon;
import simplenlg.phrasespec.AdjPhraseSpec;
import simplenlg.phrasespec.NPPhraseSpec;
import simplenlg.phrasespec.SPhraseSpec;
import simplenlg.phrasespec.VPPhraseSpec;
import simplenlg.realiser.english.Realiser;

/** The sentences in SimpleNLG's terms, as ../realizers/simplenlg_.py has them in the Python port's. */
final class Sentences {
    private final Lexicon lexicon = Lexicon.getDefaultLexicon();
    private final NLGFactory factory = new NLGFactory(lexicon);
    private final Realiser realiser = new Realiser(lexicon);
    private final Map<String, Supplier<NLGElement>> specifications = new LinkedHashMap<>();

    Sentences() {
        realiser.setCommaSepCuephrase(true); // A comma after a clause in front.
        verbs();
        questions();
        clauses();
        phrases();
    }

    /** Returns the names of the sentences. */
    Iterable<String> names() {
        return specifications.keySet();
    }

    /** Builds and realizes the named sentence anew. */
    String say(String name) {
        return realiser.realiseSentence(specifications.get(name).get());
    }

    private void verbs() {
        specifications.put("copula", () -> clause("Alice", "be", noun("a", "girl", "imaginative")));
        specifications.put("negation", () -> with(
            clause(noun("the", "Queen of Hearts"), "like", plural(null, "rose", "white")),
            Feature.NEGATED, true));
        specifications.put("passive_perfect", () -> with(with(
            clause(plural("the", "card"), "chase", pronoun("she")),
            Feature.PASSIVE, true), Feature.PERFECT, true));
        specifications.put("future", () -> complement(with(
            clause(noun("the", "Cheshire Cat"), "grin", null), Feature.TENSE, Tense.FUTURE),
            preposition("at", noun("the", "Duchess"))));
        specifications.put("past_progressive", () -> complement(with(
            past(clause(noun("the", "Hatter"), "drink", noun(null, "tea"))),
            Feature.PROGRESSIVE, true), preposition("with", noun("the", "March Hare"))));
        specifications.put("past_perfect", () -> with(
            past(clause("Alice", "eat", noun("the", "cake", "small"))), Feature.PERFECT, true));
        specifications.put("passive_past", () -> with(
            past(clause(noun("the", "Knave"), "steal", plural("the", "tart"))),
            Feature.PASSIVE, true));
        specifications.put("modal_negation", () -> complement(with(with(
            clause(noun("the", "Dormouse"), "stay", null),
            Feature.MODAL, "can"), Feature.NEGATED, true), "awake"));
        specifications.put("modal_perfect", () -> with(with(
            clause(noun("the", "Knave"), "steal", plural("the", "tart")),
            Feature.MODAL, "must"), Feature.PERFECT, true));
        specifications.put("contraction", () -> complement(
            with(clause("Alice", "be", null), Feature.NEGATED, true), "afraid"));
        specifications.put("imperative", () -> with(with(
            clause("you", "wake", noun("the", "Dormouse")),
            Feature.NEGATED, true), Feature.FORM, Form.IMPERATIVE));
        specifications.put("adverbs", () -> {
            SPhraseSpec built = clause(noun("the", "Cat"), "disappear", null);
            built.addPreModifier("often");
            built.addPostModifier("slowly");
            return built;
        });
    }

    private void questions() {
        specifications.put("yes_no", () -> ask(
            clause(noun("the", "Caterpillar"), "smoke", noun("a", "pipe")),
            InterrogativeType.YES_NO));
        specifications.put("yes_no_past", () -> ask(
            past(clause(noun("the", "King"), "forgive", noun("the", "Knave"))),
            InterrogativeType.YES_NO));
        specifications.put("who", () -> ask(
            past(clause(null, "steal", plural("the", "tart"))), InterrogativeType.WHO_SUBJECT));
        specifications.put("what", () -> ask(
            past(clause(noun("the", "Rabbit"), "lose", null)), InterrogativeType.WHAT_OBJECT));
        specifications.put("where", () -> ask(
            clause(noun("the", "Duchess"), "live", null), InterrogativeType.WHERE));
        specifications.put("why", () -> ask(with(
            clause(noun("the", "Hatter"), "sing", null), Feature.PROGRESSIVE, true),
            InterrogativeType.WHY));
    }

    private void clauses() {
        specifications.put("although", () -> front(
            clause(noun("the", "Queen"), "shout", null),
            under("although", complement(clause(pronoun("she"), "be", null), "small"))));
        specifications.put("relative_subject", () -> clause("Alice", "follow", modified(
            noun("a", "rabbit"),
            under("that", clause(null, "wear", noun("a", "waistcoat"))))));
        specifications.put("relative_object", () -> clause(
            modified(noun("the", "key"), under("that", past(clause("Alice", "find", null)))),
            "open", noun("a", "door", "little")));
        specifications.put("because", () -> modified(
            clause(noun("the", "Rabbit"), "hurry", null),
            under("because", complement(clause(pronoun("he"), "be", null), "late"))));
        specifications.put("when", () -> front(
            past(clause(plural("the", "gardener"), "fall", null)),
            under("when", past(clause(noun("the", "Queen"), "shout", null)))));
        specifications.put("and_clauses", () -> and(
            clause(noun("the", "Queen"), "shout", null),
            clause(plural("the", "gardener"), "tremble", null)));
        specifications.put("and_predicates", () -> {
            SPhraseSpec built = factory.createClause();
            built.setSubject("Alice");
            built.setVerbPhrase(and(
                predicate("open", noun("the", "bottle")),
                predicate("drink", noun("the", "potion"))));
            return built;
        });
        specifications.put("infinitive", () -> clause(noun("the", "Queen"), "want", with(
            clause(null, "play", noun(null, "croquet")), Feature.FORM, Form.INFINITIVE)));
        specifications.put("object_infinitive", () -> complement(
            past(clause(noun("the", "Duchess"), "tell", factory.createNounPhrase("Alice"))),
            with(clause(null, "leave", null), Feature.FORM, Form.INFINITIVE)));
        specifications.put("that_clause", () -> clause("Alice", "think",
            complement(clause(noun("the", "Hatter"), "be", null), "rude")));
    }

    private void phrases() {
        specifications.put("possessive_pronoun", () -> past(clause(noun("the", "White Rabbit"),
            "lose", plural(his(), "glove"))));
        specifications.put("and_names", () -> clause(
            and(noun("the", "Hatter"), noun("the", "March Hare"), noun("the", "Dormouse")),
            "be", plural(null, "friend")));
        specifications.put("and_adjectives",
            () -> clause("Alice", "be", and("kind", "curious", "polite")));
        specifications.put("irregular_plurals", () -> clause(plural("the", "child"), "feed",
            and(plural("two", "goose"), plural("three", "mouse"))));
        specifications.put("possessive", () -> clause(
            noun(possessive(factory.createNounPhrase("Alice")), "sister"),
            "read", noun("a", "book")));
        specifications.put("plural_possessive", () -> complement(clause(
            plural(possessive(plural("the", "gardener")), "brush"), "be", null), "red"));
        specifications.put("pronouns", () -> {
            SPhraseSpec built = past(clause("they", "give", noun("a", "key", "golden")));
            built.setIndirectObject(pronoun("she"));
            return built;
        });
        specifications.put("prepositions", () -> complement(clause("Alice", "fall", null),
            preposition("into", modified(
                noun("a", "hole", "deep"), preposition("under", noun("the", "hedge"))))));
        specifications.put("a_an", () -> complement(
            clause(noun("a", "unicorn"), "wait", null), preposition("for", noun("a", "hour"))));
        specifications.put("existential", () -> modified(
            clause("there", "be", plural(null, "tart")), preposition("on", noun("the", "table"))));
        specifications.put("comparative", () -> clause("Alice", "be", modified(
            adjective("tall", Feature.IS_COMPARATIVE),
            preposition("than", noun("the", "mushroom")))));
        specifications.put("superlative", () -> modified(
            clause(noun("the", "Queen"), "be",
                noun("the", "person", adjective("angry", Feature.IS_SUPERLATIVE))),
            preposition("in", factory.createNounPhrase("Wonderland"))));
    }

    private NPPhraseSpec noun(Object determiner, String word, Object... adjectives) {
        NPPhraseSpec phrase = factory.createNounPhrase(determiner, word);
        // The lexicon's word remembers what it was in the sentence before.
        phrase.setFeature(Feature.POSSESSIVE, false);
        for (Object adjective : adjectives) {
            if (adjective instanceof NLGElement) {
                phrase.addPreModifier((NLGElement) adjective);
            } else {
                phrase.addPreModifier((String) adjective);
            }
        }
        return phrase;
    }

    private NPPhraseSpec plural(Object determiner, String word, Object... adjectives) {
        NPPhraseSpec phrase = noun(determiner, word, adjectives);
        phrase.setPlural(true);
        return phrase;
    }

    private NPPhraseSpec pronoun(String word) {
        return factory.createNounPhrase(word);
    }

    /** As a word: a noun phrase here would become "their" before a plural noun. */
    private NLGElement his() {
        NLGElement he = factory.createInflectedWord("he", LexicalCategory.PRONOUN);
        he.setFeature(LexicalFeature.GENDER, Gender.MASCULINE);
        return with(he, Feature.POSSESSIVE, true);
    }

    private NPPhraseSpec possessive(NPPhraseSpec phrase) {
        return with(phrase, Feature.POSSESSIVE, true);
    }

    private AdjPhraseSpec adjective(String word, String degree) {
        return with(factory.createAdjectivePhrase(word), degree, true);
    }

    private PhraseElement preposition(String word, NPPhraseSpec phrase) {
        return factory.createPrepositionPhrase(word, phrase);
    }

    private VPPhraseSpec predicate(String verb, NPPhraseSpec object) {
        VPPhraseSpec phrase = factory.createVerbPhrase(verb);
        phrase.setObject(object);
        return phrase;
    }

    private SPhraseSpec clause(Object subject, String verb, Object object) {
        return factory.createClause(subject, verb, object);
    }

    private SPhraseSpec past(SPhraseSpec clause) {
        return with(clause, Feature.TENSE, Tense.PAST);
    }

    private SPhraseSpec ask(SPhraseSpec clause, InterrogativeType kind) {
        return with(clause, Feature.INTERROGATIVE_TYPE, kind);
    }

    private SPhraseSpec under(String conjunction, SPhraseSpec clause) {
        clause.setFeature(InternalFeature.CLAUSE_STATUS, ClauseStatus.SUBORDINATE);
        return with(clause, Feature.COMPLEMENTISER, conjunction);
    }

    private SPhraseSpec front(SPhraseSpec clause, SPhraseSpec subordinate) {
        clause.addFrontModifier(subordinate);
        return clause;
    }

    private SPhraseSpec complement(SPhraseSpec clause, Object complement) {
        if (complement instanceof NLGElement) {
            clause.addComplement((NLGElement) complement);
        } else {
            clause.addComplement((String) complement);
        }
        return clause;
    }

    private <P extends PhraseElement> P modified(P phrase, NLGElement modifier) {
        phrase.addPostModifier(modifier);
        return phrase;
    }

    private <P extends NLGElement> P with(P element, String feature, Object value) {
        element.setFeature(feature, value);
        return element;
    }

    private CoordinatedPhraseElement and(Object... items) {
        CoordinatedPhraseElement coordination = factory.createCoordinatedPhrase();
        for (Object item : items) {
            coordination.addCoordinate(item);
        }
        return coordination;
    }
}
