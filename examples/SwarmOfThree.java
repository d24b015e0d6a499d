import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Three drones that fly at the same time and wait for each other after each step.
 *
 * <p>Start the simulator with three drones first, in another terminal:
 *
 * <pre>mvn javafx:run "-Djavafx.args=--drones 3 --on"</pre>
 *
 * <p>Then start this, with nothing but a JDK:
 *
 * <pre>java examples/SwarmOfThree.java [host:port host:port host:port]</pre>
 *
 * <p>Without arguments it flies the drones at 127.0.0.1, 127.0.0.2 and 127.0.0.3, port 8879. Real
 * ones (Tello EDU) have the addresses that your access point gave them, and port 8889.
 */
public final class SwarmOfThree {

  /** A drone answers a motion only when it is over; a takeoff takes several seconds. */
  private static final int PATIENCE_MS = 20_000;

  private static final List<String> SIMULATED =
      List.of("127.0.0.1:8879", "127.0.0.2:8879", "127.0.0.3:8879");

  private final List<Drone> drones;
  private final ExecutorService threads;

  private SwarmOfThree(List<Drone> drones, ExecutorService threads) {
    this.drones = drones;
    this.threads = threads;
  }

  public static void main(String[] args) throws InterruptedException {
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      List<Drone> drones = new ArrayList<>();
      for (String address : args.length > 0 ? List.of(args) : SIMULATED) {
        drones.add(Drone.at(address));
      }
      new SwarmOfThree(drones, threads).fly();
    } catch (IOException e) {
      System.err.println("The flight failed: " + e.getMessage());
      System.exit(1);
    } finally {
      threads.shutdown();
    }
  }

  private void fly() throws IOException, InterruptedException {
    all("command", "command", "command");
    try {
      all("takeoff", "takeoff", "takeoff");
      all("up 20", "up 40", "up 60");
      all("cw 90", "cw 180", "cw 90");
      all("forward 50", "forward 50", "forward 50");
    } finally {
      all("land", "land", "land"); // whatever went wrong: never leave a drone in the air
    }
    System.out.println("All have landed.");
  }

  /** Gives each drone its command, all at once, and waits until the last one has answered. */
  private void all(String... commands) throws IOException, InterruptedException {
    List<Callable<String>> tasks = new ArrayList<>();
    for (int i = 0; i < drones.size(); i++) {
      Drone drone = drones.get(i);
      String command = commands[i];
      tasks.add(() -> drone.command(command));
    }
    IOException failure = null;
    for (Future<String> answer : threads.invokeAll(tasks)) {
      try {
        System.out.println(answer.get());
      } catch (ExecutionException e) {
        failure = new IOException(e.getCause().getMessage(), e);
      }
    }
    if (failure != null) {
      throw failure;
    }
  }

  /** A drone with a socket of its own, so that replies cannot be mixed up. */
  private record Drone(String address, DatagramSocket socket) {

    static Drone at(String address) throws IOException {
      int colon = address.lastIndexOf(':');
      String host = address.substring(0, colon);
      int port = Integer.parseInt(address.substring(colon + 1));
      DatagramSocket socket = new DatagramSocket();
      socket.connect(new InetSocketAddress(host, port));
      socket.setSoTimeout(PATIENCE_MS);
      return new Drone(address, socket);
    }

    /** Sends a command that must be answered with {@code ok}. */
    String command(String text) throws IOException {
      String reply = ask(text);
      if (!reply.equals("ok")) {
        throw new IOException("%s answered `%s` to `%s`".formatted(address, reply, text));
      }
      return "%s: %s -> %s".formatted(address, text, reply);
    }

    private String ask(String text) throws IOException {
      byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
      DatagramPacket reply = new DatagramPacket(new byte[1500], 1500);
      try {
        socket.send(new DatagramPacket(bytes, bytes.length));
        socket.receive(reply);
      } catch (PortUnreachableException e) {
        throw new IOException(
            "nothing listens at " + address + "; does the simulator run, is the drone on?", e);
      } catch (SocketTimeoutException e) {
        throw new IOException("no reply from " + address + "; is the drone on?", e);
      }
      return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII).strip();
    }
  }
}
