package tellosimulator.video;

import static tellosimulator.video.Boxes.ascii;
import static tellosimulator.video.Boxes.box;
import static tellosimulator.video.Boxes.fullBox;
import static tellosimulator.video.Boxes.joined;
import static tellosimulator.video.Boxes.u16;
import static tellosimulator.video.Boxes.u32;
import static tellosimulator.video.Boxes.u64;
import static tellosimulator.video.Boxes.u8;
import static tellosimulator.video.Boxes.zeros;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * An MP4 file with one H.264 track (ISO/IEC 14496-12 and 14496-15). It is written as fragments, so
 * that it remains playable no matter how the program ends. JCodec's muxer is not used, because it
 * writes its only movie box at the end: if the program were killed, the whole recording would be
 * lost. Closing the file converts it to an ordinary one, in which all players and editors can seek.
 * First, a movie box with the positions of all pictures is appended. Then, a single write of 16
 * bytes turns all fragments into media data. Not thread-safe.
 */
final class Mp4File implements AutoCloseable {

  /** Ticks per second. Decided: as in RTP, and fine enough for any picture rate. */
  static final int TIMESCALE = 90_000;

  /** Size of the box that reserves space for the header of the media data [bytes]. */
  private static final int MEDIA_HEADER = 16;

  /** Size of the length field that precedes each picture [bytes]. */
  private static final int LENGTH_BYTES = 4;

  private static final int TRACK = 1;

  /**
   * The identity matrix as fixed-point numbers with 16 and 30 fractional bits (14496-12, 6.2.2).
   */
  private static final byte[] UNITY = u32(0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000);

  /** Sample flags of a picture that does not depend on others (14496-12, 8.8.3.1). */
  private static final int SYNC_SAMPLE = 0x02000000;

  /** Sample flags of a picture that depends on others and is not a sync sample. */
  private static final int OTHER_SAMPLE = 0x01010000;

  /**
   * The decoder configuration.
   *
   * @param sequence the sequence parameter set, without start code
   * @param picture the picture parameter set, without start code
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared, and the bytes are never modified
  record Format(int width, int height, byte[] sequence, byte[] picture) {}

  /**
   * A picture.
   *
   * @param unit the only NAL unit of the picture, without start code
   * @param key whether decoding can start at this picture
   * @param ticks the duration of the picture
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared, and the bytes are never modified
  record Sample(byte[] unit, boolean key, int ticks) {}

  private record Place(int size, boolean key, int ticks) {}

  /** The position of a fragment's pictures in the file. */
  private record Chunk(long offset, int samples) {}

  private final FileChannel channel;
  private final Format format;
  private final List<Place> places = new ArrayList<>();
  private final List<Chunk> chunks = new ArrayList<>();
  private final long mediaStart;
  private long end;
  private long duration;

  private Mp4File(FileChannel channel, Format format) throws IOException {
    this.channel = channel;
    this.format = format;
    byte[] type = box("ftyp", ascii("isom"), u32(0x200), ascii("isomiso5avc1mp41"));
    mediaStart = type.length;
    append(joined(type, box("free", zeros(MEDIA_HEADER - Boxes.HEADER)), movie(true)));
  }

  /**
   * Writes the beginning of a file.
   *
   * @param channel an empty file, which is closed together with this object
   */
  static Mp4File begin(FileChannel channel, Format format) throws IOException {
    return new Mp4File(channel, format);
  }

  /** Creates a file, which must not exist yet. */
  static FileChannel create(Path file) throws IOException {
    return FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  /**
   * Adds consecutive pictures; the first picture of the file must be a key picture.
   *
   * @throws IOException if they cannot be written; the file then ends before them
   */
  void add(List<Sample> samples) throws IOException {
    List<Place> added =
        samples.stream()
            .map(one -> new Place(LENGTH_BYTES + one.unit().length, one.key(), one.ticks()))
            .toList();
    int size = fragment(added, 0).length;
    byte[][] units =
        samples.stream()
            .flatMap(one -> Stream.of(u32(one.unit().length), one.unit()))
            .toArray(byte[][]::new);
    long data = end + size + Boxes.HEADER;
    append(joined(fragment(added, size + Boxes.HEADER), box("mdat", units)));
    places.addAll(added);
    chunks.add(new Chunk(data, samples.size()));
    duration += added.stream().mapToLong(Place::ticks).sum();
  }

  /**
   * Builds the header of a fragment (14496-12, 8.8.4).
   *
   * @param offset the position of the first picture, from the beginning of the fragment [bytes]
   */
  private byte[] fragment(List<Place> samples, int offset) {
    long[] run =
        samples.stream()
            .flatMapToLong(
                one -> LongStream.of(one.ticks, one.size, one.key ? SYNC_SAMPLE : OTHER_SAMPLE))
            .toArray();
    return box(
        "moof",
        fullBox("mfhd", 0, u32(chunks.size() + 1L)),
        box(
            "traf",
            fullBox("tfhd", 0x020000, u32(TRACK)), // offsets are relative to moof
            fullBox("tfdt", 0x01000000, u64(duration)),
            // an offset, and the duration, size and flags of each picture
            fullBox("trun", 0x000701, u32(samples.size(), offset), u32(run))));
  }

  /**
   * Converts the file to an ordinary MP4 file. If that fails, the fragments remain playable.
   *
   * @throws IOException if the file cannot be written
   */
  @Override
  public void close() throws IOException {
    try (channel) {
      long size = end - mediaStart;
      append(movie(false));
      // 1 means: the size follows the type
      write(joined(u32(1), ascii("mdat"), u64(size)), mediaStart);
    }
  }

  private void append(byte[] bytes) throws IOException {
    try {
      write(bytes, end);
      end += bytes.length;
    } catch (IOException e) {
      channel.truncate(end);
      throw e;
    }
  }

  private void write(byte[] bytes, long position) throws IOException {
    ByteBuffer left = ByteBuffer.wrap(bytes);
    while (left.hasRemaining()) {
      channel.write(left, position + left.position());
    }
  }

  // --- the movie's description (14496-12, 8.2 to 8.8) ---

  private byte[] movie(boolean fragmented) {
    return box(
        "moov",
        fullBox("mvhd", 0, movieHeader()),
        box("trak", track()),
        fragmented ? box("mvex", fullBox("trex", 0, u32(TRACK, 1), zeros(12))) : zeros(0));
  }

  private byte[] movieHeader() {
    return joined(
        zeros(8),
        u32(TIMESCALE, duration),
        u32(0x10000), // normal speed
        u16(0x100), // normal volume
        zeros(10),
        UNITY,
        zeros(24),
        u32(TRACK + 1));
  }

  private byte[] track() {
    byte[] header =
        joined(
            zeros(8),
            u32(TRACK, 0, duration),
            zeros(16),
            UNITY,
            u32((long) format.width << 16, (long) format.height << 16));
    byte[] media = joined(zeros(8), u32(TIMESCALE, duration), u16(0x55c4, 0));
    return joined(
        fullBox("tkhd", 3, header), // enabled, and part of the movie
        box(
            "mdia",
            fullBox("mdhd", 0, media),
            fullBox("hdlr", 0, zeros(4), ascii("vide"), zeros(12), ascii("video\0")),
            box(
                "minf",
                fullBox("vmhd", 1, zeros(8)),
                box("dinf", fullBox("dref", 0, u32(1), fullBox("url ", 1))),
                box("stbl", tables()))));
  }

  private byte[] tables() {
    long[] durations = places.stream().flatMapToLong(one -> LongStream.of(1, one.ticks)).toArray();
    long[] keys =
        LongStream.rangeClosed(1, places.size()).filter(i -> places.get((int) i - 1).key).toArray();
    long[] counts =
        IntStream.range(0, chunks.size())
            .boxed()
            .flatMapToLong(i -> LongStream.of(i + 1L, chunks.get(i).samples, 1))
            .toArray();
    return joined(
        fullBox("stsd", 0, u32(1), box("avc1", description())),
        fullBox("stts", 0, u32(places.size()), u32(durations)),
        fullBox("stss", 0, u32(keys.length), u32(keys)),
        fullBox("stsc", 0, u32(chunks.size()), u32(counts)),
        fullBox(
            "stsz",
            0,
            u32(0, places.size()),
            u32(places.stream().mapToLong(Place::size).toArray())),
        fullBox(
            "co64",
            0,
            u32(chunks.size()),
            u64(chunks.stream().mapToLong(Chunk::offset).toArray())));
  }

  /** Builds the sample description (14496-15, 5.3.3 and 5.4.2). */
  private byte[] description() {
    byte[] set = format.sequence;
    return joined(
        zeros(6),
        u16(1),
        zeros(16),
        u16(format.width, format.height),
        u32(0x480000, 0x480000, 0), // 72 dpi
        u16(1),
        zeros(32),
        u16(24, -1),
        box(
            "avcC",
            u8(1, set[1], set[2], set[3], 0xfc | (LENGTH_BYTES - 1), 0xe1),
            u16(set.length),
            set,
            u8(1),
            u16(format.picture.length),
            format.picture));
  }
}
