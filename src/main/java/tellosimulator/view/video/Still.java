package tellosimulator.view.video;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import tellosimulator.video.FilmedPicture;
import tellosimulator.video.VideoStream;
import tellosimulator.video.VideoWatcher;
import tellosimulator.video.picture.Picture;

/** Waits for the next picture of a stream, of which it hands over a copy. For any thread. */
final class Still implements VideoWatcher {

  private final AtomicBoolean waiting = new AtomicBoolean(true);
  private final VideoStream stream;
  private final Consumer<Picture> taker;

  private Still(VideoStream stream, Consumer<Picture> taker) {
    this.stream = stream;
    this.taker = taker;
  }

  /**
   * Lets the next picture be taken.
   *
   * @param taker called on the video thread, once
   */
  static void take(VideoStream stream, Consumer<Picture> taker) {
    stream.watch(new Still(stream, taker));
  }

  @Override
  public void filmed(FilmedPicture filmed) {
    if (waiting.getAndSet(false)) {
      stream.ignore(this);
      taker.accept(filmed.picture().copy());
    }
  }
}
