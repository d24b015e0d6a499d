package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.testing.SteppedDrone.address;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.TextPort;
import tellosimulator.time.PendingWork;
import tellosimulator.time.SimTime;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Room;
import tellosimulator.world.Wind;

/**
 * The simulated moment at which a datagram is handled at unlimited speed, which depends on the
 * earlier datagrams alone.
 */
class TakingTest {

  private static final Peer PEER =
      new Peer(address("192.168.10.2", 9000), address("192.168.10.1", 8889));

  /** Number of steps that exceeds every wait: one minute. */
  private static final int MANY = 12_000;

  private final List<String> replies = new ArrayList<>();
  private Simulation simulation = simulation(config(Vec3.ZERO, new Vec3(0, 1, 0)));

  /** State lines are due at 0, 0.1, 0.2 s and so on, each sent at the end of a step. */
  @ParameterizedTest
  @CsvSource({"battery?", "speed 30", "mon", "foo", "rc 0 0 0 0", "land", "stop"})
  void theNextOneIsTakenAfterTheStateLine(String first) {
    ask(1, "command");
    ask(1, "battery?"); // after the line at 0 s, at the end of the first step
    assertThat(seconds()).isCloseTo(0.005, within(1e-9));

    submit(1, first);
    submit(1, "time?");
    runWhile(PendingWork.REPLY);
  }

  @Test
  void stopIsOverWithItsSecondAnswer() {
    fly(1, "command", "takeoff");
    fly(1, "stop");

    submit(1, "battery?");
    runWhile(PendingWork.REPLY);

    assertThat(replies.subList(2, 5)).containsExactly("ok", "forced stop", "100");
  }

  @Test
  void afterEmergencyTheDroneIsOnTheGround() {
    fly(1, "command", "takeoff", "up 100");
    submit(1, "emergency");
    simulation.drain();

    assertThat(ask(1, "height?")).isEqualTo("0dm");
  }

  /** A drone restarts 3 s after the reply, and is silent for 8 s. */
  @Test
  void whatComesDuringARestartIsTakenAfterIt() {
    simulation =
        simulation(
            config(Vec3.ZERO)
                .withProduct(Profile.EDU, Behavior.MEASURED)
                .withLink(LinkPreset.IDEAL));
    ask(1, "command");
    ask(1, "wifi name password");

    assertThat(ask(1, "command")).isEqualTo("ok");
    assertThat(seconds()).isBetween(11.0, 12.0);
  }

  @Test
  void whileSomebodyWaitsForAnAnswerOthersAreTakenAtOnce() {
    fly(1, "command", "takeoff");
    fly(2, "command");
    runWhile(PendingWork.REPLY);
    submit(1, "forward 100");
    simulation.drain();
    double begun = seconds();

    submit(2, "battery?");
    submit(2, "time?");
    submit(1, "up 50");
    simulation.drain();

    assertThat(seconds()).isEqualTo(begun);
    assertThat(replies.subList(3, 6)).containsExactly("100", "0s", "error Not joystick");
  }

  @Test
  void aDroneThatIsSteeredKeepsNobodyWaiting() {
    fly(1, "command", "takeoff");
    submit(1, "rc 0 20 0 0");
    runWhile(PendingWork.REPLY);
    double moved = seconds();
    assertThat(simulation.demand()).isEqualTo(PendingWork.MOTION);

    submit(1, "height?");
    simulation.drain();

    assertThat(replies.get(2)).isEqualTo("3dm");
    assertThat(seconds()).isEqualTo(moved);
  }

  @Test
  void centeredSticksComeToRest() {
    fly(1, "command", "takeoff");
    submit(1, "rc 30 30 30 30");
    runWhile(PendingWork.REPLY);
    submit(1, "rc 0 0 0 0");
    simulation.drain();
    double centered = seconds();
    runWhile(PendingWork.REPLY);

    assertThat(simulation.demand()).isEqualTo(PendingWork.NONE);
    assertThat(seconds() - centered).isLessThan(8);
  }

  /** In gusts no drone stands still, so `stop` gets no second reply. */
  @Test
  void whatNeverEndsIsWaitedForForTwentySeconds() {
    SimConfig calm = config(Vec3.ZERO);
    DroneSetup patient = calm.drones().get(0).withoutSafetyLanding();
    Arena stormy =
        calm.arena().withRoom(new Room(50, 50, 10)).withWind(new Wind(new Vec3(2, 0, 0), 6));
    simulation = simulation(calm.withArena(stormy).withDrones(List.of(patient)));
    fly(1, "command", "takeoff", "stop");
    double last = seconds();
    runWhile(PendingWork.REPLY);
    assertThat(seconds() - last).isCloseTo(20, within(0.01));
    assertThat(simulation.demand()).isEqualTo(PendingWork.MOTION);

    submit(1, "sdk?");
    simulation.drain();
    assertThat(replies.get(replies.size() - 1)).isEqualTo("20");
  }

  @ParameterizedTest
  @CsvSource({"1, false", "20, false", "1, true"})
  void byTheClockOrInAPauseEverythingIsTakenAtOnce(double factor, boolean paused) {
    simulation = simulation(config(Vec3.ZERO).withTimeFactor(new TimeFactor(factor)));
    simulation.control(new Control.Pause(paused));
    submit(1, "command");
    submit(1, "battery?");
    submit(1, "time?");
    simulation.drain();

    assertThat(replies).containsExactly("ok", "100", "0s");
  }

  /** After `mon` a state line is pending; later inputs wait for it, even controls. */
  @Test
  void asFastAsPossibleAControlWaitsForWhatCommandsBeforeItHaveCaused() {
    ask(1, "command");
    ask(1, "battery?");
    submit(1, "mon");
    submit(1, "battery?");
    simulation.control(new Control.SetBattery(1, 40));
    simulation.drain();
    assertThat(simulation.snapshot().drones().get(0).state().energy().battery().percent())
        .isEqualTo(100);

    submit(1, "battery?");
    runWhile(PendingWork.REPLY);
    simulation.drain();
    runWhile(PendingWork.REPLY);
    assertThat(replies.subList(2, 5)).containsExactly("ok", "100", "40");
  }

  @Test
  void aPauseOfWhatRunsAsFastAsPossibleKeepsNobodyWaiting() {
    simulation.control(new Control.Pause(true));
    submit(1, "command");
    submit(1, "battery?");
    submit(1, "time?");
    simulation.drain();

    assertThat(replies).containsExactly("ok", "100", "0s");
  }

  private void fly(int drone, String... commands) {
    for (String command : commands) {
      ask(drone, command);
    }
  }

  /** Sends a command, lets time pass until its reply, and returns the reply. */
  private String ask(int drone, String command) {
    int before = replies.size();
    submit(drone, command);
    simulation.drain();
    for (int i = 0; i < MANY && replies.size() == before; i++) {
      simulation.step();
      simulation.drain();
    }
    return replies.get(before);
  }

  private void submit(int drone, String command) {
    assertThat(simulation.submit(drone, PEER, WireText.encode(command))).isTrue();
  }

  private void runWhile(PendingWork demand) {
    simulation.drain();
    for (int i = 0; i < MANY && simulation.demand() == demand; i++) {
      simulation.step();
      simulation.drain();
    }
  }

  private double seconds() {
    return simulation.snapshot().time().since(SimTime.ZERO);
  }

  private static SimConfig config(Vec3... starts) {
    List<Pose> poses = Stream.of(starts).map(start -> new Pose(start, Attitude.LEVEL)).toList();
    return SimConfig.DEFAULT.withRoom(Room.DEFAULT, poses).withTimeFactor(TimeFactor.MAX);
  }

  private Simulation simulation(SimConfig config) {
    Simulation made =
        new Simulation(
            config, drone -> TextPort.replies(text -> replies.add(text.strip())), List.of());
    for (int drone = 1; drone <= config.drones().size(); drone++) {
      made.control(new Control.Power(drone, true));
    }
    return made;
  }
}
