import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Shows height, battery and attitude from the state lines, which a drone sends ten times a second.
 *
 * <p>Start the simulator first, in another terminal: {@code mvn javafx:run}, and switch the drone
 * on. Then start this, with nothing but a JDK, and while it runs fly the drone with another
 * program, such as FirstFlight:
 *
 * <pre>java examples/ReadState.java [host] [port] [state port] [lines]</pre>
 *
 * <p>Without arguments it reads 600 lines (one minute) on port 8890, from the simulator on this
 * machine (127.0.0.1, port 8879). A real Tello has host 192.168.10.1 and port 8889.
 */
public final class ReadState {

  private static final int PATIENCE_MS = 10_000;
  private static final int LINES_A_SECOND = 10;

  private ReadState() {}

  public static void main(String[] args) {
    String host = args.length > 0 ? args[0] : "127.0.0.1";
    int port = args.length > 1 ? Integer.parseInt(args[1]) : 8879;
    int statePort = args.length > 2 ? Integer.parseInt(args[2]) : 8890;
    int lines = args.length > 3 ? Integer.parseInt(args[3]) : 600;
    // The state port first: so no line is missed, and a port that is taken shows at once.
    try (DatagramSocket states = new DatagramSocket(statePort);
        DatagramSocket commands = new DatagramSocket()) {
      states.setSoTimeout(PATIENCE_MS);
      startState(commands, new InetSocketAddress(host, port));
      for (int line = 0; line < lines; line++) {
        Map<String, String> state = parse(receive(states));
        if (line % LINES_A_SECOND == 0) {
          System.out.println(describe(state));
        }
      }
    } catch (SocketTimeoutException e) {
      fail("No state on port %d. Is the drone at %s:%d on?".formatted(statePort, host, port));
    } catch (IOException e) {
      fail("The state on port %d cannot be read: %s".formatted(statePort, e.getMessage()));
    }
  }

  /** The drone sends its state to the host that said {@code command} first. */
  private static void startState(DatagramSocket commands, InetSocketAddress drone)
      throws IOException {
    byte[] bytes = "command".getBytes(StandardCharsets.US_ASCII);
    commands.send(new DatagramPacket(bytes, bytes.length, drone));
  }

  private static String receive(DatagramSocket states) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[1500], 1500);
    states.receive(packet);
    return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.US_ASCII);
  }

  /** From {@code pitch:0;roll:0;...} to a map. */
  private static Map<String, String> parse(String line) {
    Map<String, String> state = new LinkedHashMap<>();
    for (String field : line.strip().split(";")) {
      int colon = field.indexOf(':');
      if (colon > 0) {
        state.put(field.substring(0, colon), field.substring(colon + 1));
      }
    }
    return state;
  }

  private static String describe(Map<String, String> state) {
    return "height %s cm, battery %s %%, pitch %s, roll %s, yaw %s degrees"
        .formatted(
            state.get("h"),
            state.get("bat"),
            state.get("pitch"),
            state.get("roll"),
            state.get("yaw"));
  }

  private static void fail(String message) {
    System.err.println(message);
    System.exit(1);
  }
}
