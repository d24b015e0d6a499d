package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.application.Platform;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.scene.Node;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.VBox;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;

/**
 * A panel at a side of the window: parts below each other, of which some are {@link Card}s. Where
 * there is no room for all of them, it folds as many cards as it must, the least used first; who
 * has opened a card keeps it, and scrolls. For the JavaFX thread.
 */
abstract class ControlPanel extends ScrollPane {

  private final DoubleProperty availableHeight =
      new SimpleDoubleProperty(this, "availableHeight", Double.MAX_VALUE);
  private final VBox parts = new VBox();
  private final List<Card> cards = new ArrayList<>();
  private boolean folding;

  /**
   * @param width of the panel [px]
   */
  ControlPanel(String id, double width) {
    setId(id);
    getStyleClass().add("control-panel");
    getStylesheets().add(ControlPanel.class.getResource("controls.css").toExternalForm());
    setFitToWidth(true);
    setHbarPolicy(ScrollBarPolicy.NEVER);
    setMinWidth(width);
    setPrefWidth(width);
    setMaxWidth(width);
    parts.getStyleClass().add("parts");
    setContent(parts);
    availableHeight.addListener((property, before, now) -> foldSoon());
    sceneProperty().addListener((property, before, now) -> foldSoon());
  }

  /** Lays out everything, from above. */
  final void layoutPanel(Node... nodes) {
    parts.getChildren().setAll(nodes);
  }

  /** Says which cards are folded where room is short, the least used one first. */
  final void foldInOrder(Card... leastUsedFirst) {
    cards.addAll(List.of(leastUsedFirst));
  }

  /** How high it can be [px]. */
  public final DoubleProperty availableHeightProperty() {
    return availableHeight;
  }

  /** Its cards are at first as they were left, and it remembers how they are left. */
  public final void remember(Settings settings) {
    for (Card card : cards) {
      settings.bind(key(card), card.foldingProperty(), SettingCodec.constant(Card.Folding.class));
    }
  }

  /** Lets another window of the same program remember. */
  public final void forget(Settings settings) {
    cards.forEach(card -> settings.unbind(key(card)));
  }

  private static String key(Card card) {
    return "card." + card.name();
  }

  /** Not at once: the height changes while everything is laid out. */
  final void foldSoon() {
    if (!folding) {
      folding = true;
      Platform.runLater(this::fold);
    }
  }

  private void fold() {
    folding = false;
    if (!isShown()) {
      return; // there are no styles to measure with
    }
    cards.forEach(card -> card.setRoom(true));
    applyCss();
    for (Card card : cards) {
      if (height() <= availableHeight.get()) {
        return;
      }
      card.setRoom(false);
    }
  }

  private boolean isShown() {
    return getScene() != null
        && getScene().getWindow() != null
        && getScene().getWindow().isShowing();
  }

  private double height() {
    double width = getPrefWidth();
    return isFitToHeight() ? parts.minHeight(width) : parts.prefHeight(width);
  }
}
