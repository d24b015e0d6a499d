package tellosimulator.view.controls;

import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.shape.Circle;
import tellosimulator.view.text.Messages;

/** A lamp with words that say whether something runs. For the JavaFX thread. */
final class Lamp extends Label {

  private static final PseudoClass LIT = PseudoClass.getPseudoClass("lit");

  /**
   * @param key of its words, with {@code .on} or {@code .off} behind
   */
  Lamp(String id, Messages messages, String key, ObservableValue<Boolean> runs) {
    setId(id);
    getStyleClass().add("lamp");
    Circle light = new Circle(4);
    light.getStyleClass().add("light");
    setGraphic(light);
    textProperty().bind(runs.flatMap(lit -> messages.text(key + (lit ? ".on" : ".off"))));
    runs.addListener((property, before, now) -> pseudoClassStateChanged(LIT, now));
    pseudoClassStateChanged(LIT, runs.getValue());
  }
}
