package tellosimulator.view.text;

import java.io.IOException;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import tellosimulator.files.IoReason;
import tellosimulator.translation.PhraseCatalog;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.words.Phrase;
import tellosimulator.words.Translation;

/**
 * The language of the window. Texts follow its changes immediately. Confined to the JavaFX thread.
 */
public final class Language {

  private final ObjectProperty<Locale> locale = new SimpleObjectProperty<>();
  private final Map<Locale, Translation> translations = new HashMap<>();

  public Language(Locale locale) {
    this.locale.set(PhraseCatalog.nearest(locale));
  }

  /** The chosen locale: one of {@link PhraseCatalog#OFFERED}. */
  public ObjectProperty<Locale> localeProperty() {
    return locale;
  }

  /** Returns the codec for a language in the settings. */
  public static SettingCodec<Locale> codec() {
    return new SettingCodec<>(
        "one of "
            + String.join(", ", PhraseCatalog.OFFERED.stream().map(Locale::getLanguage).toList()),
        text ->
            PhraseCatalog.OFFERED.stream()
                .filter(offer -> offer.getLanguage().equals(text))
                .findFirst(),
        Locale::getLanguage);
  }

  /** Returns the chosen locale: one of {@link PhraseCatalog#OFFERED}. */
  public Locale locale() {
    return locale.get();
  }

  /** Translates a phrase into the current language. */
  public String say(Phrase phrase) {
    return phrase.in(translation());
  }

  /** Returns the reason why a file could not be written, in the current language. */
  public String reason(IOException e) {
    Object reason = IoReason.of(e);
    return reason instanceof Phrase phrase ? say(phrase) : reason.toString();
  }

  /**
   * Returns the translation into the current language, for callers that format phrases themselves.
   */
  public Translation translation() {
    return translations.computeIfAbsent(locale(), PhraseCatalog::of);
  }

  /**
   * Returns a language for a temporary view. A change of the locale in either object applies to
   * both.
   */
  public Language linked() {
    Language other = new Language(locale());
    other.locale.bindBidirectional(locale); // the binding holds no strong references
    return other;
  }

  /**
   * Returns the texts for the views of a package.
   *
   * @param view any class of the package; the texts are in {@code messages.properties} and {@code
   *     messages_de.properties} next to it
   */
  public Messages messages(Class<?> view) {
    return new Messages(this, view);
  }
}
