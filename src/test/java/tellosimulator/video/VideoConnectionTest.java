package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.Mockito.doAnswer;
import static org.mockito.Mockito.mock;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.command.Packetizer;
import tellosimulator.command.Peer;
import tellosimulator.network.DatagramPort;
import tellosimulator.time.Ticker;
import tellosimulator.video.VideoConnection.Route;

class VideoConnectionTest {

  /** An address of this machine that is used by no other test's drone. */
  private static final String DRONE = "127.0.7.9";

  private static final List<byte[]> TEN = Collections.nCopies(10, new byte[] {0, 0, 0, 1, 1});

  private final Ticker ticker = new Ticker();
  private final VideoConnection connection =
      new VideoConnection(ticker, () -> {}, new VideoFaults(1), port -> port);
  private VideoReceiver receiver;

  @BeforeEach
  void open() throws IOException {
    receiver = VideoReceiver.open(0);
  }

  @AfterEach
  void close() {
    connection.close();
    receiver.close();
  }

  private Route link(String drone) throws IOException {
    InetAddress loopback = InetAddress.getLoopbackAddress();
    Peer operator =
        new Peer(
            new InetSocketAddress(loopback, 5000),
            new InetSocketAddress(InetAddress.getByName(drone), 8889));
    return Route.of(OperatorEndpoint.raw(Optional.of(operator), 8890, receiver.port()))
        .orElseThrow();
  }

  @Test
  void aPictureIsSpreadOverItsTime() throws IOException {
    long begun = ticker.nanos();
    connection.send(TEN, link(DRONE), 20_000_000);

    assertThat(ticker.nanos() - begun).isGreaterThanOrEqualTo(20_000_000);
    for (int i = 0; i < TEN.size(); i++) {
      assertThat(receiver.unit()).hasSize(5);
    }
  }

  @Test
  void itComesFromTheDronesAddressAndPort() throws IOException {
    connection.send(TEN, link(DRONE), 0);
    receiver.unit();

    assertThat(receiver.sender().getAddress().getHostAddress()).isEqualTo(DRONE);
    assertThat(receiver.sender().getPort()).isEqualTo(62512);
  }

  @Test
  void whereThePortIsTakenItComesFromAnother() throws IOException {
    String drone = "127.0.7.8";
    try (DatagramSocket taken =
        new DatagramSocket(new InetSocketAddress(InetAddress.getByName(drone), 62512))) {
      connection.send(TEN, link(drone), 0);
      receiver.unit();

      assertThat(receiver.sender().getAddress().getHostAddress()).isEqualTo(drone);
      assertThat(receiver.sender().getPort()).isNotEqualTo(taken.getLocalPort());
    }
  }

  /** A machine reports its port as unreachable after the first datagram of each try. */
  @Test
  void whereNothingReceivesOneDatagramIsATryAndThenAWholePictureGoes() throws IOException {
    InetSocketAddress remote = new InetSocketAddress("192.0.2.7", 11_111);
    Route route = new Route(InetAddress.getLoopbackAddress(), remote, Packetizer.RAW);
    AtomicInteger told = new AtomicInteger();
    List<byte[]> sent = new ArrayList<>();
    AtomicBoolean receives = new AtomicBoolean();
    VideoConnection.Connector silent =
        (from, to, listener) -> {
          DatagramPort port = mock(DatagramPort.class);
          doAnswer(
                  call -> {
                    sent.add(call.getArgument(0));
                    if (!receives.get()) {
                      listener.unreachable(to);
                    }
                    return null;
                  })
              .when(port)
              .send(any(), any());
          return port;
        };

    try (VideoConnection tried =
        new VideoConnection(
            ticker, told::incrementAndGet, new VideoFaults(1), port -> port, silent)) {
      tried.send(TEN, route, 0);
      assertThat(sent).hasSize(1);
      assertThat(told).hasValue(1);
      tried.send(TEN, route, 0);
      assertThat(sent).hasSize(2);

      receives.set(true);
      long begun = ticker.nanos();
      tried.send(TEN, route, 0);
      assertThat(sent).hasSize(12);
      assertThat(told).hasValue(2);
      assertThat(ticker.nanos() - begun)
          .as("waits for the answer to the first one")
          .isGreaterThanOrEqualTo(20_000_000);
    }
  }

  @Test
  void anAddressThatIsNotOfThisMachineHarmsNothing() throws IOException {
    connection.send(TEN, link("192.0.2.77"), 0);
    connection.send(TEN, link(DRONE), 0);

    assertThat(receiver.unit()).hasSize(5);
  }
}
