package tellosimulator.benchmark;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.platform.engine.discovery.DiscoverySelectors;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;
import tellosimulator.junit.SimulatedDrone;
import tellosimulator.junit.TelloSimulation;
import tellosimulator.junit.TelloTest;

/** Many tests of the kind that the test kit is for, and the program that runs them in one JVM. */
@TelloTest
public class KitFlights {

  static final int TESTS = 1000;

  /** The simulated time of each flight [s]; its commands are chosen so that it takes longer. */
  static final double SIMULATED_SECONDS = 30;

  static final String[] COMMANDS = {
    "command", "battery?", "takeoff", "up 50", "forward 100", "cw 90", "forward 100", "cw 90",
    "forward 100", "cw 90", "forward 100", "cw 90", "speed 30", "left 60", "right 60", "back 60",
    "forward 60", "down 30", "height?", "land"
  };

  private static long firstNanos;
  private static long flownNanos;
  private static double leastSeconds = Double.POSITIVE_INFINITY;

  /**
   * Prints how long it took: {@code tests failed firstMs totalMs flownMs leastSimulatedSeconds}.
   */
  public static void main(String[] arguments) {
    long begun = System.nanoTime();
    long startedMs =
        System.currentTimeMillis() - ManagementFactory.getRuntimeMXBean().getStartTime();
    SummaryGeneratingListener summary = new SummaryGeneratingListener();
    LauncherFactory.create()
        .execute(
            LauncherDiscoveryRequestBuilder.request()
                .selectors(DiscoverySelectors.selectClass(KitFlights.class))
                .build(),
            summary);
    System.out.printf(
        "%d %d %d %d %d %.1f%n",
        summary.getSummary().getTestsSucceededCount(),
        summary.getSummary().getTestsFailedCount(),
        startedMs + (firstNanos - begun) / 1_000_000,
        (System.nanoTime() - begun) / 1_000_000,
        flownNanos / 1_000_000,
        leastSeconds);
  }

  @RepeatedTest(TESTS)
  void flies(SimulatedDrone drone, TelloSimulation simulation) throws IOException {
    long begun = System.nanoTime();
    firstNanos = firstNanos == 0 ? begun : firstNanos;
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(20_000);
      DatagramPacket reply = new DatagramPacket(new byte[2048], 2048);
      for (String command : COMMANDS) {
        byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
        socket.send(new DatagramPacket(bytes, bytes.length, drone.address()));
        socket.receive(reply);
      }
    }
    if (!drone.truth().landed()) {
      throw new IllegalStateException("has not landed");
    }
    leastSeconds = Math.min(leastSeconds, simulation.time().toMillis() / 1000.0);
    flownNanos += System.nanoTime() - begun;
  }
}
