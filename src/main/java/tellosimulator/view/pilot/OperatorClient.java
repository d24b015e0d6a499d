package tellosimulator.view.pilot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import tellosimulator.network.PortTakenException;
import tellosimulator.pilot.OperatorSocket;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;

/**
 * An operator that sends one command at a time to a drone's UDP command port, and polls for the
 * reply at each UI tick. Confined to the JavaFX thread; never blocks.
 */
final class OperatorClient implements AutoCloseable {

  private final FxSimulation simulation;
  private final FxDroneModel drone;
  private final OperatorSocket socket;
  private String command = "";
  private Optional<ReplyTimeout> timeout = Optional.empty();
  private Optional<Message> early = Optional.empty();

  /**
   * Opens a socket.
   *
   * @param drone a drone that is switched on
   * @throws IOException if the system cannot provide a socket
   */
  public OperatorClient(ViewContext context, FxDroneModel drone) throws IOException {
    this.simulation = context.simulation();
    this.drone = drone;
    InetSocketAddress address = context.actions().addresses(drone.number()).get(0);
    this.socket = OperatorSocket.open(address);
  }

  /** Sends a command; {@link #answer} returns its result. */
  void ask(String newCommand) {
    command = newCommand;
    timeout = Optional.empty();
    early = Optional.empty();
    tell(newCommand);
  }

  /** Sends a command that has no reply, or whose reply is ignored. */
  void tell(String unanswered) {
    try {
      socket.send(unanswered);
    } catch (IOException e) {
      early = Optional.of(unreachable());
    }
  }

  /**
   * Returns the result of the last command: {@link Message#NONE} if the drone replied {@code ok},
   * otherwise the reason why the command failed; empty while the command is running.
   *
   * @param nanos the time of the UI tick [ns]
   */
  Optional<Message> answer(long nanos) {
    if (!drone.onProperty().get()) {
      return Optional.of(Message.of("switched-off", number()));
    }
    if (early.isPresent()) {
      return early;
    }
    try {
      Optional<String> reply = socket.receive();
      if (reply.isPresent()) {
        return reply.map(this::judged);
      }
    } catch (IOException e) {
      early = Optional.of(unreachable()); // the next tick may show that the drone is off
    }
    return isLost(nanos) ? Optional.of(Message.of("silence", command)) : Optional.empty();
  }

  @Override
  public void close() {
    socket.close();
  }

  private boolean isLost(long nanos) {
    ReplyTimeout.Clocks clocks =
        new ReplyTimeout.Clocks(
            nanos, simulation.secondsProperty().get(), simulation.pausedProperty().get());
    if (timeout.isEmpty()) {
      timeout = Optional.of(new ReplyTimeout(clocks));
    }
    return timeout.get().isOver(clocks);
  }

  private Message judged(String reply) {
    return reply.strip().equals("ok") ? Message.NONE : refused(command, reply);
  }

  /** Returns the message for a command that the drone refused. */
  static Message refused(String command, String reply) {
    return Message.of("refused", command, reply.strip());
  }

  /**
   * Switches a drone on.
   *
   * @param problem receives the reason if the drone cannot be switched on
   * @param then called once the drone is on
   */
  static void switchOn(
      ViewContext context, FxDroneModel drone, Consumer<Message> problem, Runnable then) {
    context
        .actions()
        .switchPower(
            drone.number(),
            true,
            refusal -> refusal.ifPresentOrElse(e -> problem.accept(portTaken(e)), then));
  }

  /** Returns the message for a drone that cannot be switched on. */
  static Message portTaken(PortTakenException e) {
    String obstacle = e.obstacle().name().toLowerCase(Locale.ROOT).replace('_', '-');
    return Message.of(
        "port-" + obstacle,
        Integer.toString(e.address().getPort()),
        e.address().getAddress().getHostAddress());
  }

  private Message unreachable() {
    return Message.of("unreachable", number(), Integer.toString(socket.drone().getPort()));
  }

  private String number() {
    return Integer.toString(drone.number());
  }

  /**
   * Decides when a reply is overdue: after {@link #SIMULATED} seconds of simulated time, or if
   * simulated time has stood still for {@link #IDLE_NANOS} of wall-clock time without a pause.
   */
  static final class ReplyTimeout {

    /** Maximum wait in simulated time [s]. Assumed: longer than any command of a tour takes. */
    static final double SIMULATED = 60;

    /**
     * Maximum wall-clock time to wait while simulated time does not advance although the simulation
     * is not paused [ns]. Simulated time that runs as fast as possible advances only while a drone
     * has something to do. Assumed.
     */
    static final long IDLE_NANOS = 3_000_000_000L;

    /**
     * The readings of both clocks.
     *
     * @param nanos the wall-clock time [ns]
     * @param seconds the simulated time [s]
     */
    record Clocks(long nanos, double seconds, boolean paused) {}

    private final double began;
    private double seconds;
    private long movedNanos;

    ReplyTimeout(Clocks clocks) {
      began = clocks.seconds();
      seconds = clocks.seconds();
      movedNanos = clocks.nanos();
    }

    /** Updates the clocks, and returns whether the reply is overdue. */
    boolean isOver(Clocks clocks) {
      if (clocks.paused() || clocks.seconds() != seconds) {
        seconds = clocks.seconds();
        movedNanos = clocks.nanos();
      }
      return seconds - began >= SIMULATED || clocks.nanos() - movedNanos >= IDLE_NANOS;
    }
  }
}
