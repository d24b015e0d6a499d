package tellosimulator.view.model;

import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.drone.StatusLight;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * A drone as observable properties and values that mirror the latest snapshot. {@link FxSimulation}
 * updates it at each UI tick. Confined to the JavaFX thread.
 *
 * <p>Numbers are for display: coordinates of the room frame in centimetres, and angles in degrees
 * with the signs of the protocol. Yaw is clockwise from the heading at power-on, pitch is positive
 * with the nose up, and roll is positive with the right side down.
 */
public final class FxDroneModel {

  private final int number;
  private final Livery livery;
  private final ReadOnlyObjectWrapper<DroneSnapshot> snapshot;
  private final ReadOnlyObjectWrapper<Pose> pose = new ReadOnlyObjectWrapper<>();
  private final ReadOnlyObjectWrapper<Pose> start = new ReadOnlyObjectWrapper<>();
  private final ReadOnlyObjectWrapper<FlightPhase> phase =
      new ReadOnlyObjectWrapper<>(FlightPhase.OFF);
  private final ReadOnlyBooleanWrapper on = new ReadOnlyBooleanWrapper();
  private final ReadOnlyBooleanWrapper filming = new ReadOnlyBooleanWrapper();
  private final ReadOnlyDoubleWrapper batteryPercent = new ReadOnlyDoubleWrapper();
  private DroneSnapshot pictured;

  FxDroneModel(DroneSnapshot first) {
    number = first.state().drone();
    livery = Livery.of(first);
    snapshot = new ReadOnlyObjectWrapper<>(first);
    update(first, false);
  }

  /**
   * Updates the properties from the latest snapshot.
   *
   * @param idle whether the window is idle; the status light is then drawn without blinking
   */
  void update(DroneSnapshot newest, boolean idle) {
    snapshot.set(newest);
    pictured = idle ? StatusLight.steady(newest) : newest;
    pose.set(newest.state().motion().pose());
    start.set(newest.start());
    phase.set(newest.state().phase());
    on.set(newest.state().phase() != FlightPhase.OFF);
    filming.set(on.get() && newest.link().sdkMode() && newest.state().video().on());
    batteryPercent.set(newest.state().energy().battery().percent());
  }

  /** Returns the drone's number, from 1. */
  public int number() {
    return number;
  }

  /** Returns the drone's colours. They never change. */
  public Livery livery() {
    return livery;
  }

  /** The complete snapshot. It is replaced at each UI tick while anything changes. */
  public ReadOnlyObjectProperty<DroneSnapshot> snapshotProperty() {
    return snapshot.getReadOnlyProperty();
  }

  /**
   * Returns the snapshot to draw. It equals {@link #snapshotProperty}, except in an idle window,
   * where the status light does not blink.
   */
  public DroneSnapshot pictured() {
    return pictured;
  }

  /** The position of the drone's feet [m] and the drone's attitude, both in the room frame. */
  public ReadOnlyObjectProperty<Pose> poseProperty() {
    return pose.getReadOnlyProperty();
  }

  /** The pose to which a reset returns the drone, in the room frame [m]. */
  public ReadOnlyObjectProperty<Pose> startProperty() {
    return start.getReadOnlyProperty();
  }

  public ReadOnlyObjectProperty<FlightPhase> phaseProperty() {
    return phase.getReadOnlyProperty();
  }

  /** Whether the drone is switched on. */
  public ReadOnlyBooleanProperty onProperty() {
    return on.getReadOnlyProperty();
  }

  /** Whether the drone sends video to an operator. */
  public ReadOnlyBooleanProperty filmingProperty() {
    return filming.getReadOnlyProperty();
  }

  public double xCm() {
    return Frames.centimeters(pose().position().x());
  }

  public double yCm() {
    return Frames.centimeters(pose().position().y());
  }

  /** Returns the height of the drone's feet above the floor [cm]. */
  public double zCm() {
    return Frames.centimeters(pose().position().z());
  }

  /**
   * Returns the yaw, clockwise seen from above, within ±180 [deg]. This is the yaw that the drone
   * reports in its state line, but without noise. 0 is the direction of the nose when the drone was
   * switched on or returned to its start.
   */
  public double yawDeg() {
    return Frames.yawOfHeading(state().reference().turned(pose().attitude()));
  }

  /** Returns the pitch; nose up is positive [deg]. */
  public double pitchDeg() {
    return Math.toDegrees(pose().attitude().elevation());
  }

  /** Returns the roll; right side down is positive [deg]. */
  public double rollDeg() {
    return Math.toDegrees(pose().attitude().bank());
  }

  /** Returns the speed in three dimensions [cm/s]. */
  public double speedCm() {
    return Frames.centimeters(state().motion().velocity().norm());
  }

  private DroneState state() {
    return snapshot.get().state();
  }

  private Pose pose() {
    return state().motion().pose();
  }

  public ReadOnlyDoubleProperty batteryPercentProperty() {
    return batteryPercent.getReadOnlyProperty();
  }
}
