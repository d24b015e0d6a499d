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
 * Renders frames with the software camera, one at a time, on its own thread. No method blocks. All
 * methods must be called on the same thread.
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

    /** Returns the width in pixels. */
    int width() {
      return intrinsics.width();
    }

    /** Returns the height in pixels. */
    int height() {
      return intrinsics.height();
    }

    /**
     * Returns the pixels row by row, with 8 bits each for alpha, red, green and blue. The array is
     * not a copy.
     */
    int[] argb() {
      return argb;
    }
  }

  /** Everything that determines the content of a frame. */
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

  /** Returns whether a frame is being rendered, or a rendered frame has not been taken yet. */
  boolean busy() {
    return busy;
  }

  /**
   * Returns whether the last requested frame was not rendered, because it equals the previous one.
   */
  boolean settled() {
    return settled;
  }

  /**
   * Starts to render a frame, unless it would equal the previous one. Must not be called while
   * busy.
   */
  void render(Scene scene, PinholeCamera viewpoint) {
    settled = false;
    busy = true;
    next.set(Optional.of(new Job(scene, viewpoint)));
    ticker.wake();
  }

  /**
   * Returns the newest frame, unless it has been taken already. The frame is valid until the next
   * one is rendered.
   */
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
      frameBuffer = NOTHING; // memory may have run out
      argb = NO_PIXELS;
      last = Optional.empty();
      busy = false;
      return failed;
    }
  }

  private void attempt(Job job) {
    Optional<Rendered> now = rendered(job);
    if (now.isPresent()) {
      rendered.set(now); // stays busy until the frame is taken
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

  /** Stops the thread after the frame in progress. */
  @Override
  public void close() {
    worker.end();
    ticker.wake();
  }
}
