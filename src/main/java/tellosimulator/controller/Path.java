package tellosimulator.controller;

import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;
import tellosimulator.physics.Setpoint;

/** A way through the room, measured by the length covered. Immutable. */
sealed interface Path {

  double length();

  /** Where to be and how to move at a point of the way. */
  Setpoint.Track track(SpeedProfile.Sample sample, Setpoint.Heading heading);

  /**
   * A straight line.
   *
   * @param start room frame [m]
   * @param direction unit vector, or zero if there is nowhere to go
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
   * A part of a circle.
   *
   * @param start room frame [m]
   * @param arc relative to the start, in axes turned by {@code turn}
   * @param turn heading of the arc's axes [rad]
   * @param miss by how much it ends elsewhere, room frame; it grows evenly on the way [m]
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
