package tellosimulator.endurance;

import java.io.IOException;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A {@link TourClient} as a process, and what it tells. */
final class TourProcess implements AutoCloseable {

  private static final double ANSWER_SECONDS = 10;

  private static final Pattern WINDOW = Pattern.compile("window state (.+) video (.+) reply (.+)");

  private final Program client;

  /**
   * What came to the client within a window of time.
   *
   * @param reply those to the queries that it sends ten times a second
   */
  record Window(Arrivals.Figures state, Arrivals.Figures video, Arrivals.Figures reply) {}

  /**
   * Starts it, and does not wait until it flies.
   *
   * @param drone address and command port, state port and video port
   * @param patienceMs how long it waits for a reply [ms]
   */
  TourProcess(Host host, Ports drone, int patienceMs) throws IOException {
    client =
        host.start(
            TourClient.class,
            drone.address(),
            drone.command(),
            drone.state(),
            drone.video(),
            patienceMs);
  }

  /** Where a drone takes commands, and to which ports of the client it sends. */
  record Ports(String address, int command, int state, int video) {

    /** Those of a real drone. */
    static Ports usual(String address) {
      return new Ports(address, 8889, 8890, 11_111);
    }

    /** The same as options of the simulator. */
    String[] options() {
      return new String[] {
        "--command-port", "" + command, "--state-port", "" + state, "--video-port", "" + video
      };
    }
  }

  /** Waits until it has taken off the next time. */
  void awaitFlying(double seconds) throws IOException {
    await("flying", seconds);
  }

  /**
   * Waits until another course is flown.
   *
   * @return how many commands it has sent again since its beginning
   */
  int awaitFlown(double seconds) throws IOException {
    String line = await("flown again ", seconds);
    return Integer.parseInt(line.substring(line.lastIndexOf(' ') + 1));
  }

  private String await(String beginning, double seconds) throws IOException {
    String line = client.await(List.of(beginning, "failed"), seconds);
    if (line.startsWith("failed")) {
      throw new IOException("the client " + line);
    }
    return line;
  }

  /**
   * Waits until a moment has passed, and asks what has come from another one to it.
   *
   * @param from moment of {@link System#nanoTime}
   */
  Window window(long from, double seconds) throws IOException {
    long to = from + (long) (seconds * 1e9);
    Waiting.pass((to - System.nanoTime()) * 1e-9);
    client.type("window " + from + " " + to);
    Matcher matcher = WINDOW.matcher(await("window", ANSWER_SECONDS));
    if (!matcher.matches()) {
      throw new IOException("the client did not say what came");
    }
    return new Window(
        Arrivals.Figures.of(matcher.group(1)),
        Arrivals.Figures.of(matcher.group(2)),
        Arrivals.Figures.of(matcher.group(3)));
  }

  Program program() {
    return client;
  }

  @Override
  public void close() {
    client.close();
  }
}
