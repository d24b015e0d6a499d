package tellosimulator.web;

import java.util.Locale;
import java.util.Map;
import java.util.MissingResourceException;
import java.util.ResourceBundle;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.translation.PhraseCatalog;
import tellosimulator.words.Phrase;
import tellosimulator.words.Translation;

/**
 * The texts of the pages in one language. A key such as {@code controls.drones.on} names a file of
 * the window's texts, and the key in it; {@code web} is the file of the pages. Immutable.
 */
final class WebTexts {

  /** A placeholder of a page. */
  private static final Pattern PLACE = Pattern.compile("\\{\\{([a-zA-Z.-]+)}}");

  private final Translation translation;

  WebTexts(Locale locale) {
    translation = PhraseCatalog.of(locale);
  }

  Translation translation() {
    return translation;
  }

  /** Translates a phrase. */
  String say(Phrase phrase) {
    return phrase.in(translation);
  }

  /**
   * Returns a text.
   *
   * @throws MissingResourceException if there is none
   */
  String text(String key, Object... values) {
    int dot = key.indexOf('.');
    String file = key.substring(0, dot);
    String name = "tellosimulator." + (file.equals("web") ? file : "view." + file) + ".messages";
    ResourceBundle.Control noSystemLanguage =
        ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES);
    String template =
        ResourceBundle.getBundle(
                name, translation.locale(), WebTexts.class.getClassLoader(), noSystemLanguage)
            .getString(key.substring(dot + 1));
    return Phrase.format(translation.locale(), template, values);
  }

  /**
   * Returns a page with its placeholders replaced by texts or values.
   *
   * @param values the values of placeholders that name no text
   */
  String filled(String page, Map<String, String> values) {
    return PLACE
        .matcher(page)
        .replaceAll(
            place -> {
              String value = values.get(place.group(1));
              return Matcher.quoteReplacement(
                  escaped(value == null ? text(place.group(1)) : value));
            });
  }

  /** Escapes a text for markup, including quoted attribute values. */
  private static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
