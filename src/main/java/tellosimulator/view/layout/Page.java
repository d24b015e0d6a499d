package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;

/** A page that lies over the window: a title, content, and buttons below. For the JavaFX thread. */
abstract class Page extends VBox {

  private final Label title = new Label();
  private final HBox buttons = new HBox();

  Page(String id, String styleClass, ObservableValue<String> caption) {
    setId(id);
    getStyleClass().addAll("page", styleClass);
    getStylesheets().add(Page.class.getResource("pages.css").toExternalForm());
    title.textProperty().bind(caption);
    title.setWrapText(true);
    title.getStyleClass().add(Styles.TITLE_3);
    buttons.getStyleClass().add("page-buttons");
  }

  /** Lays out everything; to be called once. */
  final void layoutPage(Node... content) {
    getChildren().add(title);
    getChildren().addAll(content);
    getChildren().add(buttons);
  }

  /** Adds a button; the first one is the default. */
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

  /** What has the focus when it opens. */
  Node firstFocus() {
    return defaultButton();
  }

  final Button defaultButton() {
    return (Button) buttons.getChildren().get(0);
  }
}
