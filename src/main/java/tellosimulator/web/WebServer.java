package tellosimulator.web;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.json.Json;
import tellosimulator.network.PortTakenException;

/**
 * Serves the page with the JDK's HTTP server. Each request has a thread of its own, so that a slow
 * one delays no other. Thread-safe.
 */
public final class WebServer implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(WebServer.class);

  /** Largest body of a request [bytes]. Decided: a scenario with a large room has some 20 kB. */
  private static final int MOST_BYTES = 1 << 20;

  private static final int OK = 200;
  private static final int BAD_REQUEST = 400;
  private static final int FORBIDDEN = 403;
  private static final int NOT_FOUND = 404;
  private static final int NOT_ALLOWED = 405;
  private static final int TOO_LARGE = 413;
  private static final int TOO_MANY = 503;

  private static final Map<String, String> FILES =
      Map.of(
          "/", "page.html",
          "/page.js", "page.js",
          "/page.css", "page.css");

  private static final Map<String, String> TYPES =
      Map.of("html", "text/html", "js", "text/javascript", "css", "text/css");

  private final HttpServer server;
  private final Access access;
  private final Viewers viewers;
  private final InetSocketAddress address;

  static {
    // a request that is not complete by then is dropped [s]; read once by the JDK's server
    System.setProperty("sun.net.httpserver.maxReqTime", "10");
  }

  /**
   * Creates a server that answers immediately.
   *
   * @param wanted the address; port 0 lets the system choose
   * @throws PortTakenException if the port cannot be opened
   */
  public WebServer(Viewers viewers, InetSocketAddress wanted) throws PortTakenException {
    this.viewers = viewers;
    try {
      server = HttpServer.create(wanted, 0);
    } catch (IOException e) {
      throw PortTakenException.taken(wanted, "--web", e);
    }
    address = server.getAddress();
    access = new Access(address.getPort());
    server.createContext("/", this::answer);
    server.setExecutor(task -> Worker.start("web", new Task(task)));
    server.start();
  }

  /** A request, which is answered once. */
  private record Task(Runnable task) implements Agent {

    private static final ErrorPolicy FAILED = ErrorPolicy.finish("A request of a browser failed");

    @Override
    public Outcome doWork() {
      task.run();
      return Outcome.FINISHED;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return FAILED;
    }
  }

  /** Returns the line with the link, for which people and scripts wait. */
  public String line() {
    InetAddress shown =
        address.getAddress().isAnyLocalAddress()
            ? InetAddress.getLoopbackAddress()
            : address.getAddress();
    return "web: " + access.link(shown, address.getPort());
  }

  private void answer(HttpExchange request) throws IOException {
    try (request) {
      request.getResponseHeaders().set("X-Content-Type-Options", "nosniff");
      request.getResponseHeaders().set("Referrer-Policy", "no-referrer");
      request.getResponseHeaders().set("Cache-Control", "no-store");
      if (!access.allows(request)) {
        text(request, FORBIDDEN, "Open the link that the simulator has printed: it has the token.");
        return;
      }
      String path = request.getRequestURI().getPath();
      switch (request.getRequestMethod()) {
        case "GET" -> get(request, path);
        case "POST" -> post(request, path);
        default -> text(request, NOT_ALLOWED, "Only GET and POST are known.");
      }
    } catch (IOException e) {
      LOG.debug("A browser has gone: {}", e.toString()); // pages are closed at any time
    }
  }

  private void get(HttpExchange request, String path) throws IOException {
    String file = FILES.get(path);
    if (file != null) {
      page(request, file);
      return;
    }
    Optional<Viewer> viewer = viewer(request);
    if (viewer.isEmpty()) {
      text(request, TOO_MANY, "There are too many viewers; close another page.");
      return;
    }
    switch (path) {
      case "/room" -> viewer.get().sendRoom(request);
      case "/film" -> viewer.get().sendFilm(request);
      case "/state" -> viewer.get().sendState(request);
      default -> text(request, NOT_FOUND, "There is no such page.");
    }
  }

  private Optional<Viewer> viewer(HttpExchange request) {
    return viewers.find(Access.parameter(request.getRequestURI(), "viewer").orElse(""));
  }

  private void page(HttpExchange request, String file) throws IOException {
    if (access.named(request)) {
      request.getResponseHeaders().add("Set-Cookie", access.cookieHeader());
    }
    try (InputStream bytes = WebServer.class.getResourceAsStream(file)) {
      String type = TYPES.get(file.substring(file.lastIndexOf('.') + 1));
      request.getResponseHeaders().set("Content-Type", type + "; charset=utf-8");
      request.getResponseHeaders().set("Content-Security-Policy", "default-src 'self'");
      send(request, OK, bytes.readAllBytes());
    }
  }

  private void post(HttpExchange request, String path) throws IOException {
    byte[] body = request.getRequestBody().readNBytes(MOST_BYTES + 1);
    if (body.length > MOST_BYTES) {
      text(request, TOO_LARGE, "The request is longer than 1 MB.");
      return;
    }
    if (!path.equals("/do")) {
      text(request, NOT_FOUND, "There is no such action.");
      return;
    }
    Optional<Viewer> viewer = viewer(request);
    try {
      Map<String, Object> action =
          Json.flatObject(new String(body, StandardCharsets.UTF_8), "{\"do\": \"drones\"}");
      Object result =
          viewer
              .orElseThrow(() -> new IllegalStateException("There are too many viewers."))
              .carryOut(action);
      json(request, OK, result);
    } catch (IllegalArgumentException | IllegalStateException | AssertionError e) {
      text(request, BAD_REQUEST, String.valueOf(e.getMessage()).lines().findFirst().orElse(""));
    }
  }

  private static void json(HttpExchange request, int status, Object value) throws IOException {
    request.getResponseHeaders().set("Content-Type", "application/json");
    send(request, status, Json.text(value).getBytes(StandardCharsets.UTF_8));
  }

  private static void text(HttpExchange request, int status, String sentence) throws IOException {
    request.getResponseHeaders().set("Content-Type", "text/plain; charset=utf-8");
    send(request, status, sentence.getBytes(StandardCharsets.UTF_8));
  }

  private static void send(HttpExchange request, int status, byte[] bytes) throws IOException {
    request.sendResponseHeaders(status, bytes.length == 0 ? -1 : bytes.length);
    request.getResponseBody().write(bytes);
  }

  @Override
  public void close() {
    viewers.close();
    server.stop(0);
  }
}
