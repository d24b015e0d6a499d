package tellosimulator.view.replay;

import java.util.Locale;
import java.util.OptionalDouble;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;
import tellosimulator.math.Frames;
import tellosimulator.view.controls.DroneComboBox;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.text.Messages;

/**
 * Displays the position and motion of the selected drone, and its distance from its ghost. Confined
 * to the JavaFX thread.
 */
final class FlightReadout extends VBox {

  private final FxReplay replay;
  private final Messages messages;
  private final Label place = Nodes.named(new Label(), "place");
  private final Label motion = Nodes.named(new Label(), "motion");
  private final Label state = Nodes.named(new Label(), "state");
  private final Label distance = Nodes.named(new Label(), "distance", "distance");

  FlightReadout(FxReplay replay, SceneContext context) {
    this.replay = replay;
    messages = context.language().messages(FlightReadout.class);
    Nodes.named(this, "readout", "readout");
    Nodes.showIf(distance, distance.textProperty().isNotEmpty());
    getChildren().addAll(new DroneComboBox(context), state, place, motion, distance);
    context.ticker().onTick(nanos -> write());
  }

  private void write() {
    FxDroneModel drone = replay.simulation().selected();
    place.setText(messages.now("place", drone.xCm(), drone.yCm(), drone.zCm()));
    double heading = drone.poseProperty().get().attitude().heading();
    double headingDeg = Math.rint(Frames.yawOfHeading(heading)) + 0.0; // turns -0 into 0
    motion.setText(messages.now("motion", drone.speedCm(), headingDeg));
    String phase = drone.phaseProperty().get().name().toLowerCase(Locale.ROOT).replace('_', '-');
    state.setText(
        messages.now("state", messages.now("phase." + phase), drone.batteryPercentProperty()));
    OptionalDouble apart = replay.distance();
    distance.setText(
        apart.isPresent() ? messages.now("distance", Frames.centimeters(apart.getAsDouble())) : "");
  }
}
