package tellosimulator.view.plan;

import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * The position and heading of an item. Immutable.
 *
 * @param place the position of the item's middle or foot in the room frame [m]
 * @param heading the direction of the item's x axis, counter-clockwise seen from above [rad]
 */
record Placement(Vec3 place, double heading) {

  /** Returns the placement of a body with a given pose. */
  static Placement of(Pose pose) {
    return new Placement(pose.position(), pose.attitude().heading());
  }

  Pose pose() {
    return new Pose(place, Attitude.ofHeading(heading));
  }

  /** Returns a copy of this placement at another place on the floor, at the same height. */
  Placement at(Vec3 newPlace) {
    return new Placement(newPlace.withZ(place.z()), heading);
  }

  /** Returns a copy of this placement with another heading [rad]. */
  Placement turnedTo(double newHeading) {
    return new Placement(place, Frames.wrapped(newHeading));
  }

  /** Transforms a point from the item's frame to the room frame. */
  Vec3 toRoom(Vec3 own) {
    return place.plus(own.turned(heading));
  }

  /** Transforms a point from the room frame to the item's frame. */
  Vec3 toOwn(Vec3 room) {
    return room.minus(place).turned(-heading);
  }
}
