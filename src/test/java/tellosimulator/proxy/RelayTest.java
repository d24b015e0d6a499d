package tellosimulator.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.LocalNetworks;
import tellosimulator.network.LocalNetworks.Member;
import tellosimulator.network.Reach;
import tellosimulator.recording.DroneRecorder;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.testing.CapturedLog;

/**
 * Tests a relay that checks the networks when the test calls it; networks that appear are in
 * 127.0.0.0/8.
 */
@EnabledOnOs(OS.LINUX) // other systems have no 127.0.0.2 by default
class RelayTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  @TempDir private Path folder;

  private final List<Member> members = new ArrayList<>();
  private WireEnd drone;
  private DroneRecorder recorder;
  private Relay relay;

  @BeforeEach
  void open() throws IOException {
    drone = WireEnd.loopback();
    recorder =
        DroneRecorder.start(RecordingFolder.at(folder), LOOPBACK, List.of("proxy"), reason -> {});
    ProxyPlan plan =
        new ProxyPlan(
            drone.address(),
            AddressPlan.ofMachine(1, 0).withReach(Reach.NETWORK),
            new StreamPorts(0, 0),
            new StreamPorts(9, 9));
    relay = Relay.open(plan, recorder, new Relay.Polling(() -> new LocalNetworks(members), 1000));
  }

  @AfterEach
  void close() {
    relay.onClose();
    recorder.close();
    drone.close();
  }

  private InetSocketAddress join(String address) throws IOException {
    InetAddress host = InetAddress.getByName(address);
    members.add(new Member(host, 8));
    return new InetSocketAddress(host, relay.addresses().get(0).getPort());
  }

  @Test
  void aNetworkThatIsJoinedLaterIsListenedOn() throws IOException {
    InetSocketAddress joined = join("127.0.0.2");
    assertThat(relay.addresses()).hasSize(1);

    relay.look();

    assertThat(relay.addresses()).hasSize(2).endsWith(joined);
  }

  @Test
  void anAddressThatWasTakenIsOpenedOnceItIsFree() throws Exception {
    InetSocketAddress taken = join("127.0.0.2");
    InetSocketAddress free = join("127.0.0.3");
    try (CapturedLog log = CapturedLog.of(Relay.class)) {
      try (DatagramSocket other = new DatagramSocket(taken)) {
        assertThat(other.isBound()).isTrue();
        relay.look();
        relay.look();

        assertThat(relay.addresses()).as("those after it").hasSize(2).endsWith(free);
        assertThat(log.next()).startsWith("Port " + taken.getPort() + " of 127.0.0.2 is taken");
        assertThat(log.isEmpty()).as("told once").isTrue();
      }
      relay.look();

      assertThat(relay.addresses()).hasSize(3).endsWith(taken);
      assertThat(log.isEmpty()).isTrue();
    }
  }

  @Test
  void anObstacleThatComesBackIsToldAgain() throws Exception {
    InetSocketAddress taken = join("127.0.0.2");
    try (CapturedLog log = CapturedLog.of(Relay.class);
        DatagramSocket other = new DatagramSocket(taken)) {
      relay.look();
      String sentence = log.next();
      Member gone = members.remove(0);
      relay.look();
      members.add(gone);
      relay.look();

      assertThat(other.isBound()).isTrue();
      assertThat(log.next()).isEqualTo(sentence);
    }
  }
}
