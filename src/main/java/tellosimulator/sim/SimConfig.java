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
 * The initial configuration of a simulation. Immutable.
 *
 * @param arena the arena in which the drones fly
 * @param drones in the order of their numbers
 * @param timeFactor the speed of simulated time
 * @param seed the seed of all randomness
 * @param rules the rules for all drones
 */
public record SimConfig(
    Arena arena, List<DroneSetup> drones, TimeFactor timeFactor, long seed, Rules rules) {

  /** A simulated product, with the reference model that it follows. */
  public record Product(Profile profile, Behavior behavior) {

    /** An EDU that behaves as described in the FHNW report. */
    public static final Product DEFAULT = new Product(Profile.EDU, Behavior.REPORT);
  }

  /** The ports of state lines and video on an operator's host. */
  public record StreamPorts(int statePort, int videoPort) {

    /** The ports of a real drone. Documented: SDK 1.3 User Guide. */
    public static final StreamPorts DEFAULT = new StreamPorts(8890, 11111);
  }

  /**
   * The rules for all drones of a simulation.
   *
   * @param crashSpeed the speed above which a contact is a crash [m/s]
   * @param operators determines who may operate a drone
   * @param faults the faults and the link quality
   */
  public record Rules(double crashSpeed, OperatorRule operators, FaultPlan faults) {

    /**
     * The highest crash speed that can be set [m/s]. Decided: no drone reaches this speed, so at
     * this setting no contact is a crash.
     */
    public static final double FASTEST_TOUCH = 20;

    public Rules {
      if (!(crashSpeed >= 0)) {
        throw new IllegalArgumentException(
            "crashSpeed is " + crashSpeed + " m/s, but must not be negative");
      }
    }

    /**
     * The default rules: drones crash as real ones do, the first sender operates a drone, and there
     * are no faults.
     */
    public static final Rules DEFAULT =
        new Rules(DroneSpec.CRASH_SPEED, OperatorRule.FIRST, FaultPlan.NONE);

    /** Returns a copy with other faults. */
    public Rules withFaults(FaultPlan newFaults) {
      return new Rules(crashSpeed, operators, newFaults);
    }

    /** Returns a copy with another crash speed. */
    public Rules withCrashSpeed(double newCrashSpeed) {
      return new Rules(newCrashSpeed, operators, faults);
    }
  }

  /** The default configuration: one EDU in the middle of the default room, in real time. */
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

  /** Returns the setups of fully charged drones of the default product with the default ports. */
  public static List<DroneSetup> alike(List<Pose> starts) {
    List<DroneSetup> alike = new ArrayList<>();
    for (Pose start : starts) {
      alike.add(DroneSetup.at(start, Product.DEFAULT, StreamPorts.DEFAULT));
    }
    return List.copyOf(alike);
  }

  /** Returns the starts of the drones, in the order of their numbers. */
  public List<Pose> starts() {
    return drones.stream().map(DroneSetup::start).toList();
  }

  /** Returns a copy in which all drones have another product. */
  public SimConfig withProduct(Profile profile, Behavior behavior) {
    Product product = new Product(profile, behavior);
    return withEach(drone -> drone.withProduct(product));
  }

  /** Returns a copy in which all drones send to other ports on the operator's host. */
  public SimConfig withStreamPorts(StreamPorts streamPorts) {
    return withEach(drone -> drone.withStreamPorts(streamPorts));
  }

  public SimConfig withDrones(List<DroneSetup> newDrones) {
    return new SimConfig(arena, newDrones, timeFactor, seed, rules);
  }

  /** Returns a copy with another room, and with drones like the first one at other starts. */
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

  /** Returns a copy with another fault plan. */
  public SimConfig withFaults(FaultPlan newFaults) {
    return withRules(rules.withFaults(newFaults));
  }

  /** Returns a copy with other faults and the same link quality. */
  public SimConfig withFaults(List<Fault> newFaults) {
    return withFaults(rules.faults().withFaults(newFaults));
  }

  /**
   * Returns a copy with another link quality, which overrides the default of the drones' behaviour.
   */
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
