package tellosimulator.view.pilot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.Optional;
import tellosimulator.network.PortTakenException;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;

/**
 * An operator who sends one drone one command at a time through the drone's real port, and looks at
 * each beat whether the reply has come. For the JavaFX thread; it never waits.
 */
final class OperatorClient implements AutoCloseable {

  /**
   * How a command ended.
   *
   * @param problem why it did not succeed; {@link Message#NONE} if the drone said {@code ok}
   */
  public record Answer(Message problem) {

    static final Answer OK = new Answer(Message.NONE);

    public boolean ok() {
      return problem.isNone();
    }
  }

  private final FxSimulation simulation;
  private final FxDroneModel drone;
  private final OperatorSocket socket;
  private String command = "";
  private Optional<ReplyTimeout> timeout = Optional.empty();
  private Optional<Answer> early = Optional.empty();

  /**
   * @param drone which is on
   * @throws IOException if the system has no socket left
   */
  public OperatorClient(ViewContext context, FxDroneModel drone) throws IOException {
    this.simulation = context.simulation();
    this.drone = drone;
    InetSocketAddress address = context.actions().addresses(drone.number()).get(0);
    this.socket = OperatorSocket.open(address);
  }

  /** Sends a command; {@link #answer} says how it ends. */
  void ask(String newCommand) {
    command = newCommand;
    timeout = Optional.empty();
    early = Optional.empty();
    try {
      socket.send(newCommand);
    } catch (IOException e) {
      early = Optional.of(unreachable());
    }
  }

  /** Sends a command whose reply interests nobody, or that has none. */
  void tell(String unanswered) {
    try {
      socket.send(unanswered);
    } catch (IOException e) {
      early = Optional.of(unreachable());
    }
  }

  /**
   * How the command that was asked last ended; empty while it runs.
   *
   * @param nanos the beat's time [ns]
   */
  Optional<Answer> answer(long nanos) {
    if (!drone.onProperty().get()) {
      return Optional.of(new Answer(Message.of("switched-off", number())));
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
      early = Optional.of(unreachable()); // unless the next beat shows that it was switched off
    }
    return isLost(nanos) ? Optional.of(new Answer(silence())) : Optional.empty();
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

  private Answer judged(String reply) {
    return reply.strip().equals("ok") ? Answer.OK : new Answer(refused(command, reply));
  }

  /** The drone refused a command. */
  static Message refused(String command, String reply) {
    return Message.of("refused", command, reply.strip());
  }

  /** A drone cannot be switched on. */
  static Message portTaken(PortTakenException e) {
    String obstacle = e.obstacle().name().toLowerCase(Locale.ROOT).replace('_', '-');
    return Message.of(
        "port-" + obstacle,
        Integer.toString(e.address().getPort()),
        e.address().getAddress().getHostAddress());
  }

  private Answer unreachable() {
    return new Answer(Message.of("unreachable", number(), port()));
  }

  private Message silence() {
    return Message.of("silence", command);
  }

  private String number() {
    return Integer.toString(drone.number());
  }

  private String port() {
    return Integer.toString(socket.drone().getPort());
  }
}
