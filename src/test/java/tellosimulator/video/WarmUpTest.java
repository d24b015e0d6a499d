package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.model.DroneState;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.EncodedPicture;
import tellosimulator.video.codec.VideoEncoder;
import tellosimulator.video.picture.Picture;
import tellosimulator.world.Room;

@Timeout(value = 20, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class WarmUpTest {

  private final BlockingQueue<SimSnapshot> filmed = new LinkedBlockingQueue<>();
  private final SimSnapshot snapshot =
      new Simulation(SimConfig.DEFAULT, drone -> (peer, text) -> {}, report -> {}, List.of())
          .snapshot();

  /** An encoder that does nothing. */
  private static final class Idle implements VideoEncoder {
    @Override
    public void setRate(int framesPerSecond, int bitsPerSecond) {}

    @Override
    public EncodedPicture encode(Picture picture, boolean key) {
      return FakePicture.of(5, 10);
    }
  }

  private WarmUp warmUp() {
    FrameSource source = (moment, shot, picture) -> filmed.add(moment);
    return new WarmUp(() -> source, (width, height) -> new Idle());
  }

  @Test
  void beforeThereIsASimulationItFilmsTheDefaultRoomOnce() throws InterruptedException {
    warmUp().beginEarly();

    SimSnapshot early = filmed.take();
    assertThat(early.room()).isEqualTo(Room.DEFAULT);
    assertThat(early.drones()).hasSize(1);
    assertThat(filmed.poll(1, TimeUnit.SECONDS)).isNull();
  }

  @Test
  void whoWaitsForTheEarlyPictureGetsIt() throws InterruptedException {
    WarmUp warmUp = warmUp();
    warmUp.beginEarly();
    warmUp.awaitEarly();

    assertThat(filmed).hasSize(1);
  }

  @Test
  void itTurnsTheDroneOfTheSimulation() throws InterruptedException {
    warmUp().begin(() -> snapshot);

    double first = heading(filmed.take());
    assertThat(heading(filmed.take())).isGreaterThan(first);
  }

  @Test
  void itMakesRoomForADroneThatIsFilmedInEarnest() throws InterruptedException {
    DroneSnapshot drone = snapshot.drones().get(0);
    DroneState now = drone.state();
    DroneState asked =
        new DroneState(
            now.drone(),
            now.time(),
            now.motion(),
            now.phase(),
            now.energy(),
            now.reference(),
            now.perception(),
            VideoSettings.DEFAULT.started());
    SimSnapshot filming = snapshot.withDrones(List.of(drone.withState(asked)));

    warmUp().begin(() -> filming);

    assertThat(filmed.poll(1, TimeUnit.SECONDS)).isNull();
  }

  @Test
  void onceClosedItFilmsNothing() throws InterruptedException {
    WarmUp warmUp = warmUp();
    warmUp.close();
    warmUp.begin(() -> snapshot);

    assertThat(filmed.poll(1, TimeUnit.SECONDS)).isNull();
  }

  private static double heading(SimSnapshot moment) {
    return moment.drones().get(0).state().motion().pose().attitude().heading();
  }
}
