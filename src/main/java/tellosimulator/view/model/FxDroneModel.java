package tellosimulator.view.model;

import java.util.Optional;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.command.Peer;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.drone.StatusLight;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * A drone as properties that views bind to: a mirror of the newest snapshot. Written once a pulse
 * by {@link FxSimulation}; for the JavaFX thread only.
 *
 * <p>Positions are in the room frame and in centimetres, angles in degrees with the signs of the
 * wire: yaw clockwise from the heading at power-on, pitch nose up, roll right side down.
 */
public final class FxDroneModel {

  private final int number;
  private final Livery livery;
  private final ReadOnlyObjectWrapper<DroneSnapshot> snapshot;
  private final ReadOnlyObjectWrapper<Pose> pose = new ReadOnlyObjectWrapper<>();
  private final ReadOnlyObjectWrapper<Pose> start = new ReadOnlyObjectWrapper<>();
  private final ReadOnlyObjectWrapper<FlightPhase> phase =
      new ReadOnlyObjectWrapper<>(FlightPhase.OFF);
  private final ReadOnlyObjectWrapper<Optional<Peer>> operator =
      new ReadOnlyObjectWrapper<>(Optional.empty());
  private final ReadOnlyBooleanWrapper on = new ReadOnlyBooleanWrapper();
  private final ReadOnlyBooleanWrapper filming = new ReadOnlyBooleanWrapper();
  private final ReadOnlyDoubleWrapper xCm = new ReadOnlyDoubleWrapper();
  private final ReadOnlyDoubleWrapper yCm = new ReadOnlyDoubleWrapper();
  private final ReadOnlyDoubleWrapper zCm = new ReadOnlyDoubleWrapper();
  private final ReadOnlyDoubleWrapper yawDeg = new ReadOnlyDoubleWrapper();
  private final ReadOnlyDoubleWrapper pitchDeg = new ReadOnlyDoubleWrapper();
  private final ReadOnlyDoubleWrapper rollDeg = new ReadOnlyDoubleWrapper();
  private final ReadOnlyDoubleWrapper speedCm = new ReadOnlyDoubleWrapper();
  private final ReadOnlyDoubleWrapper batteryPercent = new ReadOnlyDoubleWrapper();
  private DroneSnapshot pictured;

  FxDroneModel(DroneSnapshot first) {
    number = first.state().drone();
    livery = Livery.of(first);
    snapshot = new ReadOnlyObjectWrapper<>(first);
    update(first, false);
  }

  /**
   * Takes over what the newest snapshot says.
   *
   * @param idle whether pictures shall show a lamp that does not blink
   */
  void update(DroneSnapshot newest, boolean idle) {
    snapshot.set(newest);
    pictured = idle ? StatusLight.steady(newest) : newest;
    Pose newPose = newest.state().motion().pose();
    if (!newPose.equals(pose.get())) {
      pose.set(newPose);
      show(newPose);
    }
    double turned = newest.state().reference().turned(newPose.attitude());
    yawDeg.set(Frames.yawOfHeading(turned));
    start.set(newest.start());
    phase.set(newest.state().phase());
    operator.set(newest.link().operator());
    on.set(newest.state().phase() != FlightPhase.OFF);
    filming.set(on.get() && newest.link().sdkMode() && newest.state().video().on());
    speedCm.set(Frames.centimeters(newest.state().motion().velocity().norm()));
    batteryPercent.set(newest.state().energy().battery().percent());
  }

  private void show(Pose newPose) {
    Vec3 position = newPose.position();
    xCm.set(Frames.centimeters(position.x()));
    yCm.set(Frames.centimeters(position.y()));
    zCm.set(Frames.centimeters(position.z()));
    Attitude attitude = newPose.attitude();
    pitchDeg.set(Math.toDegrees(attitude.elevation()));
    rollDeg.set(Math.toDegrees(attitude.bank()));
  }

  /** Its number, from 1. */
  public int number() {
    return number;
  }

  /** Its colours, which stay. */
  public Livery livery() {
    return livery;
  }

  /** Everything about it; a new value each pulse while something changes. */
  public ReadOnlyObjectProperty<DroneSnapshot> snapshotProperty() {
    return snapshot.getReadOnlyProperty();
  }

  /** What pictures show of it: the same, but for a lamp that does not blink in an idle window. */
  public DroneSnapshot pictured() {
    return pictured;
  }

  /** Position of its feet and attitude, room frame [m]. */
  public ReadOnlyObjectProperty<Pose> poseProperty() {
    return pose.getReadOnlyProperty();
  }

  /** Where a reset puts it, room frame [m]. */
  public ReadOnlyObjectProperty<Pose> startProperty() {
    return start.getReadOnlyProperty();
  }

  public ReadOnlyObjectProperty<FlightPhase> phaseProperty() {
    return phase.getReadOnlyProperty();
  }

  /** Who gets its state and video; empty until a first {@code command}. */
  public ReadOnlyObjectProperty<Optional<Peer>> operatorProperty() {
    return operator.getReadOnlyProperty();
  }

  /** Whether it has power. */
  public ReadOnlyBooleanProperty onProperty() {
    return on.getReadOnlyProperty();
  }

  /** Whether it sends its video to an operator. */
  public ReadOnlyBooleanProperty filmingProperty() {
    return filming.getReadOnlyProperty();
  }

  public ReadOnlyDoubleProperty xCmProperty() {
    return xCm.getReadOnlyProperty();
  }

  public ReadOnlyDoubleProperty yCmProperty() {
    return yCm.getReadOnlyProperty();
  }

  /** Height of its feet above the floor. */
  public ReadOnlyDoubleProperty zCmProperty() {
    return zCm.getReadOnlyProperty();
  }

  /**
   * Clockwise seen from above, within ±180: what the state line says, but for noise. 0 is where the
   * nose pointed when the power came or the drone was put back to its start.
   */
  public ReadOnlyDoubleProperty yawDegProperty() {
    return yawDeg.getReadOnlyProperty();
  }

  /** Nose up is positive. */
  public ReadOnlyDoubleProperty pitchDegProperty() {
    return pitchDeg.getReadOnlyProperty();
  }

  /** Right side down is positive. */
  public ReadOnlyDoubleProperty rollDegProperty() {
    return rollDeg.getReadOnlyProperty();
  }

  /** Speed in space [cm/s]. */
  public ReadOnlyDoubleProperty speedCmProperty() {
    return speedCm.getReadOnlyProperty();
  }

  public ReadOnlyDoubleProperty batteryPercentProperty() {
    return batteryPercent.getReadOnlyProperty();
  }
}
