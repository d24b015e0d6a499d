package tellosimulator.view.pilot;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javafx.collections.ObservableSet;
import javafx.collections.SetChangeListener;
import javafx.css.PseudoClass;
import javafx.geometry.HPos;
import javafx.scene.control.Label;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;

/**
 * Displays the keys that fly the drone, arranged as on a keyboard. Pressed keys are highlighted.
 */
final class KeyLegend extends HBox {

  private static final PseudoClass PRESSED = PseudoClass.getPseudoClass("lit");

  /** The position of a key in its grid. */
  private record Place(SteeringKey key, int column, int row) {}

  private static final List<Place> PLACES =
      List.of(
          new Place(SteeringKey.FORWARD, 1, 0),
          new Place(SteeringKey.LEFT, 0, 1),
          new Place(SteeringKey.BACK, 1, 1),
          new Place(SteeringKey.RIGHT, 2, 1),
          new Place(SteeringKey.UP, 5, 0),
          new Place(SteeringKey.TURN_LEFT, 4, 1),
          new Place(SteeringKey.DOWN, 5, 1),
          new Place(SteeringKey.TURN_RIGHT, 6, 1));

  private static final List<Place> ACTIONS =
      List.of(
          new Place(SteeringKey.TAKE_OFF_OR_LAND, 0, 0),
          new Place(SteeringKey.EMERGENCY, 0, 1),
          new Place(SteeringKey.FLIP, 1, 0),
          new Place(SteeringKey.FASTER, 1, 1));

  private final Messages messages;
  private final ObservableSet<SteeringKey> pressed;
  private final Map<SteeringKey, Label> caps = new TreeMap<>();
  private final List<Label> words = new ArrayList<>();
  private final GridPane sticks = Nodes.styled(new GridPane(), "sticks");
  private final GridPane actions = Nodes.styled(new GridPane(), "actions");

  KeyLegend(Messages messages, ObservableSet<SteeringKey> pressed) {
    this.messages = messages;
    this.pressed = pressed;
    Nodes.named(this, "key-hint", "key-hint");
    for (SteeringKey key : SteeringKey.values()) {
      Label cap = Nodes.named(new Label(key.symbol()), "cap-" + key.textKey(), "key-cap");
      Tooltips.install(cap, messages.text(key.textKey()));
      caps.put(key, cap);
    }
    layoutParts();
    setupEventHandlers();
  }

  private void layoutParts() {
    for (Place place : PLACES) {
      sticks.add(caps.get(place.key()), place.column(), place.row());
    }
    ColumnConstraints gap = new ColumnConstraints(14);
    sticks
        .getColumnConstraints()
        .addAll(new ColumnConstraints(), new ColumnConstraints(), new ColumnConstraints(), gap);
    addLegend("sticks-left", 0);
    addLegend("sticks-right", 4);
    for (Place place : ACTIONS) {
      Label what = messages.label("short-" + place.key().textKey(), "key-text");
      what.setMinWidth(USE_PREF_SIZE);
      words.add(what);
      HBox pair = Nodes.styled(new HBox(caps.get(place.key()), what), "key-pair");
      actions.add(pair, place.column(), place.row());
    }
    getChildren().addAll(sticks, actions);
  }

  /**
   * Shows or hides the captions of the keys that do not move the sticks. Tooltips explain all keys,
   * even while captions are hidden.
   */
  void showWords(boolean shown) {
    for (Label word : words) {
      Nodes.setShown(word, shown);
    }
  }

  private void addLegend(String textKey, int column) {
    Label legend = messages.label(textKey, "key-text");
    legend.setMinWidth(USE_PREF_SIZE);
    GridPane.setHalignment(legend, HPos.CENTER);
    sticks.add(legend, column, 2, 3, 1);
  }

  private void setupEventHandlers() {
    pressed.addListener(
        (SetChangeListener<SteeringKey>)
            change -> {
              if (change.wasAdded()) {
                light(change.getElementAdded(), true);
              } else {
                light(change.getElementRemoved(), false);
              }
            });
  }

  private void light(SteeringKey key, boolean lit) {
    caps.get(key).pseudoClassStateChanged(PRESSED, lit);
  }
}
