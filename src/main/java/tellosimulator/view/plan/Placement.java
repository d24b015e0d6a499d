package tellosimulator.view.plan;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * Where something is, and how it is turned. Immutable.
 *
 * @param place of its middle or foot, room frame [m]
 * @param heading where its x axis points [rad], counter-clockwise seen from above
 */
record Placement(Vec3 place, double heading) {

  /** Where a body stands. */
  static Placement of(Pose pose) {
    return new Placement(pose.position(), pose.attitude().heading());
  }

  Pose pose() {
    return new Pose(place, Attitude.ofHeading(heading));
  }

  /** The same above another place of the floor. */
  Placement at(Vec3 newPlace) {
    return new Placement(newPlace.withZ(place.z()), heading);
  }

  /** A vector of its frame in the room. */
  Vec3 toRoom(Vec3 own) {
    return place.plus(own.turned(heading));
  }

  /** A place of the room in its frame. */
  Vec3 toOwn(Vec3 room) {
    return room.minus(place).turned(-heading);
  }
}
