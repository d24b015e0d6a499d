package tellosimulator.cli;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.command.OperatorRule;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.Reach;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * The command-line options for the addresses of the drones, the hosts that may operate the drones,
 * and the ports to which the drones send.
 */
final class NetworkOptions {

  /** The port on which operator programs usually receive state. */
  static final String USUAL_STATE_PORT = Integer.toString(StreamPorts.DEFAULT.statePort());

  static final String USUAL_VIDEO_PORT = Integer.toString(StreamPorts.DEFAULT.videoPort());

  private final OptionValue<Integer> commandPort;
  private final OptionValue<Integer> statePort;
  private final OptionValue<List<Integer>> videoPorts;

  /**
   * The port to which replies go; if empty, each reply goes to the port from which its command
   * came.
   */
  final OptionValue<OptionalInt> replyPort;

  private final OptionValue<Optional<List<InetAddress>>> bind;
  private final OptionValue<Boolean> lan;
  final OptionValue<OperatorRule> operators;
  private final OptionValue<Boolean> portPerDrone;

  NetworkOptions(OptionList optionList) {
    commandPort = commandPort(optionList, "Where drones take commands");
    statePort = statePort(optionList);
    videoPorts =
        optionList
            .option(
                "--video-port",
                "PORT,...",
                "Where your program takes the drone's video: one port for all drones, or one for"
                    + " each.")
            .read(OptionTypes::portsOfDrones, USUAL_VIDEO_PORT);
    replyPort =
        optionList
            .option(
                "--reply-port",
                "sender|PORT",
                "Where replies go on your program's host: to the port that the command came from,"
                    + " or always to the same one.")
            .read(OptionTypes::replyPort, "sender");
    bind =
        optionList
            .option(
                "--bind",
                "A,B,...",
                "One address of this machine for each drone. Default: 127.0.0.1 for drone 1,"
                    + " 127.0.0.2 for drone 2, and so on.")
            .readIfGiven(OptionTypes::addresses);
    lan =
        optionList.flag(
            "--lan",
            "Let other machines of the local network fly: drone 1, or with --port-per-drone each"
                + " drone, also listens on this machine's addresses there. Otherwise only this"
                + " machine does.");
    operators =
        optionList
            .option(
                "--operator",
                "first|ADDRESS|anyone",
                "Who operates a drone: the host that first sends command, until it lets go; one"
                    + " host alone; or anyone, as with the real drone. Others may only read.")
            .read(OptionTypes::operators, "first");
    portPerDrone =
        optionList.flag(
            "--port-per-drone",
            "Give all drones the same addresses and count the port up: 8879, 8880 and so on,"
                + " leaving out 8889, 8890 and 11111.");
  }

  /**
   * Adds the option for the local port on which commands are received.
   *
   * @param what the purpose of that port, for the help
   */
  static OptionValue<Integer> commandPort(OptionList optionList, String what) {
    return optionList
        .option("--command-port", "PORT", what + "; 0 chooses a free port.")
        .read(OptionTypes::portOrFree, "8879");
  }

  /** Adds the option for the port to which state is sent on the operator's machine. */
  static OptionValue<Integer> statePort(OptionList optionList) {
    return optionList
        .option("--state-port", "PORT", "Where your program takes the drone's state.")
        .read(OptionTypes::port, USUAL_STATE_PORT);
  }

  /** Returns the address of the page; see {@link #webAddress(int, boolean)}. */
  InetSocketAddress webAddress(int port) {
    return webAddress(port, lan.value());
  }

  /**
   * Returns the address of a server for browsers.
   *
   * @param lan whether it is on all addresses of this machine, or on loopback alone
   */
  static InetSocketAddress webAddress(int port, boolean lan) {
    return lan
        ? new InetSocketAddress(port)
        : new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
  }

  /** Returns the number of addresses to bind if each of them is for one drone; otherwise empty. */
  OptionalInt addresses() {
    return bind.value().isPresent() && !portPerDrone.value()
        ? OptionalInt.of(bind.value().get().size())
        : OptionalInt.empty();
  }

  /**
   * Checks that {@code --bind}, if given without {@code --port-per-drone}, has one address for each
   * drone.
   *
   * @throws IllegalArgumentException if the numbers differ; the message is one sentence
   */
  void checkAddresses(int drones) {
    if (addresses().orElse(drones) != drones) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "--bind has %d addresses for %d drones, but each drone needs one",
              addresses().getAsInt(),
              drones));
    }
  }

  /**
   * Checks that there is one video port for all drones, or one for each.
   *
   * @throws IllegalArgumentException if there is any other number of ports; the message is one
   *     sentence
   */
  void checkVideoPorts(int drones) {
    int ports = videoPorts.value().size();
    if (ports != 1 && ports != drones) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "--video-port has %d ports for %d drones, but must have one for each, or one for all",
              ports,
              drones));
    }
  }

  /**
   * Returns the ports to which a drone's state and video go.
   *
   * @param drone the drone's number, from 1
   * @param said the ports to use if no options are given
   */
  StreamPorts streamPorts(int drone, StreamPorts said) {
    List<Integer> ports = videoPorts.value();
    return new StreamPorts(
        statePort.or(said.statePort()),
        videoPorts.given() ? ports.get((drone - 1) % ports.size()) : said.videoPort());
  }

  /**
   * Returns the listen addresses of all drones. If the number of addresses to bind differs from the
   * number of drones, each drone listens on its own port at all of these addresses.
   *
   * @throws IllegalArgumentException if there are not enough ports; the message is one sentence
   */
  AddressPlan addressPlan(Scenario scenario) {
    return endpoints(scenario).withReach(lan.value() ? Reach.NETWORK : Reach.THIS_MACHINE);
  }

  private AddressPlan endpoints(Scenario scenario) {
    int count = scenario.config().drones().size();
    int port = commandPort.value();
    Optional<List<InetAddress>> bound = bind.value();
    if (bound.isPresent() && addresses().orElse(0) == count) {
      return AddressPlan.of(bound.get(), port);
    }
    if (bound.isPresent() || portPerDrone.value()) {
      return AddressPlan.portPerDrone(count, bound.orElse(List.of()), port);
    }
    return commandPort.given()
        ? scenario.withCommandPort(port).addressPlan(port)
        : scenario.addressPlan(port);
  }
}
