package tellosimulator.scenario;

import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Frames;
import tellosimulator.sim.SimConfig.Rules;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Decor;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Wind;

/**
 * A kind of number that users edit, with its unit and range in scenario files, in the window and on
 * the command line. In the program, such numbers are in SI units. Immutable.
 *
 * @param least minimum in the written unit
 * @param most maximum in the written unit
 */
public record Quantity(Unit unit, double least, double most) {

  /** The unit in which a number is written. */
  public enum Unit {
    /** No unit. */
    ONE,
    /** Centimetres or centimetres per second, converted to metres or metres per second. */
    CENTIMETER,
    /** Degrees counter-clockwise, converted to radians within ±π. */
    DEGREE,
    /** Seconds. The unit may be written, too, as in {@code 90s}. */
    SECOND
  }

  public static final Quantity ANGLE = new Quantity(Unit.DEGREE, -360, 360);

  /** A coordinate in the room or on one of its surfaces, positive or negative. */
  public static final Quantity OFFSET = length(-Room.LONGEST, Room.LONGEST);

  /** A height above the floor. */
  public static final Quantity HEIGHT = length(0, Room.LONGEST);

  public static final Quantity ROOM_EDGE = length(Room.SHORTEST, Room.LONGEST);
  public static final Quantity GRID = length(Decor.SMALLEST_GRID, Decor.LARGEST_GRID);
  public static final Quantity POSTER_WIDTH = length(Poster.NARROWEST, Room.LONGEST);

  /** The length of an edge of an obstacle, or the radius of a cylinder. */
  public static final Quantity SIZE = length(Shape.SHORTEST, Shape.LONGEST);

  public static final Quantity DIAMETER = length(2 * Shape.SHORTEST, Shape.LONGEST);
  public static final Quantity GOAL_RADIUS = length(GoalRegion.SMALLEST, Room.LONGEST);

  /** The speed of the wind or of its gusts. */
  public static final Quantity WIND_SPEED = length(0, Wind.FASTEST);

  public static final Quantity CRASH_SPEED = length(0, Rules.FASTEST_TOUCH);
  public static final Quantity HOVER_TIME =
      new Quantity(Unit.SECOND, Goal.SHORTEST_HOVER, Goal.LONGEST_HOVER);

  /** How much of the picture's width something takes that a drone must see, in percent. */
  public static final Quantity SIGHT =
      new Quantity(Unit.ONE, Goal.SMALLEST_SIZE, Goal.LARGEST_SIZE);

  /** The time limit of a challenge. Decided: at least a second. */
  public static final Quantity TIME_LIMIT = new Quantity(Unit.SECOND, 1, Challenge.LONGEST);

  /** The points of a goal, a penalty or a bonus. */
  public static final Quantity POINTS = new Quantity(Unit.ONE, 0, Terms.MOST_POINTS);

  /** The points of a whole attempt, which penalties can make negative. */
  public static final Quantity TOTAL =
      new Quantity(Unit.ONE, -Terms.MOST_POINTS, Terms.MOST_POINTS);

  /** A time at which a bonus begins or ceases to decrease. */
  public static final Quantity BONUS_TIME = new Quantity(Unit.SECOND, 0, Challenge.LONGEST);

  public static final Quantity TIME_FACTOR =
      new Quantity(Unit.ONE, TimeFactor.SMALLEST, TimeFactor.LARGEST);
  public static final Quantity BATTERY_PERCENT = new Quantity(Unit.ONE, 0, 100);

  private static Quantity length(double least, double most) {
    return new Quantity(Unit.CENTIMETER, Frames.centimeters(least), Frames.centimeters(most));
  }

  public boolean contains(double written) {
    return written >= least && written <= most;
  }

  /** Converts a written number to SI units. */
  public double inSi(double written) {
    return switch (unit) {
      case ONE, SECOND -> written;
      case CENTIMETER -> Frames.meters(written);
      case DEGREE -> StrictMath.toRadians(within180(written));
    };
  }

  /**
   * Converts a number in SI units to the written number. Angles are above -180° and at most 180°.
   */
  public double written(double si) {
    return switch (unit) {
      case ONE, SECOND -> si;
      case CENTIMETER -> Frames.centimeters(si);
      case DEGREE ->
          within180(NumberCodec.rounded(StrictMath.toDegrees(Frames.wrapped(si)))); // as when read
    };
  }

  private static double within180(double degrees) {
    double turned = degrees > 180 ? degrees - 360 : degrees;
    return turned <= -180 ? turned + 360 : turned;
  }
}
