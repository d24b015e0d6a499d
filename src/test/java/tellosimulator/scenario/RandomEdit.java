package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Scenario.CommandAddress;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Wind;

/**
 * A single edit of a scenario by a user.
 *
 * @param what description for failure messages
 * @param changed the scenario afterwards
 * @param linesGone maximum number of lines that may be changed or removed
 * @param linesNew maximum number of lines that may be added
 */
record RandomEdit(String what, Scenario changed, int linesGone, int linesNew) {

  /** Lines of a block that describes an item. */
  private static final int ITEM = 12;

  static RandomEdit of(Scenario scenario, SplittableRandom random) {
    Maker maker = new Maker(scenario, random);
    List<Supplier<RandomEdit>> kinds =
        List.of(
            maker::moveObstacle,
            maker::moveObstacle,
            maker::turnObstacle,
            maker::resizeObstacle,
            maker::addObstacle,
            maker::removeObstacle,
            maker::movePad,
            maker::addPad,
            maker::removePad,
            maker::moveDrone,
            maker::addDrone,
            maker::removeDrone,
            maker::resizeRoom,
            maker::blow);
    return kinds.get(random.nextInt(kinds.size())).get();
  }

  private record Maker(Scenario scenario, SplittableRandom random) {

    private Arena arena() {
      return scenario.config().arena();
    }

    private RandomEdit edit(String what, Arena arena, int gone, int fresh) {
      SimConfig config = scenario.config().withArena(arena);
      return new RandomEdit(what, scenario.withConfig(config), gone, fresh);
    }

    private RandomEdit none() {
      return new RandomEdit("nothing", scenario, 0, 0);
    }

    private RandomEdit moveObstacle() {
      if (arena().obstacles().isEmpty()) {
        return none();
      }
      int index = random.nextInt(arena().obstacles().size());
      Obstacle each = arena().obstacles().get(index);
      Obstacle moved = each.movedTo(each.foot().plus(step()), each.heading());
      return edit("move " + each.name(), with(index, moved), ITEM, 1);
    }

    private RandomEdit turnObstacle() {
      if (arena().obstacles().isEmpty()) {
        return none();
      }
      int index = random.nextInt(arena().obstacles().size());
      Obstacle each = arena().obstacles().get(index);
      double heading = Math.toRadians(random.nextInt(-35, 37) * 5);
      return edit("turn " + each.name(), with(index, each.movedTo(each.foot(), heading)), ITEM, 1);
    }

    private RandomEdit resizeObstacle() {
      if (arena().obstacles().isEmpty()) {
        return none();
      }
      int index = random.nextInt(arena().obstacles().size());
      Obstacle each = arena().obstacles().get(index);
      Obstacle other =
          new Obstacle(
              each.name(), larger(each.shape()), each.foot(), each.heading(), each.appearance());
      return edit("resize " + each.name(), with(index, other), ITEM, 1);
    }

    private static Shape larger(Shape shape) {
      if (shape instanceof Shape.Box box) {
        return new Shape.Box(box.depth(), box.width() + 0.1, box.height() + 0.05);
      } else if (shape instanceof Shape.Cylinder cylinder) {
        return new Shape.Cylinder(cylinder.radius() + 0.01, cylinder.height());
      } else if (shape instanceof Shape.Ring ring) {
        return new Shape.Ring(ring.radius() + 0.1, ring.tube(), ring.middle() + 0.2);
      }
      Shape.Frame frame = (Shape.Frame) shape;
      return new Shape.Frame(frame.width() + 0.1, frame.opening(), frame.beam(), frame.middle());
    }

    private RandomEdit addObstacle() {
      Set<String> names = new HashSet<>();
      arena().obstacles().forEach(each -> names.add(each.name()));
      int number = 1;
      while (names.contains("thing-" + number)) {
        number++;
      }
      List<Shape> shapes =
          List.of(
              new Shape.Box(0.5, 0.6, 0.7),
              new Shape.Cylinder(0.1, 2),
              new Shape.Ring(0.4, 0.05, 1.2),
              new Shape.Frame(1, 0.8, 0.05, 1.5));
      ObstacleAppearance appearance =
          random.nextBoolean()
              ? ObstacleAppearance.DEFAULT
              : new ObstacleAppearance(
                  0x123456, ObstacleAppearance.Pattern.CHECKS, java.util.Map.of());
      List<Obstacle> more = new ArrayList<>(arena().obstacles());
      more.add(
          new Obstacle(
              "thing-" + number,
              shapes.get(random.nextInt(shapes.size())),
              step(),
              Math.toRadians(random.nextInt(2) * 45),
              appearance));
      return edit("add thing-" + number, arena().withObstacles(more), 1, ITEM);
    }

    private RandomEdit removeObstacle() {
      if (arena().obstacles().isEmpty()) {
        return none();
      }
      List<Obstacle> fewer = new ArrayList<>(arena().obstacles());
      Obstacle gone = fewer.remove(random.nextInt(fewer.size()));
      // the next gate may get the name to which a goal refers
      return edit("remove " + gone.name(), arena().withObstacles(fewer), ITEM + 6, 3);
    }

    private Arena with(int index, Obstacle obstacle) {
      List<Obstacle> changed = new ArrayList<>(arena().obstacles());
      changed.set(index, obstacle);
      return arena().withObstacles(changed);
    }

    private RandomEdit movePad() {
      if (arena().pads().isEmpty()) {
        return none();
      }
      List<MissionPad> pads = new ArrayList<>(arena().pads());
      int index = random.nextInt(pads.size());
      MissionPad pad = pads.get(index);
      pads.set(
          index,
          new MissionPad(
              pad.id(), pad.surface(), pad.along() + 0.05, pad.height() + 0.1, pad.rotation()));
      return edit("move pad " + pad.id(), arena().withPads(pads), 2, 2);
    }

    private RandomEdit addPad() {
      List<MissionPad> pads = new ArrayList<>(arena().pads());
      Set<Integer> ids = new HashSet<>();
      pads.forEach(pad -> ids.add(pad.id()));
      int id = 1;
      while (ids.contains(id)) {
        id++;
      }
      if (id > MissionPad.LAST_ID) {
        return none();
      }
      pads.add(MissionPad.onFloor(id, step(), Math.toRadians(random.nextInt(2) * 30)));
      return edit("add pad " + id, arena().withPads(pads), 1, 6);
    }

    private RandomEdit removePad() {
      if (arena().pads().isEmpty()) {
        return none();
      }
      List<MissionPad> pads = new ArrayList<>(arena().pads());
      MissionPad gone = pads.remove(random.nextInt(pads.size()));
      return edit("remove pad " + gone.id(), arena().withPads(pads), ITEM, 1);
    }

    private RandomEdit moveDrone() {
      List<DroneSetup> drones = new ArrayList<>(scenario.config().drones());
      int index = random.nextInt(drones.size());
      DroneSetup drone = drones.get(index);
      Pose start = drone.start();
      drones.set(index, drone.withStart(new Pose(start.position().plus(step()), start.attitude())));
      return drones("move drone " + (index + 1), drones, scenario.stations(), 4);
    }

    private RandomEdit addDrone() {
      List<DroneSetup> drones = new ArrayList<>(scenario.config().drones());
      List<CommandAddress> stations = new ArrayList<>(scenario.stations());
      Pose start = new Pose(step(), tellosimulator.math.Attitude.LEVEL);
      drones.add(DroneSetup.at(start, Product.DEFAULT, new StreamPorts(9000, 11111)));
      stations.add(CommandAddress.USUAL);
      return drones("add a drone", drones, stations, ITEM);
    }

    private RandomEdit removeDrone() {
      List<DroneSetup> drones = new ArrayList<>(scenario.config().drones());
      boolean named =
          scenario.challenge().goals().stream().anyMatch(goal -> goal.drone().isPresent());
      if (drones.size() == 1 || named) {
        return none();
      }
      List<CommandAddress> stations = new ArrayList<>(scenario.stations());
      int index = random.nextInt(drones.size());
      drones.remove(index);
      stations.remove(index);
      return drones("remove drone " + (index + 1), drones, stations, ITEM);
    }

    private RandomEdit drones(
        String what, List<DroneSetup> drones, List<CommandAddress> stations, int lines) {
      SimConfig config = scenario.config().withDrones(drones);
      Scenario changed =
          new Scenario(scenario.description(), config, stations, scenario.challenge());
      return new RandomEdit(what, changed, lines, lines);
    }

    private RandomEdit resizeRoom() {
      Room room = arena().room();
      Room other =
          new Room(room.width() + random.nextInt(2) * 0.1, room.depth() + 0.25, room.height());
      return edit("resize the room", arena().withRoom(other), 5, 3);
    }

    private RandomEdit blow() {
      double heading = Math.toRadians(random.nextInt(-17, 18) * 10);
      double speed = random.nextInt(4) * 0.5;
      Vec3 mean = new Vec3(StrictMath.cos(heading) * speed, StrictMath.sin(heading) * speed, 0);
      return edit("blow", arena().withWind(new Wind(mean, random.nextInt(3) * 0.1)), 3, 5);
    }

    /** Returns a coordinate on a grid of 5 cm. */
    private Vec3 step() {
      int[] cm = IntStream.range(0, 2).map(i -> random.nextInt(-20, 21) * 5).toArray();
      return new Vec3(cm[0] / 100.0, cm[1] / 100.0, 0);
    }
  }
}
