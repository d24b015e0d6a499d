package tellosimulator.video;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Optional;
import org.jcodec.common.Codec;
import org.jcodec.common.MuxerTrack;
import org.jcodec.common.VideoCodecMeta;
import org.jcodec.common.io.FileChannelWrapper;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Packet;
import org.jcodec.common.model.Packet.FrameType;
import org.jcodec.common.model.Size;
import org.jcodec.containers.mp4.muxer.MP4Muxer;
import tellosimulator.video.codec.EncodedPicture;
import tellosimulator.video.picture.Picture;
import tellosimulator.words.Phrase;

/**
 * A stream that is kept as an MP4 file, picture by picture as it is sent. It begins with the next
 * key picture, and ends when it is closed, when pictures get another size, or when the file cannot
 * be written. For any thread.
 */
public final class Recording implements VideoWatcher, AutoCloseable {

  /** Ticks a second in the file. Decided: as in RTP, fine enough for any picture rate. */
  private static final int TIMESCALE = 90_000;

  /** How long the last picture is shown [ticks]. Decided: as at 30 pictures a second. */
  private static final long LAST = TIMESCALE / 30;

  private final Path file;
  private final FileChannelWrapper channel;
  private final MP4Muxer muxer;
  private Optional<MuxerTrack> track = Optional.empty();
  private Optional<Kept> kept = Optional.empty();
  private Optional<Phrase> failure = Optional.empty();
  private Size size = new Size(0, 0);
  private long begun;
  private int count;
  private boolean ended;

  /** A picture whose duration is not known before the next one comes. */
  private record Kept(ByteBuffer bytes, boolean key, long ticks) {}

  private Recording(Path file, FileChannelWrapper channel, MP4Muxer muxer) {
    this.file = file;
    this.channel = channel;
    this.muxer = muxer;
  }

  /**
   * Begins a file, which must not exist yet.
   *
   * @throws IOException if it cannot be written
   */
  public static Recording to(Path file) throws IOException {
    FileChannel opened =
        FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    FileChannelWrapper channel = new FileChannelWrapper(opened);
    return new Recording(file, channel, MP4Muxer.createMP4MuxerToChannel(channel));
  }

  public Path file() {
    return file;
  }

  /** How many pictures are in it. */
  public synchronized int pictures() {
    return count;
  }

  /** Why it ended by itself; empty while it goes on, or if it was closed. */
  public synchronized Optional<Phrase> failure() {
    return failure;
  }

  @Override
  public boolean needsStream() {
    return true;
  }

  @Override
  public synchronized void filmed(FilmedPicture filmed) {
    if (ended || filmed.encoded().isEmpty()) {
      return;
    }
    try {
      add(filmed.picture(), filmed.encoded().get(), filmed.nanos());
    } catch (IOException e) {
      fail(Phrase.of("the recording %s ended, because it cannot be written: %s", file, why(e)));
    }
  }

  private void add(Picture picture, EncodedPicture encoded, long nanos) throws IOException {
    if (track.isEmpty()) {
      if (!encoded.key()) {
        return;
      }
      size = new Size(picture.width(), picture.height());
      VideoCodecMeta meta = VideoCodecMeta.createSimpleVideoCodecMeta(size, ColorSpace.YUV420);
      track = Optional.of(muxer.addVideoTrack(Codec.H264, meta));
      begun = nanos;
    } else if (picture.width() != size.getWidth() || picture.height() != size.getHeight()) {
      fail(Phrase.of("the recording %s ended, because the pictures have another size now", file));
      return;
    }
    long ticks = Math.round((nanos - begun) * 1e-9 * TIMESCALE);
    write(ticks);
    ByteBuffer bytes = ByteBuffer.wrap(Arrays.copyOf(encoded.bytes(), encoded.size()));
    kept = Optional.of(new Kept(bytes, encoded.key(), ticks));
  }

  /** Writes the picture that was kept, which is shown until now. */
  private void write(long now) throws IOException {
    if (kept.isPresent() && track.isPresent()) {
      Kept picture = kept.get();
      track
          .get()
          .addFrame(
              Packet.createPacket(
                  picture.bytes,
                  picture.ticks,
                  TIMESCALE,
                  Math.max(1, now - picture.ticks),
                  count,
                  picture.key ? FrameType.KEY : FrameType.INTER,
                  null));
      count++;
    }
  }

  private void fail(Phrase reason) {
    failure = Optional.of(reason);
    try {
      close();
    } catch (IOException e) {
      failure = Optional.of(Phrase.of("%s; what was recorded is lost: %s", reason, why(e)));
    }
  }

  private static String why(IOException e) {
    return e.getMessage() == null ? e.toString() : e.getMessage();
  }

  /**
   * Ends the file, which is deleted if there is no picture in it; does nothing if it has ended.
   *
   * @throws IOException if the end cannot be written
   */
  @Override
  public synchronized void close() throws IOException {
    if (ended) {
      return;
    }
    ended = true;
    try (channel) {
      if (kept.isPresent()) {
        write(kept.get().ticks + LAST);
        muxer.finish();
      }
    }
    if (kept.isEmpty()) {
      Files.deleteIfExists(file);
    }
  }
}
