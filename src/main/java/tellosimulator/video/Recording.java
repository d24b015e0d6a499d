package tellosimulator.video;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import tellosimulator.files.IoReason;
import tellosimulator.video.Mp4File.Format;
import tellosimulator.video.Mp4File.Sample;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.picture.Picture;
import tellosimulator.words.Phrase;

/**
 * Records a stream as an MP4 file while its pictures are sent. The recording starts with the next
 * key picture. It ends when it is closed, when the picture size changes, or when the file cannot be
 * written. Each half second is written as soon as it is complete, so that at most the last second
 * is missing if the program is killed. Thread-safe.
 */
public final class Recording implements VideoWatcher, AutoCloseable {

  /** Duration assigned to the last picture [ticks]. Decided: as at 30 pictures a second. */
  private static final int LAST = Mp4File.TIMESCALE / 30;

  /**
   * Duration of a fragment [ticks]; each fragment is written in one piece. Decided: half of the
   * acceptable loss of one second, because a busy machine sends pictures late and in bursts.
   */
  private static final long FRAGMENT = Mp4File.TIMESCALE / 2;

  private static final int START_CODE_LENGTH = 4;

  private final Path file;
  private final FileChannel channel;
  private final List<Sample> fragment = new ArrayList<>();
  private Optional<Mp4File> film = Optional.empty();
  private Optional<BufferedUnit> kept = Optional.empty();
  private Optional<Phrase> failure = Optional.empty();
  private int width;
  private int height;
  private long begun;
  private long fragmentBegun;
  private int count;
  private boolean ended;

  /** A picture whose duration is unknown until the next one arrives. */
  @SuppressWarnings("ArrayRecordComponent") // never compared, and the bytes are never modified
  private record BufferedUnit(byte[] unit, boolean key, long ticks) {}

  private Recording(Path file, FileChannel channel) {
    this.file = file;
    this.channel = channel;
  }

  /**
   * Creates a recording in a file that must not exist yet.
   *
   * @throws IOException if the file cannot be written
   */
  public static Recording to(Path file) throws IOException {
    return new Recording(file, Mp4File.create(file));
  }

  public Path file() {
    return file;
  }

  /** The number of recorded pictures. */
  public synchronized int pictures() {
    return count;
  }

  /**
   * The reason why the recording ended by itself; empty while it continues, and if it was closed.
   */
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
      fail(
          Phrase.of(
              "the recording %s ended, because it cannot be written: %s", file, IoReason.of(e)));
    }
  }

  private void add(Picture picture, AccessUnit encoded, long nanos) throws IOException {
    if (film.isEmpty()) {
      if (!encoded.idr()) {
        return;
      }
      width = picture.width();
      height = picture.height();
      Format format = new Format(width, height, unit(encoded, 0), unit(encoded, 1));
      film = Optional.of(Mp4File.begin(channel, format));
      begun = nanos;
    } else if (picture.width() != width || picture.height() != height) {
      fail(Phrase.of("the recording %s ended, because the pictures have another size now", file));
      return;
    }
    long ticks = Math.round((nanos - begun) * 1e-9 * Mp4File.TIMESCALE);
    keep(ticks);
    if (ticks - fragmentBegun >= FRAGMENT) {
      flush(film.get());
      fragmentBegun = ticks;
    }
    byte[] slice = unit(encoded, encoded.nalUnits() - 1);
    kept = Optional.of(new BufferedUnit(slice, encoded.idr(), ticks));
  }

  /** Returns a NAL unit without its start code. */
  private static byte[] unit(AccessUnit encoded, int unit) {
    int start = encoded.start(unit) + START_CODE_LENGTH;
    return Arrays.copyOfRange(encoded.bytes(), start, encoded.start(unit + 1));
  }

  /** Adds the buffered picture to the fragment, with a duration up to now. */
  private void keep(long now) {
    if (kept.isPresent()) {
      BufferedUnit picture = kept.get();
      kept = Optional.empty();
      int shown = Math.toIntExact(Math.max(1, now - picture.ticks));
      fragment.add(new Sample(picture.unit, picture.key, shown));
      count++;
    }
  }

  private void flush(Mp4File written) throws IOException {
    List<Sample> samples = List.copyOf(fragment);
    fragment.clear();
    written.add(samples);
  }

  private void fail(Phrase reason) {
    failure = Optional.of(reason);
    try {
      close();
    } catch (IOException e) {
      failure =
          Optional.of(Phrase.of("%s; its last second may be missing: %s", reason, IoReason.of(e)));
    }
  }

  /**
   * Completes the file, or deletes it if it contains no pictures. Does nothing if the recording has
   * already ended.
   *
   * @throws IOException if the end of the file cannot be written
   */
  @Override
  public synchronized void close() throws IOException {
    if (ended) {
      return;
    }
    ended = true;
    try (channel) {
      if (film.isPresent()) {
        keep(kept.map(BufferedUnit::ticks).orElse(0L) + LAST);
        try (Mp4File written = film.get()) {
          flush(written);
        }
      }
    }
    if (film.isEmpty()) {
      Files.deleteIfExists(file);
    }
  }
}
