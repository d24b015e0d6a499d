package tellosimulator.web;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.pilot.OperatorSocket;

/**
 * Sends commands of pages to the drones' command ports, as any operator program does. Thread-safe.
 */
final class WebPilot implements AutoCloseable {

  /** The commands with which people fly by hand. */
  private static final Pattern COMMAND =
      Pattern.compile("takeoff|land|stop|emergency|flip [lrfb]|rc( -?[0-9]{1,3}){4}");

  private final OnlineSimulation simulation;
  private final Map<Integer, OperatorSocket> sockets = new HashMap<>();

  WebPilot(OnlineSimulation simulation) {
    this.simulation = simulation;
  }

  /**
   * Sends a command, and does not wait for the reply, which is part of the state.
   *
   * @throws IllegalArgumentException if it is not a command for flying by hand
   * @throws IllegalStateException if the drone cannot be reached; the message is one sentence
   */
  synchronized void send(int drone, String command) {
    if (!COMMAND.matcher(command).matches()) {
      throw new IllegalArgumentException(
          "the page flies only with takeoff, land, stop, emergency, flip and rc");
    }
    try {
      OperatorSocket socket = socket(drone);
      if (simulation.snapshot().drones().get(drone - 1).link().operator().isEmpty()) {
        socket.send("command");
      }
      socket.send(command);
    } catch (IOException e) {
      Optional.ofNullable(sockets.remove(drone)).ifPresent(OperatorSocket::close);
      throw new IllegalStateException("drone " + drone + " cannot be reached; is it on?", e);
    }
  }

  private OperatorSocket socket(int drone) throws IOException {
    InetSocketAddress address = simulation.addresses(drone).get(0);
    OperatorSocket known = sockets.get(drone);
    if (known == null || !known.drone().equals(address)) {
      Optional.ofNullable(known).ifPresent(OperatorSocket::close);
      known = OperatorSocket.open(address);
      sockets.put(drone, known);
    }
    while (known.receive().isPresent()) {
      // the state has the reply; it must not fill the buffer
    }
    return known;
  }

  @Override
  public synchronized void close() {
    sockets.values().forEach(OperatorSocket::close);
    sockets.clear();
  }
}
