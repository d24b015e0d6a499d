package tellosimulator.control;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.network.PortTakenException;

/**
 * The server of the control channel, through which programs inspect and control the simulation. The
 * programs must run on this machine and know the token. Thread-safe.
 */
public final class ControlServer implements AutoCloseable {

  /**
   * Maximum number of clients. Decided: enough for tests that run in parallel and a user who
   * watches.
   */
  static final int MOST_CONNECTIONS = 8;

  /** Maximum number of clients waiting to be accepted. Decided. */
  private static final int BACKLOG = 16;

  private final ServerSocket server;

  private final AccessToken token = AccessToken.create();

  private final Supplier<Requests> requests;
  private final Set<ControlConnection> connections = ConcurrentHashMap.newKeySet();
  private final Worker acceptor;

  /**
   * Creates a server that listens immediately.
   *
   * @param requests returns what can be asked of the present scenario
   * @param port the port; 0 lets the system choose
   * @throws PortTakenException if the port cannot be opened
   */
  public ControlServer(Supplier<Requests> requests, int port) throws PortTakenException {
    this.requests = requests;
    InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
    try {
      server = new ServerSocket(port, BACKLOG, address.getAddress());
    } catch (IOException e) {
      throw PortTakenException.taken(address, "--control", e);
    }
    acceptor = Worker.start("control", new Acceptor());
  }

  /** Accepts clients and starts a thread for each of them. */
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
    socket.setTcpNoDelay(true); // clients wait for each answer
    ControlConnection connection =
        new ControlConnection(socket, token, requests, connections::remove);
    connections.add(connection);
    Worker.start("control client", connection);
  }

  /** Returns the line that contains the address and the token. Scripts wait for this line. */
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

  /** Closes the server and all connections. */
  @Override
  public void close() {
    acceptor.end();
    try {
      server.close();
    } catch (IOException e) {
      // already closed
    }
    acceptor.close();
  }
}
