package tellosimulator.endurance;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;

/** Heaps that are too small for what is asked of the program. */
final class SmallHeapTrial {

  private static final int RATE = 50_000;
  private static final double FLOOD_SECONDS = 8;
  private static final double FILM_SECONDS = 8;
  private static final double PATIENCE_SECONDS = 30;

  private SmallHeapTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    List<Measurement> rows = new ArrayList<>();
    rows.addAll(film());
    rows.add(flood("127.0.0.9", "-Xmx24m, flood by a stranger"));
    rows.add(flood("127.0.0.1", "-Xmx24m, flood from the operator's address"));
    return rows;
  }

  private static List<Measurement> film() throws IOException {
    try (DatagramSocket video = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        SimulatorProcess simulator = start("-Xmx32m", "" + video.getLocalPort())) {
      if (simulator.ready().isEmpty()) {
        return List.of(Health.row("-Xmx32m, started", simulator));
      }
      return film(simulator, video);
    }
  }

  private static List<Measurement> film(SimulatorProcess simulator, DatagramSocket video)
      throws IOException {
    try (Operator operator = new Operator(simulator.drone(1).getPort())) {
      operator.expect("command", "ok");
      operator.expect("streamon", "ok");
      Waiting.pass(FILM_SECONDS);
      List<Measurement> rows = new ArrayList<>();
      rows.add(Health.rowOfWhole("-Xmx32m with video", simulator));
      if (simulator.program().process().isAlive()) {
        operator.expect("streamoff", "ok");
        drain(video);
        operator.expect("setresolution low", "ok");
        operator.expect("streamon", "ok");
        boolean pictures = comes(video);
        rows.add(
            new Measurement(
                "… after the next `streamon`, of smaller pictures",
                "pictures",
                pictures ? "pictures" : "none",
                pictures));
      }
      return rows;
    }
  }

  private static Measurement flood(String from, String name) throws IOException {
    try (SimulatorProcess simulator = start("-Xmx24m", "9")) {
      if (!Health.answers(simulator)) {
        return Health.rowOfWhole(name, simulator);
      }
      try (Program stranger =
          Host.HERE.start(
              Stranger.class,
              Host.HERE.address(),
              simulator.drone(1).getPort(),
              RATE,
              FLOOD_SECONDS,
              from,
              "garbage")) {
        stranger.await("sent", FLOOD_SECONDS + PATIENCE_SECONDS);
      }
      return Health.rowOfWhole(name, simulator);
    }
  }

  private static SimulatorProcess start(String heap, String videoPort) throws IOException {
    return SimulatorProcess.tryToStart(
        List.of(heap), "--command-port", "0", "--profile", "tt", "--video-port", videoPort);
  }

  private static void drain(DatagramSocket socket) throws IOException {
    while (comes(socket, 200)) {
      // Pictures that were sent before.
    }
  }

  private static boolean comes(DatagramSocket socket) throws IOException {
    return comes(socket, (int) (FILM_SECONDS * 1000));
  }

  private static boolean comes(DatagramSocket socket, int patienceMs) throws IOException {
    socket.setSoTimeout(patienceMs);
    try {
      socket.receive(new DatagramPacket(new byte[2048], 2048));
      return true;
    } catch (SocketTimeoutException e) {
      return false;
    }
  }
}
