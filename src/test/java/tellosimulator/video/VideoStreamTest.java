package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.fault.Fault;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Scene;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.CapturedLog;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.CameraView;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.video.picture.Picture;

/** The pictures that a stream renders, and its reaction to failures. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class VideoStreamTest {

  private static final Peer OPERATOR =
      new Peer(address("127.0.0.1", 50_000), address("127.0.0.1", 8879));

  private static final String RESTS = "The video of drone 1 rests until the next streamon: ";

  private static final SimConfig CONFIG = SimConfig.DEFAULT.withStreamPorts(new StreamPorts(9, 9));

  private final Simulation simulation = new Simulation(CONFIG, drone -> datagram -> {}, List.of());
  private final AtomicReference<Error> failure = new AtomicReference<>();
  private final BlockingQueue<String> filmed = new LinkedBlockingQueue<>();
  private final AtomicReference<CameraView> view = new AtomicReference<>(view(0));
  private final AtomicInteger films = new AtomicInteger();
  private final Semaphore looks = new Semaphore(0);
  private final CapturedLog log = CapturedLog.of(ErrorPolicy.class);
  private final VideoStream stream =
      new VideoStream(1, this::look, () -> new FramePipeline(1, source(), H264Encoder::new));

  /** Returns the view of a drone at some height [m]. */
  private static CameraView view(double height) {
    Pose pose = new Pose(new Vec3(0, 0, height), Attitude.LEVEL);
    return new CameraView(Scene.of(List.of()), pose, false);
  }

  private SimSnapshot look() {
    looks.release();
    return simulation.snapshot();
  }

  private FrameSource source() {
    films.incrementAndGet();
    return new FrameSource() {
      @Override
      public void film(SimSnapshot snapshot, CameraId shot, Picture picture) {
        Error broken = failure.get();
        filmed.add(broken == null ? "picture" : "failure");
        if (broken != null) {
          throw broken;
        }
      }

      @Override
      public Optional<CameraView> view(SimSnapshot snapshot, CameraId shot) {
        return Optional.of(view.get());
      }
    };
  }

  @AfterEach
  void close() {
    stream.close();
    log.close();
  }

  @Test
  void inStationModeNothingIsFilmedUntilTheFaultIsOver() throws InterruptedException {
    simulation.control(new Control.InjectFault(Fault.of("no-video-in-station-mode")));
    switchOn();
    tell("streamon");
    lookAgain();
    assertThat(filmed).isEmpty();

    simulation.control(new Control.ClearFaults());
    simulation.drain();
    stream.wake();
    assertThat(filmed.take()).isEqualTo("picture");
  }

  @Test
  void whoNeedsNoPicturesSeesOnlyThoseThatOthersWant() throws InterruptedException {
    BlockingQueue<Boolean> encoded = new LinkedBlockingQueue<>();
    stream.watch(
        new VideoWatcher() {
          @Override
          public boolean needsPictures() {
            return false;
          }

          @Override
          public void filmed(FilmedPicture picture) {
            encoded.add(picture.encoded().isPresent());
          }
        });
    switchOn();
    lookAgain();
    assertThat(filmed).as("before somebody asks").isEmpty();

    tell("streamon");

    assertThat(filmed.take()).isEqualTo("picture");
    assertThat(encoded.take()).isTrue();
  }

  @Test
  void withoutMemoryItRestsUntilTheNextStreamon() throws InterruptedException {
    failure.set(new OutOfMemoryError("broken on purpose"));
    switchOn();
    tell("streamon");
    assertThat(filmed.take()).isEqualTo("failure");
    assertThat(log.next()).startsWith(RESTS + "memory is full");
    failure.set(null);
    lookAgain();
    assertThat(filmed).as("a picture that nobody asked for").isEmpty();

    tell("streamon");

    assertThat(filmed.take()).isEqualTo("picture");
    assertThat(films).as("the first film has given its memory back").hasValue(2);
  }

  @Test
  void withoutMemoryItRestsUntilPowerWasOff() throws InterruptedException {
    failure.set(new OutOfMemoryError("broken on purpose"));
    switchOn();
    tell("streamon");
    assertThat(log.next()).startsWith(RESTS);
    failure.set(null);
    filmed.clear();
    simulation.control(new Control.Power(1, false));
    simulation.drain();
    lookAgain();
    switchOn();

    tell("streamon");

    assertThat(filmed.take()).isEqualTo("picture");
  }

  @Test
  void withoutMemoryItRestsUntilSomebodyElseLooks() throws InterruptedException {
    failure.set(new OutOfMemoryError("broken on purpose"));
    switchOn();
    tell("streamon");
    assertThat(log.next()).startsWith(RESTS);
    failure.set(null);
    filmed.clear();

    stream.watch(picture -> {});

    assertThat(filmed.take()).isEqualTo("picture");
  }

  @Test
  void otherErrorsCostOnePictureEach() throws InterruptedException {
    failure.set(new StackOverflowError("broken on purpose"));
    switchOn();
    tell("streamon");
    assertGoesOnAfterTheFailure();
  }

  @Test
  void whoOnlyLooksGetsNoPictureThatIsAsTheLast() throws InterruptedException {
    stream.watch(picture -> {});
    assertThat(filmed.take()).isEqualTo("picture");

    looks.drainPermits();
    looks.acquire(6); // some ticks, in which an encoded stream would have pictures

    assertThat(filmed).isEmpty();
    view.set(view(1));
    assertThat(filmed.take()).isEqualTo("picture");
  }

  @Test
  void whoeverBeginsToLookGetsAPicture() throws InterruptedException {
    BlockingQueue<FilmedPicture> seen = new LinkedBlockingQueue<>();
    stream.watch(picture -> {});
    assertThat(filmed.take()).isEqualTo("picture");

    stream.watch(seen::add);

    assertThat(seen.take().encoded()).isEmpty();
  }

  @Test
  void aPictureThatFailedIsTakenAgain() throws InterruptedException {
    failure.set(new StackOverflowError("broken on purpose"));
    stream.watch(picture -> {});
    assertGoesOnAfterTheFailure();
  }

  @Test
  void whatIsSentIsTakenAtEachTick() throws InterruptedException {
    switchOn();
    tell("streamon");

    assertThat(filmed.take()).isEqualTo("picture");
    assertThat(filmed.take()).isEqualTo("picture");
  }

  @Test
  void afterTheSimulationBeganAnewAStreamBeginsWithAKeyPicture() throws InterruptedException {
    BlockingQueue<String> seen = new LinkedBlockingQueue<>();
    stream.watch(picture -> seen.add(kind(picture)));
    switchOn();
    tell("streamon");
    while (!seen.take().equals("key")) {
      // rendered before it was requested
    }
    assertThat(seen.take()).isEqualTo("predicted");

    simulation.control(new Control.NewRun(CONFIG));
    simulation.drain();
    stream.restart();
    simulation.control(new Control.Power(1, true));
    simulation.submit(1, OPERATOR, WireText.encode("command"));
    simulation.submit(1, OPERATOR, WireText.encode("streamon"));
    simulation.drain();
    seen.clear();

    assertThat(List.of(seen.take(), seen.take(), seen.take()))
        .as("one that was begun before, and those after")
        .contains("key");
  }

  private static String kind(FilmedPicture picture) {
    return picture.encoded().map(unit -> unit.idr() ? "key" : "predicted").orElse("preview");
  }

  private void assertGoesOnAfterTheFailure() throws InterruptedException {
    assertThat(filmed.take()).isEqualTo("failure");
    assertThat(log.next()).startsWith("A picture of drone 1 failed; please report this: ");
    failure.set(null);

    while (!filmed.take().equals("picture")) {
      assertThat(films).hasValue(1);
    }
  }

  /** Lets the stream check twice, so that at least one check is later than this call. */
  private void lookAgain() throws InterruptedException {
    for (int i = 0; i < 2; i++) {
      looks.drainPermits();
      stream.wake();
      looks.acquire();
    }
  }

  private void switchOn() {
    simulation.control(new Control.Power(1, true));
    simulation.drain();
    tell("command");
  }

  private void tell(String text) {
    simulation.submit(1, OPERATOR, WireText.encode(text));
    simulation.drain();
    stream.wake();
  }
}
