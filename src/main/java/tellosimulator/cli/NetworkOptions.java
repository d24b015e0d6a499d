package tellosimulator.cli;

import java.net.InetAddress;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.command.OperatorRule;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.Reach;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig.StreamPorts;

/** The options that say where drones listen, to whom, and where what they send goes. */
final class NetworkOptions {

  /** Where operator programs take state and video. */
  static final String USUAL_STATE_PORT = Integer.toString(StreamPorts.DEFAULT.statePort());

  static final String USUAL_VIDEO_PORT = Integer.toString(StreamPorts.DEFAULT.videoPort());

  private final OptionValue<Integer> commandPort;
  private final OptionValue<Integer> statePort;
  private final OptionValue<OptionTypes.PortList> videoPorts;
  private final OptionValue<OptionalInt> replyPort;
  private final OptionValue<Optional<OptionTypes.AddressList>> bind;
  private final OptionValue<Boolean> lan;
  private final OptionValue<OperatorRule> operators;
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
                    + " each. Default: 11111.")
            .read(OptionTypes::portsOfDrones, USUAL_VIDEO_PORT);
    replyPort =
        optionList
            .option(
                "--reply-port",
                "sender|PORT",
                "Where replies go on your program's host: to the port that the command came from,"
                    + " or always to the same one. Default: sender.")
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
                    + " host alone; or anyone, as with the real drone. Others may only read."
                    + " Default: first.")
            .read(OptionTypes::operators, "first");
    portPerDrone =
        optionList.flag(
            "--port-per-drone",
            "Give all drones the same addresses and count the port up: 8879, 8880 and so on,"
                + " leaving out 8889, 8890 and 11111.");
  }

  /**
   * The option that says at which port of this machine commands are taken.
   *
   * @param what is said at that port
   */
  static OptionValue<Integer> commandPort(OptionList optionList, String what) {
    return optionList
        .option("--command-port", "PORT", what + "; 0 chooses a free port. Default: 8879.")
        .read(OptionTypes::portOrFree, "8879");
  }

  /** The option that says at which port of its machine a program takes the state. */
  static OptionValue<Integer> statePort(OptionList optionList) {
    return optionList
        .option(
            "--state-port", "PORT", "Where your program takes the drone's state. Default: 8890.")
        .read(OptionTypes::port, USUAL_STATE_PORT);
  }

  /** Where replies go; empty for the port that the command came from. */
  OptionalInt replyPort() {
    return replyPort.value();
  }

  OperatorRule operators() {
    return operators.value();
  }

  /** How many addresses there are if each is for one drone. */
  OptionalInt addresses() {
    return bind.value().isPresent() && !portPerDrone.value()
        ? OptionalInt.of(bind.value().get().addresses().size())
        : OptionalInt.empty();
  }

  /**
   * Looks whether each drone has an address.
   *
   * @throws IllegalArgumentException with a sentence, if not
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
   * Looks whether each drone has a port for its video.
   *
   * @throws IllegalArgumentException with a sentence, if not
   */
  void checkVideoPorts(int drones) {
    int ports = videoPorts.value().ports().size();
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
   * Where state and video of a drone go.
   *
   * @param drone its number, from 1
   * @param said what else says so
   */
  StreamPorts streamPorts(int drone, StreamPorts said) {
    List<Integer> ports = videoPorts.value().ports();
    return new StreamPorts(
        statePort.or(said.statePort()),
        videoPorts.given() ? ports.get((drone - 1) % ports.size()) : said.videoPort());
  }

  /**
   * Which drone listens where; also where there are more drones than addresses to bind.
   *
   * @throws IllegalArgumentException with a sentence, if there are not enough ports
   */
  AddressPlan addressPlan(Scenario scenario) {
    return endpoints(scenario).withReach(lan.value() ? Reach.NETWORK : Reach.THIS_MACHINE);
  }

  private AddressPlan endpoints(Scenario scenario) {
    int count = scenario.config().drones().size();
    int port = commandPort.value();
    Optional<List<InetAddress>> bound = bind.value().map(OptionTypes.AddressList::addresses);
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
