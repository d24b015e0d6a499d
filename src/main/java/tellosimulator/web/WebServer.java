package tellosimulator.web;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.Semaphore;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.control.AccessToken;
import tellosimulator.network.LocalNetworks;
import tellosimulator.network.PortTakenException;

/**
 * Serves pages with the JDK's HTTP server. Each request has a thread of its own, so that a slow one
 * delays no other; there are only so many of them, and the server drops whoever takes too long to
 * ask or to read. Thread-safe.
 */
public final class WebServer implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(WebServer.class);

  /** Maximum number of requests at a time. Decided: eight viewers with eight requests each. */
  private static final int MOST_REQUESTS = 64;

  private static final Map<String, String> TYPES =
      Map.of("html", "text/html", "js", "text/javascript", "css", "text/css");

  /** What a page may load: only what comes from this server, so that no text can run a script. */
  private static final String POLICY =
      "default-src 'self'; img-src 'self' data: blob:; base-uri 'none'; form-action 'none';"
          + " object-src 'none'";

  /** Added without a token in the address: other pages cannot show such a page in a frame. */
  private static final String UNFRAMED = "; frame-ancestors 'none'";

  /** Maximum number of connections. Decided: some for each request, and more for attackers. */
  private static final int MOST_CONNECTIONS = 4 * MOST_REQUESTS;

  private static final ErrorPolicy FAILED = ErrorPolicy.finish("A request of a browser failed");

  private final HttpServer server;
  private final Site site;
  private final Access access;
  private final InetSocketAddress address;
  private final Semaphore places = new Semaphore(MOST_REQUESTS);

  static {
    // read once by the JDK's server [s]: who asks or reads more slowly is dropped
    System.setProperty("sun.net.httpserver.maxReqTime", "10");
    System.setProperty("jdk.httpserver.maxConnections", Integer.toString(MOST_CONNECTIONS));
    System.setProperty(
        "sun.net.httpserver.maxRspTime", Integer.toString(WebRequest.LONGEST_STREAM + 10));
  }

  /**
   * Creates a server that answers immediately.
   *
   * @param site the pages, which the server closes
   * @param wanted the address; port 0 lets the system choose
   * @param option the option that selects another port
   * @throws PortTakenException if the port cannot be opened
   */
  WebServer(Site site, InetSocketAddress wanted, String option) throws PortTakenException {
    this.site = site;
    try {
      server = HttpServer.create(wanted, 0);
    } catch (IOException e) {
      throw PortTakenException.taken(wanted, option, e);
    }
    address = server.getAddress();
    access = new Access(address.getPort());
    server.createContext("/", this::answer);
    server.setExecutor(this::start);
    server.start();
  }

  /** Creates a server of the page of a simulator; see {@link #WebServer}. */
  public static WebServer of(ScenarioHost host, InetSocketAddress wanted)
      throws PortTakenException {
    return new WebServer(new SimulatorSite(host), wanted, "--web");
  }

  /** Creates a server of the teacher's board; see {@link #WebServer}. */
  public static WebServer board(InetSocketAddress wanted) throws PortTakenException {
    return new WebServer(new BoardSite(), wanted, "--port");
  }

  private void start(Runnable request) {
    if (!places.tryAcquire()) {
      throw new RejectedExecutionException("too many requests"); // the connection is closed
    }
    try {
      Worker.once("web", FAILED, () -> answer(request));
    } catch (Throwable noThread) {
      places.release();
      throw noThread;
    }
  }

  private void answer(Runnable request) {
    try {
      request.run();
    } finally {
      places.release();
    }
  }

  int port() {
    return address.getPort();
  }

  AccessToken token() {
    return access.token();
  }

  /** Returns a line with a link for each address, for which people and scripts wait. */
  public List<String> lines() {
    return links()
        .flatMap(
            link ->
                Stream.concat(
                    Stream.of("web: " + link + "/?token=" + access.token().text()),
                    site.lines(link)))
        .toList();
  }

  /** Returns the addresses of this server, without a path. */
  Stream<String> links() {
    Stream<InetAddress> hosts =
        address.getAddress().isAnyLocalAddress()
            ? LocalNetworks.look().members().stream().map(LocalNetworks.Member::address)
            : Stream.of(address.getAddress());
    return hosts.map(host -> "http://" + host.getHostAddress() + ":" + address.getPort());
  }

  private void answer(HttpExchange exchange) {
    WebRequest request = new WebRequest(exchange);
    try (exchange) {
      request.header("X-Content-Type-Options", "nosniff");
      request.header("Referrer-Policy", "no-referrer");
      request.header("Cache-Control", "no-store");
      boolean named = access.named(exchange);
      request.header("Content-Security-Policy", named ? POLICY : POLICY + UNFRAMED);
      if (!access.allows(exchange) && !site.admits(exchange) && !isDesign(exchange)) {
        request.answer(
            WebRequest.FORBIDDEN,
            "Open the link that the program has printed: it contains the token.");
        return;
      }
      switch (exchange.getRequestMethod()) {
        case "GET" -> get(exchange, request);
        case "POST" -> post(request);
        default -> request.answer(WebRequest.NOT_ALLOWED, "Only GET and POST are known.");
      }
    } catch (IOException e) {
      LOG.debug("A browser has gone: {}", e.toString()); // pages are closed at any time
    } catch (RuntimeException e) {
      LOG.error("A request of a browser failed", e); // the JDK's server would hide it
      refuse(request);
    }
  }

  private static void refuse(WebRequest request) {
    try {
      request.answer(WebRequest.FAILED, "The simulator failed; its log has the reason.");
    } catch (IOException e) {
      LOG.debug("An answer had begun: {}", e.toString());
    }
  }

  /**
   * Whether a request is for a script or a style sheet. They are no secrets, and frames in pages of
   * other hosts, such as notebooks, load them without the cookie.
   */
  private static boolean isDesign(HttpExchange exchange) {
    return exchange.getRequestMethod().equals("GET")
        && exchange.getRequestURI().getPath().matches(".*\\.(css|js)");
  }

  private void get(HttpExchange exchange, WebRequest request) throws IOException {
    String path = request.path();
    String file = path.isEmpty() ? site.page() : path;
    String type = TYPES.get(file.substring(file.lastIndexOf('.') + 1));
    if (type == null) {
      site.get(request);
      return;
    }
    try (InputStream in = WebServer.class.getResourceAsStream(file)) {
      if (in == null) {
        request.answer(WebRequest.NOT_FOUND, "There is no such page.");
        return;
      }
      byte[] bytes = in.readAllBytes();
      if (access.offersCookie(exchange)) {
        request.header("Set-Cookie", access.cookieHeader());
      }
      request.answer(WebRequest.OK, type, file.endsWith(".html") ? filled(bytes, request) : bytes);
    }
  }

  /** Returns a page with its texts in the language of the browser. */
  private byte[] filled(byte[] page, WebRequest request) {
    Locale locale = request.locale();
    Map<String, String> values =
        Map.of("token", access.token().text(), "language", locale.getLanguage());
    return new WebTexts(locale)
        .filled(new String(page, StandardCharsets.UTF_8), values)
        .getBytes(StandardCharsets.UTF_8);
  }

  private void post(WebRequest request) throws IOException {
    try {
      site.post(request);
    } catch (IllegalArgumentException | IllegalStateException | AssertionError e) {
      String sentence = String.valueOf(e.getMessage()).lines().findFirst().orElse("");
      request.answer(WebRequest.BAD_REQUEST, sentence);
    }
  }

  @Override
  public void close() {
    site.close();
    server.stop(0);
  }
}
