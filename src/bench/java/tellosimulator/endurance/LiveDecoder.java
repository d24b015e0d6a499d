package tellosimulator.endurance;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;

/** Takes a drone's video, and lets ffmpeg decode it as it comes. For one thread. */
final class LiveDecoder implements AutoCloseable {

  /** With more than this waiting for ffmpeg, pictures are left out [datagrams]; about 60 MB. */
  private static final int MOST_WAITING = 40_000;

  /** Types of NAL units that are slices of a picture. Source: H.264, table 7-1. */
  private static final List<Integer> SLICES = List.of(1, 5);

  private static final int START_CODE = 4;

  /** Taken for the end of the stream. */
  private static final byte[] END = {};

  private static final double PATIENCE_SECONDS = 60;

  /** Documented: proc(5); there is one for each kind of address that a socket may have. */
  private static final List<Path> SOCKETS =
      List.of(Path.of("/proc/net/udp"), Path.of("/proc/net/udp6"));

  private static final int LOCAL_ADDRESS = 1;

  private static final List<String> FFMPEG =
      List.of(
          "ffmpeg",
          "-nostdin",
          "-v",
          "error",
          "-stats_period",
          "60",
          "-progress",
          "pipe:1",
          "-f",
          "h264",
          "-i",
          "pipe:0",
          "-f",
          "null",
          "-");

  private final DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
  private final BlockingQueue<byte[]> waiting = new LinkedBlockingQueue<>(MOST_WAITING);
  private final AtomicLong pictures = new AtomicLong();
  private final AtomicLong leftOut = new AtomicLong();
  private final Program ffmpeg;
  private final Thread writer;

  LiveDecoder() throws IOException {
    socket.setReceiveBufferSize(1 << 22);
    ffmpeg = Host.HERE.start(FFMPEG);
    writer = Daemon.start("decoder", this::write);
    Daemon.start("film", this::receive);
  }

  int port() {
    return socket.getLocalPort();
  }

  /** How many pictures have come. */
  long pictures() {
    return pictures.get();
  }

  private void receive() {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    try {
      while (true) {
        socket.receive(packet);
        byte[] bytes = Arrays.copyOf(packet.getData(), packet.getLength());
        if (beginsPicture(bytes)) {
          pictures.incrementAndGet();
        }
        if (!waiting.offer(bytes)) {
          leftOut.incrementAndGet();
        }
      }
    } catch (IOException e) {
      return; // closed
    }
  }

  /** A drone's NAL unit begins a new datagram. */
  private static boolean beginsPicture(byte[] bytes) {
    return bytes.length > START_CODE
        && Arrays.equals(Arrays.copyOf(bytes, START_CODE), new byte[] {0, 0, 0, 1})
        && SLICES.contains(bytes[START_CODE] & 0x1f);
  }

  private void write() {
    try (OutputStream to = ffmpeg.process().getOutputStream()) {
      for (byte[] next = waiting.take(); next != END; next = waiting.take()) {
        to.write(next);
      }
    } catch (IOException e) {
      return; // ffmpeg has ended, which is told by what it decoded
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Datagrams of the film that came, but for which there was no room here. */
  long lost() throws IOException {
    long lost = leftOut.get();
    for (Path sockets : SOCKETS) {
      lost += dropped(sockets);
    }
    return lost;
  }

  /** What the kernel had no room for at this socket; the last word of its line. */
  private long dropped(Path sockets) throws IOException {
    String port = String.format(":%04X", port());
    try (Stream<String> lines = Files.lines(sockets)) {
      return lines
          .map(line -> List.of(line.trim().split("\\s+", -1)))
          .filter(words -> words.get(LOCAL_ADDRESS).endsWith(port))
          .mapToLong(words -> Long.parseLong(words.get(words.size() - 1)))
          .sum();
    }
  }

  /** How many pictures ffmpeg has made of all; the video must be off. */
  long decoded() throws IOException {
    try {
      if (!waiting.offer(END, (long) PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        throw new IOException("ffmpeg takes nothing any more: " + ffmpeg.errors());
      }
      writer.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    Optional<String> frames =
        ffmpeg.rest(PATIENCE_SECONDS).stream()
            .filter(line -> line.startsWith("frame="))
            .reduce((first, second) -> second);
    return Long.parseLong(frames.orElse("frame=0").substring("frame=".length()).trim());
  }

  /** What ffmpeg complained about; empty if nothing. */
  String complaints() {
    try {
      return ffmpeg.errors();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    socket.close();
    ffmpeg.close();
  }
}
