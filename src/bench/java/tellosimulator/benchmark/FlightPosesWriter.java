package tellosimulator.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.benchmark.FlightPoses.Moment;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.world.Room;

/**
 * Writes {@link FlightPoses}: a drone in the default room takes off 1.8 m behind the middle,
 * hovers, flies forward and turns by {@code rc}, in the simulator's own flight model. Parts begin
 * when its speed is steady. Running it writes the file anew.
 */
public final class FlightPosesWriter {

  private static final Vec3 START = new Vec3(-1.8, 0.4, 0);

  /** Decided: four seconds at 50 cm/s are 2 m of the room's 5. */
  private static final double SECONDS = 4;

  private static final int PICTURES_PER_SECOND = 30;

  /** Until a steady speed is reached [s]. */
  private static final double SETTLING = 1.5;

  private final SteppedDrone drone =
      SteppedDrone.of(
          SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(1, START, Room.DEFAULT)));

  private final List<Moment> moments = new ArrayList<>();

  private FlightPosesWriter() {}

  public static void main(String[] args) throws IOException {
    Files.write(FlightPoses.FILE, new FlightPosesWriter().flight().lines());
  }

  private FlightPoses flight() {
    drone.ask("command");
    drone.ask("takeoff");
    drone.ask("up 50");
    record(FlightPart.HOVER, "rc 0 0 0 0");
    record(FlightPart.FORWARD, "rc 0 50 0 0");
    drone.send("rc 0 0 0 0");
    drone.advance(SETTLING);
    record(FlightPart.TURN, "rc 0 0 0 55");
    return new FlightPoses(moments);
  }

  private void record(FlightPart part, String command) {
    drone.send(command);
    drone.advance(SETTLING);
    double begun = drone.seconds();
    for (int i = 0; i < SECONDS * PICTURES_PER_SECOND; i++) {
      double due = begun + (double) i / PICTURES_PER_SECOND;
      drone.advanceUntil(() -> drone.seconds() >= due, SECONDS);
      moments.add(new Moment(part, drone.seconds() - begun, drone.state().motion().pose()));
    }
  }
}
