package tellosimulator.scenario;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.Spot;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;

/** Reads goals. Whether what they name is there is looked at afterwards. */
final class GoalReader implements Value<Goal> {

  static final Map<String, Direction> DIRECTIONS =
      Map.of("either", Direction.EITHER, "along", Direction.ALONG, "against", Direction.AGAINST);

  /** Radius of places [m]. Decided: an arm's length is too far, a hand's breadth too near. */
  private static final double RADIUS = 0.3;

  private static final double LONGEST_CM = ObstacleReader.LONGEST_CM;

  private final int drones;

  /**
   * @param drones how many there are
   */
  GoalReader(int drones) {
    this.drones = drones;
  }

  @Override
  public Optional<Goal> read(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.GOAL, node, mistakes);
    return section.onlyKey().flatMap(kind -> section.read(kind, reader(kind)));
  }

  private Value<Goal> reader(String kind) {
    return switch (kind) {
      case "reach" -> this::reach;
      case "hover" -> this::hover;
      case "pass" -> this::pass;
      case "land" -> this::land;
      default -> this::landOn;
    };
  }

  private Optional<Goal> reach(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.REACH, node, mistakes);
    Goal goal = new Goal.Reach(drone(section), spot(section, point()));
    return section.sound() ? Optional.of(goal) : Optional.empty();
  }

  private Optional<Goal> hover(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.HOVER, node, mistakes);
    double seconds =
        section.need(
            "seconds",
            Values.number(
                Phrase.of("seconds from 0.1 to %s", Values.plain(Goal.LONGEST_HOVER)),
                0.1,
                Goal.LONGEST_HOVER),
            1.0);
    Goal goal = new Goal.Hover(drone(section), spot(section, point()), seconds);
    return section.sound() ? Optional.of(goal) : Optional.empty();
  }

  private Optional<Goal> pass(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.PASS, node, mistakes);
    String gate = section.need("gate", Values.text(), "");
    Direction direction = section.read("direction", Values.word(DIRECTIONS), Direction.EITHER);
    Goal goal = new Goal.Pass(drone(section), gate, direction);
    return section.sound() ? Optional.of(goal) : Optional.empty();
  }

  private Optional<Goal> land(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.LAND, node, mistakes);
    Goal goal = new Goal.Land(drone(section), spot(section, ObstacleReader.FLOOR_POINT));
    return section.sound() ? Optional.of(goal) : Optional.empty();
  }

  private Optional<Goal> landOn(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.LAND_ON, node, mistakes);
    Goal goal = new Goal.LandOn(drone(section), section.need("pad", RoomReader.padId(), 1));
    return section.sound() ? Optional.of(goal) : Optional.empty();
  }

  private OptionalInt drone(Section section) {
    Optional<Integer> number =
        section.read(
            "drone",
            Values.count(
                drones == 1
                    ? Phrase.of("drone 1, the only one")
                    : Phrase.of("a drone from 1 to %d", drones),
                1,
                drones));
    return number.isPresent() ? OptionalInt.of(number.get()) : OptionalInt.empty();
  }

  private static Spot spot(Section section, Value<Vec3> place) {
    return new Spot(
        section.need("at", place, Vec3.ZERO),
        section.read("radius", Values.length(Spot.SMALLEST * 100, LONGEST_CM), RADIUS));
  }

  private static Value<Vec3> point() {
    return Values.map(
        Values.lengths("x, y, z", -LONGEST_CM, LONGEST_CM),
        point -> new Vec3(point.get(0), point.get(1), point.get(2)));
  }
}
