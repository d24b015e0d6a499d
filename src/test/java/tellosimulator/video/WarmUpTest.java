package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.VideoEncoder;
import tellosimulator.video.picture.Picture;
import tellosimulator.world.Room;

@Timeout(value = 20, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class WarmUpTest {

  private static final VideoFormat FORMAT = VideoFormat.of(VideoSettings.DEFAULT);

  private final BlockingQueue<SimSnapshot> filmed = new LinkedBlockingQueue<>();
  private final Simulation simulation =
      new Simulation(SimConfig.DEFAULT, drone -> (peer, text) -> {}, report -> {}, List.of());
  private final SimSnapshot snapshot = simulation.snapshot();

  /** An encoder that does nothing. */
  private static final class Idle implements VideoEncoder {
    @Override
    public void setRate(int framesPerSecond, int bitsPerSecond) {}

    @Override
    public AccessUnit encode(Picture picture, boolean key) {
      return FakePicture.of(5, 10);
    }
  }

  /** A camera that writes down what it films, and sees what the software camera does. */
  private final class Camera implements FrameSource {
    private final FrameSource eye;

    Camera(FrameSource eye) {
      this.eye = eye;
    }

    @Override
    public void film(SimSnapshot moment, CameraId shot, Picture picture) {
      filmed.add(moment);
    }

    @Override
    public Object sight(SimSnapshot moment, CameraId shot) {
      return eye.sight(moment, shot);
    }
  }

  private final SoftwareCameras cameras = new SoftwareCameras(DroneOptics.DEFAULT);
  private final Films films =
      new Films(() -> new Camera(cameras.get()), (width, height) -> new Idle());

  private WarmUp warmUp() {
    return new WarmUp(films);
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
  void theEarlyPictureIsTheFirstOfADroneThatHasNotMoved() throws InterruptedException {
    warmUp().beginEarly();
    filmed.take();
    WarmUp.finishEarly(films, snapshot);
    simulation.step();
    films.film(1).shoot(simulation.snapshot(), FORMAT);

    assertThat(filmed).isEmpty();
  }

  @Test
  void aDroneThatStandsElsewhereHasAnotherFirstPicture() throws InterruptedException {
    warmUp().beginEarly();
    filmed.take();
    simulation.control(new Control.SetStart(1, new Vec3(0.01, 0, 0), 0));
    simulation.drain();
    SimSnapshot elsewhere = simulation.snapshot();
    WarmUp.finishEarly(films, elsewhere);
    films.film(1).shoot(elsewhere, FORMAT);

    assertThat(filmed).containsExactly(elsewhere);
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
