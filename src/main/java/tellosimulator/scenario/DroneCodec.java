package tellosimulator.scenario;

import java.net.InetAddress;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Scenario.CommandAddress;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.words.Phrase;

/** Codec of a drone: its start, product, colour, battery charge, address and ports. */
final class DroneCodec extends RecordCodec<DroneCodec.DronePlacement> {

  /** A drone and its command address. */
  record DronePlacement(DroneSetup setup, CommandAddress station) {}

  private final Field<DronePlacement, Vec3> start =
      key("start", "Start position: [x, y] in cm.")
          .need(Scalars.FLOOR_POINT, drone -> drone.setup().start().position());
  private final Field<DronePlacement, Double> heading =
      key("heading", "Heading in degrees counter-clockwise; 0 is along x.")
          .usual(NumberCodec.ANGLE.or(0.0), drone -> drone.setup().start().attitude().heading());
  private final Field<DronePlacement, Profile> profile =
      key("profile", "Tello EDU, white Tello or RoboMaster TT.")
          .usual(
              WordCodec.of(Profile.values()).or(Product.DEFAULT.profile()),
              drone -> drone.setup().product().profile());
  private final Field<DronePlacement, Behavior> behavior =
      key("behaviour", "Exact, or with the noise and delays of real drones.")
          .usual(
              WordCodec.of(Behavior.values()).or(Product.DEFAULT.behavior()),
              drone -> drone.setup().product().behavior());
  private final Field<DronePlacement, Integer> color =
      key("colour", "").optionalInt(Scalars.COLOR, drone -> drone.setup().rgb());
  private final Field<DronePlacement, Double> battery =
      key("battery", "Battery charge in percent.")
          .usual(
              new NumberCodec(Quantity.BATTERY_PERCENT, Phrase.of("a percentage from 0 to 100"))
                  .or(100.0),
              drone -> drone.setup().batteryPercent());
  private final Field<DronePlacement, InetAddress> address =
      key(
              "address",
              "Address of this machine at which it takes commands; without it, all of them for"
                  + " drone 1, 127.0.0.2 for drone 2, and so on.")
          .optional(Scalars.ADDRESS, drone -> drone.station().address());
  private final Field<DronePlacement, Integer> commandPort =
      key("command-port", "Where it takes commands; without it, that of --command-port.")
          .optionalInt(Scalars.PORT, drone -> drone.station().port());
  private final Field<DronePlacement, Integer> statePort =
      key("state-port", "Port to which it sends its state.")
          .usual(
              Scalars.PORT.or(StreamPorts.DEFAULT.statePort()),
              drone -> drone.setup().streamPorts().statePort());
  private final Field<DronePlacement, Integer> videoPort =
      key("video-port", "Port to which it sends its video.")
          .usual(
              Scalars.PORT.or(StreamPorts.DEFAULT.videoPort()),
              drone -> drone.setup().streamPorts().videoPort());

  DroneCodec() {
    super("drone", Phrase.of("a drone"), "A drone; the first one has the number 1.");
    made(this::make);
  }

  private DronePlacement make(Entries in) {
    DroneSetup setup =
        new DroneSetup(
            new Pose(in.get(start), Attitude.ofHeading(in.get(heading))),
            new Product(in.get(profile), in.get(behavior)),
            new StreamPorts(in.get(statePort), in.get(videoPort)),
            in.get(battery),
            in.findInt(color));
    return new DronePlacement(setup, new CommandAddress(in.find(address), in.findInt(commandPort)));
  }
}
