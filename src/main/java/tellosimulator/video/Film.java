package tellosimulator.video;

import java.util.Optional;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.CameraView;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.VideoEncoder;
import tellosimulator.video.picture.Picture;

/**
 * Renders the frames of one drone's camera and encodes them, in whatever format is asked for. The
 * same calls give the same bytes: it reads no clock. For one thread at a time.
 */
final class Film {

  /**
   * From one IDR frame to the next [ns]. Decided: a receiver that joins late or loses a packet
   * waits no longer. The real drone's interval is not known.
   */
  private static final long IDR_PERIOD = 1_000_000_000;

  private final int drone;
  private final FrameSource source;
  private final VideoEncoder.Factory encoders;
  private Optional<Output> output = Optional.empty();
  private boolean idrOwed;
  private long idrNanos;

  /** A frame buffer and an encoder of its size. */
  private record Output(VideoFormat format, Picture picture, VideoEncoder encoder) {

    static Output of(VideoFormat format, VideoEncoder.Factory encoders) {
      return new Output(
          format,
          new Picture(format.width(), format.height()),
          encoders.create(format.width(), format.height()));
    }

    Output withFormat(VideoFormat newFormat) {
      return new Output(newFormat, picture, encoder);
    }
  }

  /**
   * Renders nothing yet.
   *
   * @param drone its number, from 1
   * @param source renders its frames
   * @param encoders creates an encoder for each frame size
   */
  Film(int drone, FrameSource source, VideoEncoder.Factory encoders) {
    this.drone = drone;
    this.source = source;
    this.encoders = encoders;
  }

  /** Everything that a frame of this format shows; empty if the source cannot tell. */
  Optional<CameraView> view(SimSnapshot snapshot, VideoFormat format) {
    return source.view(snapshot, new CameraId(drone, format.downward()));
  }

  /** Forgets all frames until now: the next ones are encoded as by a new encoder. */
  void restart() {
    output = Optional.empty();
  }

  /** Renders the next frame; it is valid until the next call. */
  Picture shoot(SimSnapshot snapshot, VideoFormat format) {
    Picture picture = adopt(format).picture;
    source.film(snapshot, new CameraId(drone, format.downward()), picture);
    return picture;
  }

  /**
   * Encodes the frame that was rendered last; the result is valid until the next call.
   *
   * @param nanos when it was rendered; only differences mean something
   * @param forceIdr whether it must be an IDR frame
   */
  AccessUnit encode(long nanos, boolean forceIdr) {
    Output current = output.orElseThrow();
    long nextIdr = idrNanos + IDR_PERIOD - current.format.period() / 2;
    AccessUnit encoded =
        current.encoder.encode(current.picture, forceIdr || idrOwed || nanos >= nextIdr);
    if (encoded.idr()) {
      idrOwed = false;
      idrNanos = nanos;
    }
    return encoded;
  }

  private Output adopt(VideoFormat format) {
    Optional<Output> before = output;
    if (before.isPresent() && before.get().format.equals(format)) {
      return before.get();
    }
    idrOwed = true;
    Output adopted =
        before.isPresent() && before.get().format.sameSizeAs(format)
            ? before.get().withFormat(format)
            : Output.of(format, encoders);
    adopted.encoder.setRate(format.framesPerSecond(), format.bitsPerSecond());
    output = Optional.of(adopted);
    return adopted;
  }
}
