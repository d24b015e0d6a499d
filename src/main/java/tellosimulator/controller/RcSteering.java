package tellosimulator.controller;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import tellosimulator.command.Sticks;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.time.SimTime;

/**
 * What the sticks of {@code rc} ask for: velocities that follow after a dead time with a time
 * constant. For one drone and the simulation thread.
 */
final class RcSteering {

  /** Speeds below this count as none [m/s, rad/s]. Assumed. */
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

  /** New values; they stay until the next ones. */
  void set(Sticks sticks, SimTime now) {
    if (changes.getLast().time().equals(now)) {
      changes.removeLast();
    }
    changes.addLast(new Change(now, sticks));
  }

  /** The values that were set last. */
  Sticks sticks() {
    return changes.getLast().sticks();
  }

  /** Forgets all values, as reset and power-off do. */
  void center() {
    changes.clear();
    changes.add(new Change(SimTime.ZERO, Sticks.CENTERED));
    still();
  }

  /** The drone stands: the values are kept, and act from lift-off on as if set then. */
  void hold(SimTime now) {
    Sticks kept = sticks();
    center();
    if (!kept.centered()) {
      changes.add(new Change(now, kept));
    }
  }

  /** Forgets the motion, but not the values. */
  void still() {
    velocity = Vec3.ZERO;
    acceleration = Vec3.ZERO;
    yawRate = 0;
  }

  /** Whether no stick moves the drone, now or soon. */
  boolean atRest() {
    return changes.size() == 1 && sticks().centered() && velocity.equals(Vec3.ZERO) && yawRate == 0;
  }

  /** Lets the motion follow the sticks for a step. */
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

  /** Velocity in the level body frame [m/s]. */
  Vec3 velocity() {
    return velocity;
  }

  /** Acceleration in the level body frame [m/s²]. */
  Vec3 acceleration() {
    return acceleration;
  }

  /** Turning rate, counter-clockwise [rad/s]. */
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
