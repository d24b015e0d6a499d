package tellosimulator.controller;

import java.util.function.BooleanSupplier;
import tellosimulator.math.Vec3;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/** Hovers until a mission pad is seen, or for as long as it looks for one. */
final class PadSearch implements Maneuver {

  /** How long it looks [s]. Assumed: some pictures. */
  private static final double PATIENCE = 1;

  private final Setpoint.Track place;
  private final BooleanSupplier seen;
  private double time;
  private boolean found;

  /**
   * @param position where it hovers, room frame [m]
   * @param heading where the nose points [rad]
   * @param seen whether the pad is seen now
   */
  PadSearch(Vec3 position, double heading, BooleanSupplier seen) {
    this.place =
        new Setpoint.Track(position, Vec3.ZERO, Vec3.ZERO, new Setpoint.Heading(heading, 0));
    this.seen = seen;
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    time += seconds;
    found = found || seen.getAsBoolean();
    return place;
  }

  @Override
  public boolean planned() {
    return found || time >= PATIENCE;
  }

  @Override
  public Phrase progress() {
    return Phrase.of("it looks for the pad");
  }
}
