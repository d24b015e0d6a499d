package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramSocket;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class PortReservationTest {

  @Test
  void portsAreFreeDifferentAndOutsideOfWhatSystemsChoose() throws IOException {
    List<PortReservation> reservations = new ArrayList<>();
    Set<Integer> ports = new HashSet<>();
    for (int i = 0; i < 50; i++) {
      PortReservation reservation = PortReservation.of(PortChoice.FREE, 4);
      reservations.add(reservation);
      ports.addAll(reservation.ports());
    }

    assertThat(ports).hasSize(200).allMatch(port -> port >= 20_000 && port < 32_768);
    for (int port : ports) {
      new DatagramSocket(port).close();
    }
    reservations.forEach(PortReservation::close);
  }

  @Test
  void onlyOneHasTheRealPortsAtATime() throws InterruptedException {
    CountDownLatch has = new CountDownLatch(1);
    PortReservation first = PortReservation.of(PortChoice.REAL, 0);
    Thread other =
        new Thread(
            () -> {
              PortReservation second = PortReservation.of(PortChoice.REAL, 0);
              has.countDown();
              second.close();
            });
    other.start();
    while (other.getState() != Thread.State.WAITING) {
      Thread.onSpinWait();
    }
    assertThat(has.getCount()).isEqualTo(1);

    first.close();

    assertThat(has.await(50, TimeUnit.SECONDS)).isTrue();
    other.join();
  }
}
