package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetAddress;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AddressPlanTest {

  private static final LocalNetworks MACHINE =
      new LocalNetworks(
          List.of(
              new LocalNetworks.Member(address("127.0.0.1", 0).getAddress(), 8),
              new LocalNetworks.Member(address("10.0.0.2", 0).getAddress(), 24),
              new LocalNetworks.Member(address("192.168.1.3", 0).getAddress(), 24)));

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

    assertThat(plan.drones().stream().map(drone -> drone.port() + "").toList())
        .containsExactly(ports.split(" ", -1));
  }

  @Test
  void aPortPerDroneIsTheSameOnAllAddresses() {
    AddressPlan plan = AddressPlan.portPerDrone(2, List.of(ONE, TWO), 8879);

    assertThat(plan.addresses(1, MACHINE))
        .containsExactly(address("127.0.0.1", 8879), address("10.0.0.2", 8879));
    assertThat(plan.addresses(2, MACHINE))
        .containsExactly(address("127.0.0.1", 8880), address("10.0.0.2", 8880));
  }

  @Test
  void anAddressADroneOnTheSamePort() {
    AddressPlan plan = AddressPlan.of(List.of(ONE, TWO), 8879);

    assertThat(plan.addresses(1, MACHINE)).containsExactly(address("127.0.0.1", 8879));
    assertThat(plan.addresses(2, MACHINE)).containsExactly(address("10.0.0.2", 8879));
  }

  @Test
  void unlessAskedForNoDroneListensBeyondLoopback() {
    AddressPlan plan = AddressPlan.ofMachine(3, 8879);

    assertThat(plan.addresses(1, MACHINE)).containsExactly(address("127.0.0.1", 8879));
    assertThat(plan.addresses(2, MACHINE)).containsExactly(address("127.0.0.2", 8879));
    assertThat(plan.addresses(3, MACHINE)).containsExactly(address("127.0.0.3", 8879));
  }

  @Test
  void reachedFromTheNetworkTheFirstDroneTakesTheWholeMachine() {
    AddressPlan plan = AddressPlan.ofMachine(2, 8879).withReach(Reach.NETWORK);

    assertThat(plan.addresses(1, MACHINE))
        .containsExactly(
            address("127.0.0.1", 8879), address("10.0.0.2", 8879), address("192.168.1.3", 8879));
    assertThat(plan.addresses(2, MACHINE)).containsExactly(address("127.0.0.2", 8879));
  }

  @Test
  void theFirstDroneLeavesAnAddressToTheOneThatHasItForItself() {
    AddressPlan plan =
        AddressPlan.ofMachine(List.of(Optional.empty(), Optional.of(TWO)), List.of(8879, 8879))
            .withReach(Reach.NETWORK);

    assertThat(plan.addresses(1, MACHINE))
        .containsExactly(address("127.0.0.1", 8879), address("192.168.1.3", 8879));
  }

  @Test
  void aScenariosAddressInTheNetworkIsAllowedOnlyIfTheNetworkIs() {
    AddressPlan scenarios = AddressPlan.ofMachine(List.of(Optional.of(TWO)), List.of(8879));

    assertThat(scenarios.allows(1, TWO)).isFalse();
    assertThat(scenarios.withReach(Reach.NETWORK).allows(1, TWO)).isTrue();
    assertThat(AddressPlan.of(List.of(TWO), 8879).allows(1, TWO)).isTrue();
    assertThat(scenarios.allows(1, ONE)).isTrue();
  }

  @Test
  void drones1And2CanShareAnAddressOnDifferentPorts() {
    AddressPlan plan =
        AddressPlan.ofMachine(List.of(Optional.empty(), Optional.of(ONE)), List.of(8879, 9000));

    assertThat(plan.addresses(1, MACHINE)).containsExactly(address("127.0.0.1", 8879));
    assertThat(plan.addresses(2, MACHINE)).containsExactly(address("127.0.0.1", 9000));
  }

  @Test
  void anotherPortIsForOneDroneAlone() {
    AddressPlan plan = AddressPlan.ofMachine(2, 8879).withPort(2, 9000);

    assertThat(plan.addresses(1, MACHINE)).containsExactly(address("127.0.0.1", 8879));
    assertThat(plan.addresses(2, MACHINE)).containsExactly(address("127.0.0.2", 9000));
  }
}
