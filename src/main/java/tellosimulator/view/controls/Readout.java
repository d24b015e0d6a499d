package tellosimulator.view.controls;

import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/** A number without decimals below its name and unit. For the JavaFX thread. */
final class Readout extends VBox {

  private final DoubleProperty value = new SimpleDoubleProperty(this, "value");
  private final Label caption = new Label();
  private final Label number = new Label("0");
  private long shown;

  /**
   * @param id of the label with the number
   */
  Readout(String id, ObservableValue<String> name) {
    getStyleClass().add("readout");
    caption.textProperty().bind(name);
    caption.getStyleClass().add("caption");
    number.setId(id);
    number.getStyleClass().add("number");
    number.setMinWidth(USE_PREF_SIZE);
    caption.setLabelFor(number);
    getChildren().addAll(caption, number);
    value.addListener((property, before, now) -> write());
  }

  DoubleProperty valueProperty() {
    return value;
  }

  private void write() {
    long whole = Math.round(value.get());
    if (whole != shown) {
      shown = whole;
      number.setText(Long.toString(whole));
    }
  }
}
