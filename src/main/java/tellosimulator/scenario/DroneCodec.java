package tellosimulator.scenario;

import java.net.InetAddress;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Scenario.Station;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.words.Phrase;

/** A drone: what it is, where it starts, and where it takes commands. */
final class DroneCodec extends RecordCodec<DroneCodec.StationedDrone> {

  /** A drone and its place in the network. */
  record StationedDrone(DroneSetup setup, Station station) {}

  private final Field<StationedDrone, Vec3> start =
      key("start", "Where it starts: [x, y] in cm.")
          .need(Scalars.FLOOR_POINT, drone -> drone.setup().start().position());
  private final Field<StationedDrone, Double> heading =
      key("heading", "Where its nose points, in degrees counter-clockwise; 0 is along x.")
          .usual(NumberCodec.ANGLE.or(0.0), drone -> drone.setup().start().attitude().heading());
  private final Field<StationedDrone, Profile> profile =
      key("profile", "Tello EDU, white Tello or RoboMaster TT.")
          .usual(
              WordCodec.of(Profile.values()).or(Product.DEFAULT.profile()),
              drone -> drone.setup().product().profile());
  private final Field<StationedDrone, Behavior> behavior =
      key("behaviour", "Exact, or with the noise and delays of real drones.")
          .usual(
              WordCodec.of(Behavior.values()).or(Product.DEFAULT.behavior()),
              drone -> drone.setup().product().behavior());
  private final Field<StationedDrone, Integer> color =
      key("colour", "").optionalInt(Scalars.COLOR, drone -> drone.setup().rgb());
  private final Field<StationedDrone, Double> battery =
      key("battery", "Its charge in percent.")
          .usual(
              NumberCodec.of(Phrase.of("a percentage from 0 to 100"), 0, 100).or(100.0),
              drone -> drone.setup().batteryPercent());
  private final Field<StationedDrone, InetAddress> address =
      key(
              "address",
              "Address of this machine at which it takes commands; without it, all of them for"
                  + " drone 1, 127.0.0.2 for drone 2, and so on.")
          .optional(Scalars.ADDRESS, drone -> drone.station().address());
  private final Field<StationedDrone, Integer> commandPort =
      key("command-port", "Where it takes commands; without it, that of --command-port.")
          .optionalInt(Scalars.PORT, drone -> drone.station().port());
  private final Field<StationedDrone, Integer> statePort =
      key("state-port", "Where its state goes.")
          .usual(
              Scalars.PORT.or(StreamPorts.DEFAULT.statePort()),
              drone -> drone.setup().streamPorts().statePort());
  private final Field<StationedDrone, Integer> videoPort =
      key("video-port", "Where its video goes.")
          .usual(
              Scalars.PORT.or(StreamPorts.DEFAULT.videoPort()),
              drone -> drone.setup().streamPorts().videoPort());

  DroneCodec() {
    super("drone", Phrase.of("a drone"), "A drone; the first one has the number 1.");
    made(this::make);
  }

  private StationedDrone make(Entries in) {
    DroneSetup setup =
        new DroneSetup(
            new Pose(in.get(start), Attitude.ofHeading(in.get(heading))),
            new Product(in.get(profile), in.get(behavior)),
            new StreamPorts(in.get(statePort), in.get(videoPort)),
            in.get(battery),
            in.findInt(color));
    return new StationedDrone(setup, new Station(in.find(address), in.findInt(commandPort)));
  }
}
