package tellosimulator.scenario;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.snakeyaml.engine.v2.nodes.Node;
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

/** Reads a drone: what it is, where it starts, and where it takes commands. */
final class DroneReader implements Value<DroneReader.Entry> {

  /**
   * A drone and its place in the network.
   *
   * @param sound whether all that the file says of it could be read
   */
  record Entry(DroneSetup setup, Station station, boolean sound) {}

  static final Map<String, Profile> PROFILES = profiles();
  static final Map<String, Behaviour> BEHAVIOURS = behaviours();

  private static Map<String, Profile> profiles() {
    Map<String, Profile> profiles = new HashMap<>();
    for (Profile profile : Profile.values()) {
      profiles.put(profile.option(), profile);
    }
    return Map.copyOf(profiles);
  }

  private static Map<String, Behaviour> behaviours() {
    Map<String, Behaviour> behaviours = new HashMap<>();
    for (Behaviour behaviour : Behaviour.values()) {
      behaviours.put(behaviour.option(), behaviour);
    }
    return Map.copyOf(behaviours);
  }

  /** It is there in any case, so that drones keep their numbers. */
  @Override
  public Optional<Entry> read(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.DRONE, node, mistakes);
    Vec3 start = section.need("start", ObstacleReader.FLOOR_POINT, Vec3.ZERO);
    double heading = section.read("heading", Values.angle(), 0.0);
    Product product =
        new Product(
            section.read("profile", Values.word(PROFILES), Product.DEFAULT.profile()),
            section.read("behaviour", Values.word(BEHAVIOURS), Product.DEFAULT.behaviour()));
    Outlets outlets =
        new Outlets(
            section.read("state-port", Values.port(), Outlets.DEFAULT.statePort()),
            section.read("video-port", Values.port(), Outlets.DEFAULT.videoPort()));
    double battery =
        section.read(
            "battery", Values.number(Phrase.of("a percentage from 0 to 100"), 0, 100), 100.0);
    OptionalInt rgb = toInt(section.read("colour", Values.colour()));
    Station station =
        new Station(
            section.read("address", Values.address()),
            toInt(section.read("command-port", Values.port())));
    Pose pose = new Pose(start, Attitude.ofHeading(heading));
    DroneSetup setup = new DroneSetup(pose, product, outlets, battery, rgb);
    return Optional.of(new Entry(setup, station, section.sound()));
  }

  private static OptionalInt toInt(Optional<Integer> value) {
    return value.isPresent() ? OptionalInt.of(value.get()) : OptionalInt.empty();
  }
}
