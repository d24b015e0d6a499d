package tellosimulator.endurance;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import tellosimulator.benchmark.Statistics;

/**
 * An operator program that flies circles by {@code rc}, asks a hundred times a second how full the
 * battery is, and tells how it is served.
 */
final class Pilot implements AutoCloseable {

  /** A query without a reply until then counts as lost [ms]. Decided: five turns of {@code rc}. */
  private static final int PATIENCE_MS = 250;

  /** What a takeoff may take, in a flood too [ms]. */
  private static final int TAKEOFF_MS = 20_000;

  private static final long QUERY_PERIOD = 10_000_000;
  private static final int RC_PERIOD_MS = 50;
  private static final double WARM_UP_SECONDS = 3;

  private final InetSocketAddress drone;
  private final DatagramSocket steering = new DatagramSocket();
  private final DatagramSocket states;
  private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor();
  private final List<Long> stateTimes = new CopyOnWriteArrayList<>();
  private final List<Double> times = new ArrayList<>();
  private DatagramSocket withChallenge = new DatagramSocket();
  private int lost;

  private Pilot(InetSocketAddress drone, int statePort) throws IOException {
    this.drone = drone;
    states = new DatagramSocket(statePort, InetAddress.getByName("0.0.0.0"));
  }

  /**
   * Flies, prints {@code flying}, waits for a line, is served for some seconds, and prints {@code
   * served lost N asked N median MS p99 MS period MS}.
   *
   * @param arguments address and port of the drone, state port, seconds
   */
  public static void main(String[] arguments) throws IOException {
    InetSocketAddress drone = new InetSocketAddress(arguments[0], Integer.parseInt(arguments[1]));
    try (Pilot pilot = new Pilot(drone, Integer.parseInt(arguments[2]));
        BufferedReader input =
            new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8))) {
      pilot.takeOff();
      pilot.ask(WARM_UP_SECONDS);
      System.out.println("flying");
      input.readLine();
      pilot.clear();
      pilot.ask(Double.parseDouble(arguments[3]));
      System.out.println(pilot.report());
    }
  }

  private void takeOff() throws IOException {
    expectOk("command");
    expectOk("takeoff");
    Daemon.start("states", this::readStates);
    var unused = timer.scheduleAtFixedRate(this::steer, 0, RC_PERIOD_MS, TimeUnit.MILLISECONDS);
  }

  private void expectOk(String command) throws IOException {
    String reply = ask(command, TAKEOFF_MS);
    if (!reply.equals("ok")) {
      throw new IOException("`" + command + "` was answered `" + reply + "`");
    }
  }

  private String ask(String text, int patienceMs) throws IOException {
    send(withChallenge, text);
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    withChallenge.setSoTimeout(patienceMs);
    withChallenge.receive(packet);
    return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.ISO_8859_1);
  }

  private void send(DatagramSocket socket, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    socket.send(new DatagramPacket(bytes, bytes.length, drone));
  }

  private void steer() {
    try {
      send(steering, "rc 0 30 0 60");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void readStates() {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    try {
      while (true) {
        states.receive(packet);
        stateTimes.add(System.nanoTime());
      }
    } catch (IOException e) {
      return; // closed
    }
  }

  private void clear() {
    stateTimes.clear();
    times.clear();
    lost = 0;
  }

  /** After a loss it goes on with another socket, which takes no reply that comes too late. */
  private void ask(double seconds) throws IOException {
    long begun = System.nanoTime();
    for (long next = begun; next - begun < seconds * 1e9; next += QUERY_PERIOD) {
      long pause = next - System.nanoTime();
      if (pause > 0) {
        LockSupport.parkNanos(pause);
      }
      long start = System.nanoTime();
      try {
        var unused = ask("battery?", PATIENCE_MS);
        times.add((System.nanoTime() - start) * 1e-6);
      } catch (SocketTimeoutException e) {
        lost++;
        renew();
      }
    }
  }

  private void renew() throws SocketException {
    withChallenge.close();
    withChallenge = new DatagramSocket();
  }

  private String report() {
    Statistics statistics = new Statistics(times.isEmpty() ? List.of(Double.NaN) : times);
    List<Long> lines = List.copyOf(stateTimes);
    double period =
        lines.size() < 2
            ? Double.NaN
            : (lines.get(lines.size() - 1) - lines.get(0)) * 1e-6 / (lines.size() - 1);
    return String.format(
        Locale.ROOT,
        "served lost %d asked %d median %.3f p99 %.3f period %.3f",
        lost,
        lost + times.size(),
        statistics.median(),
        statistics.quantile(0.99),
        period);
  }

  @Override
  public void close() {
    timer.shutdownNow();
    steering.close();
    states.close();
    withChallenge.close();
  }
}
