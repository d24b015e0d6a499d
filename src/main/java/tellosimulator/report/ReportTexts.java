package tellosimulator.report;

import java.util.Enumeration;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.ResourceBundle;
import tellosimulator.words.Phrase;
import tellosimulator.words.Retranslation;
import tellosimulator.words.Translation;

/** The localized texts of a report. For one thread at a time. */
public final class ReportTexts {

  private static final String BASE_NAME = ReportTexts.class.getPackageName() + ".messages";

  private final Translation translation;
  private final Retranslation retranslation;
  private final ResourceBundle bundle;

  /**
   * @param translation of what the simulation says about itself; the texts of the page are English
   *     where there are none in its language
   */
  public ReportTexts(Translation translation) {
    this.translation = translation;
    retranslation = new Retranslation(translation);
    ResourceBundle.Control noSystemLanguage =
        ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES);
    bundle =
        ResourceBundle.getBundle(
            BASE_NAME, translation.locale(), ReportTexts.class.getClassLoader(), noSystemLanguage);
  }

  /** The code of the page's language: {@code de}. */
  String language() {
    String code = locale().getLanguage();
    return code.isEmpty() ? Locale.ENGLISH.getLanguage() : code;
  }

  Locale locale() {
    return bundle.getLocale();
  }

  /** A text with values in its places. */
  String of(String key, Object... values) {
    return Phrase.format(locale(), bundle.getString(key), values);
  }

  /** A text that need not be there, without values. */
  Optional<String> template(String key) {
    return bundle.containsKey(key) ? Optional.of(bundle.getString(key)) : Optional.empty();
  }

  String say(Phrase phrase) {
    return phrase.in(translation);
  }

  /** What a recording says in English words. */
  String translated(String english) {
    return retranslation.of(english);
  }

  /** The word for what a drone is doing. */
  String phase(String word) {
    return template("phase." + word).orElse(word);
  }

  /** All texts by their keys, their places empty. */
  Map<String, String> all() {
    Map<String, String> all = new LinkedHashMap<>();
    for (Enumeration<String> keys = bundle.getKeys(); keys.hasMoreElements(); ) {
      String key = keys.nextElement();
      all.put(key, bundle.getString(key));
    }
    return all;
  }
}
