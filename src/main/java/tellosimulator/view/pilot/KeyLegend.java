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
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;

/** The keys that fly, as they lie on a keyboard; those that are held down are lit. */
final class KeyLegend extends HBox {

  private static final PseudoClass PRESSED = PseudoClass.getPseudoClass("lit");

  /** Where a key lies. */
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
  private final GridPane sticks = new GridPane();
  private final GridPane actions = new GridPane();

  KeyLegend(Messages messages, ObservableSet<SteeringKey> pressed) {
    this.messages = messages;
    this.pressed = pressed;
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
  }

  private void initializeSelf() {
    setId("key-hint");
    getStyleClass().add("key-hint");
  }

  private void initializeParts() {
    for (SteeringKey key : SteeringKey.values()) {
      Label cap = new Label(key.symbol());
      cap.setId("cap-" + key.textKey());
      cap.getStyleClass().add("key-cap");
      Tooltips.install(cap, messages.text(key.textKey()));
      caps.put(key, cap);
    }
  }

  private void layoutParts() {
    sticks.getStyleClass().add("sticks");
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
      HBox pair = new HBox(caps.get(place.key()), what);
      pair.getStyleClass().add("key-pair");
      actions.add(pair, place.column(), place.row());
    }
    actions.getStyleClass().add("actions");
    getChildren().addAll(sticks, actions);
  }

  /** Whether it says what the keys beside the sticks do; else their hints do. */
  void showWords(boolean shown) {
    for (Label word : words) {
      word.setVisible(shown);
      word.setManaged(shown);
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
