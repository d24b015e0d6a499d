package tellosimulator.cli;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.LocalNetworks;
import tellosimulator.network.PortTakenException;
import tellosimulator.network.Reach;
import tellosimulator.proxy.DroneProxy;
import tellosimulator.proxy.ProxyPlan;
import tellosimulator.recording.DroneRecorder;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * Runs a proxy between operator programs and a real drone, and records the flights. Not
 * thread-safe.
 */
final class ProxySubcommand extends Subcommand {

  private final Supplier<InetSocketAddress> drone =
      optionList
          .option(
              "--drone",
              "ADDRESS[:PORT]",
              "Where the drone is: 192.168.10.1 once this machine has joined its network.")
          .readRequired(OptionTypes::droneAddress);

  private final OptionValue<Path> record =
      optionList
          .option(
              RecordingOptions.RECORD,
              "DIR",
              "The folder in which each flight has a folder of its own.")
          .read(OptionTypes::fileOrFolder, "recordings");

  private final OptionValue<Optional<InetAddress>> bind =
      optionList
          .option(
              "--bind",
              "ADDRESS",
              "The address of this machine at which commands are taken. Default: 127.0.0.1.")
          .readIfGiven(OptionTypes::ownAddress);

  private final OptionValue<Boolean> lan =
      optionList.flag(
          "--lan",
          "Take commands from other machines of the local network, too: at all addresses of this"
              + " machine.");

  private final OptionValue<Integer> commandPort =
      NetworkOptions.commandPort(optionList, "Where commands are taken");

  private final OptionValue<Integer> statePort = NetworkOptions.statePort(optionList);

  private final OptionValue<Integer> videoPort =
      optionList
          .option("--video-port", "PORT", "Where your program takes the drone's video.")
          .read(OptionTypes::port, NetworkOptions.USUAL_VIDEO_PORT);

  private final OptionValue<Integer> droneStatePort =
      optionList
          .option(
              "--drone-state-port",
              "PORT",
              "The port of this machine to which the drone sends its state.")
          .read(OptionTypes::portOrFree, NetworkOptions.USUAL_STATE_PORT);

  private final OptionValue<Integer> droneVideoPort =
      optionList
          .option(
              "--drone-video-port",
              "PORT",
              "The port of this machine to which the drone sends its video.")
          .read(OptionTypes::portOrFree, NetworkOptions.USUAL_VIDEO_PORT);

  ProxySubcommand() {
    super(
        SubcommandName.PROXY,
        "Passes commands on to a real drone, and back what it sends, and records its flights.",
        "Exit code 0: ended by quit; 1: an address or a port is not available; 2: wrong options.");
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    Path recordings = record.value();
    RecordingOptions.check(recordings);
    ProxyPlan plan = plan();
    return () -> run(plan, recordings, to);
  }

  private int run(ProxyPlan plan, Path recordings, ProgramOutput to)
      throws PortTakenException, InterruptedException {
    RecordingFolder folder = RecordingFolder.at(recordings);
    DroneRecorder recorder =
        DroneRecorder.start(folder, plan.drone().getAddress(), optionList.words(), reason -> {});
    DroneProxy proxy = DroneProxy.start(plan, recorder);
    AtomicBoolean ended = new AtomicBoolean();
    Runnable end =
        () -> {
          proxy.close();
          if (!ended.getAndSet(true)) {
            folder.made().forEach(made -> to.out().println("recorded: " + made));
            to.out().flush();
          }
        };
    to.input().atEnd().accept(end);
    try {
      to.out().println(proxy.ready());
      to.out().println(passing(plan, recordings));
      to.out().flush();
      to.input().awaitQuit();
    } finally {
      end.run();
    }
    return ExitCode.DONE;
  }

  private ProxyPlan plan() {
    AddressPlan here =
        bind.value()
            .map(address -> AddressPlan.of(List.of(address), commandPort.value()))
            .orElseGet(
                () ->
                    AddressPlan.ofMachine(1, commandPort.value())
                        .withReach(lan.value() ? Reach.NETWORK : Reach.THIS_MACHINE));
    checkForLoop(here);
    return new ProxyPlan(
        drone.get(),
        here,
        new StreamPorts(droneStatePort.value(), droneVideoPort.value()),
        new StreamPorts(statePort.value(), videoPort.value()));
  }

  /**
   * Rejects the proxy's own address as the address of the drone, because the proxy would send to
   * itself.
   */
  private void checkForLoop(AddressPlan here) {
    InetSocketAddress to = drone.get();
    if (here.addresses(1, LocalNetworks.look()).contains(to)) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "--drone %s:%d is where the proxy itself takes commands; name the drone's address",
              to.getAddress().getHostAddress(),
              to.getPort()));
    }
  }

  /** Returns a line that describes where the traffic is forwarded. */
  private static String passing(ProxyPlan plan, Path recordings) {
    return String.format(
        Locale.ROOT,
        "passing on: commands to %s:%d, its state to port %d and its video to port %d of the"
            + " machine that sent command; recording in %s",
        plan.drone().getAddress().getHostAddress(),
        plan.drone().getPort(),
        plan.towardsOperator().statePort(),
        plan.towardsOperator().videoPort(),
        recordings);
  }
}
