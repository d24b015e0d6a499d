package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetAddress;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LocalNetworksTest {

  private static final LocalNetworks MACHINE =
      new LocalNetworks(
          List.of(
              new LocalNetworks.Member(at("192.168.1.3"), 24),
              new LocalNetworks.Member(at("10.20.0.1"), 16),
              new LocalNetworks.Member(at("169.254.9.9"), 16),
              new LocalNetworks.Member(at("203.0.113.5"), 24),
              new LocalNetworks.Member(at("172.16.0.1"), 0)));

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # own,        sender,         neighbours
          127.0.0.1,    127.0.0.1,      true
          127.0.0.2,    192.168.1.3,    true
          192.168.1.3,  192.168.1.3,    true
          192.168.1.3,  192.168.1.254,  true
          192.168.1.3,  192.168.2.7,    false
          192.168.1.3,  10.20.0.9,      false
          192.168.1.3,  8.8.8.8,        false
          192.168.1.3,  127.0.0.1,      false
          10.20.0.1,    10.20.255.9,    true
          10.20.0.1,    10.21.0.9,      false
          169.254.9.9,  169.254.1.1,    true
          203.0.113.5,  203.0.113.6,    false
          172.16.0.1,   192.168.77.1,   true
          192.168.1.99, 192.168.1.3,    false
          """)
  void neighborsAreInTheSamePrivateNetwork(String own, String sender, boolean neighbors) {
    assertThat(MACHINE.neighbors(at(own), at(sender))).isEqualTo(neighbors);
  }

  @Test
  void theAddressesBeginWithLoopback() {
    assertThat(MACHINE.addresses()).startsWith(at("127.0.0.1"), at("192.168.1.3")).hasSize(6);
    assertThat(LocalNetworks.look().addresses())
        .startsWith(at("127.0.0.1"))
        .doesNotHaveDuplicates();
  }

  private static InetAddress at(String host) {
    return address(host, 0).getAddress();
  }
}
