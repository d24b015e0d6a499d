package tellosimulator.endurance;

import java.io.IOException;
import java.net.DatagramSocket;

/** A port that nobody uses. */
final class FreePort {

  private FreePort() {}

  /** One that was free just now at all addresses; the system gives the same one late again. */
  static int find() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      return socket.getLocalPort();
    }
  }
}
