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
 * A room that can be handed out: what is in it, which drones fly there, and what they shall do.
 * Immutable; for any thread.
 *
 * @param description for people
 * @param config what to simulate
 * @param stations where each drone takes commands, in the order of their numbers
 * @param challenge what the drones shall do
 */
public record Scenario(
    Description description, SimConfig config, List<Station> stations, Challenge challenge) {

  /**
   * Where a drone takes commands, as far as a scenario says so.
   *
   * @param address of this machine; empty for the usual one of the drone's number
   * @param port empty for the usual one
   */
  public record Station(Optional<InetAddress> address, OptionalInt port) {

    /** At the usual place. */
    public static final Station USUAL = new Station(Optional.empty(), OptionalInt.empty());
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

  /** Without a name and without goals, drones at the usual places. */
  public static Scenario of(SimConfig config) {
    List<Station> usual = Collections.nCopies(config.drones().size(), Station.USUAL);
    return new Scenario(Description.NONE, config, usual, Challenge.NONE);
  }

  /** The same with as many drones, but something else to simulate. */
  public Scenario withConfig(SimConfig newConfig) {
    return new Scenario(description, newConfig, stations, challenge);
  }

  /** The same with something else to do. */
  public Scenario withChallenge(Challenge newChallenge) {
    return new Scenario(description, config, stations, newChallenge);
  }

  /**
   * The same with room, starts, products and ports as they are in a simulation of it now.
   *
   * @param snapshot with as many drones
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

  /** The same with all drones at one port. */
  public Scenario withCommandPort(int port) {
    List<Station> others =
        stations.stream()
            .map(station -> new Station(station.address(), OptionalInt.of(port)))
            .toList();
    return new Scenario(description, config, others, challenge);
  }

  /**
   * Which drone listens where.
   *
   * @param usualPort for drones whose port is not said
   */
  public AddressPlan addressPlan(int usualPort) {
    return AddressPlan.ofMachine(
        stations.stream().map(Station::address).toList(),
        stations.stream().map(station -> station.port().orElse(usualPort)).toList());
  }
}
