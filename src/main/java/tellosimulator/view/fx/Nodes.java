package tellosimulator.view.fx;

import java.util.Locale;
import java.util.function.Function;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Button;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.MenuItem;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.util.StringConverter;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Configures nodes with the settings that most views need. Most methods return their node, so that
 * they can be used where the node is created. Confined to the JavaFX thread.
 */
public final class Nodes {

  private Nodes() {}

  /**
   * Adds the styles that all windows use in addition to the theme: readable colours, one hover
   * style and one focus ring.
   *
   * @param root the root of a window
   */
  public static void addCommonStyles(Parent root) {
    root.getStylesheets().add(Nodes.class.getResource("common.css").toExternalForm());
  }

  /** Sets the id of a node and adds style classes. */
  public static <N extends Node> N named(N node, String id, String... styleClasses) {
    node.setId(id);
    return styled(node, styleClasses);
  }

  /** Adds style classes to a node. */
  public static <N extends Node> N styled(N node, String... styleClasses) {
    node.getStyleClass().addAll(styleClasses);
    return node;
  }

  /** Sets the description of a node, for its tooltip and for screen readers. */
  public static <N extends Node> N described(N node, ObservableValue<String> description) {
    Tooltips.install(node, description);
    node.accessibleTextProperty().bind(description);
    return node;
  }

  /** Returns a label whose text is bound to a value. */
  public static Label label(ObservableValue<String> text, String... styleClasses) {
    Label label = styled(new Label(), styleClasses);
    label.textProperty().bind(text);
    return label;
  }

  /** Sets the id, text and action of a menu item. */
  public static <I extends MenuItem> I menuItem(
      I item, String id, ObservableValue<String> text, Runnable action) {
    item.setId(id);
    item.textProperty().bind(text);
    item.setOnAction(chosen -> action.run());
    return item;
  }

  /** Returns a small button with an icon; its tooltip is the description. */
  public static Button iconButton(String id, Ikon icon, ObservableValue<String> description) {
    return described(named(new Button("", new FontIcon(icon)), id, "icon-button"), description);
  }

  /** Returns a button with an icon, a text, and a tooltip. */
  public static Button button(
      String id, Ikon icon, ObservableValue<String> text, ObservableValue<String> hint) {
    Button button = named(new Button("", new FontIcon(icon)), id);
    button.textProperty().bind(text);
    Tooltips.install(button, hint);
    return button;
  }

  /** Returns a wrapping label that takes no space while its text is empty. */
  public static Label sentence(String id, String... styleClasses) {
    Label label = wrapping(named(new Label(), id, styleClasses));
    showIf(label, label.textProperty().isNotEmpty());
    return label;
  }

  /** Makes a label wrap its text instead of cutting it off. */
  public static Label wrapping(Label label) {
    label.setWrapText(true);
    label.setMinHeight(Region.USE_PREF_SIZE);
    return label;
  }

  /** Makes a node take the remaining width of its {@link HBox}. */
  public static <R extends Region> R growing(R region) {
    region.setMaxWidth(Double.MAX_VALUE);
    HBox.setHgrow(region, Priority.ALWAYS);
    return region;
  }

  /** Prevents a node from becoming narrower than its content. */
  public static <R extends Region> R unshrinkable(R region) {
    region.setMinWidth(Region.USE_PREF_SIZE);
    return region;
  }

  /** Sets a constant width [px]. */
  public static void fixWidth(Region region, double width) {
    region.setMinWidth(width);
    region.setPrefWidth(width);
    region.setMaxWidth(width);
  }

  /** Names the items of a choice box. The names follow the language. */
  public static <T> void nameItems(
      ChoiceBox<T> box, ObservableValue<Locale> locale, Function<T, String> name) {
    StringConverter<T> converter =
        new StringConverter<>() {
          @Override
          public String toString(T value) {
            return value == null ? "" : name.apply(value);
          }

          @Override
          public T fromString(String typed) {
            throw new UnsupportedOperationException("items are chosen, not typed");
          }
        };
    locale.subscribe(
        now -> {
          box.setConverter(null); // otherwise the box would keep the old names
          box.setConverter(converter);
        });
  }

  /** Shows a node, or hides it so that it takes no space. */
  public static void setShown(Node node, boolean shown) {
    node.setVisible(shown);
    node.setManaged(shown);
  }

  /** Shows a node only while a condition holds; otherwise it takes no space. */
  public static <N extends Node> N showIf(N node, ObservableValue<Boolean> shown) {
    node.visibleProperty().bind(shown);
    return collapsible(node);
  }

  /** Makes a node take no space while it is invisible. */
  public static <N extends Node> N collapsible(N node) {
    node.managedProperty().bind(node.visibleProperty());
    return node;
  }
}
