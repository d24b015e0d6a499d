package tellosimulator.view.world;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.scenery.Scene;
import tellosimulator.time.Ticker;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;

/**
 * Renders frames with the software camera, one after the other, on a thread of its own. Nobody ever
 * waits for it. Called by one thread.
 */
final class BackgroundRenderer implements AutoCloseable {

  private static final FrameBuffer NOTHING = FrameBuffer.forScreen(0, 0);
  private static final int[] NO_PIXELS = {};

  /** A rendered frame. */
  static final class Rendered {

    private final CameraIntrinsics intrinsics;
    private final int[] argb;

    private Rendered(CameraIntrinsics intrinsics, int[] argb) {
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

  /** All that decides what a frame looks like. */
  private record Job(Scene scene, PinholeCamera camera) {}

  private final SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final Ticker ticker = new Ticker();
  private final AtomicReference<Optional<Job>> next = new AtomicReference<>(Optional.empty());
  private final AtomicReference<Optional<Rendered>> rendered =
      new AtomicReference<>(Optional.empty());
  private volatile boolean busy;
  private volatile boolean settled;
  private final Worker worker;
  private Optional<Job> last = Optional.empty();
  private FrameBuffer frameBuffer = NOTHING;
  private int[] argb = NO_PIXELS;

  BackgroundRenderer() {
    worker = Worker.start("window-renderer", new Rendering());
  }

  /** Whether it renders, or has rendered what nobody has taken yet. */
  boolean busy() {
    return busy;
  }

  /** Whether the frame that was asked for last looks as the one before, and was not rendered. */
  boolean settled() {
    return settled;
  }

  /** Renders a frame, unless it would look as the one before. Not while it is busy. */
  void render(Scene scene, PinholeCamera viewpoint) {
    settled = false;
    busy = true;
    next.set(Optional.of(new Job(scene, viewpoint)));
    ticker.wake();
  }

  /** The newest frame, if nobody has taken it; valid until the next one is rendered. */
  Optional<Rendered> take() {
    Optional<Rendered> taken = rendered.getAndSet(Optional.empty());
    if (taken.isPresent()) {
      busy = false;
    }
    return taken;
  }

  private final class Rendering implements Agent {

    private final ErrorPolicy failed = ErrorPolicy.goOn("The room could not be drawn");

    @Override
    public Outcome doWork() {
      Optional<Job> job = next.getAndSet(Optional.empty());
      job.ifPresent(BackgroundRenderer.this::attempt);
      return job.isPresent() ? Outcome.WORKED : Outcome.IDLE;
    }

    @Override
    public void idle() {
      ticker.rest();
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      frameBuffer = NOTHING; // the memory that it takes may be what is missing
      argb = NO_PIXELS;
      last = Optional.empty();
      busy = false;
      return failed;
    }
  }

  private void attempt(Job job) {
    Optional<Rendered> now = rendered(job);
    if (now.isPresent()) {
      rendered.set(now); // from here on, who takes it says when this is no longer busy
    } else {
      busy = false;
    }
  }

  private Optional<Rendered> rendered(Job job) {
    if (last.filter(job::equals).isPresent()) {
      settled = true;
      return Optional.empty();
    }
    CameraIntrinsics intrinsics = job.camera().intrinsics();
    if (frameBuffer.width() != intrinsics.width() || frameBuffer.height() != intrinsics.height()) {
      frameBuffer = FrameBuffer.forScreen(intrinsics.width(), intrinsics.height());
      argb = new int[intrinsics.width() * intrinsics.height()];
    }
    camera.draw(job.scene(), job.camera(), frameBuffer);
    frameBuffer.copyTo(argb);
    last = Optional.of(job);
    return Optional.of(new Rendered(intrinsics, argb));
  }

  /** Ends the thread after the frame that it renders. */
  @Override
  public void close() {
    worker.end();
    ticker.wake();
  }
}
