package tellosimulator.view.video;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * A picture of the window's scene that a drone's video wants. The video thread makes it and waits;
 * the JavaFX thread fills it.
 */
public final class SnapshotOrder {

  private final int drone;
  private final int width;
  private final int height;
  private final int[] argb;
  private final CountDownLatch filled = new CountDownLatch(1);

  /**
   * @param drone whose camera takes it, from 1
   * @param argb gets the pixels; nobody else may use it before this is filled
   */
  SnapshotOrder(int drone, int width, int height, int[] argb) {
    this.drone = drone;
    this.width = width;
    this.height = height;
    this.argb = argb;
  }

  /** Whose camera takes it, from 1. */
  public int drone() {
    return drone;
  }

  /** Pixels. */
  public int width() {
    return width;
  }

  /** Pixels. */
  public int height() {
    return height;
  }

  /** Where the pixels go, row by row, each opaque with 8 bits for alpha, red, green and blue. */
  public int[] argb() {
    return argb;
  }

  /** All pixels are there. */
  void fill() {
    filled.countDown();
  }

  /**
   * Waits for the pixels.
   *
   * @return whether they came in time
   */
  boolean await(long nanos) {
    try {
      return filled.await(nanos, TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
