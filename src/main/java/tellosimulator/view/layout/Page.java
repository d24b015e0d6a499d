package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.view.fx.Nodes;

/**
 * A page over the window: a title, the content, and a row of buttons. Confined to the JavaFX
 * thread.
 */
abstract class Page extends VBox {

  private final Label title = Nodes.styled(new Label(), Styles.TITLE_3);
  private final HBox buttons = Nodes.styled(new HBox(), "page-buttons");

  /**
   * @param id the id of the page and its style class
   */
  Page(String id, ObservableValue<String> caption) {
    Nodes.named(this, id, "page", id);
    getStylesheets().add(Page.class.getResource("pages.css").toExternalForm());
    title.textProperty().bind(caption);
    title.setWrapText(true);
  }

  /** Lays out the page; must be called once. */
  final void layoutPage(Node... content) {
    getChildren().add(title);
    getChildren().addAll(content);
    getChildren().add(buttons);
  }

  /** Adds a button; the first is the default button. */
  final Button addButton(String id, ObservableValue<String> text) {
    Button button = new Button();
    button.setId(id);
    button.textProperty().bind(text);
    button.setDefaultButton(buttons.getChildren().isEmpty());
    buttons.getChildren().add(button);
    return button;
  }

  final Label title() {
    return title;
  }

  /** Returns the node that has the focus when the page opens. */
  Node firstFocus() {
    return defaultButton();
  }

  final Button defaultButton() {
    return (Button) buttons.getChildren().get(0);
  }
}
