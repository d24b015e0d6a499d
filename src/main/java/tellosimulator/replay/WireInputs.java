package tellosimulator.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Stream;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.Peer;
import tellosimulator.json.JsonRecords;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.recording.InitialConditions;
import tellosimulator.recording.RecordedDatagram;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedInput;
import tellosimulator.recording.RecordedRun;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimInput;
import tellosimulator.time.SimTime;

/**
 * What can be flown of a recording that tells its datagrams alone: drones that were just switched
 * on get the same commands at the same moments. Immutable.
 *
 * @param start the scenario, as far as it is known
 * @param commands all inputs, in their order
 */
record WireInputs(InitialConditions start, List<RecordedInput> commands) {

  WireInputs {
    commands = List.copyOf(commands);
  }

  /**
   * Reads them.
   *
   * @param outline what the recording says of itself
   * @throws IOException if they cannot be read
   */
  static WireInputs read(Path folder, RecordedFlight outline) throws IOException {
    Scenario scenario = outline.scenario().orElseGet(() -> Scenario.of(config(outline.run())));
    int drones = scenario.config().drones().size();
    List<RecordedInput> inputs = new ArrayList<>();
    for (int drone = 1; drone <= drones; drone++) {
      inputs.add(new RecordedInput(SimTime.ZERO, new SimInput.Act(new Control.Power(drone, true))));
    }
    Set<Integer> greeted = new HashSet<>();
    RecordedDatagram.readAll(
        folder,
        datagram -> {
          if (datagram.kind().equals("command") && datagram.drone() <= drones) {
            command(datagram, greeted.add(datagram.drone())).forEach(inputs::add);
          }
        });
    return new WireInputs(
        new InitialConditions(scenario.config(), scenario.challenge(), OptionalInt.empty()),
        inputs);
  }

  /** A command; before the first one {@code command}, which may have come in an earlier flight. */
  private static List<RecordedInput> command(RecordedDatagram datagram, boolean first) {
    Peer peer =
        new Peer(
            JsonRecords.socketAddress(datagram.from()), JsonRecords.socketAddress(datagram.to()));
    SimTime time =
        new SimTime(Math.round(Math.max(0, datagram.time()) / SimTime.STEP) * SimTime.STEP_NANOS);
    RecordedInput sent =
        new RecordedInput(time, new SimInput.Datagram(datagram.drone(), peer, datagram.text()));
    String greeting = CommandSyntax.COMMAND.verb();
    return !first || datagram.text().strip().equals(greeting)
        ? List.of(sent)
        : List.of(
            new RecordedInput(time, new SimInput.Datagram(datagram.drone(), peer, greeting)), sent);
  }

  private static SimConfig config(RecordedRun run) {
    List<DroneSetup> setups = new ArrayList<>();
    for (RecordedRun.DroneEntry drone : run.setting().drones()) {
      setups.add(DroneSetup.at(drone.start(), product(drone), StreamPorts.DEFAULT));
    }
    SimConfig config =
        SimConfig.DEFAULT
            .withArena(SimConfig.DEFAULT.arena().withRoom(run.setting().room()))
            .withSeed(run.seed().orElse(SimConfig.DEFAULT.seed()));
    return setups.isEmpty() ? config : config.withDrones(setups);
  }

  private static Product product(RecordedRun.DroneEntry drone) {
    return new Product(
        option(Profile.values(), drone.profile(), Product.DEFAULT.profile()),
        option(Behavior.values(), drone.behavior(), Product.DEFAULT.behavior()));
  }

  private static <T extends Enum<T>> T option(T[] known, String word, T other) {
    return Stream.of(known)
        .filter(each -> each.name().equalsIgnoreCase(word))
        .findFirst()
        .orElse(other);
  }
}
