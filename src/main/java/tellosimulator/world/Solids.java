package tellosimulator.world;

import java.util.List;
import java.util.stream.Stream;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;

/** Takes obstacles apart into what one can calculate with. */
final class Solids {

  private Solids() {}

  static List<Solid> of(Obstacle obstacle) {
    Shape shape = obstacle.shape();
    if (shape instanceof Shape.Box box) {
      return List.of(block(obstacle, Vec3.ZERO, new Vec3(box.depth(), box.width(), box.height())));
    }
    if (shape instanceof Shape.Cylinder cylinder) {
      return List.of(new Pillar(obstacle.foot(), cylinder.radius(), cylinder.height()));
    }
    if (shape instanceof Shape.Ring ring) {
      return ring(obstacle, ring);
    }
    return frame(obstacle, (Shape.Frame) shape);
  }

  private static List<Solid> ring(Obstacle obstacle, Shape.Ring ring) {
    double tube = ring.tube() / 2;
    Solid hoop =
        new Hoop(
            obstacle.foot().plusScaled(Vec3.UP, ring.middle()),
            ring.radius() + tube,
            tube,
            ahead(obstacle));
    double post = ring.middle() - ring.radius() - ring.tube();
    return post <= 0 ? List.of(hoop) : List.of(hoop, new Pillar(obstacle.foot(), tube, post));
  }

  private static List<Solid> frame(Obstacle obstacle, Shape.Frame frame) {
    double beam = frame.beam();
    double side = (frame.width() + beam) / 2;
    double top = frame.middle() + frame.opening() / 2;
    double sill = frame.middle() - frame.opening() / 2 - beam;
    Vec3 post = new Vec3(beam, beam, top + beam);
    Vec3 crossbar = new Vec3(beam, frame.width(), beam);
    Stream<Solid> around =
        Stream.of(
            block(obstacle, new Vec3(0, side, 0), post),
            block(obstacle, new Vec3(0, -side, 0), post),
            block(obstacle, new Vec3(0, 0, top), crossbar));
    Stream<Solid> below =
        sill < 0 ? Stream.of() : Stream.of(block(obstacle, new Vec3(0, 0, sill), crossbar));
    return Stream.concat(around, below).toList();
  }

  /**
   * A box in an obstacle's frame.
   *
   * @param middle of its base
   * @param size its depth, width and height
   */
  private static Solid block(Obstacle obstacle, Vec3 middle, Vec3 size) {
    return new Block(
        obstacle.foot().plus(obstacle.pose().attitude().toRoom(middle)),
        new Vec3(size.x() / 2, size.y() / 2, size.z()),
        ahead(obstacle));
  }

  private static Vec3 ahead(Obstacle obstacle) {
    return Attitude.ofHeading(obstacle.heading()).toRoom(new Vec3(1, 0, 0));
  }
}
