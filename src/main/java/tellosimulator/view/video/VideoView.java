package tellosimulator.view.video;

import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.scene.image.ImageView;
import tellosimulator.video.VideoFigures;
import tellosimulator.video.VideoStream;
import tellosimulator.video.picture.Picture;
import tellosimulator.video.picture.YuvConverter;
import tellosimulator.view.fx.ScreenPixels;
import tellosimulator.view.video.TripleBuffer.BufferedPicture;

/**
 * Shows the rendered pictures of a drone's stream, before they are encoded. A view that does not
 * watch a stream takes no processor time. Confined to the JavaFX thread.
 */
public final class VideoView extends ImageView {

  private final ReadOnlyObjectWrapper<VideoFigures> figures =
      new ReadOnlyObjectWrapper<>(this, "figures", VideoFigures.NONE);
  private Optional<Watched> watched = Optional.empty();
  private final ScreenPixels pixels = new ScreenPixels(this);

  /** A stream and its newest picture. */
  private record Watched(VideoStream stream, TripleBuffer newest) {}

  /** Creates a view that does not watch a stream yet. */
  public VideoView() {
    setPreserveRatio(true);
  }

  /** Shows the pictures of a stream instead of the previous one. */
  public void watch(VideoStream stream) {
    rest();
    Watched now = new Watched(stream, new TripleBuffer());
    watched = Optional.of(now);
    stream.watch(now.newest);
  }

  /** Stops showing pictures. */
  public void rest() {
    watched.ifPresent(before -> before.stream.ignore(before.newest));
    watched = Optional.empty();
    pixels.clear();
    figures.set(VideoFigures.NONE);
  }

  /** The figures of the stream; {@link VideoFigures#NONE} while no stream is watched. */
  public ReadOnlyObjectProperty<VideoFigures> figuresProperty() {
    return figures.getReadOnlyProperty();
  }

  /** Shows the newest picture, if it is not shown yet. */
  public void advance() {
    watched.flatMap(now -> now.newest.take()).ifPresent(this::show);
  }

  private void show(BufferedPicture kept) {
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

  /**
   * Returns whether half of the picture's pixels per row would be too few for the view's width on
   * the screen.
   */
  private boolean needsAll(Picture picture) {
    double scale =
        getScene() == null || getScene().getWindow() == null
            ? 1
            : getScene().getWindow().getOutputScaleX();
    return getLayoutBounds().getWidth() * scale > picture.width() / 2.0;
  }
}
