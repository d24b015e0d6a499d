package tellosimulator.report;

import java.util.Enumeration;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.ResourceBundle;
import tellosimulator.words.Phrase;
import tellosimulator.words.Translation;

/** The localized texts of a report. Must not be used by two threads at the same time. */
public final class ReportTexts {

  private static final String BASE_NAME = ReportTexts.class.getPackageName() + ".messages";

  private final Translation translation;
  private final ResourceBundle bundle;

  /**
   * Creates the texts in the language of a translation.
   *
   * @param translation the translation of the simulation's messages; if the page's texts do not
   *     exist in its language, they are English
   */
  public ReportTexts(Translation translation) {
    this.translation = translation;
    ResourceBundle.Control noSystemLanguage =
        ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES);
    bundle =
        ResourceBundle.getBundle(
            BASE_NAME, translation.locale(), ReportTexts.class.getClassLoader(), noSystemLanguage);
  }

  /** The code of the page's language, such as {@code de}. */
  String language() {
    String code = locale().getLanguage();
    return code.isEmpty() ? Locale.ENGLISH.getLanguage() : code;
  }

  Locale locale() {
    return bundle.getLocale();
  }

  /** Returns a text with its placeholders replaced by values. */
  String of(String key, Object... values) {
    return Phrase.format(locale(), bundle.getString(key), values);
  }

  /** Returns a text with its placeholders still in it; empty if no text has this key. */
  Optional<String> template(String key) {
    return bundle.containsKey(key) ? Optional.of(bundle.getString(key)) : Optional.empty();
  }

  String say(Phrase phrase) {
    return phrase.in(translation);
  }

  /** Returns the word for a flight phase. */
  String phase(String word) {
    return template("phase." + word).orElse(word);
  }

  /** All texts by key, with their placeholders still in them. */
  Map<String, String> all() {
    Map<String, String> all = new LinkedHashMap<>();
    for (Enumeration<String> keys = bundle.getKeys(); keys.hasMoreElements(); ) {
      String key = keys.nextElement();
      all.put(key, bundle.getString(key));
    }
    return all;
  }
}
