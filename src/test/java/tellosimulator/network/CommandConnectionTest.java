package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SimulatedDrone.address;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.concurrent.Uncaught;
import tellosimulator.concurrent.Verdict;
import tellosimulator.concurrent.Worker;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.SimulationLoop;
import tellosimulator.testing.CapturedLog;

/** What becomes of a receiver whose socket or memory fails. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class CommandConnectionTest {

  private static final InetSocketAddress SENDER = address("127.0.0.1", 50_000);

  private final BlockingQueue<String> replies = new LinkedBlockingQueue<>();
  private final Simulation simulation =
      new Simulation(
          SimConfig.DEFAULT, drone -> (peer, text) -> replies.add(text), report -> {}, List.of());
  private final InMemoryPort port = new InMemoryPort(address("127.0.0.1", 8879));
  private final CapturedLog log = CapturedLog.of(Verdict.class);

  /** Fails some times before it receives. */
  private static final class FailingPort implements DatagramPort {

    private final DatagramPort port;
    private final Throwable failure;
    private int failures;

    FailingPort(DatagramPort port, Throwable failure, int failures) {
      this.port = port;
      this.failure = failure;
      this.failures = failures;
    }

    @Override
    public Received receive() throws IOException {
      if (failures-- <= 0) {
        return port.receive();
      }
      if (failure instanceof IOException exception) {
        throw exception;
      }
      throw (Error) failure;
    }

    @Override
    public InetSocketAddress address() {
      return port.address();
    }

    @Override
    public void send(byte[] bytes, InetSocketAddress to) {
      port.send(bytes, to);
    }

    @Override
    public void close() {
      port.close();
    }
  }

  @AfterEach
  void close() {
    log.close();
  }

  static List<Throwable> failures() {
    return List.of(
        new IOException("broken on purpose"),
        new OutOfMemoryError("broken on purpose"),
        new StackOverflowError("broken on purpose"),
        new NoClassDefFoundError("broken/on/purpose"));
  }

  @ParameterizedTest
  @MethodSource("failures")
  void receivesAfterAFailure(Throwable failure) throws InterruptedException {
    assertThat(replyAfter(failure, 3)).isEqualTo("ok");

    assertThat(log.next()).startsWith("Receiving on /127.0.0.1:8879 failed");
  }

  /** As where the network of a machine is down for a while. */
  @Test
  void aSocketMayFailAsOftenAsItLikes() throws InterruptedException {
    assertThat(replyAfter(new IOException("broken on purpose"), 120)).isEqualTo("ok");
  }

  @Test
  void memoryThatStaysFullEndsTheProgram() throws InterruptedException {
    OutOfMemoryError failure = new OutOfMemoryError("broken on purpose");
    try (Uncaught uncaught = new Uncaught();
        Worker receiver = listen(failure, Integer.MAX_VALUE)) {
      assertThat(uncaught.await()).isSameAs(failure);
      assertThat(receiver.hasEnded()).isTrue();
    }
  }

  private String replyAfter(Throwable failure, int failures) throws InterruptedException {
    simulation.control(new Control.Power(1, true));
    port.deliver(SENDER, "command");
    try (SimulationLoop loop = new SimulationLoop(simulation);
        Worker receiver = listen(failure, failures)) {
      String reply = replies.poll(20, TimeUnit.SECONDS);
      assertThat(loop).isNotNull();
      assertThat(receiver.hasEnded()).isFalse();
      port.close();
      return reply;
    }
  }

  private Worker listen(Throwable failure, int failures) {
    FailingPort failing = new FailingPort(port, failure, failures);
    return new CommandConnection(1, failing, new Ports(), simulation, (peer, text) -> true)
        .listen(new Traffic());
  }
}
