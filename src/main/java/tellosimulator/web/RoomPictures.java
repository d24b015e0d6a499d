package tellosimulator.web;

import java.util.Optional;
import tellosimulator.scenery.Scene;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;
import tellosimulator.video.picture.JpegEncoder;

/** Draws the room for one viewer as JPEG files. Confined to the thread of the viewer's stream. */
final class RoomPictures implements AutoCloseable {

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
  private Optional<Seen> seen = Optional.empty();

  private record Seen(Scene scene, PinholeCamera camera) {}

  /**
   * Creates the pictures of one stream.
   *
   * @param cache the cache of all viewers, for {@link ColorSpace#RGB}
   * @param width width of a picture [pixels]
   * @param height height of a picture [pixels]
   */
  RoomPictures(WebSubject subject, RenderCache cache, int width, int height) {
    this.subject = subject;
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
    Seen now =
        new Seen(
            subject.scenes().scene(snapshot),
            viewer.at(
                snapshot, drone, subject.goals().progress().challenge().goals(), width, height));
    if (seen.filter(now::equals).isPresent()) {
      return Optional.empty();
    }
    camera.draw(now.scene, now.camera, frame);
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
