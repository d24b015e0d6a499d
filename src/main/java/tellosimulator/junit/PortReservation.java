package tellosimulator.junit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Semaphore;

/**
 * Reserves ports for simulators and the programs under test. No two simulators on this machine hold
 * the same port, even in different processes: a locked file represents each reserved port, and a
 * lock ends with its process. The ports are below the ephemeral range of every operating system, so
 * no other program is assigned one by chance.
 */
final class PortReservation implements AutoCloseable {

  private static final int FIRST = 20_000;

  /**
   * The end of the range, exclusive. Documented: ephemeral ports begin at 32768 (Linux) or at 49152
   * (Windows and macOS; RFC 6335).
   */
  private static final int END = 32_768;

  private static final String REAL = "real";

  /**
   * Held while a simulator in this process uses the real ports. A file lock does not exclude other
   * threads, because it belongs to the whole process.
   */
  private static final Semaphore REAL_PORTS = new Semaphore(1);

  private final List<FileChannel> locks = new ArrayList<>();
  private final List<Integer> ports = new ArrayList<>();
  private boolean real;

  private PortReservation() {}

  /**
   * Reserves free ports, or the real ports. If another simulator holds the real ports, waits until
   * it releases them.
   *
   * @param count the number of free ports to reserve
   */
  static PortReservation of(PortChoice which, int count) {
    PortReservation reservation = new PortReservation();
    try {
      Path folder =
          Files.createDirectories(
              Path.of(System.getProperty("java.io.tmpdir"), "tello-simulator-ports"));
      if (which == PortChoice.REAL) {
        reservation.reserveReal(folder);
      } else {
        reservation.reserveFree(folder, count);
      }
      return reservation;
    } catch (IOException e) {
      reservation.close();
      throw new UncheckedIOException(e);
    }
  }

  private void reserveReal(Path folder) throws IOException {
    REAL_PORTS.acquireUninterruptibly();
    real = true;
    FileChannel channel = open(folder, REAL);
    locks.add(channel);
    FileLock lock = channel.lock(); // waits until another process has ended or closed its simulator
    if (!lock.isValid()) {
      throw new IOException("the lock of the real ports was lost");
    }
  }

  private void reserveFree(Path folder, int count) throws IOException {
    int next = first();
    for (int tried = 0; ports.size() < count; tried++) {
      if (tried == END - FIRST) {
        throw new IllegalStateException(
            "there are no " + count + " free UDP ports from " + FIRST + " to " + END);
      }
      FileChannel channel = open(folder, Integer.toString(next));
      if (locked(channel) && bindable(next)) {
        locks.add(channel);
        ports.add(next);
      } else {
        channel.close();
      }
      next = next + 1 < END ? next + 1 : FIRST;
    }
  }

  /**
   * Returns the first port to try. It differs between processes and reservations, to avoid
   * contention.
   */
  private int first() {
    long process = ProcessHandle.current().pid() * 7919; // spreads consecutive process ids
    return FIRST + (int) ((process + System.identityHashCode(this)) % (END - FIRST));
  }

  private static FileChannel open(Path folder, String name) throws IOException {
    return FileChannel.open(
        folder.resolve(name), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
  }

  private static boolean locked(FileChannel channel) throws IOException {
    try {
      return channel.tryLock() != null;
    } catch (OverlappingFileLockException e) {
      return false;
    }
  }

  private static boolean bindable(int port) {
    try (DatagramSocket socket = new DatagramSocket(new InetSocketAddress(port))) {
      return socket.isBound();
    } catch (SocketException e) {
      return false;
    }
  }

  /** Returns the reserved free ports. */
  List<Integer> ports() {
    return ports;
  }

  /** Releases the ports. */
  @Override
  public void close() {
    try {
      for (FileChannel lock : locks) {
        lock.close();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      if (real) {
        real = false;
        REAL_PORTS.release();
      }
    }
  }
}
