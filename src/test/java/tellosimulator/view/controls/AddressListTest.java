package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.testing.SteppedDrone;

class AddressListTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          127.0.0.1                                     | 127.0.0.1
          127.0.0.1 192.168.1.5                         | 192.168.1.5 127.0.0.1
          127.0.0.1 172.17.0.1 192.168.1.5 169.254.1.1  | 192.168.1.5 127.0.0.1 172.17.0.1 169.254.1.1
          127.0.0.1 10.1.2.3 86.1.2.3                   | 10.1.2.3 127.0.0.1 86.1.2.3
          169.254.7.7 172.17.0.1                        | 172.17.0.1 169.254.7.7
          """)
  void theNetworkComesFirstAndThenThisMachine(String given, String wanted) {
    assertThat(AddressList.mostUsefulFirst(addresses(given))).isEqualTo(addresses(wanted));
  }

  private static List<InetSocketAddress> addresses(String hosts) {
    return Stream.of(hosts.split(" ")).map(host -> SteppedDrone.address(host, 8879)).toList();
  }
}
