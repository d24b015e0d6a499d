package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class VideoWatchTest {

  private Optional<InetSocketAddress> unasked = Optional.empty();
  private int reports;

  private final VideoWatch watch = new VideoWatch(() -> unasked, () -> reports++);

  @Test
  void aProgramThatListensInVainIsReportedOnce() throws IOException {
    try (UdpPort program = UdpPort.open(loopback(0))) {
      unasked = Optional.of(loopback(program.address().getPort()));

      look(VideoWatch.LOOKS_WITH_LISTENER - 1);
      assertThat(reports).isZero();
      look(VideoWatch.LOOKS);
      assertThat(reports).isEqualTo(1);
    }
  }

  @Test
  void aPortThatNoProgramHasIsNotReported() throws IOException {
    unasked = Optional.of(loopback(freePort()));

    look(2 * VideoWatch.LOOKS);
    assertThat(reports).isZero();
  }

  @Test
  void videoThatIsAskedForInTimeIsNotReported() throws IOException {
    try (UdpPort program = UdpPort.open(loopback(0))) {
      unasked = Optional.of(loopback(program.address().getPort()));
      look(VideoWatch.LOOKS_WITH_LISTENER - 1);
      unasked = Optional.empty();
      look(VideoWatch.LOOKS);

      assertThat(reports).isZero();
    }
  }

  private void look(int times) {
    for (int i = 0; i < times; i++) {
      watch.look();
    }
  }

  private static int freePort() throws IOException {
    try (UdpPort port = UdpPort.open(loopback(0))) {
      return port.address().getPort();
    }
  }

  private static InetSocketAddress loopback(int port) {
    return new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
  }
}
