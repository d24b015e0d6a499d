package tellosimulator.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import tellosimulator.command.OperatorRule;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultPlan;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * The initial configuration of a simulation. Immutable; for any thread.
 *
 * @param arena in which they fly
 * @param drones in the order of their numbers
 * @param timeFactor how fast simulated time passes
 * @param seed of everything random
 * @param rules what holds for all drones
 */
public record SimConfig(
    Arena arena, List<DroneSetup> drones, TimeFactor timeFactor, long seed, Rules rules) {

  /** Which drone is simulated, after which account of it. */
  public record Product(Profile profile, Behavior behavior) {

    /** An EDU, after the report. */
    public static final Product DEFAULT = new Product(Profile.EDU, Behavior.REPORT);
  }

  /** Where on an operator's host state lines and video go. */
  public record StreamPorts(int statePort, int videoPort) {

    /** Documented: SDK 1.3 User Guide. */
    public static final StreamPorts DEFAULT = new StreamPorts(8890, 11111);
  }

  /**
   * What holds for all drones of a simulation.
   *
   * @param crashSpeed above which a touch is a crash [m/s]
   * @param operators who may operate them
   * @param faults what goes wrong
   */
  public record Rules(double crashSpeed, OperatorRule operators, FaultPlan faults) {

    /**
     * The highest crash speed that can be chosen [m/s]. Decided: no drone gets there, so that no
     * touch is a crash.
     */
    public static final double FASTEST_TOUCH = 20;

    public Rules {
      if (!(crashSpeed >= 0)) {
        throw new IllegalArgumentException(
            "crashSpeed is " + crashSpeed + " m/s, but must not be negative");
      }
    }

    /** As real drones crash, operated by who comes first, without faults. */
    public static final Rules DEFAULT =
        new Rules(DroneSpec.CRASH_SPEED, OperatorRule.FIRST, FaultPlan.NONE);

    /** The same with something else that goes wrong. */
    public Rules withFaults(FaultPlan newFaults) {
      return new Rules(crashSpeed, operators, newFaults);
    }

    /** The same with another crash speed. */
    public Rules withCrashSpeed(double newCrashSpeed) {
      return new Rules(newCrashSpeed, operators, faults);
    }
  }

  /** One EDU in the middle of the default room, in real time. */
  public static final SimConfig DEFAULT =
      new SimConfig(
          Arena.DEFAULT,
          alike(Formation.row(1, Vec3.ZERO, Room.DEFAULT)),
          TimeFactor.REAL_TIME,
          1,
          Rules.DEFAULT);

  public SimConfig {
    drones = List.copyOf(drones);
    if (drones.isEmpty()) {
      throw new IllegalArgumentException("there must be at least one drone");
    }
  }

  /** Drones of the default product, full, with the default ports. */
  public static List<DroneSetup> alike(List<Pose> starts) {
    List<DroneSetup> alike = new ArrayList<>();
    for (Pose start : starts) {
      alike.add(DroneSetup.at(start, Product.DEFAULT, StreamPorts.DEFAULT));
    }
    return List.copyOf(alike);
  }

  /** Where the drones stand, in the order of their numbers. */
  public List<Pose> starts() {
    return drones.stream().map(DroneSetup::start).toList();
  }

  /** The same with all drones of another product. */
  public SimConfig withProduct(Profile profile, Behavior behavior) {
    Product product = new Product(profile, behavior);
    return withEach(drone -> drone.withProduct(product));
  }

  /** The same with all drones sending elsewhere. */
  public SimConfig withStreamPorts(StreamPorts streamPorts) {
    return withEach(drone -> drone.withStreamPorts(streamPorts));
  }

  public SimConfig withDrones(List<DroneSetup> newDrones) {
    return new SimConfig(arena, newDrones, timeFactor, seed, rules);
  }

  /** Another room, with drones that are as the first one but for their starts. */
  public SimConfig withRoom(Room room, List<Pose> starts) {
    DroneSetup first = drones.get(0);
    return withArena(arena.withRoom(room))
        .withDrones(starts.stream().map(first::withStart).toList());
  }

  public SimConfig withDecor(Decor decor) {
    return withArena(arena.withDecor(decor));
  }

  public SimConfig withArena(Arena newArena) {
    return new SimConfig(newArena, drones, timeFactor, seed, rules);
  }

  public SimConfig withTimeFactor(TimeFactor newTimeFactor) {
    return new SimConfig(arena, drones, newTimeFactor, seed, rules);
  }

  public SimConfig withSeed(long newSeed) {
    return new SimConfig(arena, drones, timeFactor, newSeed, rules);
  }

  public SimConfig withCrashSpeed(double newCrashSpeed) {
    return withRules(rules.withCrashSpeed(newCrashSpeed));
  }

  public SimConfig withOperators(OperatorRule newOperators) {
    return withRules(new Rules(rules.crashSpeed(), newOperators, rules.faults()));
  }

  /** The same with something else that goes wrong. */
  public SimConfig withFaults(FaultPlan newFaults) {
    return withRules(rules.withFaults(newFaults));
  }

  /** The same with faults and the link as it was. */
  public SimConfig withFaults(List<Fault> newFaults) {
    return withFaults(rules.faults().withFaults(newFaults));
  }

  /** The same with another link, whatever the behaviour of a drone is. */
  public SimConfig withLink(LinkPreset newLink) {
    return withFaults(rules.faults().withLink(newLink));
  }

  private SimConfig withRules(Rules newRules) {
    return new SimConfig(arena, drones, timeFactor, seed, newRules);
  }

  private SimConfig withEach(UnaryOperator<DroneSetup> change) {
    return withDrones(drones.stream().map(change).toList());
  }
}
