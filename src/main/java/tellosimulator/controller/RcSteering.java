package tellosimulator.controller;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.time.SimTime;

/**
 * The movement commanded by the sticks of {@code rc}: after a dead time, the velocities follow the
 * sticks with a time constant. One instance per drone, confined to the simulation thread.
 */
final class RcSteering {

  /** Speeds below this are treated as zero [m/s, rad/s]. Assumed. */
  private static final double NEGLIGIBLE = 1e-4;

  private record Change(SimTime time, Sticks sticks) {}

  private final Behavior behavior;
  private final Deque<Change> changes = new ArrayDeque<>();
  private Vec3 velocity = Vec3.ZERO;
  private Vec3 acceleration = Vec3.ZERO;
  private double yawRate;

  RcSteering(Behavior behavior) {
    this.behavior = behavior;
    center();
  }

  /** Sets new stick values. They remain in effect until the next ones. */
  void set(Sticks sticks, SimTime now) {
    if (changes.getLast().time().equals(now)) {
      changes.removeLast();
    }
    changes.addLast(new Change(now, sticks));
  }

  /** Returns the latest stick values. */
  Sticks sticks() {
    return changes.getLast().sticks();
  }

  /** Clears all stick values and the movement, on a reset or power-off. */
  void center() {
    changes.clear();
    changes.add(new Change(SimTime.ZERO, Sticks.CENTERED));
    still();
  }

  /**
   * Keeps the stick values while the drone is on the ground. They take effect at lift-off, as if
   * set at that moment.
   */
  void hold(SimTime now) {
    Sticks kept = sticks();
    center();
    if (!kept.centered()) {
      changes.add(new Change(now, kept));
    }
  }

  /** Stops the movement, but keeps the stick values. */
  void still() {
    velocity = Vec3.ZERO;
    acceleration = Vec3.ZERO;
    yawRate = 0;
  }

  /** Whether the sticks have no effect on the drone, both now and after the dead time. */
  boolean atRest() {
    return changes.size() == 1 && sticks().centered() && velocity.equals(Vec3.ZERO) && yawRate == 0;
  }

  /** Advances the movement by a step. */
  void follow(SimTime now, double seconds) {
    if (atRest()) {
      return;
    }
    Sticks level = delayed(now, behavior.rcLevelDelay());
    Vec3 wanted = wantedVelocity(level);
    Vec3 asked = wanted.minus(velocity).times(1 / behavior.rcLevelTimeConstant());
    double onset = behavior.rcLevelOnset();
    acceleration =
        onset == 0 ? asked : acceleration.plusScaled(asked.minus(acceleration), seconds / onset);
    velocity = velocity.plusScaled(acceleration, seconds);
    Sticks yaw = delayed(now, behavior.rcYawDelay());
    double wantedRate = -behavior.rcYawRate(yaw.clockwise());
    yawRate += (wantedRate - yawRate) * seconds / behavior.rcYawTimeConstant();
    forgetOld(now);
    if (wanted.equals(Vec3.ZERO)
        && velocity.norm() < NEGLIGIBLE
        && acceleration.norm() * onset < NEGLIGIBLE) {
      velocity = Vec3.ZERO;
      acceleration = Vec3.ZERO;
    }
    if (wantedRate == 0 && Math.abs(yawRate) < NEGLIGIBLE) {
      yawRate = 0;
    }
  }

  /** Returns the velocity in the level body frame [m/s]. */
  Vec3 velocity() {
    return velocity;
  }

  /** Returns the acceleration in the level body frame [m/s²]. */
  Vec3 acceleration() {
    return acceleration;
  }

  /** Returns the yaw rate, counter-clockwise [rad/s]. */
  double yawRate() {
    return yawRate;
  }

  private Vec3 wantedVelocity(Sticks sticks) {
    return new Vec3(
        level(sticks.forward()), level(-sticks.right()), sticks.up() * behavior.rcVerticalGain());
  }

  private double level(double value) {
    return Math.abs(value) <= behavior.rcDeadZone() ? 0 : value * behavior.rcLevelGain();
  }

  private Sticks delayed(SimTime now, double delay) {
    Iterator<Change> latestFirst = changes.descendingIterator();
    Change change = latestFirst.next();
    while (latestFirst.hasNext() && now.since(change.time()) < delay) {
      change = latestFirst.next();
    }
    return change.sticks();
  }

  private void forgetOld(SimTime now) {
    double longest = Math.max(behavior.rcLevelDelay(), behavior.rcYawDelay());
    while (changes.size() > 1) {
      Change oldest = changes.removeFirst();
      if (now.since(changes.getFirst().time()) < longest) {
        changes.addFirst(oldest);
        return;
      }
    }
  }
}
