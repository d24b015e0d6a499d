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
 * Receives what comes to the open sockets of all drones, on one thread, and hands it to the
 * simulation. What is waiting when it wakes up is read as a whole before any of it is handed over,
 * so that of two datagrams that a program sends to different drones the second does not overtake
 * the first; see {@link DatagramBatch}. Nothing that arrives ends it. Its methods are for any
 * thread.
 */
final class Receiver implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(Receiver.class);

  /** Longer than the longest command, so that a longer one is seen to be longer [bytes]. */
  private static final int BUFFER = 2048;

  /** Datagrams that are read from a socket before the next one has its turn. Decided. */
  private static final int MOST_OF_PORT = 64;

  /** Pause after a socket failed, so that it does not take a whole processor [ms]. Decided. */
  private static final int BACK_OFF_MS = 10;

  /** How often {@link #settle} looks whether the thread has ended [ms]. */
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
   * Starts; nothing is received yet.
   *
   * @throws IllegalStateException if the system has no more of what that takes
   */
  static Receiver start(Simulation simulation) {
    try {
      return new Receiver(Selector.open(), simulation);
    } catch (IOException e) {
      throw new IllegalStateException("the system lets nobody wait for datagrams", e);
    }
  }

  /** Receives from a socket until that is closed. */
  void add(UdpPort port, CommandConnection connection) {
    port.register(selector, new Source(port, connection));
    wakeUp();
  }

  /**
   * Waits until what has come to the sockets is handed over and sockets that have been closed are
   * let go of, so that their ports are free. Does not wait after the end.
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

  /** As {@link #settle}, soon. */
  void settleSoon() {
    wakeUp();
  }

  /** A selector that is closed must not be woken: its descriptor may be another's by then. */
  private synchronized void wakeUp() {
    if (selector.isOpen()) {
      selector.wakeup();
    }
  }

  /** Ends it after what it does now. Sockets are closed by whoever opened them. */
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

    /** Sockets that failed, and pause. */
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
     * Who sends a command after the reply to the one before, or without such, has sent everything
     * else by then: so it is looked once more after something was found.
     */
    private void receive(boolean atOnce) throws IOException {
      if (atOnce) {
        selector.selectNow(this::read);
      } else {
        await();
      }
      int found = selector.keys().size() > 1 ? 0 : batch.size(); // one socket has its own order
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
