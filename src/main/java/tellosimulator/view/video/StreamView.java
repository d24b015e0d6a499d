package tellosimulator.view.video;

import java.nio.IntBuffer;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import tellosimulator.video.VideoFigures;
import tellosimulator.video.VideoStream;
import tellosimulator.video.picture.Picture;
import tellosimulator.view.video.NewestPicture.Kept;

/**
 * Shows the pictures of a drone's stream as they are made, the very ones that are encoded. Costs
 * nothing while it watches no stream. For the JavaFX thread.
 */
public final class StreamView extends ImageView {

  private final ReadOnlyObjectWrapper<VideoFigures> figures =
      new ReadOnlyObjectWrapper<>(this, "figures", VideoFigures.NONE);
  private Optional<Watched> watched = Optional.empty();
  private Optional<PixelBuffer<IntBuffer>> pixels = Optional.empty();

  /** A stream and its newest picture. */
  private record Watched(VideoStream stream, NewestPicture newest) {}

  /** Watches nothing yet. */
  public StreamView() {
    setPreserveRatio(true);
  }

  /** Shows the pictures of a stream from now on, and no longer those of the one before. */
  public void watch(VideoStream stream) {
    rest();
    Watched now = new Watched(stream, new NewestPicture());
    watched = Optional.of(now);
    stream.watch(now.newest);
  }

  /** Shows no more pictures. */
  public void rest() {
    watched.ifPresent(before -> before.stream.ignore(before.newest));
    watched = Optional.empty();
    pixels = Optional.empty();
    figures.set(VideoFigures.NONE);
    setImage(null);
  }

  /** How the stream goes; none while nothing is shown. */
  public ReadOnlyObjectProperty<VideoFigures> figuresProperty() {
    return figures.getReadOnlyProperty();
  }

  /** Shows the newest picture, if there is a new one. */
  public void advance() {
    watched.flatMap(now -> now.newest.take()).ifPresent(this::show);
  }

  private void show(Kept kept) {
    Picture picture = kept.picture();
    boolean whole = needsAll(picture);
    int parts = whole ? 1 : 2;
    PixelBuffer<IntBuffer> target = pixels(picture.width() / parts, picture.height() / parts);
    int[] argb = target.getBuffer().array();
    if (whole) {
      ScreenColors.whole(picture, argb);
    } else {
      ScreenColors.half(picture, argb);
    }
    target.updateBuffer(all -> null);
    figures.set(kept.figures());
  }

  /** Whether half as many pixels a row would be fewer than the screen shows. */
  private boolean needsAll(Picture picture) {
    double scale =
        getScene() == null || getScene().getWindow() == null
            ? 1
            : getScene().getWindow().getOutputScaleX();
    return getLayoutBounds().getWidth() * scale > picture.width() / 2.0;
  }

  /** The pixels of what is shown, which are used again and again. */
  private PixelBuffer<IntBuffer> pixels(int width, int height) {
    Optional<PixelBuffer<IntBuffer>> before =
        pixels.filter(old -> old.getWidth() == width && old.getHeight() == height);
    if (before.isPresent()) {
      return before.get();
    }
    PixelBuffer<IntBuffer> made =
        new PixelBuffer<>(
            width, height, IntBuffer.allocate(width * height), PixelFormat.getIntArgbPreInstance());
    setImage(new WritableImage(made));
    pixels = Optional.of(made);
    return made;
  }
}
