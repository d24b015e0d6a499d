package tellosimulator.view.replay;

import java.util.Locale;
import java.util.OptionalDouble;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;
import tellosimulator.math.Frames;
import tellosimulator.view.controls.DroneComboBox;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.text.Messages;

/**
 * Where the selected drone is at the moment, how it moves, and how far its ghost is away. For the
 * JavaFX thread.
 */
final class FlightReadout extends VBox {

  private final FxReplay replay;
  private final Messages messages;
  private final Label place = new Label();
  private final Label motion = new Label();
  private final Label state = new Label();
  private final Label distance = new Label();

  FlightReadout(FxReplay replay, SceneContext context) {
    this.replay = replay;
    messages = context.language().messages(FlightReadout.class);
    setId("readout");
    getStyleClass().add("readout");
    place.setId("place");
    motion.setId("motion");
    state.setId("state");
    distance.setId("distance");
    distance.getStyleClass().add("distance");
    distance.managedProperty().bind(distance.textProperty().isNotEmpty());
    distance.visibleProperty().bind(distance.managedProperty());
    getChildren().addAll(new DroneComboBox(context), state, place, motion, distance);
    context.pulse().onBeat(nanos -> write());
  }

  private void write() {
    FxDroneModel drone = replay.simulation().selected();
    place.setText(
        messages.now("place", drone.xCmProperty(), drone.yCmProperty(), drone.zCmProperty()));
    double heading = drone.poseProperty().get().attitude().heading();
    double headingDeg = Math.rint(Frames.yawOfHeading(heading)) + 0.0; // makes 0 of -0
    motion.setText(messages.now("motion", drone.speedCmProperty(), headingDeg));
    String phase = drone.phaseProperty().get().name().toLowerCase(Locale.ROOT).replace('_', '-');
    state.setText(
        messages.now("state", messages.now("phase." + phase), drone.batteryPercentProperty()));
    OptionalDouble apart = replay.distance();
    distance.setText(
        apart.isPresent() ? messages.now("distance", Frames.centimeters(apart.getAsDouble())) : "");
  }
}
