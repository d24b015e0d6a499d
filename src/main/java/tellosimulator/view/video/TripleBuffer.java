package tellosimulator.view.video;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import tellosimulator.video.FilmedPicture;
import tellosimulator.video.VideoFigures;
import tellosimulator.video.VideoWatcher;
import tellosimulator.video.picture.Picture;

/**
 * Passes the newest picture of a stream to another thread by triple buffering: one buffer is being
 * written, one is being read, and one holds the newest complete picture. One thread writes, another
 * one reads, and neither ever waits.
 */
final class TripleBuffer implements VideoWatcher {

  /**
   * A copy of a picture.
   *
   * @param fresh whether the picture has not been read yet
   */
  record BufferedPicture(Picture picture, VideoFigures figures, boolean fresh) {

    private static BufferedPicture nothing() {
      return new BufferedPicture(new Picture(2, 2), VideoFigures.NONE, false);
    }

    private BufferedPicture seen() {
      return new BufferedPicture(picture, figures, false);
    }
  }

  private final AtomicReference<BufferedPicture> between =
      new AtomicReference<>(BufferedPicture.nothing());
  private BufferedPicture written = BufferedPicture.nothing();
  private BufferedPicture read = BufferedPicture.nothing();

  /** Copies the picture. */
  @Override
  public void filmed(FilmedPicture filmed) {
    Picture source = filmed.picture();
    Picture copy = written.picture;
    if (copy.width() != source.width() || copy.height() != source.height()) {
      copy = new Picture(source.width(), source.height());
    }
    copy.set(source);
    written = between.getAndSet(new BufferedPicture(copy, filmed.figures(), true));
  }

  /**
   * Returns the newest picture, unless it has already been taken. The picture is valid until the
   * next call.
   */
  Optional<BufferedPicture> take() {
    if (!between.get().fresh) {
      return Optional.empty();
    }
    read = between.getAndSet(read.seen());
    return Optional.of(read);
  }
}
