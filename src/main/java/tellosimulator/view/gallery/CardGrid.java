package tellosimulator.view.gallery;

import java.util.List;
import javafx.scene.Node;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;

/**
 * Cards in as many columns as there is room for; arrow keys, Home and End move the focus between
 * them. For the JavaFX thread.
 */
final class CardGrid extends GridPane {

  /** The least width of a card [px]. Decided: five of them at 1024 pixels. */
  private static final double LEAST_WIDTH = 165;

  private static final int MOST_COLUMNS = 5;

  private final List<? extends Node> cards;
  private int columns;

  CardGrid(List<? extends Node> cards) {
    this.cards = List.copyOf(cards);
    getStyleClass().add("card-grid");
    arrange(MOST_COLUMNS);
    widthProperty().subscribe(width -> arrange(columnsFor(width.doubleValue())));
    addEventFilter(KeyEvent.KEY_PRESSED, this::moveFocus);
  }

  private static int columnsFor(double width) {
    return width <= 0
        ? MOST_COLUMNS
        : (int) Math.max(1, Math.min(MOST_COLUMNS, Math.floor(width / LEAST_WIDTH)));
  }

  private void arrange(int newColumns) {
    if (newColumns == columns) {
      return;
    }
    columns = newColumns;
    getChildren().clear();
    getColumnConstraints().clear();
    for (int i = 0; i < columns; i++) {
      ColumnConstraints column = new ColumnConstraints();
      column.setPercentWidth(100.0 / columns);
      getColumnConstraints().add(column);
    }
    for (int i = 0; i < cards.size(); i++) {
      add(cards.get(i), i % columns, i / columns);
    }
  }

  private void moveFocus(KeyEvent key) {
    int focused = focused();
    if (focused < 0) {
      return;
    }
    int wanted =
        switch (key.getCode()) {
          case LEFT -> focused - 1;
          case RIGHT -> focused + 1;
          case UP -> focused - columns;
          case DOWN -> focused + columns;
          case HOME -> 0;
          case END -> cards.size() - 1;
          default -> focused;
        };
    if (wanted != focused || key.getCode().isArrowKey()) {
      key.consume();
    }
    if (wanted >= 0 && wanted < cards.size()) {
      cards.get(wanted).requestFocus();
    }
  }

  private int focused() {
    for (int i = 0; i < cards.size(); i++) {
      if (cards.get(i).isFocused()) {
        return i;
      }
    }
    return -1;
  }
}
