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
 * Flies the present maneuver, with the sticks of {@code rc} on top, and says when it is over. For
 * one drone and the simulation thread.
 */
final class Autopilot {

  /** What has become of a maneuver. */
  enum Outcome {
    RUNNING,
    ARRIVED,
    /** Something stood in the way for a second. Decided. */
    HELD,
    /** The drone did not come to rest. */
    RESTLESS,
    /** The maneuver cannot be flown to its end. */
    LOST
  }

  /** How far the target may lie inside an obstacle before the drone waits [m]. Assumed. */
  private static final double LEASH = 0.3;

  /** How far the target lies inside what it leans against at the least [m]: not yet arrived. */
  private static final double LEANING_LAG = 0.006;

  /** By how much a maneuver may miss its end at the most [standard deviations]. Assumed. */
  private static final double MOST_SIGMAS = 3;

  /** How long it leans against something before it gives up [s]. Decided. */
  private static final double LEANING = 1;

  /** A target missed by less is where the next maneuver starts from [m, rad]. Assumed. */
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

  /** How the target moves away by itself from now on, room frame [m/s]. */
  void drift(Vec3 velocity) {
    drift = velocity;
  }

  /** Whether the target moves by itself. */
  boolean drifts() {
    return !drift.equals(Vec3.ZERO);
  }

  /** Motors off. */
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

  /** Where a maneuver starts: the last target if the drone is on it, else where it is. */
  Vec3 basePosition(Motion motion) {
    return setpoint instanceof Setpoint.Track track
            && !touched
            && track.position().distanceTo(motion.position()) < ON_TARGET
        ? track.position()
        : motion.position();
  }

  /** The heading from which a maneuver starts [rad]. */
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
   * Looks at what the step has made of the target. Where sticks, drift or a miss have moved it into
   * what the drone touches, it moves back, so that only the maneuver itself leans against that.
   *
   * @param contactNormal of what it touches; zero if it touches nothing
   * @param pushed whether wind pushes it
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

  /** Moves the target as the sticks ask for. */
  private void follow(Motion motion, double planned, double seconds) {
    turn += rc.yawRate() * seconds;
    Vec3 velocity = allowed(rc.velocity()).turned(planned + turn);
    move(velocity, motion, seconds);
  }

  /** Moves the target, but not away from a drone that something holds. */
  private void move(Vec3 velocity, Motion motion, double seconds) {
    Vec3 lag = lag(motion);
    boolean runsAway = touched && lag.norm() > LEASH && lag.dot(velocity) > 0;
    if (!runsAway) {
      shift = shift.plusScaled(velocity, seconds);
    }
  }

  /** What the sticks may add: a takeoff is not pushed back to the ground. */
  private Vec3 allowed(Vec3 asked) {
    boolean down = rc.velocity().z() < 0 && maneuver.leavesHoverHeights();
    return down ? asked.horizontal() : asked;
  }

  /** The target with what the sticks have added to it. */
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
   * The target, kept within the heights in which a drone hovers and braked before it gets there.
   * What the sticks asked for in vain is forgotten.
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

  /** The height nearest to {@code wanted} from which it can still brake before the limits [m]. */
  private double reachableHeight(double wanted, double last, double seconds) {
    double lowest = behavior.lowestHover();
    double highest = DroneSpec.MAX_HEIGHT;
    double down = seconds * brakingSpeed(last - lowest);
    double up = seconds * brakingSpeed(highest - last);
    double reachable = Math.max(last - down, Math.min(last + up, wanted));
    return Math.max(lowest, Math.min(highest, reachable));
  }

  /** The speed that can be lost over a distance [m/s]. */
  private static double brakingSpeed(double distance) {
    return Math.sqrt(2 * DroneSpec.HARD_BRAKING * Math.max(0, distance));
  }

  /** Motors off. Has no end. */
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
