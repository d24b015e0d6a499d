package tellosimulator.video;

import java.util.Optional;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.CameraView;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.VideoEncoder;
import tellosimulator.video.picture.JpegEncoder;
import tellosimulator.video.picture.Picture;

/**
 * Renders the frames of one drone's camera and encodes them, in any requested format.
 * Deterministic: it reads no clock, so the same calls return the same bytes. Used by one thread at
 * a time.
 */
final class FramePipeline {

  /**
   * Interval between IDR frames [ns]. Decided: the longest time that a receiver should wait after
   * joining late or losing a packet. The interval of the real drone is not known.
   */
  private static final long IDR_PERIOD = 1_000_000_000;

  private final int drone;
  private final FrameSource source;
  private final VideoEncoder.Factory encoders;
  private Optional<Output> output = Optional.empty();
  private boolean idrOwed;
  private long idrNanos;

  /** A frame buffer and an encoder for frames of its size. */
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
   * Creates a pipeline that has not rendered any frames yet.
   *
   * @param drone the drone's number, from 1
   * @param source renders the frames
   * @param encoders creates an encoder for each frame size
   */
  FramePipeline(int drone, FrameSource source, VideoEncoder.Factory encoders) {
    this.drone = drone;
    this.source = source;
    this.encoders = encoders;
  }

  /**
   * Returns the view that fully defines a frame in the given format; empty if the source cannot
   * provide one.
   */
  Optional<CameraView> view(SimSnapshot snapshot, VideoFormat format) {
    return source.view(snapshot, new CameraId(drone, format.downward()));
  }

  /** Discards all state; the next frames are encoded as if by a new encoder. */
  void restart() {
    output = Optional.empty();
  }

  /** Renders the next frame. The result is valid until the next call. */
  Picture capture(SimSnapshot snapshot, VideoFormat format) {
    Picture picture = adopt(format).picture;
    source.film(snapshot, new CameraId(drone, format.downward()), picture);
    return picture;
  }

  /** Renders what the forward camera sees, and returns it as a JPEG file. */
  byte[] photo(SimSnapshot snapshot, float quality) {
    Picture photo = source.blankPhoto();
    source.film(snapshot, new CameraId(drone, false), photo);
    return JpegEncoder.encode(photo, quality);
  }

  /**
   * Encodes the last rendered frame. The result is valid until the next call.
   *
   * @param nanos time of the frame [ns]; only differences between times matter
   * @param forceIdr whether the frame must be an IDR frame
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
