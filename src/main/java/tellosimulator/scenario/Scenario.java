package tellosimulator.scenario;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.goal.Challenge;
import tellosimulator.network.AddressPlan;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * A scenario that can be shared: a room with its contents, the drones and their goals. Immutable.
 *
 * @param description the description for users
 * @param config the configuration of the simulation
 * @param stations the command address of each drone, in the order of drone numbers
 * @param challenge the goals of the drones
 */
public record Scenario(
    Description description, SimConfig config, List<CommandAddress> stations, Challenge challenge) {

  /**
   * The command address of a drone, as far as a scenario sets it.
   *
   * @param address an address of this machine; empty for the default address for the drone's number
   * @param port the port; empty for the default port
   */
  public record CommandAddress(Optional<InetAddress> address, OptionalInt port) {

    /** The default address and port. */
    public static final CommandAddress USUAL =
        new CommandAddress(Optional.empty(), OptionalInt.empty());
  }

  public Scenario {
    stations = List.copyOf(stations);
    if (stations.size() != config.drones().size()) {
      throw new IllegalArgumentException(
          "there are "
              + stations.size()
              + " stations for "
              + config.drones().size()
              + " drones, but each needs one");
    }
  }

  /**
   * Returns a scenario without a name or goals, in which all drones have their default addresses.
   */
  public static Scenario of(SimConfig config) {
    List<CommandAddress> usual = Collections.nCopies(config.drones().size(), CommandAddress.USUAL);
    return new Scenario(Description.NONE, config, usual, Challenge.NONE);
  }

  /**
   * Returns a copy of this scenario with another configuration, which must have the same number of
   * drones.
   */
  public Scenario withConfig(SimConfig newConfig) {
    return new Scenario(description, newConfig, stations, challenge);
  }

  /** Returns a copy of this scenario with another challenge. */
  public Scenario withChallenge(Challenge newChallenge) {
    return new Scenario(description, config, stations, newChallenge);
  }

  /**
   * Returns a copy of this scenario with the room, starts, products and ports that its simulation
   * has now.
   *
   * @param snapshot a snapshot with the same number of drones
   */
  public Scenario asIn(SimSnapshot snapshot) {
    List<DroneSetup> setups = new ArrayList<>();
    for (DroneSnapshot drone : snapshot.drones()) {
      DroneSetup first = config.drones().get(setups.size());
      StreamPorts streamPorts = new StreamPorts(drone.link().statePort(), drone.link().videoPort());
      setups.add(
          first.withStart(drone.start()).withProduct(drone.product()).withStreamPorts(streamPorts));
    }
    return withConfig(config.withArena(snapshot.arena()).withDrones(setups));
  }

  /** Returns a copy of this scenario with the same command port for all drones. */
  public Scenario withCommandPort(int port) {
    List<CommandAddress> others =
        stations.stream()
            .map(station -> new CommandAddress(station.address(), OptionalInt.of(port)))
            .toList();
    return new Scenario(description, config, others, challenge);
  }

  /**
   * Returns the listen addresses of all drones.
   *
   * @param usualPort the port of drones for which the scenario sets none
   */
  public AddressPlan addressPlan(int usualPort) {
    return AddressPlan.ofMachine(
        stations.stream().map(CommandAddress::address).toList(),
        stations.stream().map(station -> station.port().orElse(usualPort)).toList());
  }
}
