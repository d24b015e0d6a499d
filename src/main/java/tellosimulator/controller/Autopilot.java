package tellosimulator.controller;

import tellosimulator.controller.Maneuver.Sensed;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;
import tellosimulator.profile.Behavior;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Flies the current maneuver, adds the movement that the sticks of {@code rc} demand, and
 * determines the outcome of the maneuver. One instance per drone, confined to the simulation
 * thread.
 */
final class Autopilot {

  /** The outcome of a maneuver. */
  enum Outcome {
    RUNNING,
    ARRIVED,
    /** An obstacle has blocked the drone for a second. Decided. */
    HELD,
    /** The drone has not settled on its target in time. */
    RESTLESS,
    /** The maneuver cannot be completed. */
    LOST
  }

  /**
   * The plan waits for a drone that touches an obstacle and is farther than this from its target
   * [m]. Assumed.
   */
  private static final double LEASH = 0.3;

  /**
   * A drone leans on the touched object if its target is deeper than this inside the object [m].
   * Decided: the distance from the target within which a drone counts as settled.
   */
  private static final double LEANING_LAG = 0.006;

  /** Maximum error at the end of a maneuver [standard deviations]. Assumed. */
  private static final double MOST_SIGMAS = 3;

  /** Time for which the drone leans on an object before the maneuver is abandoned [s]. Decided. */
  private static final double LEANING = 1;

  /**
   * Maximum distance between target and actual pose at which the next maneuver starts from the
   * target instead of the actual pose [m, rad]. Assumed.
   */
  private static final double ON_TARGET = 0.02;

  private final Behavior behavior;
  private final RcSteering rc;
  private final Settling settling;
  private Maneuver maneuver;
  private Setpoint setpoint = new Setpoint.MotorsOff();
  private Vec3 shift = Vec3.ZERO;
  private double turn;
  private double leaning;
  private boolean touched;
  private Vec3 drift = Vec3.ZERO;

  Autopilot(Behavior behavior, RcSteering rc) {
    this.behavior = behavior;
    this.rc = rc;
    this.settling = new Settling(behavior.steadyTime());
    this.maneuver = new Parked();
  }

  void fly(Maneuver next) {
    maneuver = next;
    shift = Vec3.ZERO;
    turn = 0;
    leaning = 0;
    settling.restart();
  }

  /** Sets the drift velocity of the target, in the room frame [m/s]. */
  void drift(Vec3 velocity) {
    drift = velocity;
  }

  /** Whether the target drifts. */
  boolean drifts() {
    return !drift.equals(Vec3.ZERO);
  }

  /** Switches the motors off. */
  void park() {
    fly(new Parked());
    setpoint = new Setpoint.MotorsOff();
    rc.still();
  }

  Maneuver maneuver() {
    return maneuver;
  }

  Setpoint setpoint() {
    return setpoint;
  }

  /**
   * Returns the start of a new maneuver: the last target if the drone is on it, otherwise the
   * drone's position.
   */
  Vec3 basePosition(Motion motion) {
    return setpoint instanceof Setpoint.Track track
            && !touched
            && track.position().distanceTo(motion.position()) < ON_TARGET
        ? track.position()
        : motion.position();
  }

  /** Returns the initial heading of a new maneuver [rad]. */
  double baseHeading(Motion motion) {
    double heading = motion.attitude().heading();
    return setpoint instanceof Setpoint.Track track
            && Math.abs(Frames.wrapped(track.heading().angle() - heading)) < ON_TARGET
        ? Frames.wrapped(track.heading().angle())
        : heading;
  }

  /** Sets the target for the next step. */
  void steer(Motion motion, boolean onGround, double seconds) {
    boolean blocked = touched && lag(motion).norm() > LEASH;
    Setpoint planned = maneuver.advance(new Sensed(motion, blocked, onGround), seconds);
    setpoint = planned instanceof Setpoint.Track track ? steered(track, motion, seconds) : planned;
  }

  /**
   * Evaluates the result of a step. The sticks, a drift or the simulated positioning error can move
   * the target into the touched object. This method undoes that part of the shift, so that the
   * drone leans on the object only if the maneuver itself leads into the object.
   *
   * @param contactNormal the normal of the touched surface; zero if there is none
   * @param pushed whether wind pushes the drone
   */
  void observe(Motion motion, Vec3 contactNormal, boolean pushed) {
    touched = !contactNormal.equals(Vec3.ZERO);
    double inside = Math.max(0, -lag(motion).dot(contactNormal));
    double ownMiss = MOST_SIGMAS * behavior.positionSigma();
    double inVain = Math.min(inside, Math.max(0, ownMiss - shift.dot(contactNormal)));
    shift = shift.plusScaled(contactNormal, inVain);
    leaning = inside - inVain > LEANING_LAG ? leaning + SimTime.STEP : 0;
    if (maneuver.planned()) {
      settling.observe(setpoint, motion, !rc.atRest() || drifts(), pushed);
    }
  }

  Outcome outcome() {
    if (leaning >= LEANING) {
      return Outcome.HELD;
    }
    if (settling.settled()) {
      return Outcome.ARRIVED;
    }
    if (maneuver.lost().isPresent()) {
      return Outcome.LOST;
    }
    return settling.givenUp() ? Outcome.RESTLESS : Outcome.RUNNING;
  }

  private Vec3 lag(Motion motion) {
    return setpoint instanceof Setpoint.Track track
        ? track.position().minus(motion.position())
        : Vec3.ZERO;
  }

  private Setpoint steered(Setpoint.Track track, Motion motion, double seconds) {
    if (maneuver.steerable() && !rc.atRest()) {
      follow(motion, track.heading().angle(), seconds);
    }
    if (drifts()) {
      move(drift, motion, seconds);
    }
    Setpoint.Track wanted = shifted(track);
    return maneuver.leavesHoverHeights() ? wanted : withinHeights(wanted, motion, seconds);
  }

  /** Moves the target according to the sticks. */
  private void follow(Motion motion, double planned, double seconds) {
    turn += rc.yawRate() * seconds;
    Vec3 velocity = allowed(rc.velocity()).turned(planned + turn);
    move(velocity, motion, seconds);
  }

  /** Moves the target, but not further away from a blocked drone. */
  private void move(Vec3 velocity, Motion motion, double seconds) {
    Vec3 lag = lag(motion);
    boolean runsAway = touched && lag.norm() > LEASH && lag.dot(velocity) > 0;
    if (!runsAway) {
      shift = shift.plusScaled(velocity, seconds);
    }
  }

  /**
   * Returns the velocity that the sticks may add. They cannot lower the target during a takeoff or
   * a flip.
   */
  private Vec3 allowed(Vec3 asked) {
    boolean down = rc.velocity().z() < 0 && maneuver.leavesHoverHeights();
    return down ? asked.horizontal() : asked;
  }

  /** Returns the target after it has been shifted by the sticks and by a drift. */
  private Setpoint.Track shifted(Setpoint.Track track) {
    double heading = track.heading().angle() + turn;
    Setpoint.Track shifted =
        new Setpoint.Track(
            track.position().plus(shift),
            track.velocity().plus(drift),
            track.acceleration(),
            new Setpoint.Heading(heading, track.heading().rate()));
    if (!maneuver.steerable() || rc.atRest()) {
      return shifted;
    }
    return new Setpoint.Track(
        shifted.position(),
        shifted.velocity().plus(allowed(rc.velocity()).turned(heading)),
        track.acceleration().plus(allowed(rc.acceleration()).turned(heading)),
        new Setpoint.Heading(heading, track.heading().rate() + rc.yawRate()));
  }

  /**
   * Returns the target, limited to the hover heights. The target slows down in time to stop at a
   * limit. The part of the sticks' offset that has no effect because of a limit is discarded.
   */
  private Setpoint.Track withinHeights(Setpoint.Track track, Motion motion, double seconds) {
    double wanted = track.position().z();
    double last =
        setpoint instanceof Setpoint.Track before ? before.position().z() : motion.position().z();
    double height = reachableHeight(wanted, last, seconds);
    if (height == wanted) {
      return track;
    }
    double asked = rc.velocity().z() * seconds;
    double inVain = height - wanted;
    if (asked * inVain < 0) {
      shift =
          shift.plusScaled(
              Vec3.UP, Math.copySign(Math.min(Math.abs(asked), Math.abs(inVain)), inVain));
    }
    boolean still = height == last;
    Vec3 vertical = Vec3.UP.times((height - last) / seconds);
    return new Setpoint.Track(
        track.position().withZ(height),
        track.velocity().horizontal().plus(vertical),
        track.acceleration().withZ(still ? 0 : Math.copySign(DroneSpec.HARD_BRAKING, inVain)),
        track.heading());
  }

  /**
   * Returns the height nearest to {@code wanted} from which the drone can still brake before it
   * reaches a limit [m].
   */
  private double reachableHeight(double wanted, double last, double seconds) {
    double lowest = behavior.lowestHover();
    double highest = DroneSpec.MAX_HEIGHT;
    double down = seconds * brakingSpeed(last - lowest);
    double up = seconds * brakingSpeed(highest - last);
    double reachable = Math.max(last - down, Math.min(last + up, wanted));
    return Math.max(lowest, Math.min(highest, reachable));
  }

  /** Returns the highest speed from which the drone can brake within a distance [m/s]. */
  private static double brakingSpeed(double distance) {
    return Math.sqrt(2 * DroneSpec.HARD_BRAKING * Math.max(0, distance));
  }

  /** A maneuver that keeps the motors off and never ends. */
  private static final class Parked implements Maneuver {

    @Override
    public Setpoint advance(Sensed sensed, double seconds) {
      return new Setpoint.MotorsOff();
    }

    @Override
    public boolean planned() {
      return false;
    }

    @Override
    public boolean atRest() {
      return true;
    }

    @Override
    public Phrase progress() {
      return Phrase.of("standing");
    }
  }
}
