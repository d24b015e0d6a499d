package tellosimulator.pilot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import java.util.function.LongSupplier;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.time.Ticker;

/**
 * A flight by a list of commands, each of which is sent after the reply to the one before. Ends
 * after the last reply, after a reply other than {@code ok}, or when it is closed; the latter two
 * land the drone. Thread-safe.
 */
public final class ScriptedFlight implements AutoCloseable {

  private static final ErrorPolicy FAILED = ErrorPolicy.finish("A demo flight failed");

  /** Time between two looks for a reply [ns]. Decided: shorter than people notice. */
  private static final long PERIOD = 20_000_000;

  /** Maximum wait for a reply [simulated s]. Assumed: longer than any command of a tour takes. */
  private static final double LONGEST = 60;

  private final OperatorSocket socket;
  private final Queue<String> commands;
  private final LongSupplier nanos;
  private final Ticker ticker = new Ticker();
  private final Worker worker;
  private volatile boolean ended;
  private long askedAt;

  /**
   * Begins a flight.
   *
   * @param nanos the simulated time [ns]
   * @throws IOException if no socket can be opened
   */
  public ScriptedFlight(InetSocketAddress drone, List<String> commands, LongSupplier nanos)
      throws IOException {
    this.commands = new ArrayDeque<>(commands);
    this.nanos = nanos;
    socket = OperatorSocket.open(drone);
    worker = Worker.start("demo", new Flight());
  }

  /** Whether the flight is over. */
  public boolean ended() {
    return ended;
  }

  /** Sends the commands. */
  private final class Flight implements Agent {

    @Override
    public Outcome doWork() throws IOException {
      if (askedAt == 0) {
        askNext();
      }
      if (!ticker.awaitTick(PERIOD)) {
        return Outcome.WORKED;
      }
      String reply = socket.receive().orElse("").strip();
      boolean late = nanos.getAsLong() - askedAt > LONGEST * 1e9;
      if (late || (!reply.isEmpty() && !reply.equals("ok"))) {
        socket.send("land");
        return Outcome.FINISHED;
      }
      if (reply.equals("ok")) {
        if (commands.isEmpty()) {
          return Outcome.FINISHED;
        }
        askNext();
      }
      return Outcome.WORKED;
    }

    private void askNext() throws IOException {
      askedAt = Math.max(1, nanos.getAsLong());
      String command = commands.remove();
      if (command.equals("takeoff")) {
        socket.send("rc 0 0 0 0"); // sticks of an earlier operator would move the drone
      }
      socket.send(command);
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return FAILED;
    }

    @Override
    public void onClose() {
      ended = true;
      socket.close();
    }
  }

  /** Ends the flight, and lands the drone unless it has already ended. */
  @Override
  public void close() {
    if (!ended) {
      try {
        socket.send("stop");
        socket.send("land");
      } catch (IOException e) {
        // the drone is off, or the flight has just ended
      }
    }
    worker.end();
    ticker.wake();
    worker.close();
  }
}
