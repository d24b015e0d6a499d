package tellosimulator.world;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import tellosimulator.math.Vec3;

/**
 * The shape of an obstacle. The origin of its frame is the middle of its foot. The x axis points
 * along the depth, or through the opening of a gate; the y axis points along the width, and the z
 * axis up. All lengths are in metres. Immutable.
 */
public sealed interface Shape {

  /** Maximum length of an edge [m]. Decided: the same as for a room. */
  double LONGEST = Room.LONGEST;

  /** Minimum length of an edge [m]. Decided: the thickness of a sheet of cardboard. */
  double SHORTEST = 0.001;

  /** Returns the height of the shape above its foot. */
  double height();

  /** Returns the maximum distance of any point of the shape from the vertical axis. */
  default double reach() {
    return StrictMath.hypot(size().x(), size().y()) / 2;
  }

  /** Returns the depth, width and height of the shape's bounding box. */
  Vec3 size();

  /** Whether the shape's outline, seen from above, is a circle rather than a rectangle. */
  default boolean round() {
    return 2 * reach() <= Math.min(size().x(), size().y());
  }

  /** Applies the function for this kind of shape and returns its result. */
  <T> T match(Cases<T> cases);

  /** A function for each kind of shape, for code that treats the kinds differently. */
  record Cases<T>(
      Function<Box, T> box,
      Function<Cylinder, T> cylinder,
      Function<Ring, T> ring,
      Function<Frame, T> frame) {}

  /**
   * A box. A thin box serves as a wall.
   *
   * @param depth the extent along x
   * @param width the extent along y
   */
  record Box(double depth, double width, double height) implements Shape {
    public Box {
      check("depth", depth);
      check("width", width);
      check("height", height);
    }

    @Override
    public Vec3 size() {
      return new Vec3(depth, width, height);
    }

    @Override
    public <T> T match(Cases<T> cases) {
      return cases.box().apply(this);
    }
  }

  /** An upright cylinder. */
  record Cylinder(double radius, double height) implements Shape {
    public Cylinder {
      check("radius", radius);
      check("height", height);
    }

    @Override
    public double reach() {
      return radius;
    }

    @Override
    public Vec3 size() {
      return new Vec3(2 * radius, 2 * radius, height);
    }

    @Override
    public <T> T match(Cases<T> cases) {
      return cases.cylinder().apply(this);
    }
  }

  /** An upright opening. A drone can fly through it along the x axis, in either direction. */
  sealed interface Gate extends Shape {

    /** Returns the height of the opening's middle above the foot. */
    double middle();

    /** Returns the width of the opening. */
    double width();

    /**
     * Whether a point in the plane of the opening is inside the opening.
     *
     * @param across the distance from the middle along y
     * @param up the height above the middle
     */
    boolean opens(double across, double up);

    /** Applies the function for this kind of gate and returns its result. */
    <T> T match(Function<Ring, T> ring, Function<Frame, T> frame);

    @Override
    default <T> T match(Cases<T> cases) {
      return match(cases.ring(), cases.frame());
    }
  }

  /**
   * A ring on a post.
   *
   * @param radius the radius of the opening
   * @param tube the thickness of the ring and of its post
   * @param middle the height of the opening's middle above the foot; at the minimum, {@code radius
   *     + tube}, the ring has no post
   */
  record Ring(double radius, double tube, double middle) implements Gate {
    public Ring {
      check("radius", radius);
      check("tube", tube);
      check("middle", middle);
      if (middle < radius + tube) {
        throw new IllegalArgumentException(
            "middle is "
                + middle
                + " m, but a ring of this size needs at least "
                + (radius + tube));
      }
    }

    @Override
    public double height() {
      return middle + radius + tube;
    }

    /** Returns the height of the post up to the ring; 0 if the ring needs no post. */
    public double post() {
      return Math.max(0, middle - radius - tube);
    }

    @Override
    public double reach() {
      return radius + tube;
    }

    @Override
    public Vec3 size() {
      return new Vec3(tube, 2 * reach(), height());
    }

    @Override
    public double width() {
      return 2 * radius;
    }

    @Override
    public boolean opens(double across, double up) {
      return StrictMath.hypot(across, up) < radius;
    }

    @Override
    public <T> T match(Function<Ring, T> ring, Function<Frame, T> frame) {
      return ring.apply(this);
    }
  }

  /**
   * A rectangular frame of two sides, a top and, if there is space for it above the foot, a sill.
   * The sides reach down to the foot, so below the sill they are posts.
   *
   * @param width the width of the opening
   * @param opening the height of the opening
   * @param beam the thickness of the beams
   * @param middle the height of the opening's middle above the foot
   */
  record Frame(double width, double opening, double beam, double middle) implements Gate {
    public Frame {
      check("width", width);
      check("opening", opening);
      check("beam", beam);
      check("middle", middle);
      if (middle < opening / 2) {
        throw new IllegalArgumentException(
            "middle is " + middle + " m, but a frame of this size needs at least " + opening / 2);
      }
    }

    @Override
    public double height() {
      return middle + opening / 2 + beam;
    }

    /** Returns the height of the frame's lower end. Below it, there are only the posts. */
    public double post() {
      return Math.max(0, sill());
    }

    private double sill() {
      return middle - opening / 2 - beam;
    }

    /** Returns the beams: the two sides from the foot up, the top, and the sill if there is one. */
    public List<Beam> beams() {
      double side = (width + beam) / 2;
      double top = middle + opening / 2;
      Vec3 upright = new Vec3(beam, beam, top + beam);
      Vec3 crossbar = new Vec3(beam, width, beam);
      List<Beam> beams = new ArrayList<>();
      beams.add(new Beam(new Vec3(0, side, 0), upright));
      beams.add(new Beam(new Vec3(0, -side, 0), upright));
      beams.add(new Beam(new Vec3(0, 0, top), crossbar));
      if (sill() >= 0) {
        beams.add(new Beam(new Vec3(0, 0, sill()), crossbar));
      }
      return beams;
    }

    @Override
    public Vec3 size() {
      return new Vec3(beam, width + 2 * beam, height());
    }

    @Override
    public boolean opens(double across, double up) {
      return Math.abs(across) < width / 2 && Math.abs(up) < opening / 2;
    }

    @Override
    public <T> T match(Function<Ring, T> ring, Function<Frame, T> frame) {
      return frame.apply(this);
    }
  }

  /**
   * A beam of a gate.
   *
   * @param base the middle of the beam's base, in the gate's frame
   * @param size the depth, width and height of the beam
   */
  record Beam(Vec3 base, Vec3 size) {}

  private static void check(String name, double value) {
    if (!(value >= SHORTEST && value <= LONGEST)) {
      throw new IllegalArgumentException(
          name + " is " + value + " m, but must be from " + SHORTEST + " to " + LONGEST);
    }
  }
}
