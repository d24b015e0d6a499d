package tellosimulator.view.controls;

import javafx.scene.AccessibleAttribute;
import javafx.scene.Node;
import javafx.scene.layout.Region;
import tellosimulator.view.fx.Nodes;

/** A control of fixed size that draws values of the drone. Confined to the JavaFX thread. */
abstract class Instrument extends Region {

  /**
   * @param width the width [px]
   * @param height the height [px]
   */
  Instrument(String id, String styleClass, double width, double height) {
    Nodes.named(this, id, "instrument", styleClass);
    setMinSize(width, height);
    setPrefSize(width, height);
    setMaxSize(width, height);
  }

  /** Adds shapes. They are unmanaged, so that moving them does not request a layout. */
  final void addShapes(Node... shapes) {
    for (Node shape : shapes) {
      shape.setManaged(false);
    }
    getChildren().addAll(shapes);
  }

  /**
   * Returns the values as text. The text is created only when a screen reader requests it, because
   * the values change in each frame.
   */
  abstract String description();

  @Override
  public Object queryAccessibleAttribute(AccessibleAttribute attribute, Object... parameters) {
    return attribute == AccessibleAttribute.TEXT
        ? description()
        : super.queryAccessibleAttribute(attribute, parameters);
  }
}
