package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.application.Platform;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.scene.Node;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;

/**
 * A panel at a side of the window: a column of parts, some of which are {@link Card}s. If there is
 * not enough space for all of them, the panel folds as many cards as necessary, starting with the
 * least used ones. Cards that the user has opened stay open; if they do not fit, the panel scrolls.
 * Confined to the JavaFX thread.
 */
abstract class ControlPanel extends ScrollPane {

  private final DoubleProperty availableHeight =
      new SimpleDoubleProperty(this, "availableHeight", Double.MAX_VALUE);
  private final VBox parts = Nodes.styled(new VBox(), "parts");
  private final List<Card> cards = new ArrayList<>();
  private boolean folding;

  /**
   * @param width the width of the panel [px]
   */
  ControlPanel(String id, double width) {
    Nodes.named(this, id, "control-panel");
    getStylesheets().add(ControlPanel.class.getResource("controls.css").toExternalForm());
    setFitToWidth(true);
    setHbarPolicy(ScrollBarPolicy.NEVER);
    Nodes.fixWidth(this, width);
    setContent(parts);
    availableHeight.addListener((property, before, now) -> foldSoon());
    sceneProperty().addListener((property, before, now) -> foldSoon());
  }

  /** Sets the parts of the panel, from top to bottom. */
  final void layoutPanel(Node... nodes) {
    parts.getChildren().setAll(nodes);
  }

  /** Sets the cards that are folded if space is short, in this order. */
  final void foldInOrder(Card... leastUsedFirst) {
    cards.addAll(List.of(leastUsedFirst));
  }

  /** The height that is available to the panel [px]. If it is too small, cards are folded. */
  public final DoubleProperty availableHeightProperty() {
    return availableHeight;
  }

  /**
   * Restores from the settings which cards are folded, and saves changes until the subscription
   * ends.
   */
  public final Subscription remember(Settings settings) {
    SettingCodec<Card.Folding> codec = SettingCodec.constant(Card.Folding.class);
    return Subscription.combine(
        cards.stream()
            .map(card -> settings.bind("card." + card.name(), card.foldingProperty(), codec))
            .toArray(Subscription[]::new));
  }

  /** Folds cards as soon as the current layout is complete; until then, heights still change. */
  final void foldSoon() {
    if (!folding) {
      folding = true;
      Platform.runLater(this::fold);
    }
  }

  private void fold() {
    folding = false;
    if (!isShown()) {
      return; // without styles, nothing can be measured yet
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
