package tellosimulator.scenario;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiFunction;
import java.util.function.Function;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.words.Phrase;

/**
 * Codecs of goals. Whether the gates and mission pads named by goals exist is checked by {@link
 * ScenarioValidator}.
 */
final class GoalCodecs {

  private GoalCodecs() {}

  /** Returns the codec of a goal of any kind. */
  static Codec<Goal> goal() {
    ChoiceCodec<Goal> codec = new ChoiceCodec<>("goal", Phrase.of("a goal"), "One goal.");
    Field<Goal, ?> reach = codec.or("reach", reach());
    Field<Goal, ?> hover = codec.or("hover", hover());
    Field<Goal, ?> pass = codec.or("pass", pass());
    Field<Goal, ?> land = codec.or("land", land());
    Field<Goal, ?> landOn = codec.or("land-on", landOn());
    Field<Goal, ?> see = codec.or("see", see());
    Goal.Cases<Field<Goal, ?>> keys =
        new Goal.Cases<>(
            goal -> reach, goal -> hover, goal -> pass, goal -> land, goal -> landOn, goal -> see);
    return codec.choosing(goal -> goal.match(keys));
  }

  private static Codec<Goal.Reach> reach() {
    KindCodec<Goal.Reach> reach =
        new KindCodec<>("reach", Phrase.of("a place to reach"), "Reach a place.");
    Function<Entries, GoalRegion> region = reach.region(Goal.Reach::region);
    return reach.madeFor((in, terms) -> new Goal.Reach(terms, region.apply(in)));
  }

  private static Codec<Goal.Hover> hover() {
    KindCodec<Goal.Hover> hover =
        new KindCodec<>("hover", Phrase.of("a place to hover"), "Stay at a place.");
    Function<Entries, GoalRegion> region = hover.region(Goal.Hover::region);
    Field<Goal.Hover, Double> seconds =
        hover
            .key("seconds", "Duration without interruption.")
            .need(NumberCodec.seconds(Quantity.HOVER_TIME), Goal.Hover::seconds);
    return hover.madeFor((in, terms) -> new Goal.Hover(terms, region.apply(in), in.get(seconds)));
  }

  private static Codec<Goal.Pass> pass() {
    KindCodec<Goal.Pass> pass =
        new KindCodec<>("pass", Phrase.of("a gate to pass"), "Fly through the opening of a gate.");
    Field<Goal.Pass, String> gate =
        pass.key("gate", "Name of the gate.").need(Scalars.LINE, Goal.Pass::gate);
    Field<Goal.Pass, Direction> direction =
        pass.key("direction", "Along the gate's heading, against it, or either way.")
            .usual(WordCodec.of(Direction.values()).or(Direction.EITHER), Goal.Pass::direction);
    return pass.madeFor((in, terms) -> new Goal.Pass(terms, in.get(gate), in.get(direction)));
  }

  private static Codec<Goal.Land> land() {
    KindCodec<Goal.Land> land =
        new KindCodec<>("land", Phrase.of("a place to land"), "Land at a place.");
    Function<Entries, GoalRegion> region =
        land.region("The place: [x, y] in cm.", Scalars.FLOOR_POINT, Goal.Land::region);
    return land.madeFor((in, terms) -> new Goal.Land(terms, region.apply(in)));
  }

  private static Codec<Goal.LandOn> landOn() {
    KindCodec<Goal.LandOn> landOn =
        new KindCodec<>(
            "land-on",
            Phrase.of("a pad to land on"),
            "Land on a mission pad that lies on the floor.");
    Field<Goal.LandOn, Integer> pad =
        landOn.key("pad", "Number of the mission pad.").need(RoomCodecs.PAD_ID, Goal.LandOn::pad);
    return landOn.madeFor((in, terms) -> new Goal.LandOn(terms, in.get(pad)));
  }

  private static Codec<Goal.See> see() {
    KindCodec<Goal.See> see =
        new KindCodec<>(
            "see",
            Phrase.of("a poster or pad to see"),
            "Have a poster or a mission pad in the picture of the forward camera.");
    Field<Goal.See, String> poster =
        see.key("poster", "Name of the poster.")
            .optional(
                Scalars.LINE,
                goal ->
                    goal.target() instanceof Goal.NamedPoster named
                        ? Optional.of(named.name())
                        : Optional.empty());
    Field<Goal.See, Integer> pad =
        see.key("pad", "Number of the mission pad.")
            .optionalInt(
                RoomCodecs.PAD_ID,
                goal ->
                    goal.target() instanceof Goal.NumberedPad numbered
                        ? OptionalInt.of(numbered.pad())
                        : OptionalInt.empty());
    Field<Goal.See, Double> size =
        see.key("size", "Minimum share of the picture's width that it covers, in percent.")
            .usual(
                NumberCodec.percent(Quantity.SIGHT).or(Goal.DEFAULT_SIZE), Goal.See::sizePercent);
    Field<Goal.See, Double> seconds =
        see.key("seconds", "Duration without interruption.")
            .usual(NumberCodec.seconds(Quantity.HOVER_TIME).or(1.0), Goal.See::seconds);
    see.add(Case.with("poster").excludes("pad"));
    see.add(Case.without("poster").needs("pad"));
    return see.madeFor(
        (in, terms) -> {
          Goal.Target target =
              in.find(poster)
                  .<Goal.Target>map(Goal.NamedPoster::new)
                  .orElseGet(() -> new Goal.NumberedPad(in.get(pad)));
          return new Goal.See(terms, target, in.get(size), in.get(seconds));
        });
  }

  /** Codec of one kind of goal. Declares the keys that several kinds share. */
  private static final class KindCodec<G extends Goal> extends RecordCodec<G> {

    KindCodec(String name, Phrase phrase, String description) {
      super(name, phrase, description);
    }

    Function<Entries, GoalRegion> region(Function<G, GoalRegion> getter) {
      String description = "The place: [x, y, z] in cm, z from the floor to the drone's feet.";
      return region(description, Scalars.POINT, getter);
    }

    /**
     * Declares the keys of a place and its radius; returns the function that creates the region.
     */
    Function<Entries, GoalRegion> region(
        String description, Codec<Vec3> place, Function<G, GoalRegion> getter) {
      Field<G, Vec3> at = key("at", description).need(place, getter.andThen(GoalRegion::place));
      Field<G, Double> radius =
          key("radius", "Maximum distance from the place, in cm.")
              .usual(
                  NumberCodec.length(Quantity.GOAL_RADIUS).orWritten(GoalRegion.DEFAULT_RADIUS),
                  getter.andThen(GoalRegion::radius));
      return in -> new GoalRegion(in.get(at), in.get(radius));
    }

    /** Declares the keys of the goal's terms, and how the goal is created. Must be called last. */
    Codec<G> madeFor(BiFunction<Entries, Terms, G> maker) {
      Field<G, Integer> drone =
          key("drone", "Number of the drone that must do it. Default: any drone.")
              .optionalInt(droneNumber(), Goal::drone);
      Field<G, Double> points =
          key("points", "Points for reaching the goal.")
              .usual(NumberCodec.POINTS.or(0.0), goal -> goal.terms().points());
      return made(in -> maker.apply(in, new Terms(in.findInt(drone), in.get(points))));
    }
  }

  /** Returns the codec of a drone number. The file must contain a drone with that number. */
  private static Codec<Integer> droneNumber() {
    return droneUpTo(AddressPlan.MOST_DRONES)
        .readBy((node, context) -> droneUpTo(context.drones()).read(node, context));
  }

  private static Codec<Integer> droneUpTo(int drones) {
    Phrase expected =
        drones == 1
            ? Phrase.of("drone 1, the only one")
            : Phrase.of("a drone from 1 to %d", drones);
    return Scalars.count(expected, 1, drones);
  }
}
