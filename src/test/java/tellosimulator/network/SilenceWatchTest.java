package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class SilenceWatchTest {

  private final List<Silence> told = new ArrayList<>();
  private boolean silent = true;

  @Test
  void aProgramThatHasThePortAndSaysNothingIsNoticedOnce() throws IOException {
    try (UdpPort program = UdpPort.open(new InetSocketAddress(0))) { // on all addresses
      SilenceWatch watch = watch(program.address().getPort());

      look(watch, SilenceWatch.LOOKS_WITH_PROGRAM - 1);
      assertThat(told).isEmpty();
      look(watch, SilenceWatch.LOOKS);

      assertThat(told).containsExactly(Silence.PROGRAM_ELSEWHERE);
    }
  }

  @Test
  void withoutAProgramItTakesLonger() throws IOException {
    SilenceWatch watch = watch(freePort());

    look(watch, SilenceWatch.LOOKS - 1);
    assertThat(told).isEmpty();
    look(watch, 1);

    assertThat(told).containsExactly(Silence.NOTHING_CAME);
  }

  @Test
  void whatEndsMeanwhileBeginsAnew() throws IOException {
    SilenceWatch watch = watch(freePort());
    look(watch, SilenceWatch.LOOKS - 1);
    silent = false;
    look(watch, 1);
    silent = true;

    look(watch, SilenceWatch.LOOKS - 1);

    assertThat(told).isEmpty();
  }

  @Test
  void theProgramCanHaveThePortBetweenTwoLooks() throws IOException {
    int port = freePort();
    SilenceWatch watch = watch(port);
    look(watch, 2);

    try (UdpPort program = UdpPort.open(new InetSocketAddress(port))) {
      assertThat(program.address().getPort()).isEqualTo(port);
    }
  }

  private static void look(SilenceWatch watch, int times) {
    for (int i = 0; i < times; i++) {
      watch.look();
    }
  }

  private static int freePort() throws IOException {
    try (UdpPort port = UdpPort.open(new InetSocketAddress(0))) {
      return port.address().getPort();
    }
  }

  private SilenceWatch watch(int port) {
    return new SilenceWatch(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), port), () -> silent, told::add);
  }
}
