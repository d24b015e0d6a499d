package tellosimulator.web;

import java.util.List;
import java.util.Optional;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Progress;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.overlay.Eye;
import tellosimulator.scenery.overlay.Overlay;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.Ticker;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;
import tellosimulator.video.picture.JpegEncoder;

/**
 * Draws the room for one viewer as JPEG files, with the aids that the window shows: goals, heading
 * rings and trails. Confined to the thread of the viewer's stream.
 */
final class ViewerPictures implements AutoCloseable {

  /** Compression quality. Decided: edges of goals and drones stay sharp. */
  private static final float QUALITY = 0.8f;

  /** Color outside the room. Decided: the same as in the report. */
  private static final int OUTSIDE = 0xd8dde3;

  private final WebSubject subject;
  private final SoftwareCamera camera;
  private final int width;
  private final int height;
  private final FrameBuffer frame;
  private final int[] pixels;
  private final JpegEncoder encoder;
  private final Ticker clock = new Ticker();
  private final Overlay overlay;
  private Optional<Seen> seen = Optional.empty();

  private record Seen(Scene scene, PinholeCamera camera, int drone, List<PlacedGoal> goals) {}

  /**
   * Creates the pictures of one stream.
   *
   * @param overlay the aids, which may be shared by pictures of the same viewer
   * @param cache the cache of all viewers, for {@link ColorSpace#RGB}
   * @param width width of a picture [pixels]
   * @param height height of a picture [pixels]
   */
  ViewerPictures(WebSubject subject, Overlay overlay, RenderCache cache, int width, int height) {
    this.subject = subject;
    this.overlay = overlay;
    this.camera = new SoftwareCamera(cache);
    this.width = width;
    this.height = height;
    frame = FrameBuffer.forScreen(width, height);
    pixels = new int[width * height];
    encoder = new JpegEncoder(width, height, QUALITY);
  }

  /** Returns the next picture; empty if nothing has changed. */
  Optional<byte[]> next(ViewerCamera viewer, int drone) {
    SimSnapshot snapshot = subject.simulation().snapshot();
    Progress progress = subject.goals().progress();
    PinholeCamera view = viewer.at(snapshot, drone, progress.challenge().goals(), width, height);
    List<PlacedGoal> goals = PlacedGoal.of(progress, snapshot.arena());
    Seen now = new Seen(subject.scenes().scene(snapshot), view, drone, goals);
    Eye eye = new Eye(view.pose(), ViewerCamera.NEAR);
    List<Instance> aids;
    synchronized (overlay) {
      overlay.advance(snapshot, clock.nanos());
      if (seen.filter(now::equals).isPresent()) {
        return Optional.empty();
      }
      overlay.choose(drone);
      overlay.show(goals, List.of());
      aids = overlay.instances(snapshot, eye);
    }
    camera.draw(now.scene.withOverlay(aids), view, frame);
    frame.copyTo(pixels);
    for (int i = 0; i < pixels.length; i++) {
      pixels[i] = pixels[i] == 0 ? OUTSIDE : pixels[i];
    }
    seen = Optional.of(now);
    return Optional.of(encoder.encode(pixels));
  }

  @Override
  public void close() {
    encoder.close();
  }
}
