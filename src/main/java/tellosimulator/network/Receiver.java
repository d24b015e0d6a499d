package tellosimulator.network;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Exceptions;
import tellosimulator.concurrent.Worker;
import tellosimulator.sim.Simulation;

/**
 * Receives the datagrams of all open sockets on one thread, and passes them to the simulation. When
 * the thread wakes up, it reads all pending datagrams before it passes on any of them. Thus, if a
 * program sends two datagrams to different drones, the second cannot overtake the first; see {@link
 * DatagramBatch}. No received datagram can terminate the thread. Thread-safe.
 */
final class Receiver implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(Receiver.class);

  /**
   * Buffer length [bytes]. It exceeds the longest command, so that an overlong command is
   * recognized.
   */
  private static final int BUFFER = 2048;

  /** Maximum number of datagrams read from one socket before the next socket is read. Decided. */
  private static final int MOST_OF_PORT = 64;

  /**
   * Pause after a socket failure [ms], so that repeated failures do not occupy a whole processor.
   * Decided.
   */
  private static final int BACK_OFF_MS = 10;

  /** Interval at which {@link #settle} checks whether the thread has ended [ms]. */
  private static final int PATIENCE_MS = 1000;

  private final Selector selector;
  private final Simulation simulation;
  private final Queue<CountDownLatch> settling = new ConcurrentLinkedQueue<>();
  private final Worker worker;
  private volatile boolean closed;

  private record Source(UdpPort port, CommandConnection connection) {}

  private Receiver(Selector selector, Simulation simulation) {
    this.selector = selector;
    this.simulation = simulation;
    this.worker = Worker.start("receiver", new DutyCycle());
  }

  /**
   * Starts a receiver without sockets.
   *
   * @throws IllegalStateException if the system is out of resources
   */
  static Receiver start(Simulation simulation) {
    try {
      return new Receiver(Selector.open(), simulation);
    } catch (IOException e) {
      throw new IllegalStateException(
          "the system cannot provide a selector for receiving datagrams", e);
    }
  }

  /** Receives from a socket until the socket is closed. */
  void add(UdpPort port, CommandConnection connection) {
    port.register(selector, new Source(port, connection));
    wakeUp();
  }

  /**
   * Waits until all datagrams that have arrived at the sockets have been passed on, and until
   * closed sockets are deregistered, so that their ports are free. Returns at once if the receiver
   * has ended.
   */
  void settle() {
    CountDownLatch settled = new CountDownLatch(1);
    settling.add(settled);
    wakeUp();
    try {
      while (!worker.hasEnded() && !settled.await(PATIENCE_MS, TimeUnit.MILLISECONDS)) {
        wakeUp();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Starts the work for which {@link #settle} waits, and returns at once. */
  void settleSoon() {
    wakeUp();
  }

  /**
   * Wakes up the selector. A closed selector must not be woken, because its descriptor may already
   * be reused.
   */
  private synchronized void wakeUp() {
    if (selector.isOpen()) {
      selector.wakeup();
    }
  }

  /** Stops the receiver after the work in progress. The sockets are closed by their owners. */
  @Override
  public void close() {
    closed = true;
    wakeUp();
    worker.close();
    try {
      synchronized (this) {
        selector.close();
      }
    } catch (IOException e) {
      LOG.debug("Closing the selector failed: {}", e.toString());
    }
  }

  private final class DutyCycle implements Agent {

    private final ErrorPolicy once = ErrorPolicy.goOn("A datagram could not be handled");
    private final ErrorPolicy fatal = ErrorPolicy.retry("Receiving failed");
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER);
    private final byte[] bytes = new byte[BUFFER];
    private final DatagramBatch batch = new DatagramBatch();

    /** Sockets that are paused after a failure. */
    private final List<SelectionKey> failed = new ArrayList<>();

    @Override
    public Outcome doWork() throws IOException {
      int settled = settling.size();
      try {
        receive(settled > 0 || batch.size() > 0);
      } finally {
        batch.handOver(simulation);
      }
      for (int i = 0; i < settled; i++) {
        settling.remove().countDown();
      }
      return closed ? Outcome.FINISHED : Outcome.WORKED;
    }

    /**
     * Reads all pending datagrams, and repeats this until no more are found. When a command is
     * found, all earlier commands of the same program have already been sent, but may not have been
     * read yet from the sockets of other drones.
     */
    private void receive(boolean atOnce) throws IOException {
      if (atOnce) {
        selector.selectNow(this::read);
      } else {
        await();
      }
      int found = selector.keys().size() > 1 ? 0 : batch.size(); // a single socket keeps the order
      while (batch.size() > found && batch.hasRoom()) {
        found = batch.size();
        selector.selectNow(this::read);
      }
    }

    private void await() throws IOException {
      if (failed.isEmpty()) {
        selector.select(this::read);
        return;
      }
      List<SelectionKey> pausing = List.copyOf(failed);
      failed.clear();
      try {
        selector.select(this::read, BACK_OFF_MS);
      } finally {
        pausing.stream()
            .filter(SelectionKey::isValid)
            .forEach(key -> key.interestOps(SelectionKey.OP_READ));
      }
    }

    private void read(SelectionKey key) {
      Source source = (Source) key.attachment();
      try {
        for (int i = 0; i < MOST_OF_PORT && batch.hasRoom() && readNext(source); i++) {
          source.connection().works();
        }
      } catch (ClosedChannelException e) {
        key.cancel();
      } catch (IOException e) {
        source.connection().fails(e);
        key.interestOps(0);
        failed.add(key);
      }
    }

    private boolean readNext(Source source) throws IOException {
      buffer.clear();
      InetSocketAddress sender = source.port().receive(buffer);
      if (sender == null) {
        return false;
      }
      int length = buffer.flip().remaining();
      buffer.get(bytes, 0, length);
      source.connection().take(sender, bytes, length).ifPresent(batch::add);
      return true;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return Exceptions.isFatal(failure) ? fatal : once;
    }
  }
}
