package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.command.OperatorRule;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.Simulation;

class AdmissionControlTest {

  private static final String OPERATOR = "192.168.1.7";
  private static final String STRANGER = "192.168.1.8";
  private static final String FOREIGNER = "192.168.2.9";

  private static final LocalNetworks MACHINE =
      new LocalNetworks(List.of(new LocalNetworks.Member(host("192.168.1.2"), 24)));

  private final List<SimEvent.DatagramsDropped> dropped = new ArrayList<>();
  private long nanos;

  @Test
  void commandsOfTheOperatorsHostAlwaysPass() {
    Simulation simulation = operated(OperatorRule.FIRST);
    AdmissionControl admission = admission(simulation);

    assertThat(admitted(admission, OPERATOR, "battery?", 100_000)).isEqualTo(100_000);
    assertThat(admitted(admission, OPERATOR, "Re0101 forward 50", 100_000)).isEqualTo(100_000);
    assertThat(admitted(admission, OPERATOR, "\u00ccsticks", 100_000)).isEqualTo(100_000);
  }

  @Test
  void textsOfTheOperatorsHostThatAreNoCommandsAreLimited() {
    AdmissionControl admission = admission(operated(OperatorRule.FIRST));

    assertThat(admitted(admission, OPERATOR, "garbage", 100_000)).isEqualTo(1000);
    nanos += 1_000_000_000;
    assertThat(admitted(admission, OPERATOR, "garbage", 100_000)).isEqualTo(200);
    assertThat(admitted(admission, OPERATOR, "battery?", 100)).isEqualTo(100);
  }

  @Test
  void othersAreLimitedWhateverTheySendAndToldInASum() {
    Simulation simulation = operated(OperatorRule.FIRST);
    AdmissionControl admission = admission(simulation);

    int passed = admitted(admission, STRANGER, "battery?", 100_000);
    admission.report();
    admission.report();
    simulation.drain();

    assertThat(passed).isEqualTo(1000);
    assertThat(dropped).hasSize(1);
    assertThat(dropped.get(0).host()).isEqualTo(STRANGER);
    assertThat(dropped.get(0).count()).isEqualTo(100_000 - passed);
    assertThat(admitted(admission, OPERATOR, "battery?", 100)).isEqualTo(100);
  }

  @Test
  void whereEverybodyFliesNobodyIsAStranger() {
    AdmissionControl admission = admission(operated(OperatorRule.ANYONE));

    assertThat(admitted(admission, STRANGER, "rc 0 0 0 0", 10_000)).isEqualTo(10_000);
  }

  @Test
  void whatComesFromOtherNetworksNeverPassesAndIsCounted() {
    Simulation simulation = operated(OperatorRule.FIRST);
    AdmissionControl admission = admission(simulation);

    assertThat(admitted(admission, FOREIGNER, "command", 3)).isZero();
    admission.report();
    simulation.drain();

    assertThat(dropped).hasSize(1);
    assertThat(dropped.get(0).words())
        .isEqualTo(
            "3 datagrams from 192.168.2.9 turned away: only private addresses on this machine's own"
                + " networks are accepted; use --operator to allow another one");
  }

  @Test
  void theOneHostThatIsNamedPassesFromWhereverItIs() {
    OperatorRule named = OperatorRule.only(host(FOREIGNER));
    AdmissionControl admission = admission(operated(named));

    assertThat(admitted(admission, FOREIGNER, "command", 3)).isEqualTo(3);
  }

  @Test
  void howeverManyHostsThereAreTheyAreLimitedTogetherAndTheOperatorIsNot() {
    AdmissionControl admission = admission(operated(OperatorRule.FIRST));
    LocalNetworks wide =
        new LocalNetworks(List.of(new LocalNetworks.Member(host("192.168.1.2"), 16)));
    int passed = 0;
    for (int i = 0; i < 50_000; i++) {
      String forged = "192.168." + (2 + i / 250) + "." + i % 250;
      passed += admits(admission, forged, "command", wide) ? 1 : 0;
    }

    assertThat(passed).isEqualTo(2000);
    assertThat(admitted(admission, OPERATOR, "battery?", 100)).isEqualTo(100);
  }

  /** A test may switch its drone on and off many times a second. */
  @Test
  void nobodyIsTurnedAwayFromAFreeDroneAtAPaceThatProgramsHave() {
    Simulation simulation = operated(OperatorRule.FIRST);
    simulation.control(new Control.Release(1));
    simulation.drain();
    AdmissionControl admission = admission(simulation);
    for (int i = 0; i < 10_000; i++) {
      nanos += 5_000_000;
      assertThat(admitted(admission, STRANGER, "command", 1)).isEqualTo(1);
    }
  }

  private AdmissionControl admission(Simulation simulation) {
    return new AdmissionControl(1, simulation, () -> nanos);
  }

  private static int admitted(AdmissionControl admission, String host, String text, int times) {
    int admitted = 0;
    for (int i = 0; i < times; i++) {
      admitted += admits(admission, host, text, MACHINE) ? 1 : 0;
    }
    return admitted;
  }

  private static boolean admits(
      AdmissionControl admission, String host, String text, LocalNetworks networks) {
    byte[] bytes = WireText.encode(text);
    return admission.admits(host(host), host("192.168.1.2"), bytes, bytes.length, networks);
  }

  /** Returns a simulation with a drone that is on, and whose operator has sent {@code command}. */
  private Simulation operated(OperatorRule rule) {
    SimListener listener =
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            if (event instanceof SimEvent.DatagramsDropped told) {
              dropped.add(told);
            }
          }
        };
    Simulation simulation =
        new Simulation(
            SimConfig.DEFAULT.withOperators(rule), drone -> datagram -> {}, List.of(listener));
    simulation.control(new Control.Power(1, true));
    simulation.drain();
    simulation.submit(1, peer(OPERATOR), WireText.encode("command"));
    simulation.drain();
    return simulation;
  }

  private static Peer peer(String host) {
    return new Peer(
        new InetSocketAddress(host(host), 40_000), new InetSocketAddress("192.168.1.2", 8879));
  }

  private static InetAddress host(String name) {
    return address(name, 0).getAddress();
  }
}
