package tellosimulator.view.controls;

import javafx.scene.AccessibleAttribute;
import javafx.scene.layout.Region;

/** A control of fixed size that draws values of the drone. For the JavaFX thread. */
abstract class Instrument extends Region {

  /**
   * @param width its width [px]
   * @param height its height [px]
   */
  Instrument(String id, String styleClass, double width, double height) {
    setId(id);
    getStyleClass().addAll("instrument", styleClass);
    setMinSize(width, height);
    setPrefSize(width, height);
    setMaxSize(width, height);
  }

  /** What it shows, in words. Made only when a screen reader asks: values change each frame. */
  abstract String description();

  @Override
  public Object queryAccessibleAttribute(AccessibleAttribute attribute, Object... parameters) {
    return attribute == AccessibleAttribute.TEXT
        ? description()
        : super.queryAccessibleAttribute(attribute, parameters);
  }
}
