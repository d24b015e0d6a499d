package tellosimulator.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.profile.Behaviour;
import tellosimulator.profile.Profile;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * What a simulation starts from. Immutable.
 *
 * @param arena in which they fly
 * @param drones in the order of their numbers
 * @param timeFactor how fast simulated time passes
 * @param seed of everything random
 * @param crashSpeed above which a touch is a crash [m/s]
 */
public record SimConfig(
    Arena arena, List<DroneSetup> drones, TimeFactor timeFactor, long seed, double crashSpeed) {

  /** Which drone is simulated, after which account of it. */
  public record Product(Profile profile, Behaviour behaviour) {

    /** An EDU, after the report. */
    public static final Product DEFAULT = new Product(Profile.EDU, Behaviour.REPORT);
  }

  /** Where on an operator's host state lines and video go. */
  public record Outlets(int statePort, int videoPort) {

    /** Documented: SDK 1.3 User Guide. */
    public static final Outlets DEFAULT = new Outlets(8890, 11111);
  }

  /** One EDU in the middle of the default room, in real time. */
  public static final SimConfig DEFAULT =
      new SimConfig(
          Arena.DEFAULT,
          alike(Swarm.row(1, Vec3.ZERO, Room.DEFAULT)),
          TimeFactor.REAL_TIME,
          1,
          DroneSpec.CRASH_SPEED);

  public SimConfig {
    drones = List.copyOf(drones);
    if (drones.isEmpty()) {
      throw new IllegalArgumentException("there must be at least one drone");
    }
    if (!(crashSpeed >= 0)) {
      throw new IllegalArgumentException(
          "crashSpeed is " + crashSpeed + " m/s, but must not be negative");
    }
  }

  /** Drones of the default product, full, with the default ports. */
  public static List<DroneSetup> alike(List<Pose> starts) {
    List<DroneSetup> alike = new ArrayList<>();
    for (Pose start : starts) {
      alike.add(DroneSetup.at(start, Product.DEFAULT, Outlets.DEFAULT));
    }
    return List.copyOf(alike);
  }

  /** Where the drones stand, in the order of their numbers. */
  public List<Pose> starts() {
    return drones.stream().map(DroneSetup::start).toList();
  }

  /** The same with all drones of another product. */
  public SimConfig withProduct(Profile profile, Behaviour behaviour) {
    Product product = new Product(profile, behaviour);
    return withEach(drone -> drone.withProduct(product));
  }

  /** The same with all drones sending elsewhere. */
  public SimConfig withOutlets(Outlets outlets) {
    return withEach(drone -> drone.withOutlets(outlets));
  }

  public SimConfig withDrones(List<DroneSetup> newDrones) {
    return new SimConfig(arena, newDrones, timeFactor, seed, crashSpeed);
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
    return new SimConfig(newArena, drones, timeFactor, seed, crashSpeed);
  }

  public SimConfig withTimeFactor(TimeFactor newTimeFactor) {
    return new SimConfig(arena, drones, newTimeFactor, seed, crashSpeed);
  }

  public SimConfig withSeed(long newSeed) {
    return new SimConfig(arena, drones, timeFactor, newSeed, crashSpeed);
  }

  public SimConfig withCrashSpeed(double newCrashSpeed) {
    return new SimConfig(arena, drones, timeFactor, seed, newCrashSpeed);
  }

  private SimConfig withEach(UnaryOperator<DroneSetup> change) {
    return withDrones(drones.stream().map(change).toList());
  }
}
