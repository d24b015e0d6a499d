package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.Spot;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.words.Phrase;

/** Codecs of goals. Whether what they name is there is looked at afterwards. */
final class GoalCodecs {

  /** Usual radius [m]. Decided: an arm's length is too far, a hand's breadth too near. */
  private static final double RADIUS = 0.3;

  private GoalCodecs() {}

  /** A goal of any kind. */
  static Codec<Goal> goal() {
    return new ChoiceCodec<Goal>("goal", Phrase.of("a goal"), "One goal.")
        .or("reach", new ReachCodec(), goal -> only(Goal.Reach.class, goal))
        .or("hover", new HoverCodec(), goal -> only(Goal.Hover.class, goal))
        .or("pass", new PassCodec(), goal -> only(Goal.Pass.class, goal))
        .or("land", new LandCodec(), goal -> only(Goal.Land.class, goal))
        .or("land-on", new LandOnCodec(), goal -> only(Goal.LandOn.class, goal));
  }

  private static <G extends Goal> Optional<G> only(Class<G> type, Goal goal) {
    return type.isInstance(goal) ? Optional.of(type.cast(goal)) : Optional.empty();
  }

  private record DroneNumber() implements Codec<Integer> {

    @Override
    public Optional<Integer> read(Node node, Reading reading) {
      return upTo(reading.drones()).read(node, reading);
    }

    private static Codec<Integer> upTo(int drones) {
      Phrase expected =
          drones == 1
              ? Phrase.of("drone 1, the only one")
              : Phrase.of("a drone from 1 to %d", drones);
      return Scalars.count(expected, 1, drones);
    }

    @Override
    public Node write(Integer number, Path folder) {
      return upTo(AddressPlan.MOST_DRONES).write(number, folder);
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return upTo(AddressPlan.MOST_DRONES).schema(definitions);
    }
  }

  /** Keys that several goals have. */
  private abstract static class OneCodec<G extends Goal> extends RecordCodec<G> {

    OneCodec(String name, Phrase phrase, String description) {
      super(name, phrase, description);
    }

    final Field<G, Vec3> space(Function<G, Spot> spot) {
      return key("at", "The place: [x, y, z] in cm, z from the floor to the drone's feet.")
          .need(Scalars.POINT, spot.andThen(Spot::place));
    }

    final Field<G, Double> radius(Function<G, Spot> spot) {
      return key("radius", "How near is near enough, in cm.")
          .usual(
              NumberCodec.length(Spot.SMALLEST * 100, Scalars.LONGEST_CM).orWritten(RADIUS),
              spot.andThen(Spot::radius));
    }

    final Field<G, Integer> drone() {
      return key("drone", "The number of the drone that shall do it; without it, any.")
          .optional(new DroneNumber(), goal -> DroneCodec.boxed(goal.drone()));
    }
  }

  private static final class ReachCodec extends OneCodec<Goal.Reach> {

    private final Field<Goal.Reach, Vec3> at = space(Goal.Reach::spot);
    private final Field<Goal.Reach, Double> radius = radius(Goal.Reach::spot);
    private final Field<Goal.Reach, Integer> drone = drone();

    ReachCodec() {
      super("reach", Phrase.of("a place to reach"), "To be at a place.");
    }

    @Override
    Goal.Reach make(Entries in) {
      OptionalInt number = DroneCodec.unboxed(in.find(drone));
      return new Goal.Reach(number, new Spot(in.get(at), in.get(radius)));
    }
  }

  private static final class HoverCodec extends OneCodec<Goal.Hover> {

    /** Shortest time [s]. Decided: what anybody would call staying. */
    private static final double SHORTEST = 0.1;

    private final Field<Goal.Hover, Vec3> at = space(Goal.Hover::spot);
    private final Field<Goal.Hover, Double> radius = radius(Goal.Hover::spot);
    private final Field<Goal.Hover, Double> seconds =
        key("seconds", "How long without a break.")
            .need(
                NumberCodec.of(
                    Phrase.of("seconds from 0.1 to %s", NumberCodec.plain(Goal.LONGEST_HOVER)),
                    SHORTEST,
                    Goal.LONGEST_HOVER),
                Goal.Hover::seconds);
    private final Field<Goal.Hover, Integer> drone = drone();

    HoverCodec() {
      super("hover", Phrase.of("a place to hover"), "To stay at a place.");
    }

    @Override
    Goal.Hover make(Entries in) {
      OptionalInt number = DroneCodec.unboxed(in.find(drone));
      return new Goal.Hover(number, new Spot(in.get(at), in.get(radius)), in.get(seconds));
    }
  }

  private static final class PassCodec extends OneCodec<Goal.Pass> {

    private final Field<Goal.Pass, String> gate =
        key("gate", "The gate's name.").need(Scalars.LINE, Goal.Pass::gate);
    private final Field<Goal.Pass, Direction> direction =
        key("direction", "Along the gate's heading, against it, or either way.")
            .usual(Scalars.words(Direction.values()).or(Direction.EITHER), Goal.Pass::direction);
    private final Field<Goal.Pass, Integer> drone = drone();

    PassCodec() {
      super("pass", Phrase.of("a gate to pass"), "To fly through the opening of a gate.");
    }

    @Override
    Goal.Pass make(Entries in) {
      OptionalInt number = DroneCodec.unboxed(in.find(drone));
      return new Goal.Pass(number, in.get(gate), in.get(direction));
    }
  }

  private static final class LandCodec extends OneCodec<Goal.Land> {

    private final Field<Goal.Land, Vec3> at =
        key("at", "The place: [x, y] in cm.")
            .need(Scalars.FLOOR_POINT, land -> land.spot().place());
    private final Field<Goal.Land, Double> radius = radius(Goal.Land::spot);
    private final Field<Goal.Land, Integer> drone = drone();

    LandCodec() {
      super("land", Phrase.of("a place to land"), "To land at a place.");
    }

    @Override
    Goal.Land make(Entries in) {
      OptionalInt number = DroneCodec.unboxed(in.find(drone));
      return new Goal.Land(number, new Spot(in.get(at), in.get(radius)));
    }
  }

  private static final class LandOnCodec extends OneCodec<Goal.LandOn> {

    private final Field<Goal.LandOn, Integer> pad =
        key("pad", "Its number.").need(RoomCodecs.PAD_ID, Goal.LandOn::pad);
    private final Field<Goal.LandOn, Integer> drone = drone();

    LandOnCodec() {
      super(
          "land-on",
          Phrase.of("a pad to land on"),
          "To land on a mission pad that lies on the floor.");
    }

    @Override
    Goal.LandOn make(Entries in) {
      return new Goal.LandOn(DroneCodec.unboxed(in.find(drone)), in.get(pad));
    }
  }
}
