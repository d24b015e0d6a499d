package tellosimulator.view.video;

import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.scene.image.ImageView;
import tellosimulator.video.VideoFigures;
import tellosimulator.video.VideoStream;
import tellosimulator.video.picture.Picture;
import tellosimulator.view.fx.ScreenPixels;
import tellosimulator.view.video.TripleBuffer.Kept;

/**
 * Shows the pictures of a drone's stream as they are made, the very ones that are encoded. Costs
 * nothing while it watches no stream. For the JavaFX thread.
 */
public final class VideoView extends ImageView {

  private final ReadOnlyObjectWrapper<VideoFigures> figures =
      new ReadOnlyObjectWrapper<>(this, "figures", VideoFigures.NONE);
  private Optional<Watched> watched = Optional.empty();
  private final ScreenPixels pixels = new ScreenPixels(this);

  /** A stream and its newest picture. */
  private record Watched(VideoStream stream, TripleBuffer newest) {}

  /** Watches nothing yet. */
  public VideoView() {
    setPreserveRatio(true);
  }

  /** Shows the pictures of a stream from now on, and no longer those of the one before. */
  public void watch(VideoStream stream) {
    rest();
    Watched now = new Watched(stream, new TripleBuffer());
    watched = Optional.of(now);
    stream.watch(now.newest);
  }

  /** Shows no more pictures. */
  public void rest() {
    watched.ifPresent(before -> before.stream.ignore(before.newest));
    watched = Optional.empty();
    pixels.clear();
    figures.set(VideoFigures.NONE);
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
    pixels.show(
        picture.width() / parts,
        picture.height() / parts,
        argb -> {
          if (whole) {
            YuvConverter.whole(picture, argb);
          } else {
            YuvConverter.half(picture, argb);
          }
        });
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
}
