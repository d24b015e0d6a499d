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

/** The language of the window; texts follow it at once. For the JavaFX thread. */
public final class Language {

  private final ObjectProperty<Locale> locale = new SimpleObjectProperty<>();
  private final Map<Locale, Translation> translations = new HashMap<>();

  public Language(Locale locale) {
    this.locale.set(PhraseCatalog.nearest(locale));
  }

  /** One of {@link PhraseCatalog#OFFERED}. */
  public ObjectProperty<Locale> localeProperty() {
    return locale;
  }

  /** How a language is written in the settings. */
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

  /** One of {@link PhraseCatalog#OFFERED}. */
  public Locale locale() {
    return locale.get();
  }

  /** What the simulation says about itself, in the present language. */
  public String say(Phrase phrase) {
    return phrase.in(translation());
  }

  /** Why a file could not be written, in the present language. */
  public String reason(IOException e) {
    Object reason = IoReason.of(e);
    return reason instanceof Phrase phrase ? say(phrase) : reason.toString();
  }

  /** The present language, for those who make sentences of phrases. */
  public Translation translation() {
    return translations.computeIfAbsent(locale(), PhraseCatalog::of);
  }

  /** The same language for a while; each of them follows the other. */
  public Language linked() {
    Language other = new Language(locale());
    other.locale.bindBidirectional(locale); // which holds neither of them in memory
    return other;
  }

  /**
   * The texts for the views of a package.
   *
   * @param view any class of the package; the texts are in {@code messages.properties} and {@code
   *     messages_de.properties} beside it
   */
  public Messages messages(Class<?> view) {
    return new Messages(this, view);
  }
}
