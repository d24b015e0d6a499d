package tellosimulator.view.plan;

import static tellosimulator.scenario.Quantity.ANGLE;
import static tellosimulator.scenario.Quantity.GOAL_RADIUS;
import static tellosimulator.scenario.Quantity.HEIGHT;
import static tellosimulator.scenario.Quantity.HOVER_TIME;
import static tellosimulator.scenario.Quantity.OFFSET;
import static tellosimulator.scenario.Quantity.POINTS;
import static tellosimulator.scenario.Quantity.SIGHT;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import javafx.scene.paint.Color;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Terms;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.scenario.Quantity;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.view.controls.NumberRange;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.view.plan.ItemProperty.Choice;
import tellosimulator.view.plan.ItemProperty.Measure;
import tellosimulator.view.plan.ItemProperty.Name;
import tellosimulator.view.plan.ItemProperty.Paint;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;

/**
 * Lists the properties of an item, in the order of the property panel.
 *
 * @param <T> the type that describes the item
 */
final class ItemProperties<T> {

  /** The drone number that stands for any drone. */
  static final int ANY_DRONE = 0;

  private static final double PRECISION = 10;

  private final FloorPlan plan;
  private final PlanItem item;
  private final Function<T, FloorPlan> replacing;
  private final List<ItemProperty<?>> all = new ArrayList<>();

  /**
   * @param replacing returns the plan in which the item is replaced
   */
  private ItemProperties(FloorPlan plan, PlanItem item, Function<T, FloorPlan> replacing) {
    this.plan = plan;
    this.item = item;
    this.replacing = replacing;
  }

  /**
   * Returns the properties of an item.
   *
   * @param colors returns the colour of a drone, given its number
   */
  static List<ItemProperty<?>> of(FloorPlan plan, PlanItem item, IntFunction<Color> colors) {
    return item.match(
        start -> of(plan, start, colors.apply(start.drone())),
        pad -> of(plan, pad),
        obstacle -> of(plan, obstacle),
        goal -> of(plan, goal));
  }

  private static List<ItemProperty<?>> of(FloorPlan plan, Start start, Color color) {
    PlannedDrone drone = plan.drone(start);
    ItemProperties<PlannedDrone> properties =
        new ItemProperties<>(plan, start, other -> plan.with(start, other));
    properties.addNumber(
        start.drone(),
        upTo(plan.drones().size()),
        number -> new PlanChange(plan.renumbered(start, number), new Start(number)));
    properties.addPlace();
    properties.addHeading();
    properties.addPaint(color, rgb -> new PlannedDrone(drone.origin().painted(rgb), drone.start()));
    return properties.all;
  }

  private static List<ItemProperty<?>> of(FloorPlan plan, Pad item) {
    MissionPad pad = plan.pad(item);
    ItemProperties<MissionPad> properties =
        new ItemProperties<>(plan, item, other -> plan.with(item, other));
    List<Integer> ids = new ArrayList<>(plan.freePadIds());
    ids.add(pad.id());
    ids.sort(null);
    properties.addNumber(
        pad.id(),
        ids,
        id ->
            new PlanChange(
                plan.with(
                    item,
                    new MissionPad(id, pad.surface(), pad.along(), pad.height(), pad.rotation())),
                new Pad(id)));
    if (pad.surface().wall()) {
      properties.add("along", OFFSET, pad.along(), to -> pad.movedTo(to, pad.height()));
      properties.add("middle-of-pad", HEIGHT, pad.height(), to -> pad.movedTo(pad.along(), to));
    } else {
      properties.addPlace();
      properties.addHeading();
    }
    return properties.all;
  }

  private static List<ItemProperty<?>> of(FloorPlan plan, ObstacleItem item) {
    Obstacle now = plan.obstacle(item);
    ObstacleAppearance looks = now.appearance();
    Vec3 foot = now.foot();
    ItemProperties<Obstacle> properties =
        new ItemProperties<>(plan, item, other -> plan.with(item, other));
    properties.all.add(new Name("name", now.name(), name -> properties.changed(now.named(name))));
    properties.addPlace();
    properties.add("elevation", HEIGHT, foot.z(), z -> now.movedTo(foot.withZ(z), now.heading()));
    properties.addHeading();
    for (ShapeLengths.Length length : ShapeLengths.of(now.shape()).lengths()) {
      properties.add(
          length.key(),
          length.quantity(),
          length.meters(),
          to -> new Obstacle(now.name(), length.with().apply(to), foot, now.heading(), looks));
    }
    properties.addPaint(
        FxTextures.color(Rgb.of(looks.rgb())),
        rgb -> {
          ObstacleAppearance painted =
              new ObstacleAppearance(rgb, looks.pattern(), looks.pictures());
          return new Obstacle(now.name(), now.shape(), foot, now.heading(), painted);
        });
    return properties.all;
  }

  private static List<ItemProperty<?>> of(FloorPlan plan, GoalItem item) {
    Goal goal = plan.goal(item);
    ItemProperties<Goal> properties =
        new ItemProperties<>(plan, item, other -> plan.with(item, other));
    properties.addNumber(
        item.index() + 1,
        upTo(plan.goals().size()),
        number -> new PlanChange(plan.renumbered(item, number), new GoalItem(number - 1)));
    if (goal instanceof Goal.Pass pass) {
      properties.addChoice(
          "gate",
          GoalPlacement.gates(plan).stream().map(gate -> plan.obstacle(gate).name()).toList(),
          pass.gate(),
          gate -> new Goal.Pass(pass.terms(), gate, pass.direction()));
      properties.addChoice(
          "direction",
          List.of(Goal.Direction.values()),
          pass.direction(),
          way -> new Goal.Pass(pass.terms(), pass.gate(), way));
    } else if (goal instanceof Goal.LandOn land) {
      List<Integer> pads = GoalPlacement.pads(plan).stream().map(Pad::id).toList();
      properties.addChoice("pad", pads, land.pad(), id -> new Goal.LandOn(land.terms(), id));
    } else if (goal instanceof Goal.See see) {
      List<Goal.Target> targets = List.copyOf(PlacedGoal.targets(plan.arena()).keySet());
      properties.addChoice("target", targets, see.target(), see::of);
    }
    properties.addChoice(
        "drone",
        IntStream.rangeClosed(ANY_DRONE, plan.drones().size()).boxed().toList(),
        goal.drone().orElse(ANY_DRONE),
        drone -> goal.forDrone(drone == ANY_DRONE ? OptionalInt.empty() : OptionalInt.of(drone)));
    if (goal instanceof Goal.InRegion at) {
      Vec3 place = at.region().place();
      double radius = at.region().radius();
      properties.addPlace();
      if (!(goal instanceof Goal.Land)) {
        properties.add(
            "height-of-goal", HEIGHT, place.z(), z -> GoalPlacement.moved(goal, place.withZ(z)));
      }
      properties.add("radius", GOAL_RADIUS, radius, to -> at.at(new GoalRegion(place, to)));
    }
    if (goal instanceof Goal.Hover hover) {
      properties.add(
          "seconds",
          HOVER_TIME,
          hover.seconds(),
          to -> new Goal.Hover(hover.terms(), hover.region(), to));
    } else if (goal instanceof Goal.See see) {
      properties.add(
          "size",
          SIGHT,
          see.sizePercent(),
          to -> new Goal.See(see.terms(), see.target(), to, see.seconds()));
      properties.add(
          "seconds",
          HOVER_TIME,
          see.seconds(),
          to -> new Goal.See(see.terms(), see.target(), see.sizePercent(), to));
    }
    Terms terms = goal.terms();
    properties.add("points", POINTS, terms.points(), to -> goal.withTerms(terms.worth(to)));
    return properties.all;
  }

  private void addPlace() {
    Placement now = plan.placement(item);
    Vec3 place = now.place();
    addPlacement("x", OFFSET, place.x(), x -> now.at(new Vec3(x, place.y(), 0)));
    addPlacement("y", OFFSET, place.y(), y -> now.at(new Vec3(place.x(), y, 0)));
  }

  private void addHeading() {
    Placement now = plan.placement(item);
    addPlacement("heading", ANGLE, now.heading(), to -> new Placement(now.place(), to));
  }

  private void addPlacement(
      String key, Quantity quantity, double si, DoubleFunction<Placement> with) {
    all.add(measure(key, quantity, si, value -> plan.with(item, with.apply(value))));
  }

  private void add(String key, Quantity quantity, double si, DoubleFunction<T> with) {
    all.add(measure(key, quantity, si, value -> replacing.apply(with.apply(value))));
  }

  /**
   * Returns a property whose value is a number.
   *
   * @param si the current value in SI units
   * @param with returns the plan with another value in SI units
   */
  private Measure measure(
      String key, Quantity quantity, double si, DoubleFunction<FloorPlan> with) {
    int step =
        switch (quantity.unit()) {
          case CENTIMETER -> 5;
          case DEGREE -> 15;
          case SECOND, ONE -> 1;
        };
    return new Measure(
        key,
        new NumberRange(quantity, step),
        Math.round(quantity.written(si) * PRECISION) / PRECISION,
        value -> new PlanChange(with.apply(quantity.inSi(value)), item));
  }

  private void addNumber(int now, List<Integer> options, Function<Integer, PlanChange> with) {
    all.add(new Choice<>("number", options, now, with));
  }

  private static List<Integer> upTo(int most) {
    return IntStream.rangeClosed(1, most).boxed().toList();
  }

  private <V> void addChoice(String key, List<V> options, V now, Function<V, T> with) {
    all.add(new Choice<>(key, options, now, value -> changed(with.apply(value))));
  }

  private void addPaint(Color color, IntFunction<T> with) {
    all.add(new Paint("color", color, wanted -> changed(with.apply(rgb(wanted)))));
  }

  private static int rgb(Color color) {
    return (int) Math.round(255 * color.getRed()) << 16
        | (int) Math.round(255 * color.getGreen()) << 8
        | (int) Math.round(255 * color.getBlue());
  }

  private PlanChange changed(T other) {
    return new PlanChange(replacing.apply(other), item);
  }
}
