package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import tellosimulator.command.OperatorRule;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.time.TimeFactor;

/**
 * Tests an operator that is reached through the network; a program on this machine plays it, using
 * this machine's network address.
 */
@EnabledOnOs(value = OS.LINUX, disabledReason = "only Linux has connected sockets beside others")
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RemoteOperatorTest {

  private final BlockingQueue<SimEvent> events = new LinkedBlockingQueue<>();
  private InetAddress host;
  private DatagramSocket states;
  private OnlineSimulation simulation;
  private InetSocketAddress drone;

  @BeforeEach
  void switchOn() throws IOException {
    List<InetAddress> own = LocalNetworks.look().addresses();
    assumeTrue(own.size() > 1, "this machine is in no network");
    host = own.get(1);
    states = socket();
    SimListener listener =
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            events.add(event);
          }
        };
    simulation =
        new OnlineSimulation(
            SimConfig.DEFAULT
                .withTimeFactor(new TimeFactor(20))
                .withOperators(OperatorRule.only(host))
                .withStreamPorts(new StreamPorts(states.getLocalPort(), 9)),
            AddressPlan.of(List.of(host), 0),
            OptionalInt.empty(),
            List.of(listener));
    simulation.carryOut(new Control.Power(1, true));
    drone = simulation.addresses(1).get(0);
  }

  @AfterEach
  void close() {
    if (simulation != null) {
      simulation.close();
      states.close();
    }
  }

  @Test
  void aProgramThatHasEndedNoLongerOperatesTheDrone() throws Exception {
    try (DatagramSocket first = socket()) {
      assertThat(ask(first, "command")).isEqualTo("ok");
      assertThat(receive(states)).startsWith("mid:");
      send(first, "takeoff"); // the reply arrives seconds later
    }

    String free;
    do {
      free = events.take().phrase().english();
    } while (!free.startsWith("is free, because its replies at " + host.getHostAddress()));
    assertThat(simulation.snapshot().drones().get(0).link().sdkMode()).isFalse();
    try (DatagramSocket second = socket()) {
      assertThat(ask(second, "command")).isEqualTo("ok");
      assertThat(receive(states)).startsWith("mid:");
    }
  }

  private String ask(DatagramSocket from, String text) throws IOException {
    send(from, text);
    return receive(from);
  }

  private void send(DatagramSocket from, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    from.send(new DatagramPacket(bytes, bytes.length, drone));
  }

  private static String receive(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    socket.receive(packet);
    return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.ISO_8859_1);
  }

  private DatagramSocket socket() throws IOException {
    DatagramSocket socket = new DatagramSocket(new InetSocketAddress(host, 0));
    socket.setSoTimeout(20_000);
    return socket;
  }
}
