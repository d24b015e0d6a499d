package tellosimulator.web;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import tellosimulator.video.FilmedPicture;
import tellosimulator.video.VideoStream;
import tellosimulator.video.VideoWatcher;
import tellosimulator.video.picture.JpegEncoder;
import tellosimulator.video.picture.Picture;

/**
 * The film of one drone as JPEG files. The video thread only copies a picture, and only after the
 * one before was taken.
 */
final class FilmPictures implements VideoWatcher, AutoCloseable {

  /** Compression quality. Decided: the film itself is compressed more. */
  private static final float QUALITY = 0.75f;

  private final VideoStream stream;
  private final AtomicReference<Picture> newest = new AtomicReference<>();

  /**
   * Begins to watch a stream.
   *
   * @param wanted whether there are pictures at all
   */
  FilmPictures(VideoStream stream, boolean wanted) {
    this.stream = stream;
    if (wanted) {
      stream.watch(this);
    }
  }

  @Override
  public void filmed(FilmedPicture filmed) {
    if (newest.get() == null) {
      newest.set(filmed.picture().copy());
    }
  }

  /** Returns the newest picture; empty if there is none since the last call. */
  Optional<byte[]> next() {
    return Optional.ofNullable(newest.getAndSet(null))
        .map(picture -> JpegEncoder.encode(picture, QUALITY));
  }

  @Override
  public void close() {
    stream.ignore(this);
  }
}
