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
 * The simulation behind the drones of a test: its time, its goals, its weather. With time factor
 * {@code max} time stands still while the program under test computes, and passes by itself while
 * somebody waits for an answer.
 */
public final class TelloSimulation {

  /** How long {@link #awaitStill} and {@link #awaitGoals} wait unless told otherwise. Decided. */
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final TelloSimulator simulator;
  private final Faults faults;

  TelloSimulation(TelloSimulator simulator) {
    this.simulator = simulator;
    this.faults = new Faults(simulator);
  }

  /** A drone. */
  public SimulatedDrone drone(int number) {
    return simulator.drone(number);
  }

  /** Simulated time since the test began. */
  public Duration time() {
    return Duration.ofNanos(Math.round(simulator.snapshot().time().seconds() * 1e9));
  }

  /**
   * Lets simulated time pass, and returns when it has.
   *
   * @throws IllegalArgumentException if it is negative
   * @throws IllegalStateException if the simulation begins anew before
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
              "the simulation began anew before %.1f s had passed",
              duration.toNanos() * 1e-9));
    }
    if (passed.isEmpty()) {
      throw simulator.failure(
          String.format(
              Locale.ROOT,
              "%.1f s of simulated time did not pass within %d s",
              duration.toNanos() * 1e-9,
              limit.toSeconds()));
    }
  }

  /**
   * Waits until all commands that have come are carried out, their answers are given, and nothing
   * moves any more but what hovers.
   *
   * @throws AssertionError if that takes more than 30 s of the wall clock
   */
  public void awaitStill() {
    awaitStill(PATIENCE);
  }

  /**
   * The same.
   *
   * @param timeout how long at the most, by the wall clock
   */
  public void awaitStill(Duration timeout) {
    if (!simulator.awaitStill(timeout)) {
      throw simulator.failure(
          String.format(
              Locale.ROOT, "drones still move after %.1f s", timeout.toMillis() / 1000.0));
    }
  }

  /**
   * Waits until all goals of the scenario are reached, or cannot be reached any more.
   *
   * @throws AssertionError if they cannot, or if that takes more than 30 s of the wall clock
   * @throws IllegalStateException if the scenario has no goals
   */
  public void awaitGoals() {
    awaitGoals(PATIENCE);
  }

  /**
   * The same.
   *
   * @param timeout how long at the most, by the wall clock
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
    if (!goals.reached()) {
      throw simulator.failure(
          goals.failed()
              ? "the goals were missed"
              : String.format(
                  Locale.ROOT,
                  "the goals were not reached within %.1f s",
                  timeout.toMillis() / 1000.0));
    }
  }

  /** How far the drones have come with the goals of the scenario. */
  public GoalStatus goals() {
    simulator.settle();
    return present();
  }

  private GoalStatus present() {
    return GoalStatus.of(simulator.progress());
  }

  /** What goes wrong. */
  public Faults faults() {
    return faults;
  }

  /**
   * Lets the wind blow, the same everywhere in the room.
   *
   * @param speed [cm/s]
   * @param towards where it blows to [degrees], clockwise seen from above, 0 along the room's x
   * @throws IllegalArgumentException if the speed is not from 0 to 2000 cm/s, or the angle not from
   *     -360 to 360 degrees
   */
  public void wind(double speed, double towards) {
    Limits.checkWindSpeed(speed);
    Limits.checkAngle("towards", towards);
    Vec3 forward = new Vec3(Frames.meters(speed), 0, 0);
    Vec3 mean = Attitude.ofHeading(Frames.headingOfYaw(towards)).toRoom(forward);
    simulator.carryOut(new Control.SetWind(new Wind(mean, 0)));
  }
}
