package tellosimulator.sim;

import tellosimulator.command.Link;
import tellosimulator.model.DroneState;
import tellosimulator.model.PadReading;
import tellosimulator.profile.Profile;
import tellosimulator.sensor.SensorReadings;

/** The way out for state lines. Called on the simulation thread; must neither block nor throw. */
@FunctionalInterface
public interface StatePort {

  /** A state line is due. */
  void send(StateReport report);

  /**
   * What a state line is made of.
   *
   * @param link where it goes
   */
  record StateReport(
      DroneState state, SensorReadings sensors, PadReading pad, Profile profile, Link link) {}
}
