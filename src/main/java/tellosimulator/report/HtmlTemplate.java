package tellosimulator.report;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A page with places such as {@code {{title}}}, which are filled in. Not thread-safe.
 *
 * <p>Values are texts, in which markup is escaped. What goes into a script or a style is put in as
 * it is.
 */
final class HtmlTemplate {

  private static final Pattern PLACE = Pattern.compile("\\{\\{([a-z.-]+)}}");

  private final String page;
  private final Map<String, String> values = new HashMap<>();

  HtmlTemplate(String page) {
    this.page = page;
  }

  /**
   * A page of this package in the language of some texts, with the head that all pages have: it
   * wants {@code title} and {@link #ownCode}.
   *
   * @param name of the resource that has the page's body
   */
  static HtmlTemplate page(String name, ReportTexts texts) {
    HtmlTemplate page = new HtmlTemplate(resource("head.html") + resource(name));
    texts.all().forEach((key, text) -> page.text("text." + key, text));
    return page.text("language", texts.language());
  }

  /** A resource of this package. */
  static String resource(String name) {
    try (InputStream file = HtmlTemplate.class.getResourceAsStream(name)) {
      return new String(file.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(name + " cannot be read", e);
    }
  }

  /** Says what is put into a place. */
  HtmlTemplate text(String place, String text) {
    return code(place, escaped(text));
  }

  /**
   * Says what is put into a place as it is.
   *
   * @param code of the program's own
   */
  HtmlTemplate code(String place, String code) {
    values.put(place, code);
    return this;
  }

  /**
   * Says what the page looks like and what it does: nothing may be loaded or sent, and no other
   * style or script applies.
   *
   * @param script empty if the page runs none
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
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(code.getBytes(StandardCharsets.UTF_8));
      return "sha256-" + Base64.getEncoder().encodeToString(digest);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("each JDK has SHA-256", e);
    }
  }

  /**
   * The page.
   *
   * @throws IllegalArgumentException if a place has no value
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

  /** A text as markup has it, also within the quotes of an attribute. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;")
        .replace("'", "&#39;");
  }

  /** JSON that cannot end the script that it is in. */
  static String escapedJson(String json) {
    return json.replace("<", "\\u003c"); // stands in texts alone, where this means the same
  }
}
