package tellosimulator.view.pilot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Optional;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.ViewContext;

/**
 * An operator who sends one drone one command at a time through the drone's real port, and looks at
 * each beat whether the reply has come. For the JavaFX thread; it never waits.
 */
public final class Pilot implements AutoCloseable {

  /**
   * How a command ended.
   *
   * @param problem why it did not succeed; {@link Sentence#NONE} if the drone said {@code ok}
   */
  public record Answer(Sentence problem) {

    static final Answer OK = new Answer(Sentence.NONE);

    public boolean ok() {
      return problem.isNone();
    }
  }

  private final FxSimulation simulation;
  private final FxDroneModel drone;
  private final OperatorSocket socket;
  private String command = "";
  private Optional<Patience> patience = Optional.empty();
  private Optional<Answer> early = Optional.empty();

  /**
   * @param drone which is on
   * @throws IOException if the system has no socket left
   */
  public Pilot(ViewContext context, FxDroneModel drone) throws IOException {
    this.simulation = context.simulation();
    this.drone = drone;
    InetSocketAddress address = context.actions().addresses(drone.number()).get(0);
    this.socket = OperatorSocket.open(address);
  }

  /** Sends a command; {@link #answer} says how it ends. */
  public void ask(String newCommand) {
    command = newCommand;
    patience = Optional.empty();
    early = Optional.empty();
    try {
      socket.send(newCommand);
    } catch (IOException e) {
      early = Optional.of(unreachable());
    }
  }

  /** Sends a command whose reply interests nobody, or that has none. */
  public void tell(String unanswered) {
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
  public Optional<Answer> answer(long nanos) {
    if (!drone.onProperty().get()) {
      return Optional.of(new Answer(Sentence.of("switched-off", number())));
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
    Patience.Clocks clocks =
        new Patience.Clocks(
            nanos, simulation.secondsProperty().get(), simulation.pausedProperty().get());
    if (patience.isEmpty()) {
      patience = Optional.of(new Patience(clocks));
    }
    return patience.get().isOver(clocks);
  }

  private Answer judged(String reply) {
    return reply.strip().equals("ok") ? Answer.OK : new Answer(Sentence.refused(command, reply));
  }

  private Answer unreachable() {
    return new Answer(Sentence.of("unreachable", number(), port()));
  }

  private Sentence silence() {
    return Sentence.of("silence", command);
  }

  private String number() {
    return Integer.toString(drone.number());
  }

  private String port() {
    return Integer.toString(socket.drone().getPort());
  }
}
