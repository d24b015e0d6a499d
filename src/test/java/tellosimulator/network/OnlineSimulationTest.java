package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.testing.SteppedDrone.address;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class OnlineSimulationTest {

  private static final int STATE_PORT = 9;

  private final OnlineSimulation simulation =
      new OnlineSimulation(
          SimConfig.DEFAULT.withStreamPorts(new StreamPorts(STATE_PORT, STATE_PORT)),
          AddressPlan.of(List.of(address("127.0.0.1", 0).getAddress()), 0),
          OptionalInt.empty(),
          List.of());

  @AfterEach
  void close() {
    simulation.close();
  }

  @Test
  void onlyADroneThatIsOnListensAndItKeepsItsPort() throws IOException {
    assertThat(phase()).isEqualTo(FlightPhase.OFF);
    simulation.carryOut(new Control.Power(1, true));
    InetSocketAddress drone = simulation.addresses(1).get(0);
    assertThat(ask("command", drone)).isEqualTo("ok");

    simulation.carryOut(new Control.Power(1, false));
    assertThat(phase()).isEqualTo(FlightPhase.OFF);
    try (DatagramSocket free = new DatagramSocket(drone)) {
      assertThat(free.isBound()).isTrue();
    }

    simulation.carryOut(new Control.Power(1, true));
    assertThat(simulation.addresses(1)).containsExactly(drone);
    assertThat(ask("command", drone)).isEqualTo("ok");
  }

  @Test
  void aTakenPortLeavesTheDroneOffUntilAnotherPortIsChosen() throws IOException {
    try (DatagramSocket taken = new DatagramSocket(address("127.0.0.1", 0))) {
      simulation.setCommandPort(1, taken.getLocalPort());

      assertThatThrownBy(() -> simulation.carryOut(new Control.Power(1, true)))
          .isInstanceOfSatisfying(
              PortTakenException.class,
              e -> {
                assertThat(e.address().getPort()).isEqualTo(taken.getLocalPort());
                assertThat(e.obstacle()).isEqualTo(PortTakenException.Obstacle.TAKEN);
              });
      assertThat(phase()).isEqualTo(FlightPhase.OFF);

      simulation.setCommandPort(1, 0);
      simulation.carryOut(new Control.Power(1, true));
      assertThat(ask("command", simulation.addresses(1).get(0))).isEqualTo("ok");
    }
  }

  @Test
  void afterItWasClosedNoSocketIsOpenedAnyMore() throws IOException {
    InetSocketAddress drone;
    try (DatagramSocket probe = new DatagramSocket(address("127.0.0.1", 0))) {
      drone = (InetSocketAddress) probe.getLocalSocketAddress();
    }
    simulation.setCommandPort(1, drone.getPort());
    simulation.close();

    simulation.carryOut(new Control.Power(1, true));

    try (DatagramSocket free = new DatagramSocket(drone)) {
      assertThat(free.isBound()).isTrue();
    }
  }

  @Test
  void aDroneThatIsNotThereCannotBeSwitchedOn() {
    assertThatThrownBy(() -> simulation.carryOut(new Control.Power(2, true)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("there is no drone 2, the drones are 1 to 1");
  }

  @Test
  void trafficIsCounted() throws IOException {
    simulation.carryOut(new Control.Power(1, true));
    InetSocketAddress drone = simulation.addresses(1).get(0);

    ask("command", drone);
    ask("battery?", drone);

    assertThat(simulation.traffic(1).received()).isEqualTo(2);
    assertThat(simulation.traffic(1).sent()).isGreaterThanOrEqualTo(2);
  }

  @Test
  void afterItHasSettledAllThatWasSentHasArrived() throws IOException {
    simulation.carryOut(new Control.Power(1, true));
    InetSocketAddress drone = simulation.addresses(1).get(0);
    assertThat(ask("command", drone)).isEqualTo("ok");
    byte[] rc = "rc 0 0 0 0".getBytes(StandardCharsets.ISO_8859_1);

    try (DatagramSocket socket = new DatagramSocket(address("127.0.0.1", 0))) {
      for (int sent = 1; sent <= 100; sent++) {
        socket.send(new DatagramPacket(rc, rc.length, drone));
        simulation.settle();
        assertThat(simulation.traffic(1).received()).isEqualTo(1 + sent);
      }
    }
  }

  @Test
  void aDroneThatIsOffCanBecomeAnotherProduct() throws IOException {
    Product white = new Product(Profile.TELLO, Behavior.MEASURED);

    simulation.carryOut(new Control.Configure(1, white, new StreamPorts(1234, 5678)));
    simulation.carryOut(new Control.Power(1, true));

    assertThat(simulation.snapshot().drones().get(0).product()).isEqualTo(white);
    assertThat(simulation.snapshot().drones().get(0).link().statePort()).isEqualTo(1234);
    InetSocketAddress drone = simulation.addresses(1).get(0);
    assertThat(ask("command", drone)).isEqualTo("ok");
    assertThat(ask("mon", drone)).isEqualTo("unknown command: mon");
  }

  @Test
  void aDroneThatIsOnStaysWhatItIs() throws IOException {
    simulation.carryOut(new Control.Power(1, true));
    Product white = new Product(Profile.TELLO, Behavior.REPORT);

    simulation.carryOut(new Control.Configure(1, white, StreamPorts.DEFAULT));

    assertThat(simulation.snapshot().drones().get(0).product().profile()).isEqualTo(Profile.EDU);
    InetSocketAddress drone = simulation.addresses(1).get(0);
    assertThat(ask("command", drone)).isEqualTo("ok");
  }

  @Test
  @Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void whatWasTurnedAwayIsToldNowAndThen() throws IOException {
    AtomicLong turnedAway = new AtomicLong();
    simulation.listen(
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            if (event instanceof SimEvent.DatagramsDropped dropped) {
              turnedAway.addAndGet(dropped.count());
            }
          }
        });
    simulation.carryOut(new Control.Power(1, true));
    InetSocketAddress drone = simulation.addresses(1).get(0);
    assertThat(ask("command", drone)).isEqualTo("ok");

    try (DatagramSocket socket = new DatagramSocket(address("127.0.0.1", 0))) {
      while (turnedAway.get() == 0) {
        socket.send(new DatagramPacket(new byte[] {'x'}, 1, drone));
      }
    }

    assertThat(askAgainAndAgain("battery?", drone))
        .as("a command of the operator")
        .isEqualTo("100\r\n");
  }

  private FlightPhase phase() {
    return simulation.snapshot().drones().get(0).state().phase();
  }

  /** Repeats a question, since the system drops datagrams while the socket's buffer is full. */
  private static String askAgainAndAgain(String text, InetSocketAddress drone) throws IOException {
    try (DatagramSocket socket = new DatagramSocket(address("127.0.0.1", 0))) {
      socket.setSoTimeout(500);
      byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
      DatagramPacket reply = new DatagramPacket(new byte[2048], 2048);
      while (true) {
        socket.send(new DatagramPacket(bytes, bytes.length, drone));
        try {
          socket.receive(reply);
          return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.ISO_8859_1);
        } catch (SocketTimeoutException e) {
          // lost or late
        }
      }
    }
  }

  private static String ask(String text, InetSocketAddress drone) throws IOException {
    try (DatagramSocket socket = new DatagramSocket(address("127.0.0.1", 0))) {
      socket.setSoTimeout(20_000);
      byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
      socket.send(new DatagramPacket(bytes, bytes.length, drone));
      DatagramPacket reply = new DatagramPacket(new byte[2048], 2048);
      socket.receive(reply);
      return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.ISO_8859_1);
    }
  }
}
