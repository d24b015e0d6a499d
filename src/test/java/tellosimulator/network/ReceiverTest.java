package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.spy;
import static tellosimulator.testing.SteppedDrone.address;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mockito.stubbing.Stubber;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Uncaught;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.CapturedLog;

/** Uses real sockets on loopback; the drone is off, and each text that it receives is an event. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ReceiverTest {

  private static final CommandConnection.Gate OPEN = (sender, via, bytes, length) -> true;

  private final BlockingQueue<String> taken = new LinkedBlockingQueue<>();
  private final Simulation simulation =
      new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of(listener()));
  private final Traffic traffic = new Traffic();
  private UdpPort port;
  private Receiver receiver;
  private DatagramSocket client;

  private SimListener listener() {
    return new SimListener() {
      @Override
      public void event(SimEvent event) {
        taken.add(((SimEvent.CommandIgnored) event).text());
      }
    };
  }

  @BeforeEach
  void start() throws IOException {
    port = UdpPort.open(address("127.0.0.1", 0));
    client = new DatagramSocket(address("127.0.0.1", 0));
    receiver = Receiver.start(simulation);
  }

  @AfterEach
  void close() {
    port.close();
    receiver.close();
    client.close();
  }

  @Test
  void everythingThatWaitsIsHandedOverInOrder() throws Exception {
    List<String> sent = IntStream.range(0, 100).mapToObj(i -> "text " + i).toList();
    for (String text : sent) {
      send(text);
    }
    receiver.add(port, connection(port, OPEN));

    assertThat(take(sent.size())).isEqualTo(sent);
    assertThat(traffic.received()).isEqualTo(sent.size());
  }

  @Test
  void whatIsTurnedAwayIsCountedAndNotHandedOver() throws Exception {
    receiver.add(port, connection(port, (sender, via, bytes, length) -> bytes[0] == 'y'));
    send("no");
    send("yes");

    assertThat(take(1)).containsExactly("yes");
    assertThat(traffic.received()).isEqualTo(2);
  }

  @Test
  void aPortIsFreeAsSoonAsItsSocketWasClosedAndLetGo() throws Exception {
    for (int i = 0; i < 200; i++) {
      InetSocketAddress address;
      try (UdpPort another = UdpPort.open(address("127.0.0.1", 0))) {
        address = another.address();
        receiver.add(another, connection(another, OPEN));
      }
      receiver.settle();
      try (DatagramSocket again = new DatagramSocket(address)) {
        assertThat(again.getLocalPort()).isEqualTo(address.getPort());
      }
    }
  }

  static List<Throwable> errors() {
    return List.of(
        new OutOfMemoryError("broken on purpose"),
        new StackOverflowError("broken on purpose"),
        new NoClassDefFoundError("broken/on/purpose"),
        new IllegalStateException("broken on purpose"));
  }

  @ParameterizedTest
  @MethodSource("errors")
  void receivesAfterAnError(Throwable error) throws Exception {
    try (CapturedLog log = CapturedLog.of(ErrorPolicy.class)) {
      receiver.add(port, connection(port, failing(error, 3)));
      for (int i = 0; i < 3; i++) {
        send("lost");
      }
      send("taken");

      assertThat(take(1)).containsExactly("taken");
      assertThat(log.next()).containsAnyOf("Receiving failed: ", "A datagram could not be handled");
    }
  }

  /** Simulates a machine whose network is down for a while. */
  @Test
  void aSocketMayFailAsOftenAsItLikesAndIsToldOnce() throws Exception {
    UdpPort broken = spy(port);
    Stubber fails = doThrow(new IOException("broken on purpose"));
    for (int i = 1; i < 120; i++) {
      fails = fails.doThrow(new IOException("broken on purpose"));
    }
    fails.doCallRealMethod().when(broken).receive(any());
    try (CapturedLog log = CapturedLog.of(CommandConnection.class);
        UdpPort other = UdpPort.open(address("127.0.0.1", 0))) {
      receiver.add(broken, connection(broken, OPEN));
      receiver.add(other, connection(other, OPEN));
      send("taken");
      send("by another", other);

      assertThat(take(2)).containsExactlyInAnyOrder("taken", "by another");
      assertThat(log.next())
          .isEqualTo("Receiving on " + port.address() + " failed: broken on purpose");
      assertThat(log.isEmpty()).isTrue();
    }
  }

  @Test
  void memoryThatStaysFullEndsTheProgram() throws Exception {
    OutOfMemoryError error = new OutOfMemoryError("broken on purpose");
    try (Uncaught uncaught = new Uncaught();
        CapturedLog log = CapturedLog.of(ErrorPolicy.class)) {
      receiver.add(port, connection(port, failing(error, Integer.MAX_VALUE)));
      for (int i = 0; i < 200; i++) {
        send("lost");
      }

      assertThat(uncaught.await()).isSameAs(error);
      assertThat(log.next()).startsWith("Receiving failed: ");
    }
  }

  /**
   * A flood consists of rejected datagrams, so each allocation would be made 50,000 times a second.
   */
  @Test
  void whatIsTurnedAwayMakesNoGarbage() throws Exception {
    int count = 20_000;
    AdmissionControl admission = new AdmissionControl(1, simulation);
    LocalNetworks networks =
        new LocalNetworks(List.of(new LocalNetworks.Member(client.getLocalAddress(), 8)));
    CommandConnection connection =
        connection(
            port,
            (sender, via, bytes, length) -> admission.admits(sender, via, bytes, length, networks));
    InetSocketAddress sender = (InetSocketAddress) client.getLocalSocketAddress();
    byte[] garbage = new byte[1000];
    Arrays.fill(garbage, (byte) 'x');
    simulation.submit(1, new Peer(sender, port.address()), WireText.encode("command"));
    simulation.drain();
    for (int i = 0; i < count; i++) {
      connection.take(sender, garbage, garbage.length); // compiles it, and empties the bucket
    }

    var threads =
        (com.sun.management.ThreadMXBean) java.lang.management.ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    int passed = 0;
    for (int i = 0; i < count; i++) {
      passed += connection.take(sender, garbage, garbage.length).isPresent() ? 1 : 0;
    }
    long each = (threads.getCurrentThreadAllocatedBytes() - before) / count;

    assertThat(passed).isLessThan(count / 10);
    assertThat(each).as("bytes of garbage a datagram").isLessThan(40);
  }

  private CommandConnection connection(UdpPort of, CommandConnection.Gate gate) {
    return new CommandConnection(1, of.address(), new Ports(), gate, traffic);
  }

  private static CommandConnection.Gate failing(Throwable error, int times) {
    int[] left = {times};
    return (sender, via, bytes, length) -> {
      if (left[0]-- > 0) {
        throw sneaky(error);
      }
      return true;
    };
  }

  private static RuntimeException sneaky(Throwable error) {
    if (error instanceof Error thrown) {
      throw thrown;
    }
    return (RuntimeException) error;
  }

  private void send(String text) throws IOException {
    send(text, port);
  }

  private void send(String text, UdpPort to) throws IOException {
    byte[] bytes = WireText.encode(text);
    client.send(new DatagramPacket(bytes, bytes.length, to.address()));
  }

  /** Waits for a number of texts and removes them. */
  private List<String> take(int count) throws InterruptedException {
    List<String> texts = new java.util.ArrayList<>();
    while (texts.size() < count) {
      simulation.drain();
      String text = taken.poll(10, TimeUnit.MILLISECONDS);
      if (text != null) {
        texts.add(text);
      }
    }
    return texts;
  }
}
