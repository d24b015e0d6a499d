package tellosimulator.view.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.testing.CapturedLog;

/** The window's thread continues while its actions are carried out. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class SimulatorActionsTest {

  private static final List<InetAddress> LOOPBACK = List.of(InetAddress.getLoopbackAddress());

  private final CountDownLatch goOn = new CountDownLatch(1);
  private final CountDownLatch busy = new CountDownLatch(1);
  private final BlockingQueue<Boolean> answered = new LinkedBlockingQueue<>();
  private final OnlineSimulation simulation =
      new OnlineSimulation(
          SimConfig.DEFAULT.withStreamPorts(new StreamPorts(9, 9)),
          AddressPlan.portPerDrone(1, LOOPBACK, 0),
          OptionalInt.empty(),
          List.of(new Busy()));
  private final SimulatorActions actions = new SimulatorActions(simulation);

  /** Blocks the simulation thread until the test releases it. */
  private final class Busy implements SimListener {
    @Override
    public void stepped(SimSnapshot snapshot) {
      busy.countDown();
      try {
        goOn.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  @BeforeEach
  void listen() {
    actions.onAnswered(() -> answered.add(true));
  }

  @AfterEach
  void close() {
    goOn.countDown();
    actions.close();
    simulation.close();
  }

  private void settle() throws InterruptedException {
    while (actions.pending()) {
      answered.take();
      actions.collect();
      actions.deliver();
    }
  }

  /**
   * Otherwise it would read a snapshot that was taken before the answered action was carried out.
   */
  @Test
  void anAnswerThatComesAfterTheSnapshotWaitsForTheNextOne() throws InterruptedException {
    goOn.countDown();
    List<String> done = new ArrayList<>();
    actions.collect();
    actions.switchPower(1, true, refusal -> done.add("on"));
    answered.take();

    actions.deliver();
    assertThat(done).isEmpty();

    actions.collect();
    actions.deliver();
    assertThat(done).containsExactly("on");
  }

  @Test
  void whatFailedIsNotAnsweredAsDone() throws InterruptedException {
    goOn.countDown();
    List<String> done = new ArrayList<>();
    int noSuchDrone = 9;
    try (CapturedLog log = CapturedLog.of(ErrorPolicy.class)) {
      actions.switchPower(noSuchDrone, true, refusal -> done.add("on"));
      settle();

      assertThat(log.next()).startsWith("What was done in the window failed");
    }
    assertThat(done).isEmpty();
    assertThat(actions.pending()).isFalse();
  }

  @Test
  void nothingWaitsForASimulationThatIsBusy() throws InterruptedException {
    busy.await();
    List<String> done = new ArrayList<>();

    actions.carryOut(new Control.SetBattery(1, 42));
    actions.switchPower(1, true, refusal -> done.add("on"));
    actions.setCommandPort(1, 0, () -> done.add("port"));
    actions.setReachableFromNetwork(false, () -> done.add("reach"));
    actions.togglePause();
    actions.afterPending(() -> done.add("all"));
    actions.deliver();

    assertThat(actions.pending()).isTrue();
    assertThat(done).isEmpty();
    assertThat(actions.addresses(1)).hasSize(1);
    assertThat(actions.reachableFromNetwork()).isFalse();
    assertThat(simulation.snapshot().clock().paused()).isFalse();

    goOn.countDown();
    settle();

    assertThat(done).containsExactly("on", "port", "reach", "all");
    assertThat(simulation.snapshot().clock().paused()).isTrue();
    assertThat(simulation.snapshot().drones().get(0).state().energy().battery().percent())
        .isEqualTo(42);
  }

  @Test
  void twoTogglesInARowPauseAndGoOn() throws InterruptedException {
    goOn.countDown();

    actions.togglePause();
    actions.togglePause();
    settle();

    assertThat(simulation.snapshot().clock().paused()).isFalse();
  }

  @Test
  void aDroneThatStaysOffIsAnsweredAndToldOf() throws IOException, InterruptedException {
    goOn.countDown();
    List<String> told = new ArrayList<>();
    actions.onRefused((refusal, drone) -> told.add("drone " + drone));
    try (DatagramSocket other = new DatagramSocket(0, LOOPBACK.get(0))) {
      actions.setCommandPort(1, other.getLocalPort(), () -> {});
      actions.switchPower(1, true, refusal -> told.add(refusal.orElseThrow().getMessage()));
      settle();

      assertThat(told).hasSize(2).first().isEqualTo("drone 1");
      assertThat(told.get(1)).contains(Integer.toString(other.getLocalPort()));
    }
  }

  @Test
  void nothingPendingMeansAtOnce() {
    List<String> done = new ArrayList<>();

    actions.afterPending(() -> done.add("at once"));

    assertThat(done).containsExactly("at once");
  }

  @Test
  void thePowerSwitchHasAMethodOfItsOwn() {
    assertThatThrownBy(() -> actions.carryOut(new Control.Power(1, true)))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
