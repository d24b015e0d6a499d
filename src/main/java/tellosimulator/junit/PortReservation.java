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
 * Ports that no other simulator of this machine gives to a program under test, in whichever process
 * it runs. A locked file stands for each; locks end with their process. The ports are below those
 * from which systems choose by themselves, so nobody else comes upon them by chance.
 */
final class PortReservation implements AutoCloseable {

  private static final int FIRST = 20_000;

  /** Systems choose by themselves from 32768 (Linux) or 49152 on (Windows, macOS; RFC 6335). */
  private static final int END = 32_768;

  private static final String REAL = "real";

  /** File locks belong to a process; this is for its threads. */
  private static final Semaphore REAL_PORTS = new Semaphore(1);

  private final List<FileChannel> locks = new ArrayList<>();
  private final List<Integer> ports = new ArrayList<>();
  private boolean real;

  private PortReservation() {}

  /**
   * Reserves ports. For the real ones it waits until nobody else has them.
   *
   * @param count how many free ones
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
    FileLock lock = channel.lock(); // until another process has ended or closed its simulator
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

  /** Where to begin to look: elsewhere for each process and reservation, so that few meet. */
  private int first() {
    long process = ProcessHandle.current().pid() * 7919; // neighbours far from each other
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

  /** The free ones. */
  List<Integer> ports() {
    return ports;
  }

  /** Gives them back. */
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
