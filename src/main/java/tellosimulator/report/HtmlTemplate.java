package tellosimulator.report;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.files.Sha256;

/**
 * An HTML page with placeholders such as {@code {{title}}}. Not thread-safe.
 *
 * <p>Markup in text values is escaped; scripts and styles are inserted unchanged.
 */
final class HtmlTemplate {

  private static final Pattern PLACE = Pattern.compile("\\{\\{([a-z.-]+)}}");

  private final String page;
  private final Map<String, String> values = new HashMap<>();

  HtmlTemplate(String page) {
    this.page = page;
  }

  /**
   * Returns a page whose body is a resource of this package, in the language of the texts. The page
   * begins with the head that all pages share. The caller must set {@code title} and {@link
   * #ownCode}.
   *
   * @param name name of the resource that contains the page's body
   */
  static HtmlTemplate page(String name, ReportTexts texts) {
    HtmlTemplate page = new HtmlTemplate(resource("head.html") + resource(name));
    texts.all().forEach((key, text) -> page.text("text." + key, text));
    return page.text("language", texts.language());
  }

  /** Reads a resource of this package. */
  static String resource(String name) {
    try (InputStream file = HtmlTemplate.class.getResourceAsStream(name)) {
      return new String(file.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(name + " cannot be read", e);
    }
  }

  /** Sets the text for a placeholder; the text is escaped. */
  HtmlTemplate text(String place, String text) {
    return code(place, escaped(text));
  }

  /**
   * Sets the content for a placeholder; the content is inserted unchanged.
   *
   * @param code trusted content from this program
   */
  HtmlTemplate code(String place, String code) {
    values.put(place, code);
    return this;
  }

  /**
   * Sets the page's style and script. Also sets a policy that forbids any other style or script,
   * and forbids the page to load or send anything.
   *
   * @param script the script; empty if the page runs none
   */
  HtmlTemplate ownCode(String style, String script) {
    String policy =
        "default-src 'none'; img-src data:; style-src '"
            + digest(style)
            + "'; script-src "
            + (script.isEmpty() ? "'none'" : "'" + digest(script) + "'")
            + "; base-uri 'none'; form-action 'none'";
    return text("policy", policy).code("style", style).code("script", script);
  }

  private static String digest(String code) {
    byte[] digest = Sha256.create().digest(code.getBytes(StandardCharsets.UTF_8));
    return "sha256-" + Base64.getEncoder().encodeToString(digest);
  }

  /**
   * Returns the page with all placeholders replaced.
   *
   * @throws IllegalArgumentException if a placeholder has no value
   */
  String filled() {
    StringBuilder filled = new StringBuilder();
    Matcher matcher = PLACE.matcher(page);
    int end = 0;
    while (matcher.find()) {
      String value = values.get(matcher.group(1));
      if (value == null) {
        throw new IllegalArgumentException("there is no value for " + matcher.group());
      }
      filled.append(page, end, matcher.start()).append(value);
      end = matcher.end();
    }
    return filled.append(page.substring(end)).toString();
  }

  /** Escapes a text for markup, including quoted attribute values. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;")
        .replace("'", "&#39;");
  }

  /** Escapes JSON so that it cannot close the script element that contains it. */
  static String escapedJson(String json) {
    return json.replace("<", "\\u003c"); // "<" occurs only within strings
  }
}
