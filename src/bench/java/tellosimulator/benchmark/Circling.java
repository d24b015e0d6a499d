package tellosimulator.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** Lets a drone that is in the air fly small circles by {@code rc}, twenty times a second. */
final class Circling implements AutoCloseable {

  private static final int PERIOD_MS = 50;

  /** Forward at 30 cm/s with 60 degrees a second: a circle of 57 cm. */
  private static final String CIRCLE = "rc 0 30 0 60";

  private final Operator operator;
  private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor();

  Circling(int port) throws IOException {
    operator = new Operator(port);
  }

  void start() {
    var unused = timer.scheduleAtFixedRate(this::steer, 0, PERIOD_MS, TimeUnit.MILLISECONDS);
  }

  /** Takes off, circles, and waits for the drone's first picture. */
  void startWithFilm(Operator pilot, VideoSocket video) throws IOException {
    pilot.expect("command", "ok");
    pilot.expect("takeoff", "ok");
    pilot.expect("streamon", "ok");
    start();
    video.awaitKeyPicture();
  }

  private void steer() {
    try {
      operator.send(CIRCLE);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    timer.shutdownNow();
    operator.close();
  }
}
