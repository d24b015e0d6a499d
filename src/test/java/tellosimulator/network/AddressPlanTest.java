package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SimulatedDrone.address;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AddressPlanTest {

  private static final InetAddress ONE = address("127.0.0.1", 0).getAddress();
  private static final InetAddress TWO = address("10.0.0.2", 0).getAddress();

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # first, drones, ports
          8879,    3,      8879 8880 8881
          8887,    4,      8887 8888 8891 8892
          8889,    3,      8889 8891 8892
          8890,    2,      8890 8891
          11110,   3,      11110 11112 11113
          11111,   2,      11111 11112
          0,       3,      0 0 0
          """)
  void portsCountUpAndLeaveOutThoseOfOperators(int first, int drones, String ports) {
    AddressPlan plan = AddressPlan.portPerDrone(drones, List.of(ONE), first);

    assertThat(plan.drones().stream().map(drone -> drone.get(0).getPort() + "").toList())
        .containsExactly(ports.split(" ", -1));
  }

  @Test
  void aPortPerDroneIsTheSameOnAllAddresses() {
    AddressPlan plan = AddressPlan.portPerDrone(2, List.of(ONE, TWO), 8879);

    assertThat(plan.drones())
        .containsExactly(
            List.of(address("127.0.0.1", 8879), address("10.0.0.2", 8879)),
            List.of(address("127.0.0.1", 8880), address("10.0.0.2", 8880)));
  }

  @Test
  void anAddressADroneOnTheSamePort() {
    assertThat(AddressPlan.of(List.of(ONE, TWO), 8879).drones())
        .containsExactly(List.of(address("127.0.0.1", 8879)), List.of(address("10.0.0.2", 8879)));
  }

  @Test
  void theFirstDroneTakesTheWholeMachineTheOthersLoopbackAddresses() {
    AddressPlan plan = AddressPlan.ofMachine(3, 8879);

    assertThat(plan.drones()).hasSize(3);
    assertThat(plan.drones().get(0)).contains(address("127.0.0.1", 8879)).doesNotHaveDuplicates();
    assertThat(plan.drones().get(0)).extracting(InetSocketAddress::getPort).containsOnly(8879);
    assertThat(plan.drones().get(1)).containsExactly(address("127.0.0.2", 8879));
    assertThat(plan.drones().get(2)).containsExactly(address("127.0.0.3", 8879));
  }

  @Test
  void drones1And2CanShareAnAddressOnDifferentPorts() {
    AddressPlan plan =
        AddressPlan.ofMachine(List.of(Optional.empty(), Optional.of(ONE)), List.of(8879, 9000));

    assertThat(plan.drones().get(0)).contains(address("127.0.0.1", 8879));
    assertThat(plan.drones().get(1)).containsExactly(address("127.0.0.1", 9000));
  }

  @Test
  void theMachinesAddressesBeginWithLoopback() {
    assertThat(AddressPlan.machineAddresses()).startsWith(ONE).doesNotHaveDuplicates();
  }
}
