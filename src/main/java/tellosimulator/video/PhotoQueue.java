package tellosimulator.video;

import java.util.Queue;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The photos that a drone has been ordered to take, and that its video thread still has to render.
 * Thread-safe.
 */
final class PhotoQueue {

  private static final Logger LOG = LoggerFactory.getLogger(PhotoQueue.class);

  /** Maximum time to wait for a photo [s]. Decided: much longer than rendering one takes. */
  private static final int PATIENCE = 10;

  private final int drone;
  private final Queue<FutureTask<byte[]>> waiting = new ConcurrentLinkedQueue<>();

  /**
   * Creates an empty queue.
   *
   * @param drone the drone's number, from 1
   */
  PhotoQueue(int drone) {
    this.drone = drone;
  }

  /**
   * Adds a photo.
   *
   * @param photo renders the photo as a JPEG file
   * @return waits until the photo has been rendered, and supplies it; empty if it failed
   */
  Supplier<byte[]> add(Callable<byte[]> photo) {
    FutureTask<byte[]> task = new FutureTask<>(photo);
    waiting.add(task);
    return () -> result(task);
  }

  private byte[] result(FutureTask<byte[]> task) {
    try {
      return task.get(PATIENCE, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException e) {
      LOG.error("The photo of drone {} failed: {}", drone, e.getCause().toString());
    } catch (TimeoutException | CancellationException e) {
      LOG.error("The photo of drone {} was not taken: {}", drone, e.toString());
    }
    return new byte[0];
  }

  /** Renders all waiting photos on the calling thread. */
  void takeAll() {
    for (FutureTask<byte[]> task = waiting.poll(); task != null; task = waiting.poll()) {
      task.run();
    }
  }

  /** Gives up all waiting photos. */
  void close() {
    waiting.forEach(task -> task.cancel(false));
  }
}
