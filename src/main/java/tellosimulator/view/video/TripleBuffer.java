package tellosimulator.view.video;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import tellosimulator.video.FilmedPicture;
import tellosimulator.video.VideoFigures;
import tellosimulator.video.VideoWatcher;
import tellosimulator.video.picture.Picture;

/**
 * Passes the newest picture of a stream to another thread by triple buffering: one buffer is being
 * written, one is being read, and one holds the newest complete picture. One thread writes, one
 * other reads, and neither ever waits.
 */
final class TripleBuffer implements VideoWatcher {

  /**
   * A copy of a picture.
   *
   * @param fresh whether nobody has seen it yet
   */
  record Kept(Picture picture, VideoFigures figures, boolean fresh) {

    private static Kept nothing() {
      return new Kept(new Picture(2, 2), VideoFigures.NONE, false);
    }

    private Kept seen() {
      return new Kept(picture, figures, false);
    }
  }

  private final AtomicReference<Kept> between = new AtomicReference<>(Kept.nothing());
  private Kept written = Kept.nothing();
  private Kept read = Kept.nothing();

  /** Copies the picture. */
  @Override
  public void filmed(FilmedPicture filmed) {
    Picture source = filmed.picture();
    Picture copy = written.picture;
    if (copy.width() != source.width() || copy.height() != source.height()) {
      copy = new Picture(source.width(), source.height());
    }
    copy.set(source);
    written = between.getAndSet(new Kept(copy, filmed.figures(), true));
  }

  /** The newest picture, if it has not been taken before; valid until the next call. */
  Optional<Kept> take() {
    if (!between.get().fresh) {
      return Optional.empty();
    }
    read = between.getAndSet(read.seen());
    return Optional.of(read);
  }
}
