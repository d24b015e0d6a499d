package tellosimulator.controller;

import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;
import tellosimulator.physics.Setpoint;

/** A path through the room, parameterized by arc length. Immutable. */
sealed interface Path {

  double length();

  /** Returns the position, velocity and acceleration at a point of the path. */
  Setpoint.Track track(SpeedProfile.Sample sample, Setpoint.Heading heading);

  /**
   * A straight line.
   *
   * @param start the start of the line, in the room frame [m]
   * @param direction a unit vector, or zero for a path of length zero
   */
  record Line(Vec3 start, Vec3 direction, double length) implements Path {

    static Line between(Vec3 start, Vec3 goal) {
      Vec3 way = goal.minus(start);
      return new Line(start, way.normalized(), way.norm());
    }

    @Override
    public Setpoint.Track track(SpeedProfile.Sample sample, Setpoint.Heading heading) {
      return new Setpoint.Track(
          start.plusScaled(direction, sample.way()),
          direction.times(sample.speed()),
          direction.times(sample.acceleration()),
          heading);
    }
  }

  /**
   * A circular arc.
   *
   * @param start the start of the arc, in the room frame [m]
   * @param arc the arc relative to the start, in axes turned by {@code turn}
   * @param turn the heading of the arc's axes [rad]
   * @param miss the error at the end of the arc, in the room frame [m]; the error grows linearly
   *     along the path
   */
  record Curve(Vec3 start, Arc arc, double turn, Vec3 miss) implements Path {

    @Override
    public double length() {
      return arc.length();
    }

    @Override
    public Setpoint.Track track(SpeedProfile.Sample sample, Setpoint.Heading heading) {
      double swept = sample.way() / arc.radius();
      Vec3 along = arc.direction(swept);
      Vec3 centripetal = arc.inward(swept).times(sample.speed() * sample.speed() / arc.radius());
      return new Setpoint.Track(
          start.plus(arc.point(swept).turned(turn)).plusScaled(miss, sample.way() / arc.length()),
          along.times(sample.speed()).turned(turn),
          along.times(sample.acceleration()).plus(centripetal).turned(turn),
          heading);
    }
  }
}
