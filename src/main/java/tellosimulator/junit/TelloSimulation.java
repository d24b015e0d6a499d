package tellosimulator.junit;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.world.Wind;

/**
 * The simulation behind the drones of a test: its time, goals, faults and wind. With time factor
 * {@code max}, time stands still while the program under test computes, and advances on its own
 * while a client waits for a reply.
 */
public final class TelloSimulation {

  /** Default timeout of {@link #awaitStill} and {@link #awaitGoals}. Decided. */
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final TelloSimulator simulator;
  private final Faults faults;

  TelloSimulation(TelloSimulator simulator) {
    this.simulator = simulator;
    this.faults = new Faults(simulator);
  }

  /** Returns a drone by its number, from 1. */
  public SimulatedDrone drone(int number) {
    return simulator.drone(number);
  }

  /** Returns the simulated time since the test began. */
  public Duration time() {
    return Duration.ofNanos(Math.round(simulator.snapshot().time().seconds() * 1e9));
  }

  /**
   * Advances simulated time by a duration, and returns when the duration has passed.
   *
   * @throws IllegalArgumentException if the duration is negative
   * @throws IllegalStateException if the simulation is reset before the duration has passed
   * @throws AssertionError if the duration has not passed within 30 s plus twice the duration, in
   *     wall clock time
   */
  public void advance(Duration duration) {
    if (duration.isNegative()) {
      throw new IllegalArgumentException("duration is " + duration + ", but must not be negative");
    }
    long run = simulator.monitor().run();
    double end = simulator.snapshot().time().seconds() + duration.toNanos() * 1e-9;
    simulator.letPass(duration.toNanos() * 1e-9);
    Duration limit = PATIENCE.plus(duration.multipliedBy(2));
    Optional<Boolean> passed =
        simulator
            .monitor()
            .await(
                limit,
                () ->
                    simulator.monitor().run() != run
                        ? Optional.of(false)
                        : Optional.of(true)
                            .filter(yes -> simulator.snapshot().time().seconds() > end - 1e-6));
    if (passed.isPresent() && !passed.get()) {
      throw new IllegalStateException(
          String.format(
              Locale.ROOT,
              "the simulation was restarted before %.1f s had passed",
              duration.toNanos() * 1e-9));
    }
    if (passed.isEmpty()) {
      throw simulator.failure(
          "%.1f s of simulated time did not pass within %d s",
          duration.toNanos() * 1e-9, limit.toSeconds());
    }
  }

  /**
   * Waits until all received commands have been carried out and answered, and every drone is at
   * rest or hovering.
   *
   * @throws AssertionError on timeout, after 30 s of wall clock time
   */
  public void awaitStill() {
    awaitStill(PATIENCE);
  }

  /**
   * Waits like {@link #awaitStill()}, with another timeout.
   *
   * @param timeout the maximum wait, in wall clock time
   */
  public void awaitStill(Duration timeout) {
    if (!simulator.awaitStill(timeout)) {
      throw simulator.failure("drones still move after %.1f s", timeout.toMillis() / 1000.0);
    }
  }

  /**
   * Waits until all goals of the scenario have been reached, or can no longer be reached.
   *
   * @throws AssertionError if the goals can no longer be reached, or on timeout, after 30 s of wall
   *     clock time
   * @throws IllegalStateException if the scenario has no goals
   */
  public void awaitGoals() {
    awaitGoals(PATIENCE);
  }

  /**
   * Waits like {@link #awaitGoals()}, with another timeout.
   *
   * @param timeout the maximum wait, in wall clock time
   */
  public void awaitGoals(Duration timeout) {
    GoalStatus before = goals();
    if (before.done().isEmpty() && before.open().isEmpty()) {
      throw new IllegalStateException("the scenario has no goals to wait for");
    }
    Optional<GoalStatus> over =
        simulator
            .monitor()
            .await(
                timeout, () -> Optional.of(present()).filter(now -> now.reached() || now.failed()));
    GoalStatus goals = over.orElseGet(this::present);
    if (goals.failed()) {
      throw simulator.failure("the goals were missed");
    } else if (!goals.reached()) {
      throw simulator.failure(
          "the goals were not reached within %.1f s", timeout.toMillis() / 1000.0);
    }
  }

  /** Returns the drones' progress towards the goals of the scenario. */
  public GoalStatus goals() {
    simulator.settle();
    return present();
  }

  private GoalStatus present() {
    return GoalStatus.of(simulator.progress());
  }

  /** Returns the faults of this simulation. */
  public Faults faults() {
    return faults;
  }

  /**
   * Sets the wind. It is the same everywhere in the room.
   *
   * @param speed the speed of the wind [cm/s]
   * @param towards the direction in which the wind blows [degrees], clockwise seen from above; 0 is
   *     along the room's x axis
   * @throws IllegalArgumentException if the speed is not from 0 to 2000 cm/s, or the angle is not
   *     from -360 to 360 degrees
   */
  public void wind(double speed, double towards) {
    check("speed", speed, 0, Wind.FASTEST * 100, "cm/s");
    checkAngle("towards", towards);
    Vec3 forward = new Vec3(Frames.meters(speed), 0, 0);
    Vec3 mean = Attitude.ofHeading(Frames.headingOfYaw(towards)).toRoom(forward);
    simulator.carryOut(new Control.SetWind(new Wind(mean, 0)));
  }

  /**
   * Checks that an angle is in the range that is also valid in scenario files.
   *
   * @param angle the angle [degrees]
   * @throws IllegalArgumentException if the angle is out of range; the message is one sentence
   */
  static void checkAngle(String name, double angle) {
    check(name, angle, -360, 360, "degrees");
  }

  private static void check(String name, double value, double least, double most, String unit) {
    if (!(value >= least && value <= most)) {
      String range = String.format(Locale.ROOT, "%.0f to %.0f", least, most);
      throw new IllegalArgumentException(
          name + " is " + value + " " + unit + ", but must be from " + range);
    }
  }
}
