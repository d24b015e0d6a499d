package tellosimulator.control;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.json.Json;

/**
 * Reads a client's requests, one per line, and answers each request before it reads the next. The
 * connection ends when the client disconnects, or after a request with a wrong token. Confined to
 * the thread of its worker, except for {@link #close}.
 */
final class ControlConnection implements Agent {

  /** Maximum length of a request [bytes]. Decided. */
  static final int LONGEST_LINE = 64 * 1024;

  private static final String EXAMPLE = "{\"id\": 1, \"token\": \"…\", \"do\": \"truth\"}";

  private static final String WRONG_TOKEN =
      "the token is %s: it stands in the line that begins with `control:`";

  private final ErrorPolicy failed = ErrorPolicy.goOn("A request to the control channel failed");
  private final ErrorPolicy gone = ErrorPolicy.finish("A client of the control channel is gone");
  private final Socket socket;
  private final InputStream in;
  private final AccessToken token;
  private final Supplier<Requests> requests;
  private final Consumer<ControlConnection> ended;

  /**
   * Creates a connection without reading from it.
   *
   * @param ended called when the connection has ended
   */
  ControlConnection(
      Socket socket,
      AccessToken token,
      Supplier<Requests> requests,
      Consumer<ControlConnection> ended)
      throws IOException {
    this.socket = socket;
    this.in = new BufferedInputStream(socket.getInputStream());
    this.token = token;
    this.requests = requests;
    this.ended = ended;
  }

  @Override
  public Outcome doWork() throws IOException {
    try {
      return takeLine();
    } catch (IOException e) {
      if (socket.isClosed()) {
        return Outcome.FINISHED;
      }
      throw e;
    }
  }

  private Outcome takeLine() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    boolean tooLong = false;
    int next = in.read();
    if (next < 0) {
      return Outcome.FINISHED;
    }
    while (next >= 0 && next != '\n') {
      tooLong = tooLong || line.size() == LONGEST_LINE;
      if (!tooLong) {
        line.write(next);
      }
      next = in.read();
    }
    if (tooLong) {
      refuse(socket, "a request must have at most " + LONGEST_LINE + " bytes, but this has more");
      return Outcome.WORKED;
    }
    return take(line.toString(StandardCharsets.UTF_8));
  }

  private Outcome take(String line) throws IOException {
    Map<String, Object> request;
    try {
      request = Json.flatObject(line, EXAMPLE);
    } catch (IllegalArgumentException e) {
      refuse(socket, e.getMessage());
      return Outcome.WORKED;
    }
    Optional<Object> id = Optional.ofNullable(request.get("id"));
    if (!(request.get("token") instanceof String said && token.matches(said))) {
      String what = request.containsKey("token") ? "wrong" : "missing";
      refuse(socket, id, WRONG_TOKEN.replace("%s", what));
      return Outcome.FINISHED;
    }
    try {
      accept(id, requests.get().result(request));
    } catch (IllegalArgumentException | IllegalStateException | AssertionError e) {
      refuse(socket, id, e.getMessage().lines().findFirst().orElse("it cannot be done"));
    } catch (RuntimeException e) {
      refuse(socket, id, "the simulator failed, please report this: " + e);
      throw e;
    }
    return Outcome.WORKED;
  }

  private void accept(Optional<Object> id, Object result) throws IOException {
    send(socket, Json.object("id", id.orElse(null), "ok", true, "result", result));
  }

  /** Sends an error response without a request id. */
  static void refuse(Socket socket, String why) throws IOException {
    refuse(socket, Optional.empty(), why);
  }

  private static void refuse(Socket socket, Optional<Object> id, String why) throws IOException {
    send(socket, Json.object("id", id.orElse(null), "ok", false, "error", why));
  }

  private static void send(Socket socket, Map<String, Object> answer) throws IOException {
    socket.getOutputStream().write((Json.text(answer) + "\n").getBytes(StandardCharsets.US_ASCII));
  }

  @Override
  public ErrorPolicy onError(Throwable failure) {
    return failure instanceof IOException ? gone : failed;
  }

  @Override
  public void onClose() {
    close();
    ended.accept(this);
  }

  /** Closes the connection. A request in progress is not cancelled. Thread-safe. */
  void close() {
    try {
      socket.close();
    } catch (IOException e) {
      // already closed
    }
  }
}
