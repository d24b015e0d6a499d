package tellosimulator.sim;

import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behaviour;
import tellosimulator.profile.Profile;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * What a simulation starts from. Immutable.
 *
 * @param product which drone, after which account
 * @param room in which they fly
 * @param decor what the room looks like
 * @param starts where the drones stand, in the order of their numbers
 * @param timeFactor how fast simulated time passes
 * @param seed of everything random
 * @param outlets ports on the operator's host: for each drone, or once for all
 */
public record SimConfig(
    Product product,
    Room room,
    Decor decor,
    List<Pose> starts,
    TimeFactor timeFactor,
    long seed,
    List<Outlets> outlets) {

  /** Which drone is simulated, after which account of it. */
  public record Product(Profile profile, Behaviour behaviour) {}

  /** Where on an operator's host state lines and video go. */
  public record Outlets(int statePort, int videoPort) {

    /** Documented: SDK 1.3 User Guide. */
    public static final Outlets DEFAULT = new Outlets(8890, 11111);
  }

  /** One EDU in the middle of the default room, in real time. */
  public static final SimConfig DEFAULT =
      new SimConfig(
          new Product(Profile.EDU, Behaviour.REPORT),
          Room.DEFAULT,
          Decor.DEFAULT,
          Swarm.row(1, Vec3.ZERO, Room.DEFAULT),
          TimeFactor.REAL_TIME,
          1,
          List.of(Outlets.DEFAULT));

  public SimConfig {
    starts = List.copyOf(starts);
    outlets = List.copyOf(outlets);
    if (outlets.size() != 1 && outlets.size() != starts.size()) {
      throw new IllegalArgumentException(
          "outlets are for "
              + outlets.size()
              + " drones, but must be for "
              + starts.size()
              + ", or once for all");
    }
  }

  /** The ports on the operator's host of the drone of a number, from 1. */
  public Outlets outlets(int drone) {
    return outlets.get(outlets.size() == 1 ? 0 : drone - 1);
  }

  public SimConfig withProduct(Profile profile, Behaviour behaviour) {
    return new SimConfig(
        new Product(profile, behaviour), room, decor, starts, timeFactor, seed, outlets);
  }

  public SimConfig withRoom(Room newRoom, List<Pose> newStarts) {
    return new SimConfig(product, newRoom, decor, newStarts, timeFactor, seed, outlets);
  }

  public SimConfig withDecor(Decor newDecor) {
    return new SimConfig(product, room, newDecor, starts, timeFactor, seed, outlets);
  }

  public SimConfig withTimeFactor(TimeFactor newTimeFactor) {
    return new SimConfig(product, room, decor, starts, newTimeFactor, seed, outlets);
  }

  public SimConfig withSeed(long newSeed) {
    return new SimConfig(product, room, decor, starts, timeFactor, newSeed, outlets);
  }

  public SimConfig withOutlets(Outlets newOutlets) {
    return new SimConfig(product, room, decor, starts, timeFactor, seed, List.of(newOutlets));
  }
}
