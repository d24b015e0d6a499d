package tellosimulator.sim;

import tellosimulator.command.Link;
import tellosimulator.fault.Corruption;
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
   * @param corruption which bytes arrive wrong
   */
  record StateReport(
      DroneState state,
      SensorReadings sensors,
      PadReading pad,
      Profile profile,
      Link link,
      Corruption corruption) {

    /** One that arrives as it was sent. */
    public StateReport(
        DroneState state, SensorReadings sensors, PadReading pad, Profile profile, Link link) {
      this(state, sensors, pad, profile, link, Corruption.NONE);
    }

    StateReport with(Corruption newCorruption) {
      return new StateReport(state, sensors, pad, profile, link, newCorruption);
    }
  }
}
