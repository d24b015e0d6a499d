package tellosimulator.video;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;

/**
 * An MP4 file with one H.264 track (ISO/IEC 14496-12 and 14496-15), written as fragments: what has
 * been written plays, however the program ends. Closing it makes an ordinary file of it, in which
 * all players and editors can seek: a movie with the places of all pictures is appended, and then
 * all fragments become its media data by one write of 16 bytes. Not for several threads.
 */
final class Mp4File implements AutoCloseable {

  /** Ticks a second. Decided: as in RTP, fine enough for any picture rate. */
  static final int TIMESCALE = 90_000;

  /** A box of this size is kept free for the header of the media data. */
  private static final int MEDIA_HEADER = 16;

  /** Each picture is preceded by its length in this many bytes. */
  private static final int LENGTH_BYTES = 4;

  private static final int TRACK = 1;

  /** Unity, as fixed-point numbers of 16 and of 30 bits (14496-12, 6.2.2). */
  private static final int[] UNITY = {0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000};

  /** Flags of pictures (14496-12, 8.8.3.1): depends on no other, or on others and is no sync. */
  private static final int SYNC_SAMPLE = 0x02000000;

  private static final int OTHER_SAMPLE = 0x01010000;

  /**
   * What decoders must know before the first picture.
   *
   * @param sequence the sequence parameter set, without start code
   * @param picture the picture parameter set, without start code
   */
  record Format(int width, int height, ByteBuffer sequence, ByteBuffer picture) {}

  /**
   * A picture.
   *
   * @param unit its only NAL unit, without start code
   * @param ticks how long it is shown
   */
  record Sample(ByteBuffer unit, boolean key, int ticks) {}

  private record Place(int size, boolean key, int ticks) {}

  /** A fragment's pictures in the file. */
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
    BoxWriter out = new BoxWriter();
    out.box("ftyp", () -> out.ascii("isom").u32(0x200).ascii("isomiso5avc1mp41"));
    mediaStart = out.size();
    out.box("free", () -> out.zeros(MEDIA_HEADER - 8));
    movie(out, true);
    append(out.toBuffer());
  }

  /**
   * Begins a file.
   *
   * @param channel an empty file, which is closed with this
   */
  static Mp4File begin(FileChannel channel, Format format) throws IOException {
    return new Mp4File(channel, format);
  }

  /** Opens a file, which must not exist yet. */
  static FileChannel create(Path file) throws IOException {
    return FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  /**
   * Adds pictures that are shown one after another; the first one of all must be a key picture.
   *
   * @throws IOException if they cannot be written; then the file ends before them
   */
  void add(List<Sample> samples) throws IOException {
    List<Place> added =
        samples.stream()
            .map(one -> new Place(LENGTH_BYTES + one.unit().remaining(), one.key(), one.ticks()))
            .toList();
    BoxWriter out = new BoxWriter();
    fragment(out, added);
    long data = end + out.size() + 8;
    out.box(
        "mdat", () -> samples.forEach(one -> out.u32(one.unit().remaining()).bytes(one.unit())));
    append(out.toBuffer());
    places.addAll(added);
    chunks.add(new Chunk(data, samples.size()));
    duration += added.stream().mapToLong(Place::ticks).sum();
  }

  private void fragment(BoxWriter out, List<Place> samples) {
    int[] dataOffset = {0};
    out.box(
        "moof",
        () -> {
          out.fullBox("mfhd", 0, () -> out.u32(chunks.size() + 1L));
          out.box(
              "traf",
              () -> {
                out.fullBox("tfhd", 0x020000, () -> out.u32(TRACK)); // offsets are from moof
                out.fullBox("tfdt", 0x01000000, () -> out.u64(duration));
                out.fullBox(
                    "trun",
                    0x000701, // an offset, and for each picture duration, size and flags
                    () -> {
                      out.u32(samples.size());
                      dataOffset[0] = out.size();
                      out.u32(0);
                      samples.forEach(one -> run(out, one));
                    });
              });
        });
    out.set(dataOffset[0], out.size() + 8);
  }

  private static void run(BoxWriter out, Place one) {
    out.u32(one.ticks()).u32(one.size()).u32(one.key() ? SYNC_SAMPLE : OTHER_SAMPLE);
  }

  /**
   * Makes an ordinary file of it. If that fails, the fragments stay, and play.
   *
   * @throws IOException if it cannot be written
   */
  @Override
  public void close() throws IOException {
    try (channel) {
      long mediaEnd = end;
      BoxWriter out = new BoxWriter();
      movie(out, false);
      append(out.toBuffer());
      BoxWriter header = new BoxWriter();
      header.u32(1).ascii("mdat").u64(mediaEnd - mediaStart); // 1: its size follows the type
      write(header.toBuffer(), mediaStart);
    }
  }

  private void append(ByteBuffer bytes) throws IOException {
    int size = bytes.remaining();
    try {
      write(bytes, end);
      end += size;
    } catch (IOException e) {
      channel.truncate(end);
      throw e;
    }
  }

  private void write(ByteBuffer bytes, long position) throws IOException {
    long at = position;
    while (bytes.hasRemaining()) {
      at += channel.write(bytes, at);
    }
  }

  // --- the movie's description (14496-12, 8.2 to 8.8) ---

  private void movie(BoxWriter out, boolean fragmented) {
    out.box(
        "moov",
        () -> {
          out.fullBox("mvhd", 0, () -> movieHeader(out));
          out.box("trak", () -> track(out));
          if (fragmented) {
            out.box("mvex", () -> out.fullBox("trex", 0, () -> out.u32(TRACK).u32(1).zeros(12)));
          }
        });
  }

  private void movieHeader(BoxWriter out) {
    out.zeros(8).u32(TIMESCALE).u32(duration);
    out.u32(0x10000).u16(0x100).zeros(10); // normal speed and volume
    matrix(out);
    out.zeros(24).u32(TRACK + 1);
  }

  private void track(BoxWriter out) {
    out.fullBox(
        "tkhd",
        3, // enabled, and part of the movie
        () -> {
          out.zeros(8).u32(TRACK).zeros(4).u32(duration).zeros(16);
          matrix(out);
          out.u32((long) format.width << 16).u32((long) format.height << 16);
        });
    out.box(
        "mdia",
        () -> {
          out.fullBox(
              "mdhd", 0, () -> out.zeros(8).u32(TIMESCALE).u32(duration).u16(0x55c4).u16(0));
          out.fullBox("hdlr", 0, () -> out.zeros(4).ascii("vide").zeros(12).ascii("video\0"));
          out.box(
              "minf",
              () -> {
                out.fullBox("vmhd", 1, () -> out.zeros(8));
                out.box(
                    "dinf",
                    () ->
                        out.fullBox(
                            "dref", 0, () -> out.u32(1).fullBox("url ", 1, () -> out.zeros(0))));
                out.box("stbl", () -> tables(out));
              });
        });
  }

  private static void matrix(BoxWriter out) {
    for (int number : UNITY) {
      out.u32(number);
    }
  }

  private void tables(BoxWriter out) {
    out.fullBox("stsd", 0, () -> out.u32(1).box("avc1", () -> description(out)));
    out.fullBox(
        "stts",
        0,
        () -> {
          out.u32(places.size());
          places.forEach(one -> out.u32(1).u32(one.ticks()));
        });
    out.fullBox(
        "stss",
        0,
        () -> {
          out.u32(places.stream().filter(Place::key).count());
          for (int i = 0; i < places.size(); i++) {
            if (places.get(i).key()) {
              out.u32(i + 1L);
            }
          }
        });
    out.fullBox(
        "stsc",
        0,
        () -> {
          out.u32(chunks.size());
          for (int i = 0; i < chunks.size(); i++) {
            out.u32(i + 1L).u32(chunks.get(i).samples()).u32(1);
          }
        });
    out.fullBox(
        "stsz",
        0,
        () -> {
          out.u32(0).u32(places.size());
          places.forEach(one -> out.u32(one.size()));
        });
    out.fullBox(
        "co64",
        0,
        () -> {
          out.u32(chunks.size());
          chunks.forEach(one -> out.u64(one.offset()));
        });
  }

  /** How the pictures are coded (14496-15, 5.3.3 and 5.4.2). */
  private void description(BoxWriter out) {
    out.zeros(6).u16(1).zeros(16).u16(format.width).u16(format.height);
    out.u32(0x480000).u32(0x480000).zeros(4).u16(1).zeros(32).u16(24).u16(-1); // 72 dots an inch
    out.box(
        "avcC",
        () -> {
          ByteBuffer sequence = format.sequence;
          out.u8(1)
              .u8(sequence.get(1))
              .u8(sequence.get(2))
              .u8(sequence.get(3))
              .u8(0xfc | (LENGTH_BYTES - 1));
          out.u8(0xe1).u16(sequence.remaining()).bytes(sequence);
          out.u8(1).u16(format.picture.remaining()).bytes(format.picture);
        });
  }
}
