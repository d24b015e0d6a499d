package tellosimulator.control;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.junit.TelloSimulator;
import tellosimulator.network.PortTakenException;

/**
 * Lets programs of this machine look behind the wire and do what a test may do, if they know the
 * token. For any thread.
 */
public final class ControlServer implements AutoCloseable {

  /** Clients at a time. Decided: tests that run beside each other, and a person who looks. */
  static final int MOST_CONNECTIONS = 8;

  /** Clients that may wait to be accepted. Decided. */
  private static final int BACKLOG = 16;

  private final ServerSocket server;
  private final AccessToken token = AccessToken.random();
  private final Requests requests;
  private final Set<ControlConnection> connections = ConcurrentHashMap.newKeySet();
  private final Worker acceptor;

  /**
   * Listens at once.
   *
   * @param port 0 for one that the system chooses
   * @throws PortTakenException if the port cannot be had
   */
  public ControlServer(TelloSimulator simulator, int port) throws PortTakenException {
    requests = new Requests(simulator);
    InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
    try {
      server = new ServerSocket(port, BACKLOG, address.getAddress());
    } catch (IOException e) {
      throw PortTakenException.taken(address, "--control", e);
    }
    acceptor = Worker.start("control", new Acceptor());
  }

  /** Gives each client a thread of its own. */
  private final class Acceptor implements Agent {

    private final ErrorPolicy failed =
        ErrorPolicy.goOn("A client of the control channel was not accepted");

    @Override
    public Outcome doWork() throws IOException {
      try {
        accept(server.accept());
      } catch (IOException e) {
        if (server.isClosed()) {
          return Outcome.FINISHED;
        }
        throw e;
      }
      return Outcome.WORKED;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return failed;
    }

    @Override
    public void onClose() {
      connections.forEach(ControlConnection::close);
    }
  }

  private void accept(Socket socket) throws IOException {
    if (connections.size() >= MOST_CONNECTIONS) {
      try (socket) {
        ControlConnection.refuse(
            socket, "there are " + MOST_CONNECTIONS + " connections already; close one of them");
      }
      return;
    }
    socket.setTcpNoDelay(true); // each answer is waited for
    ControlConnection connection =
        new ControlConnection(socket, token, requests, connections::remove);
    connections.add(connection);
    Worker.start("control client", connection);
  }

  /** The line that says where it listens, and the token, for scripts that wait for it. */
  public String line() {
    return "control: "
        + server.getInetAddress().getHostAddress()
        + ":"
        + port()
        + " token "
        + token();
  }

  int port() {
    return server.getLocalPort();
  }

  String token() {
    return token.text();
  }

  /** Ends all connections. */
  @Override
  public void close() {
    acceptor.end();
    try {
      server.close();
    } catch (IOException e) {
      // it is closed
    }
    acceptor.close();
  }
}
