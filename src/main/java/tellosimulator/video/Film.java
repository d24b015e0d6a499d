package tellosimulator.video;

import java.util.List;
import java.util.Optional;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.VideoEncoder;
import tellosimulator.video.picture.Picture;

/**
 * Takes the pictures of one drone and encodes them, in whatever format is asked for. For one thread
 * at a time; it reads no clock.
 */
final class Film {

  /**
   * From one picture with which decoding can begin to the next [ns]. Decided: who comes late or
   * loses a packet waits no longer. The real drone's interval is not known.
   */
  private static final long KEY_PERIOD = 1_000_000_000;

  private final int drone;
  private final FrameSource source;
  private final VideoEncoder.Factory encoders;
  private Optional<Reel> reel = Optional.empty();
  private Optional<Opening> opening = Optional.empty();
  private boolean keyOwed;
  private long keyNanos;

  /** What hangs on the size of the pictures. */
  private record Reel(VideoFormat format, Picture picture, VideoEncoder encoder) {}

  /** A first picture that was made before anybody asked for it. */
  private record Opening(Object sight, AccessUnit encoded) {}

  /**
   * @param drone its number, from 1
   * @param source where its pictures come from
   */
  Film(int drone, FrameSource source, VideoEncoder.Factory encoders) {
    this.drone = drone;
    this.source = source;
    this.encoders = encoders;
  }

  /**
   * Makes the first picture before anybody asks for it. Who then does gets it at once, if there
   * still is the same to see. Does nothing if that is so already.
   */
  void prepare(SimSnapshot snapshot, VideoFormat format) {
    shoot(snapshot, format);
    if (opening.isEmpty()) {
      Object sight = source.sight(snapshot, new CameraId(drone, format.downward()));
      opening = Optional.of(new Opening(sight, encode(0, true)));
    }
  }

  /** What there is to see: where it equals that of before, the next picture is as the last. */
  Object sight(SimSnapshot snapshot, VideoFormat format) {
    return List.of(format, source.sight(snapshot, new CameraId(drone, format.downward())));
  }

  /** Takes the next picture, if it is not there in advance; it is valid until the next call. */
  Picture shoot(SimSnapshot snapshot, VideoFormat format) {
    adopt(format);
    Picture picture = reel.orElseThrow().picture;
    CameraId camera = new CameraId(drone, format.downward());
    if (opening.isPresent() && !opening.get().sight.equals(source.sight(snapshot, camera))) {
      beginAnew();
      setRate(reel.orElseThrow()); // nobody gets the picture that the encoder has counted
    }
    if (opening.isEmpty()) {
      source.film(snapshot, camera, picture);
    }
    return picture;
  }

  /**
   * Encodes the picture that was taken last; it is valid until the next call. Once a second
   * decoding can begin.
   *
   * @param nanos when it was taken; only differences mean something
   * @param fromHere whether decoding shall be able to begin with this picture
   */
  AccessUnit encode(long nanos, boolean fromHere) {
    AccessUnit encoded = opening.map(Opening::encoded).orElseGet(() -> encodeNow(nanos, fromHere));
    opening = Optional.empty();
    if (encoded.idr()) {
      keyOwed = false;
      keyNanos = nanos;
    }
    return encoded;
  }

  private AccessUnit encodeNow(long nanos, boolean fromHere) {
    Reel current = reel.orElseThrow();
    long nextKey = keyNanos + KEY_PERIOD - current.format.period() / 2;
    return current.encoder.encode(current.picture, fromHere || keyOwed || nanos >= nextKey);
  }

  /** What was encoded so far looks different, or nobody has it. */
  private void beginAnew() {
    opening = Optional.empty();
    keyOwed = true;
  }

  private void adopt(VideoFormat format) {
    Optional<Reel> before = reel;
    if (before.isPresent() && before.get().format.equals(format)) {
      return;
    }
    beginAnew();
    if (before.isPresent() && before.get().format.sameSizeAs(format)) {
      reel = Optional.of(new Reel(format, before.get().picture, before.get().encoder));
    } else {
      Picture picture = new Picture(format.width(), format.height());
      VideoEncoder encoder = encoders.create(format.width(), format.height());
      reel = Optional.of(new Reel(format, picture, encoder));
    }
    setRate(reel.orElseThrow());
  }

  private static void setRate(Reel reel) {
    reel.encoder.setRate(reel.format.framesPerSecond(), reel.format.bitsPerSecond());
  }
}
