import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The process in which SimpleNLG runs; it answers the same lines as ../realizer_worker.py.
 *
 * <p>"say" answers with what it says; "SECONDS NAME…" makes these sentences for so many seconds
 * and answers with the counts.
 */
public final class Worker {
    private static long kept;

    private Worker() {}

    /** Answers line by line until the input ends. */
    public static void main(String[] arguments) throws IOException {
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        BufferedReader in =
            new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        Sentences sentences = new Sentences();
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            String[] words = line.trim().split(" ");
            if (words[0].equals("say")) {
                out.println(said(sentences));
            } else {
                String[] names = Arrays.copyOfRange(words, 1, words.length);
                out.println(timed(sentences, Double.parseDouble(words[0]), names));
            }
        }
        if (kept == 0) { // Only so that the texts cannot be optimized away.
            System.err.println("nothing was said");
        }
    }

    private static String said(Sentences sentences) {
        StringBuilder json = new StringBuilder();
        for (String name : sentences.names()) {
            String text;
            try {
                text = sentences.say(name);
            } catch (RuntimeException error) { // Any failure is one sentence less.
                text = "<" + error + ">";
            }
            json.append(json.length() == 0 ? "{" : ", ");
            json.append(quoted(name)).append(": ").append(quoted(text));
        }
        return json.append("}").toString();
    }

    private static String timed(Sentences sentences, double seconds, String[] names) {
        long start = System.nanoTime();
        long limit = (long) (seconds * 1e9);
        long made = 0;
        long elapsed;
        do {
            for (String name : names) {
                kept += sentences.say(name).length();
            }
            made += names.length;
            elapsed = System.nanoTime() - start;
        } while (elapsed < limit);
        return "{\"seconds\": " + elapsed / 1e9 + ", \"sentences\": " + made + "}";
    }

    private static String quoted(String text) {
        return "\"" + text.strip().replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
    }
}
