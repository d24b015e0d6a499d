package tellosimulator.scenario;

import java.net.InetAddress;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behaviour;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Scenario.Station;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig.Outlets;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.words.Phrase;

/** A drone: what it is, where it starts, and where it takes commands. */
final class DroneCodec extends RecordCodec<DroneCodec.Entry> {

  /** A drone and its place in the network. */
  record Entry(DroneSetup setup, Station station) {}

  private final Field<Entry, Vec3> start =
      key("start", "Where it starts: [x, y] in cm.")
          .need(Scalars.FLOOR_POINT, drone -> drone.setup().start().position());
  private final Field<Entry, Double> heading =
      key("heading", "Where its nose points, in degrees counter-clockwise; 0 is along x.")
          .usual(NumberCodec.ANGLE.or(0.0), drone -> drone.setup().start().attitude().heading());
  private final Field<Entry, Profile> profile =
      key("profile", "Tello EDU, white Tello or RoboMaster TT.")
          .usual(
              Scalars.words(Profile.values()).or(Product.DEFAULT.profile()),
              drone -> drone.setup().product().profile());
  private final Field<Entry, Behaviour> behaviour =
      key("behaviour", "Exact, or with the noise and delays of real drones.")
          .usual(
              Scalars.words(Behaviour.values()).or(Product.DEFAULT.behaviour()),
              drone -> drone.setup().product().behaviour());
  private final Field<Entry, Integer> colour =
      key("colour", "").optional(Scalars.COLOUR, drone -> boxed(drone.setup().rgb()));
  private final Field<Entry, Double> battery =
      key("battery", "Its charge in percent.")
          .usual(
              NumberCodec.of(Phrase.of("a percentage from 0 to 100"), 0, 100).or(100.0),
              drone -> drone.setup().batteryPercent());
  private final Field<Entry, InetAddress> address =
      key(
              "address",
              "Address of this machine at which it takes commands; without it, all of them for"
                  + " drone 1, 127.0.0.2 for drone 2, and so on.")
          .optional(Scalars.ADDRESS, drone -> drone.station().address());
  private final Field<Entry, Integer> commandPort =
      key("command-port", "Where it takes commands; without it, that of --command-port.")
          .optional(Scalars.PORT, drone -> boxed(drone.station().port()));
  private final Field<Entry, Integer> statePort =
      key("state-port", "Where its state goes.")
          .usual(
              Scalars.PORT.or(Outlets.DEFAULT.statePort()),
              drone -> drone.setup().outlets().statePort());
  private final Field<Entry, Integer> videoPort =
      key("video-port", "Where its video goes.")
          .usual(
              Scalars.PORT.or(Outlets.DEFAULT.videoPort()),
              drone -> drone.setup().outlets().videoPort());

  DroneCodec() {
    super("drone", Phrase.of("a drone"), "A drone; the first one has the number 1.");
  }

  @Override
  Entry make(Entries in) {
    DroneSetup setup =
        new DroneSetup(
            new Pose(in.get(start), Attitude.ofHeading(in.get(heading))),
            new Product(in.get(profile), in.get(behaviour)),
            new Outlets(in.get(statePort), in.get(videoPort)),
            in.get(battery),
            unboxed(in.find(colour)));
    return new Entry(setup, new Station(in.find(address), unboxed(in.find(commandPort))));
  }

  static Optional<Integer> boxed(OptionalInt value) {
    return value.isPresent() ? Optional.of(value.getAsInt()) : Optional.empty();
  }

  static OptionalInt unboxed(Optional<Integer> value) {
    return value.isPresent() ? OptionalInt.of(value.get()) : OptionalInt.empty();
  }
}
