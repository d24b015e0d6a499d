package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.testing.SteppedDrone.address;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Exceptions;
import tellosimulator.concurrent.Uncaught;
import tellosimulator.testing.CapturedLog;
import tellosimulator.testing.TextPort;
import tellosimulator.time.SimTime;
import tellosimulator.time.TimeFactor;

/** The thread of a simulation. Each wait of a test fails after a timeout. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class SimulationLoopTest {

  private static final Peer PEER =
      new Peer(address("192.168.10.2", 9000), address("192.168.10.1", 8889));

  private final BlockingQueue<String> replies = new LinkedBlockingQueue<>();

  @Test
  void asFastAsPossibleAFlightTakesNoTime() throws InterruptedException {
    Simulation simulation = simulation(TimeFactor.MAX);
    try (SimulationLoop loop = new SimulationLoop(simulation)) {
      assertThat(loop).isNotNull();
      assertThat(ask(simulation, "command")).isEqualTo("ok");
      assertThat(ask(simulation, "takeoff")).isEqualTo("ok");
      assertThat(ask(simulation, "forward 50")).isEqualTo("ok");
      assertThat(ask(simulation, "land")).isEqualTo("ok");
    }
    assertThat(simulation.snapshot().time().seconds()).isGreaterThan(6);
  }

  /** Runs at a factor that no machine can keep up with. */
  @Test
  void timeThatIsLostBeforeTheFirstCommandIsNoLoss() throws InterruptedException {
    CountDownLatch begun = new CountDownLatch(20_000);
    CountDownLatch lost = new CountDownLatch(1);
    List<Double> losses = Collections.synchronizedList(new ArrayList<>());
    SimListener listener =
        new SimListener() {
          @Override
          public void stepped(SimSnapshot snapshot) {
            losses.add(snapshot.clock().lostSeconds());
            begun.countDown();
            if (snapshot.clock().lostSeconds() > 0) {
              lost.countDown();
            }
          }
        };
    Simulation simulation =
        new Simulation(
            SimConfig.DEFAULT.withTimeFactor(new TimeFactor(TimeFactor.LARGEST)),
            drone -> TextPort.replies(replies::add),
            List.of(listener));
    simulation.control(new Control.Power(1, true));
    try (SimulationLoop loop = new SimulationLoop(simulation)) {
      assertThat(loop).isNotNull();
      assertThat(begun.await(20, TimeUnit.SECONDS)).isTrue();
      assertThat(List.copyOf(losses)).containsOnly(0.0);

      assertThat(ask(simulation, "command")).isEqualTo("ok");
      assertThat(lost.await(20, TimeUnit.SECONDS)).isTrue();
    }
  }

  @Test
  void inAPauseCommandsAreTakenButTimeStandsStill() throws InterruptedException {
    Simulation simulation = simulation(new TimeFactor(100));
    simulation.control(new Control.Pause(true));
    try (SimulationLoop loop = new SimulationLoop(simulation)) {
      assertThat(loop).isNotNull();
      assertThat(ask(simulation, "command")).isEqualTo("ok");
      simulation.submit(1, PEER, WireText.encode("takeoff"));
      assertThat(ask(simulation, "battery?")).isEqualTo("error Not joystick");
      assertThat(simulation.snapshot().time()).isEqualTo(SimTime.ZERO);

      simulation.control(new Control.Pause(false));
      assertThat(reply()).isEqualTo("ok");
      assertThat(simulation.snapshot().time().seconds()).isGreaterThan(2);
    }
  }

  @Test
  void aBurstThatIsTakenInPartsIsAnsweredInFullAlsoInAPause() throws InterruptedException {
    int burst = 3000;
    Simulation simulation = simulation(TimeFactor.REAL_TIME);
    simulation.control(new Control.Pause(true));
    for (int i = 0; i < burst; i++) {
      Peer one = new Peer(address("127.0.0.1", 20_000 + i % 100), PEER.via());
      assertThat(simulation.submit(1, one, WireText.encode("command"))).isTrue();
    }

    try (SimulationLoop loop = new SimulationLoop(simulation)) {
      assertThat(loop).isNotNull();
      for (int i = 0; i < burst; i++) {
        assertThat(reply()).isEqualTo("ok");
      }
    }
  }

  @Test
  void aPortThatThrowsDoesNotEndTheThread() throws InterruptedException {
    List<String> broken = new ArrayList<>(List.of("replies", "states"));
    Simulation simulation =
        new Simulation(
            SimConfig.DEFAULT.withTimeFactor(TimeFactor.MAX),
            drone ->
                TextPort.of(
                    text -> {
                      replies.add(text);
                      failOnce(broken, "replies");
                    },
                    line -> failOnce(broken, "states")),
            List.of());
    simulation.control(new Control.Power(1, true));

    try (CapturedLog commands = CapturedLog.of(Simulation.class);
        CapturedLog steps = CapturedLog.of(ErrorPolicy.class);
        SimulationLoop loop = new SimulationLoop(simulation)) {
      assertThat(loop).isNotNull();
      assertThat(ask(simulation, "command")).isEqualTo("ok");
      assertThat(ask(simulation, "takeoff")).isEqualTo("ok");
      assertThat(broken).isEmpty();
      assertThat(commands.next()).startsWith("A command could not be handled; please report this");
      assertThat(steps.next()).startsWith("A step of the simulation failed; please report this");
    }
  }

  @Test
  void aControlThatIsCarriedOutShowsInTheNextSnapshot() {
    Simulation simulation = simulation(TimeFactor.REAL_TIME);
    try (SimulationLoop loop = new SimulationLoop(simulation)) {
      for (int percent = 100; percent > 0; percent--) {
        loop.carryOut(new Control.SetBattery(1, percent));
        assertThat(simulation.snapshot().drones().get(0).state().energy().battery().percent())
            .isEqualTo(percent);
      }
    }
  }

  @Test
  void aControlThatCannotBeCarriedOutKeepsNobodyWaiting() throws InterruptedException {
    Simulation simulation = simulation(TimeFactor.REAL_TIME);
    try (CapturedLog log = CapturedLog.of(Simulation.class);
        SimulationLoop loop = new SimulationLoop(simulation)) {
      loop.carryOut(new Control.SetStart(1, null));
      assertThat(log.next()).startsWith("A control could not be carried out; please report this");
      loop.carryOut(new Control.SetBattery(1, 42));
    }

    assertThat(simulation.snapshot().drones().get(0).state().energy().battery().percent())
        .isEqualTo(42);
  }

  /** A program that waits for the state after {@code mon} must not wait for ever. */
  @Test
  void asFastAsPossibleAStateLineFollowsEachCommand() throws InterruptedException {
    BlockingQueue<String> lines = new LinkedBlockingQueue<>();
    Simulation simulation =
        new Simulation(
            SimConfig.DEFAULT.withTimeFactor(TimeFactor.MAX),
            drone -> TextPort.of(replies::add, lines::add),
            List.of());
    simulation.control(new Control.Power(1, true));
    try (SimulationLoop loop = new SimulationLoop(simulation)) {
      assertThat(loop).isNotNull();
      assertThat(ask(simulation, "command")).isEqualTo("ok");
      assertThat(lines.poll(20, TimeUnit.SECONDS)).isNotNull();
      assertThat(ask(simulation, "mon")).isEqualTo("ok");

      String line = lines.poll(20, TimeUnit.SECONDS);
      while (line != null && line.startsWith("mid:-2;")) {
        line = lines.poll(20, TimeUnit.SECONDS);
      }
      assertThat(line).as("a state line with detection on").isNotNull();
    }
  }

  @Test
  void closingWaitsUntilTheThreadHasEnded() {
    Simulation simulation = simulation(TimeFactor.REAL_TIME);
    SimulationLoop loop = new SimulationLoop(simulation);

    loop.close();
    SimTime end = simulation.snapshot().time();
    simulation.submit(1, PEER, WireText.encode("command"));
    loop.close();

    assertThat(simulation.snapshot().time()).isEqualTo(end);
    assertThat(replies).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("errors")
  void anErrorInAPortDoesNotEndTheThread(Error error) throws InterruptedException {
    AtomicReference<Error> replyFailure = new AtomicReference<>(error);
    AtomicReference<Error> stateFailure = new AtomicReference<>(error);
    Simulation simulation =
        new Simulation(
            SimConfig.DEFAULT.withTimeFactor(TimeFactor.MAX),
            drone ->
                TextPort.of(
                    text -> {
                      replies.add(text);
                      throwOnce(replyFailure);
                    },
                    line -> throwOnce(stateFailure)),
            List.of());
    simulation.control(new Control.Power(1, true));

    try (CapturedLog commands = CapturedLog.of(Simulation.class);
        CapturedLog steps = CapturedLog.of(ErrorPolicy.class);
        SimulationLoop loop = new SimulationLoop(simulation)) {
      assertThat(loop).isNotNull();
      assertThat(ask(simulation, "command")).isEqualTo("ok");
      assertThat(ask(simulation, "takeoff")).isEqualTo("ok");
      assertThat(stateFailure).hasNullValue();
      assertThat(steps.next()).startsWith("A step of the simulation failed");
      assertThat(commands.isEmpty()).isEqualTo(Exceptions.isFatal(error));
    }
  }

  static List<Error> errors() {
    return List.of(
        new OutOfMemoryError("broken on purpose"),
        new StackOverflowError("broken on purpose"),
        new NoClassDefFoundError("broken/on/purpose"));
  }

  @Test
  void whoWaitsForASimulationThatCannotGoOnIsTold() throws InterruptedException {
    OutOfMemoryError failure = new OutOfMemoryError("broken on purpose");
    AtomicReference<Error> failing = new AtomicReference<>();
    SimListener listener =
        new SimListener() {
          @Override
          public void stepped(SimSnapshot snapshot) {
            if (failing.get() != null) {
              throw failing.get();
            }
          }
        };
    Simulation simulation =
        new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of(listener));
    try (Uncaught uncaught = new Uncaught();
        CapturedLog log = CapturedLog.of(ErrorPolicy.class);
        SimulationLoop loop = new SimulationLoop(simulation)) {
      loop.carryOut(new Control.Power(1, true));
      failing.set(failure);

      assertThat(uncaught.await()).isSameAs(failure);
      assertThat(uncaught.thread().getName()).isEqualTo("sim");
      assertThat(log.next()).startsWith("A step of the simulation failed: memory is full");
      assertThatThrownBy(() -> loop.carryOut(new Control.Power(1, false)))
          .isInstanceOf(IllegalStateException.class)
          .hasMessage("the simulation has ended because of an error");
    }
  }

  private static void throwOnce(AtomicReference<Error> error) {
    Error thrown = error.getAndSet(null);
    if (thrown != null) {
      throw thrown;
    }
  }

  private static void failOnce(List<String> broken, String port) {
    if (broken.remove(port)) {
      throw new IllegalStateException("broken on purpose");
    }
  }

  private String ask(Simulation simulation, String text) throws InterruptedException {
    simulation.submit(1, PEER, WireText.encode(text));
    return reply();
  }

  private String reply() throws InterruptedException {
    String reply = replies.poll(20, TimeUnit.SECONDS);
    assertThat(reply).as("a reply within 20 s").isNotNull();
    return reply;
  }

  private Simulation simulation(TimeFactor factor) {
    Simulation simulation =
        new Simulation(
            SimConfig.DEFAULT.withTimeFactor(factor),
            drone -> TextPort.replies(replies::add),
            List.of());
    simulation.control(new Control.Power(1, true));
    return simulation;
  }
}
