package tellosimulator.view.layout;

import javafx.scene.Node;
import javafx.scene.layout.BorderPane;

/**
 * The frame of the window: simulator controls at the left, network controls at the right, log
 * below, the 3D scene in the middle.
 */
public final class SimulatorPane extends BorderPane {

  /** The parts of the window, by their places. */
  public record Parts(Node scene, Node simulatorControls, Node networkControls, Node log) {}

  public SimulatorPane(Parts parts) {
    setId("simulator-pane");
    setCenter(parts.scene());
    setLeft(parts.simulatorControls());
    setRight(parts.networkControls());
    setBottom(parts.log());
  }
}
