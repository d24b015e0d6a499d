package tellosimulator.view.text;

import java.util.Arrays;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.stream.Stream;
import javafx.beans.Observable;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.StringBinding;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Label;
import tellosimulator.words.Phrase;

/** The texts of one package of views in the chosen language. Confined to the JavaFX thread. */
public final class Messages {

  private final Language language;
  private final String baseName;
  private final ClassLoader loader;

  Messages(Language language, Class<?> view) {
    this.language = language;
    this.baseName = view.getPackageName() + ".messages";
    this.loader = view.getClassLoader();
  }

  /**
   * Returns a text that follows the language.
   *
   * @param values the arguments, formatted as in a {@link Phrase}; if an argument is observable,
   *     the text follows its changes
   */
  public StringBinding text(String key, Object... values) {
    Observable[] causes =
        Stream.concat(
                Stream.of(language.localeProperty()),
                Arrays.stream(values)
                    .filter(Observable.class::isInstance)
                    .map(Observable.class::cast))
            .toArray(Observable[]::new);
    return Bindings.createStringBinding(() -> now(key, values), causes);
  }

  /** Returns a label with a text that follows the language. */
  public Label label(String key, String... styleClasses) {
    Label label = new Label();
    label.textProperty().bind(text(key));
    label.getStyleClass().addAll(styleClasses);
    return label;
  }

  /** Returns a text in the current language. */
  public String now(String key, Object... values) {
    Object[] present = Arrays.stream(values).map(Messages::valueOf).toArray();
    return Phrase.format(locale(), bundle().getString(key), present);
  }

  private static Object valueOf(Object value) {
    return value instanceof ObservableValue<?> observable ? observable.getValue() : value;
  }

  private Locale locale() {
    return language.locale();
  }

  private ResourceBundle bundle() {
    ResourceBundle.Control noSystemLanguage =
        ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES);
    return ResourceBundle.getBundle(baseName, locale(), loader, noSystemLanguage);
  }
}
