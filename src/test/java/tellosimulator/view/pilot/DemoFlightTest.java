package tellosimulator.view.pilot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramSocket;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.pilot.DemoFlight.Stage;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Message;
import tellosimulator.world.Room;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@Tag("slow")
class DemoFlightTest {

  /** The 15 s without commands after which a drone lands pass in less than half a second. */
  private static final SimConfig FAST =
      SimConfig.DEFAULT
          .withTimeFactor(new TimeFactor(40))
          .withLink(LinkPreset.IDEAL)
          .withDrones(
              SimConfig.DEFAULT.drones().stream().map(DroneSetup::withoutSafetyLanding).toList());

  private FlownWindow window = new FlownWindow(FAST);
  private DemoFlight demo = new DemoFlight(window.context());

  @AfterEach
  void close() {
    demo.close();
    window.close();
  }

  private void restart(SimConfig config) {
    close();
    window = new FlownWindow(config);
    demo = new DemoFlight(window.context());
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          1,   EDU,   REPORT,   40
          1.5, EDU,   MEASURED, 40
          5,   TELLO, REPORT,   max
          20,  TT,    MEASURED, max
          """)
  void fliesATourThroughTheRealPort(
      double edge, Profile profile, Behavior behavior, String factor) {
    double corner = edge / 2 - 0.1;
    Pose start = new Pose(new Vec3(-corner, corner, 0), Attitude.LEVEL);
    restart(
        FAST.withProduct(profile, behavior)
            .withTimeFactor(
                factor.equals("max") ? TimeFactor.MAX : new TimeFactor(Double.parseDouble(factor)))
            .withRoom(new Room(edge, edge, edge), List.of(start)));

    switchOnAndStart();
    assertThat(demo.runningProperty().get()).isTrue();
    int steps = demo.stepProperty().get().count();
    window.tickUntil(() -> !demo.runningProperty().get());

    assertThat(problem()).isEmpty();
    assertThat(window.phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(window.commands()).hasSize(steps + 1).contains("rc 0 0 0 0", "takeoff", "land");
    assertThat(window.events())
        .noneMatch(SimEvent.CommandRefused.class::isInstance)
        .noneMatch(SimEvent.CommandFailed.class::isInstance);
  }

  @Test
  void tellsWhichCommandRuns() {
    switchOnAndStart();
    window.tickUntil(() -> demo.stepProperty().get().command().equals("takeoff"));

    assertThat(demo.stepProperty().get().number()).isEqualTo(2);
    assertThat(demo.stepProperty().get().count()).isEqualTo(15);
    assertThat(demo.stageProperty().get()).isEqualTo(Stage.FLYING);
  }

  @ParameterizedTest
  @CsvSource({"EDU, REPORT", "EDU, MEASURED", "TELLO, REPORT", "TELLO, MEASURED"})
  void landsWhenItIsStoppedInAMove(Profile profile, Behavior behavior) {
    restart(FAST.withProduct(profile, behavior));
    switchOnAndStart();
    window.tickUntil(() -> demo.stepProperty().get().command().startsWith("curve"));

    demo.stop();

    assertThat(demo.stageProperty().get()).isEqualTo(Stage.LANDING);
    window.tickUntil(() -> !demo.runningProperty().get());
    assertThat(window.phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(window.commands()).doesNotContain("flip f").contains("land");
    assertThat(problem()).isEmpty();
  }

  @Test
  void landsWhenItIsStoppedDuringTakeoff() {
    switchOnAndStart();
    window.tickUntil(() -> demo.stepProperty().get().command().equals("takeoff"));

    demo.stop();

    window.tickUntil(() -> !demo.runningProperty().get());
    assertThat(window.phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(window.commands()).doesNotContain("up 90");
  }

  @Test
  void stoppingBeforeTakeoffNeedsNoLanding() {
    window.carryOut(new Control.Power(1, true));
    window.tick();

    demo.start();
    demo.stop();

    window.tickUntil(() -> !demo.runningProperty().get());
    assertThat(window.commands()).doesNotContain("takeoff", "land");
  }

  @Test
  void stoppingBeforeThePowerIsOnKeepsItOnTheFloor() {
    demo.switchOnAndStart();
    demo.stop();
    window.settle();

    assertThat(demo.runningProperty().get()).isFalse();
    assertThat(window.phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void waitsAsLongAsTimeStandsStill() {
    switchOnAndStart();
    window.tickUntil(() -> demo.stepProperty().get().command().startsWith("forward"));
    window.carryOut(new Control.Pause(true));
    long now = System.nanoTime();

    for (int minute = 0; minute < 10; minute++) {
      window.context().ticker().tick(now + TimeUnit.MINUTES.toNanos(minute));
    }
    assertThat(demo.stageProperty().get()).isEqualTo(Stage.FLYING);

    window.carryOut(new Control.Pause(false));
    window.tickUntil(() -> !demo.runningProperty().get());
    assertThat(problem()).isEmpty();
  }

  @Test
  void saysThatTheDroneWasSwitchedOff() {
    switchOnAndStart();
    window.tickUntil(() -> demo.stepProperty().get().command().startsWith("forward"));

    window.carryOut(new Control.Power(1, false));

    window.tickUntil(() -> !demo.runningProperty().get());
    assertThat(problem()).isEqualTo("Drone 1 was switched off.");
  }

  @Test
  void saysThatTheDroneCameDown() {
    switchOnAndStart();
    window.tickUntil(() -> window.commands().contains("flip f"));

    window.carryOut(new Control.Reset(1));

    window.tickUntil(() -> !demo.runningProperty().get());
    assertThat(problem()).isEqualTo("The drone came down during “flip f”.");
    assertThat(window.commands()).doesNotContain("land");
  }

  @Test
  void endsWithTheDronesRefusalAndLands() {
    switchOnAndStart();
    window.tickUntil(() -> demo.stepProperty().get().command().startsWith("curve"));

    window.carryOut(new Control.SetBattery(1, 30));

    window.tickUntil(() -> !demo.runningProperty().get());
    assertThat(problem()).isEqualTo("The drone answered “error” to “flip f”; the log says why.");
    assertThat(window.phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void aDroneThatIsOffIsNotFlown() {
    demo.start();

    assertThat(demo.runningProperty().get()).isFalse();
    assertThat(problem()).isEqualTo("Drone 1 is off. Switch it on first.");
  }

  @Test
  void aDroneInTheAirIsNotFlown() {
    switchOnAndStart();
    window.tickUntil(() -> demo.stepProperty().get().command().startsWith("forward"));
    DemoFlight second = new DemoFlight(window.context());

    second.start();

    assertThat(second.runningProperty().get()).isFalse();
    assertThat(second.problemProperty().get()).isEqualTo(Message.of("not-on-the-floor"));
  }

  @Test
  void saysWhoHasThePort() throws IOException {
    try (DatagramSocket other = new DatagramSocket()) {
      window.setCommandPort(other.getLocalPort());
      switchOnAndStart();

      assertThat(demo.runningProperty().get()).isFalse();
      assertThat(problem()).startsWith("Port " + other.getLocalPort() + " of 127.0.0.1 is taken");
    }
    switchOnAndStart();
    assertThat(problem()).isEmpty();
    assertThat(demo.runningProperty().get()).isTrue();
  }

  @Test
  void closingLeavesTheDroneAlone() {
    switchOnAndStart();
    window.tickUntil(() -> demo.stepProperty().get().command().startsWith("forward"));
    window.tickUntil(() -> window.commands().stream().anyMatch(text -> text.startsWith("forward")));
    int commands = window.commands().size();

    demo.close();
    window.tick();

    assertThat(demo.runningProperty().get()).isFalse();
    assertThat(window.commands()).hasSize(commands);
  }

  private void switchOnAndStart() {
    demo.switchOnAndStart();
    window.settle();
  }

  private String problem() {
    return demo.problemProperty()
        .get()
        .now(new Language(Locale.ENGLISH).messages(DemoFlight.class));
  }
}
