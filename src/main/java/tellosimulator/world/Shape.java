package tellosimulator.world;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;

/**
 * What an obstacle is made of. Its frame: origin in the middle of its foot, z up; x is its depth
 * and the way through a gate, y its width. All lengths in metres. Immutable; for any thread.
 */
public sealed interface Shape {

  /** Longest edge of anything [m]. Decided: that of a room. */
  double LONGEST = Room.LONGEST;

  /** Shortest edge of anything [m]. Decided: a sheet of cardboard. */
  double SHORTEST = 0.001;

  /** How high it reaches above its foot. */
  double height();

  /** How far it reaches from its vertical axis at the most. */
  double reach();

  /**
   * A box; a thin one is a wall.
   *
   * @param depth along x
   * @param width along y
   */
  record Box(double depth, double width, double height) implements Shape {
    public Box {
      check("depth", depth);
      check("width", width);
      check("height", height);
    }

    @Override
    public double reach() {
      return StrictMath.hypot(depth, width) / 2;
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
  }

  /** An upright opening to fly through, along x or against it. */
  sealed interface Gate extends Shape {

    /** Of the opening's middle above the foot. */
    double middle();

    /**
     * Whether a place in the plane of the opening is in it.
     *
     * @param across from the middle, along y
     * @param up from the middle
     */
    boolean opens(double across, double up);
  }

  /**
   * A ring on a post.
   *
   * @param radius of the opening
   * @param tube thickness of the ring and of its post
   * @param middle of the opening above the foot; at its lowest the ring stands on the floor
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

    /** Height of its post, up to the ring; 0 if it needs none. */
    public double post() {
      return Math.max(0, middle - radius - tube);
    }

    @Override
    public double reach() {
      return radius + tube;
    }

    @Override
    public boolean opens(double across, double up) {
      return StrictMath.hypot(across, up) < radius;
    }
  }

  /**
   * A frame of four beams, on two posts if it does not stand on the floor.
   *
   * @param width of the opening
   * @param opening height of the opening
   * @param beam thickness of the beams
   * @param middle of the opening above the foot
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

    /** Height of the frame's lower end, up to which its posts are no more than posts. */
    public double post() {
      return Math.max(0, sill());
    }

    private double sill() {
      return middle - opening / 2 - beam;
    }

    /** What it is made of: the two sides from the foot on, the top, and the sill if it has one. */
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
    public double reach() {
      return StrictMath.hypot(width / 2 + beam, beam / 2);
    }

    @Override
    public boolean opens(double across, double up) {
      return Math.abs(across) < width / 2 && Math.abs(up) < opening / 2;
    }
  }

  /**
   * A beam of a gate.
   *
   * @param base middle of its base, in the gate's frame
   * @param size its depth, width and height
   */
  record Beam(Vec3 base, Vec3 size) {}

  private static void check(String name, double value) {
    if (!(value >= SHORTEST && value <= LONGEST)) {
      throw new IllegalArgumentException(
          name + " is " + value + " m, but must be from " + SHORTEST + " to " + LONGEST);
    }
  }
}
