package tellosimulator.replay;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.goal.Challenge;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.recording.InitialConditions;
import tellosimulator.recording.RecordedInputs.RecordedInput;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimInput;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.time.SimTime;
import tellosimulator.world.Room;
import tellosimulator.world.Wind;

/**
 * A recorded flight of hours, whose battery is charged in the air. In each simulated second, a
 * seeded generator chooses a maneuver or a read command; there are occasional gusts of wind.
 */
public final class LongFlight implements Inputs {

  private static final int DRONE = 1;
  private static final int CHARGED_EVERY = 300;
  private static final int GUST_EVERY = 97;

  private static final InetSocketAddress OPERATOR = SteppedDrone.address("127.0.0.1", 9001);
  private static final InetSocketAddress COMMANDS = SteppedDrone.address("127.0.0.1", 8889);

  /** Seconds between maneuvers, so that each is completed. */
  private static final int MANEUVER_EVERY = 5;

  /** Maneuvers that together lead back to the starting point. */
  private static final List<String> MANEUVERS =
      List.of(
          "forward 60",
          "flip l",
          "cw 180",
          "forward 60",
          "flip l",
          "ccw 180",
          "rc 10 -10 5 30",
          "rc -10 10 -5 -30",
          "rc 0 0 0 0",
          "curve 25 25 0 0 50 0 30",
          "right 50",
          "up 20",
          "down 20",
          "stop");

  private static final List<String> READS =
      List.of("battery?", "attitude?", "tof?", "baro?", "time?", "takeoff", "nonsense");

  private static final Room HALL = new Room(Room.LONGEST, Room.LONGEST, 10);

  private static final SimConfig CONFIG =
      SimConfig.DEFAULT
          .withRoom(HALL, Formation.row(1, Vec3.ZERO, HALL))
          .withProduct(Profile.EDU, Behavior.MEASURED)
          .withSeed(5);

  private final Random random = new Random(1);
  private final long seconds;
  private long second;
  private boolean charged;

  private LongFlight(double hours) {
    seconds = Math.round(hours * 3600);
  }

  /**
   * Records such a flight and replays the recording.
   *
   * @param parent the folder for both recordings
   */
  public static Repetition repeat(double hours, Path parent)
      throws IOException, UnreadableRecordingException {
    LongFlight flight = new LongFlight(hours);
    Path recorded =
        new RepeatedFlight(
                new InitialConditions(CONFIG, Challenge.NONE, OptionalInt.empty()),
                "A long flight",
                Scenario.of(CONFIG),
                flight,
                RecordingFolder.at(parent.resolve("recorded")))
            .fly();
    return Replay.of(recorded).repeat(RecordingFolder.at(parent.resolve("replayed")));
  }

  private static SimTime at(long second) {
    return SimTime.ZERO.plus((double) second);
  }

  @Override
  public boolean goesOn(SimTime now) {
    return now.isBefore(at(seconds));
  }

  @Override
  public Optional<RecordedInput> due(SimTime time) {
    if (second > seconds || time.isBefore(at(second))) {
      return Optional.empty();
    }
    if (second % CHARGED_EVERY == 0 && !charged) {
      charged = true;
      Control control =
          second == 0 ? new Control.Power(DRONE, true) : new Control.SetBattery(DRONE, 100);
      return Optional.of(new RecordedInput(at(second), new SimInput.Act(control)));
    }
    charged = false;
    SimTime now = at(second);
    SimInput input =
        second % GUST_EVERY == GUST_EVERY - 1
            ? new SimInput.Act(new Control.SetWind(wind()))
            : new SimInput.Datagram(DRONE, new Peer(OPERATOR, COMMANDS), WireText.encode(word()));
    second++;
    return Optional.of(new RecordedInput(now, input));
  }

  private Wind wind() {
    Vec3 speed = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 0);
    return new Wind(speed, random.nextDouble());
  }

  private String word() {
    if (second < MANEUVER_EVERY) {
      return second == 1 ? "takeoff" : "command";
    }
    int maneuver = (int) (second / MANEUVER_EVERY) % MANEUVERS.size();
    return second % MANEUVER_EVERY == 0
        ? MANEUVERS.get(maneuver)
        : READS.get(random.nextInt(READS.size()));
  }
}
