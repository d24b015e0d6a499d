package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;

/** The events about changes of operator, which name the new operator in each case. */
class OperatorChangesTest {

  private static final Peer FIRST = peer("192.168.1.7");
  private static final Peer SECOND = peer("192.168.1.8");

  private final List<SimEvent> events = new ArrayList<>();
  private final Simulation simulation =
      new Simulation(
          SimConfig.DEFAULT,
          drone -> datagram -> {},
          List.of(
              new SimListener() {
                @Override
                public void event(SimEvent event) {
                  events.add(event);
                }
              }));

  @BeforeEach
  void theFirstOneOperatesIt() {
    simulation.control(new Control.Power(1, true));
    send(FIRST, "command");
  }

  private enum Way {
    RELEASED {
      @Override
      void lose(OperatorChangesTest test) {
        test.simulation.control(new Control.Release(1));
      }
    },
    UNREACHABLE {
      @Override
      void lose(OperatorChangesTest test) {
        test.simulation.unreachable(1, FIRST.address());
      }
    },
    SILENT {
      @Override
      void lose(OperatorChangesTest test) {
        for (int i = 0; i < 60 * 200; i++) {
          test.simulation.step();
        }
      }
    },
    RESET {
      @Override
      void lose(OperatorChangesTest test) {
        test.simulation.control(new Control.Reset(1));
      }
    },
    SWITCHED_OFF {
      @Override
      void lose(OperatorChangesTest test) {
        test.simulation.control(new Control.Power(1, false));
        test.simulation.control(new Control.Power(1, true));
      }
    };

    abstract void lose(OperatorChangesTest test);
  }

  @ParameterizedTest
  @EnumSource
  void whoLosesTheDroneAndWhoHasItNowIsTold(Way way) {
    way.lose(this);
    send(SECOND, "command");

    assertThat(words())
        .contains(
            "is operated by 192.168.1.8 now, its state goes to port 8890 of that host;"
                + " 192.168.1.7 has lost it");

    send(FIRST, "takeoff");
    assertThat(words())
        .contains(
            "`takeoff` from "
                + FIRST
                + " turned away: the drone is operated by 192.168.1.8 now, which took over from"
                + " 192.168.1.7; release it to take it back");
  }

  @ParameterizedTest
  @EnumSource
  void whoGetsItBackHasLostNothing(Way way) {
    way.lose(this);
    send(FIRST, "command");

    assertThat(words()).noneMatch(words -> words.contains("is operated by") && lost(words));
  }

  @Test
  void aReleaseSaysWhoLosesIt() {
    Way.RELEASED.lose(this);
    simulation.drain();

    assertThat(words())
        .endsWith("is free: whoever sends `command` next operates it; 192.168.1.7 has lost it");
  }

  private static boolean lost(String words) {
    return words.endsWith("has lost it");
  }

  private List<String> words() {
    return events.stream().map(SimEvent::words).toList();
  }

  private void send(Peer peer, String text) {
    simulation.submit(1, peer, WireText.encode(text));
    simulation.step();
  }

  private static Peer peer(String host) {
    return new Peer(address(host, 40_000), address("192.168.1.2", 8879));
  }
}
