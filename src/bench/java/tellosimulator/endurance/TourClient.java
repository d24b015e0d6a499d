package tellosimulator.endurance;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;

/**
 * An operator program that flies one course again and again, with video, and sends a command again
 * to which no reply comes. Beside that it asks ten times a second how full the battery is, and
 * notes when state lines, video and the replies to that come.
 *
 * <p>Each try of a command has a socket of its own, so that a late reply is never taken for that to
 * another command.
 */
final class TourClient implements AutoCloseable {

  private static final List<String> MOVES = List.of("forward 50", "cw 180", "forward 50", "cw 180");

  private static final String OK = "ok";

  /** The drone still does what an earlier try, or a duplicate, has told it. */
  private static final String BUSY = "error Not joystick";

  private static final String ON_THE_GROUND = "error Motor stop";

  /** What tells that an earlier try has done it: its reply was lost. */
  private static final Map<String, String> DONE_BEFORE =
      Map.of("takeoff", "error", "land", ON_THE_GROUND);

  /** With 20 % loss each way, 0.36 of all tries fail, and one of a million commands. */
  private static final int MOST_TRIES = 14;

  private static final double QUERY_SECONDS = 0.1;

  private final InetSocketAddress drone;
  private final int patienceMs;
  private final DatagramSocket withChallenge = new DatagramSocket();
  private final DatagramSocket stateSocket;
  private final DatagramSocket videoSocket;
  private final Arrivals replies;
  private final Arrivals states;
  private final Arrivals video;
  private int sentAgain;

  private TourClient(List<String> arguments) throws IOException {
    drone = new InetSocketAddress(arguments.get(0), Integer.parseInt(arguments.get(1)));
    InetAddress all = InetAddress.getByName("0.0.0.0");
    stateSocket = new DatagramSocket(Integer.parseInt(arguments.get(2)), all);
    videoSocket = new DatagramSocket(Integer.parseInt(arguments.get(3)), all);
    patienceMs = Integer.parseInt(arguments.get(4));
    replies = Arrivals.at(withChallenge);
    states = Arrivals.at(stateSocket);
    video = Arrivals.at(videoSocket);
  }

  /**
   * Prints {@code flying} after each takeoff, {@code flown again N} after each landing, and {@code
   * failed REASON} if it gives up. Is asked {@code window FROM TO} (moments of {@link
   * System#nanoTime}, which all processes of a machine share on Linux), and says what came between
   * them. Ends with its input.
   *
   * @param arguments address and port of the drone, state port, video port, and how long it waits
   *     for a reply [ms]
   */
  public static void main(String[] arguments) throws IOException {
    try (TourClient client = new TourClient(List.of(arguments));
        BufferedReader input =
            new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8))) {
      Daemon.start("tours", client::fly);
      Daemon.start("queries", client::ask);
      for (String line = input.readLine(); line != null; line = input.readLine()) {
        String[] words = line.split(" ", -1);
        System.out.println(client.window(Long.parseLong(words[1]), Long.parseLong(words[2])));
      }
    }
  }

  private String window(long from, long to) {
    return "window state %s video %s reply %s"
        .formatted(
            states.between(from, to).toWords(),
            video.between(from, to).toWords(),
            replies.between(from, to).toWords());
  }

  private void fly() {
    try {
      settle("command");
      settle("streamon");
      while (true) {
        settle("takeoff");
        System.out.println("flying");
        for (String move : MOVES) {
          settle(move);
        }
        settle("land");
        System.out.println("flown again " + sentAgain);
      }
    } catch (IOException e) {
      System.out.println("failed " + e.getMessage());
    }
  }

  /** Sends a command until it is carried out. A drone that has landed meanwhile takes off again. */
  private void settle(String command) throws IOException {
    String reply = attempt(command);
    for (int tries = 1; !settled(command, reply); tries++) {
      if (tries == MOST_TRIES) {
        throw new IOException("`" + command + "` was answered `" + reply + "` at last");
      }
      if (reply.equals(ON_THE_GROUND) && MOVES.contains(command)) {
        settle("takeoff");
      }
      sentAgain++;
      reply = attempt(command);
    }
  }

  private static boolean settled(String command, String reply) {
    return reply.equals(OK) || reply.equals(DONE_BEFORE.get(command));
  }

  /** The reply that tells what became of it; empty if none came in time. */
  private String attempt(String command) throws IOException {
    long end = System.nanoTime() + patienceMs * 1_000_000L;
    try (DatagramSocket socket = new DatagramSocket()) {
      send(socket, command);
      DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
      String reply = BUSY;
      while (reply.equals(BUSY)) {
        socket.setSoTimeout((int) Math.max(1, (end - System.nanoTime()) / 1_000_000));
        socket.receive(packet);
        reply = new String(packet.getData(), 0, packet.getLength(), StandardCharsets.ISO_8859_1);
      }
      return reply;
    } catch (SocketTimeoutException e) {
      return "";
    }
  }

  /** What cannot be sent, as while the interface is down, is lost. */
  private void send(DatagramSocket socket, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    try {
      socket.send(new DatagramPacket(bytes, bytes.length, drone));
    } catch (IOException e) {
      return;
    }
  }

  private void ask() {
    while (!withChallenge.isClosed()) {
      send(withChallenge, "battery?");
      Waiting.pass(QUERY_SECONDS);
    }
  }

  @Override
  public void close() {
    withChallenge.close();
    stateSocket.close();
    videoSocket.close();
  }
}
