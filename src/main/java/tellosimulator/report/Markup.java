package tellosimulator.report;

import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.words.Printable;

/** HTML or XML in which all texts from outside are escaped. Immutable. */
record Markup(String text) {

  static final Markup NONE = new Markup("");

  /**
   * Fills a template. Texts are escaped, and control characters in them made visible; markup is
   * inserted unchanged.
   *
   * @param template trusted markup with {@code %s} for each value
   */
  static Markup of(String template, Object... values) {
    Object[] safe = values.clone();
    for (int i = 0; i < safe.length; i++) {
      if (safe[i] instanceof String outside) {
        safe[i] = HtmlTemplate.escaped(Printable.of(outside));
      }
    }
    return new Markup(String.format(Locale.ROOT, template, safe));
  }

  /** Returns a text as markup in which what stands between backticks is code. */
  static Markup quoted(String outside) {
    return new Markup(of("%s", outside).text.replaceAll("`([^`]*)`", "<code>$1</code>"));
  }

  static Markup all(Stream<Markup> parts) {
    return new Markup(parts.map(Markup::text).collect(Collectors.joining("\n")));
  }

  @Override
  public String toString() {
    return text;
  }
}
