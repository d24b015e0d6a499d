package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.GoalRegion;
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
        .or("reach", reach(), goal -> only(Goal.Reach.class, goal))
        .or("hover", hover(), goal -> only(Goal.Hover.class, goal))
        .or("pass", pass(), goal -> only(Goal.Pass.class, goal))
        .or("land", land(), goal -> only(Goal.Land.class, goal))
        .or("land-on", landOn(), goal -> only(Goal.LandOn.class, goal));
  }

  private static <G extends Goal> Optional<G> only(Class<G> type, Goal goal) {
    return type.isInstance(goal) ? Optional.of(type.cast(goal)) : Optional.empty();
  }

  private static Codec<Goal.Reach> reach() {
    KindCodec<Goal.Reach> reach =
        new KindCodec<>("reach", Phrase.of("a place to reach"), "To be at a place.");
    Function<Entries, GoalRegion> region = reach.region(Goal.Reach::region);
    return reach.madeFor((in, drone) -> new Goal.Reach(drone, region.apply(in)));
  }

  private static Codec<Goal.Hover> hover() {
    KindCodec<Goal.Hover> hover =
        new KindCodec<>("hover", Phrase.of("a place to hover"), "To stay at a place.");
    Function<Entries, GoalRegion> region = hover.region(Goal.Hover::region);
    Field<Goal.Hover, Double> seconds =
        hover
            .key("seconds", "How long without a break.")
            .need(
                NumberCodec.seconds(Goal.SHORTEST_HOVER, Goal.LONGEST_HOVER), Goal.Hover::seconds);
    return hover.madeFor((in, drone) -> new Goal.Hover(drone, region.apply(in), in.get(seconds)));
  }

  private static Codec<Goal.Pass> pass() {
    KindCodec<Goal.Pass> pass =
        new KindCodec<>(
            "pass", Phrase.of("a gate to pass"), "To fly through the opening of a gate.");
    Field<Goal.Pass, String> gate =
        pass.key("gate", "The gate's name.").need(Scalars.LINE, Goal.Pass::gate);
    Field<Goal.Pass, Direction> direction =
        pass.key("direction", "Along the gate's heading, against it, or either way.")
            .usual(WordCodec.of(Direction.values()).or(Direction.EITHER), Goal.Pass::direction);
    return pass.madeFor((in, drone) -> new Goal.Pass(drone, in.get(gate), in.get(direction)));
  }

  private static Codec<Goal.Land> land() {
    KindCodec<Goal.Land> land =
        new KindCodec<>("land", Phrase.of("a place to land"), "To land at a place.");
    Function<Entries, GoalRegion> region =
        land.region("The place: [x, y] in cm.", Scalars.FLOOR_POINT, Goal.Land::region);
    return land.madeFor((in, drone) -> new Goal.Land(drone, region.apply(in)));
  }

  private static Codec<Goal.LandOn> landOn() {
    KindCodec<Goal.LandOn> landOn =
        new KindCodec<>(
            "land-on",
            Phrase.of("a pad to land on"),
            "To land on a mission pad that lies on the floor.");
    Field<Goal.LandOn, Integer> pad =
        landOn.key("pad", "Its number.").need(RoomCodecs.PAD_ID, Goal.LandOn::pad);
    return landOn.madeFor((in, drone) -> new Goal.LandOn(drone, in.get(pad)));
  }

  /** A kind of goal, with the keys that several of them have. */
  private static final class KindCodec<G extends Goal> extends RecordCodec<G> {

    KindCodec(String name, Phrase phrase, String description) {
      super(name, phrase, description);
    }

    Function<Entries, GoalRegion> region(Function<G, GoalRegion> getter) {
      String description = "The place: [x, y, z] in cm, z from the floor to the drone's feet.";
      return region(description, Scalars.POINT, getter);
    }

    /** Declares a place and its radius. */
    Function<Entries, GoalRegion> region(
        String description, Codec<Vec3> place, Function<G, GoalRegion> getter) {
      Field<G, Vec3> at = key("at", description).need(place, getter.andThen(GoalRegion::place));
      Field<G, Double> radius =
          key("radius", "How near is near enough, in cm.")
              .usual(
                  NumberCodec.length(GoalRegion.SMALLEST * 100, Scalars.LONGEST_CM)
                      .orWritten(RADIUS),
                  getter.andThen(GoalRegion::radius));
      return in -> new GoalRegion(in.get(at), in.get(radius));
    }

    /** Declares, as the last key, which drone shall do it. */
    Codec<G> madeFor(BiFunction<Entries, OptionalInt, G> maker) {
      Field<G, Integer> drone =
          key("drone", "The number of the drone that shall do it; without it, any.")
              .optionalInt(new DroneNumber(), Goal::drone);
      return made(in -> maker.apply(in, in.findInt(drone)));
    }
  }

  /** The number of one of as many drones as the file has. */
  private record DroneNumber() implements Codec<Integer> {

    private static final Codec<Integer> OF_ANY = upTo(AddressPlan.MOST_DRONES);

    @Override
    public Optional<Integer> read(Node node, Context context) {
      return upTo(context.drones()).read(node, context);
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
      return OF_ANY.write(number, folder);
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return OF_ANY.schema(definitions);
    }
  }
}
