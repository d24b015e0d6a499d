package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.Verdict;
import tellosimulator.concurrent.Worker;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.Stage;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.Metronome;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;

/**
 * Draws views of the world with the software camera, one after the other, on a thread of its own.
 * Nobody ever waits for it. It is asked by one thread.
 */
final class Painter implements AutoCloseable {

  private static final FrameBuffer NOTHING = FrameBuffer.forScreen(0, 0);
  private static final int[] NO_PIXELS = {};

  /**
   * What is to be drawn.
   *
   * @param without a drone that is not to be seen, because its camera looks
   * @param aids what there is beside the world itself
   */
  record View(
      SimSnapshot snapshot, OptionalInt without, PinholeCamera viewpoint, List<Placed> aids) {}

  /** What was drawn. */
  static final class Painted {

    private final CameraIntrinsics intrinsics;
    private final int[] argb;

    private Painted(CameraIntrinsics intrinsics, int[] argb) {
      this.intrinsics = intrinsics;
      this.argb = argb;
    }

    /** Pixels. */
    int width() {
      return intrinsics.width();
    }

    /** Pixels. */
    int height() {
      return intrinsics.height();
    }

    /** Row by row, 8 bits each for alpha, red, green and blue; itself, not a copy. */
    int[] argb() {
      return argb;
    }
  }

  /** All that decides what a picture looks like. */
  private record Sight(Scene scene, PinholeCamera viewpoint) {}

  private final Stage stage;
  private final SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final Metronome metronome = new Metronome();
  private final AtomicReference<Optional<View>> wanted = new AtomicReference<>(Optional.empty());
  private final AtomicReference<Optional<Painted>> painted =
      new AtomicReference<>(Optional.empty());
  private volatile boolean busy;
  private volatile boolean settled;
  private final Worker worker;
  private Optional<Sight> last = Optional.empty();
  private FrameBuffer frameBuffer = NOTHING;
  private int[] argb = NO_PIXELS;

  Painter(Stage stage) {
    this.stage = stage;
    worker = Worker.start("window-painter", new Painting());
  }

  /** Whether it draws, or has drawn what nobody has taken yet. */
  boolean busy() {
    return busy;
  }

  /** Whether the view that was asked for last looks as the one before, and was not drawn. */
  boolean settled() {
    return settled;
  }

  /** Draws a view, unless it would look as the one before. Not while it is busy. */
  void paint(View view) {
    settled = false;
    busy = true;
    wanted.set(Optional.of(view));
    metronome.wake();
  }

  /** What was drawn, if there is something new; valid until the next view is drawn. */
  Optional<Painted> take() {
    Optional<Painted> taken = painted.getAndSet(Optional.empty());
    if (taken.isPresent()) {
      busy = false;
    }
    return taken;
  }

  private final class Painting implements Agent {

    private final Verdict failed = Verdict.goOn("The room could not be drawn");

    @Override
    public Outcome doWork() {
      Optional<View> view = wanted.getAndSet(Optional.empty());
      view.ifPresent(Painter.this::attempt);
      return view.isPresent() ? Outcome.WORKED : Outcome.IDLE;
    }

    @Override
    public void idle() {
      metronome.rest();
    }

    @Override
    public Verdict onError(Throwable failure) {
      frameBuffer = NOTHING; // the memory that it takes may be what is missing
      argb = NO_PIXELS;
      last = Optional.empty();
      busy = false;
      return failed;
    }
  }

  private void attempt(View view) {
    Optional<Painted> now = drawn(view);
    if (now.isPresent()) {
      painted.set(now); // from here on, who takes it says when this is no longer busy
    } else {
      busy = false;
    }
  }

  private Optional<Painted> drawn(View view) {
    Sight sight = new Sight(scene(view), view.viewpoint());
    if (last.filter(sight::equals).isPresent()) {
      settled = true;
      return Optional.empty();
    }
    CameraIntrinsics intrinsics = view.viewpoint().intrinsics();
    if (frameBuffer.width() != intrinsics.width() || frameBuffer.height() != intrinsics.height()) {
      frameBuffer = FrameBuffer.forScreen(intrinsics.width(), intrinsics.height());
      argb = new int[intrinsics.width() * intrinsics.height()];
    }
    camera.draw(sight.scene(), sight.viewpoint(), frameBuffer);
    frameBuffer.copyTo(argb);
    last = Optional.of(sight);
    return Optional.of(new Painted(intrinsics, argb));
  }

  private Scene scene(View view) {
    List<Placed> parts = new ArrayList<>();
    SimSnapshot snapshot = view.snapshot();
    Scene world =
        view.without().isPresent()
            ? stage.scene(snapshot, view.without().getAsInt())
            : stage.scene(snapshot);
    parts.addAll(world.parts());
    parts.addAll(view.aids());
    return new Scene(parts);
  }

  /** Ends the thread after what it draws just now. */
  @Override
  public void close() {
    worker.end();
    metronome.wake();
  }
}
