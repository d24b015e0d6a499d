package tellosimulator.web;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import tellosimulator.json.Json;
import tellosimulator.time.Ticker;
import tellosimulator.translation.PhraseCatalog;

/** A request that is allowed, with the ways to answer it. Confined to the thread that answers. */
final class WebRequest {

  static final int OK = 200;
  static final int BAD_REQUEST = 400;
  static final int FORBIDDEN = 403;
  static final int NOT_FOUND = 404;
  static final int NOT_ALLOWED = 405;
  static final int FAILED = 500;
  static final int TOO_MANY = 503;

  /** Largest body [bytes]. Decided: a scenario with a large room has some 20 kB. */
  static final int MOST_BYTES = 1 << 20;

  /**
   * Longest duration of a stream [s]; the page begins the next one. Decided: the JDK's server drops
   * a reader that takes longer, so that one that does not read is dropped, too.
   */
  static final int LONGEST_STREAM = 60;

  private final HttpExchange exchange;

  WebRequest(HttpExchange exchange) {
    this.exchange = exchange;
  }

  /** Returns the path after the last slash, because proxies may put a prefix before it. */
  String path() {
    String path = exchange.getRequestURI().getPath();
    return path.substring(path.lastIndexOf('/') + 1);
  }

  Optional<String> parameter(String name) {
    return Access.parameter(exchange.getRequestURI(), name);
  }

  /** Returns the language that is named in the address, or else the browser's. */
  Locale locale() {
    String wanted =
        parameter("language")
            .orElseGet(() -> Access.first(exchange.getRequestHeaders(), "Accept-Language"));
    return offered(wanted);
  }

  /** Returns the first of some languages that is offered, or else English. */
  static Locale offered(String wanted) {
    return Arrays.stream(wanted.split("[,;]"))
        .map(tag -> Locale.forLanguageTag(tag.strip()).getLanguage())
        .map(Locale::forLanguageTag)
        .filter(PhraseCatalog.OFFERED::contains)
        .findFirst()
        .orElse(Locale.ENGLISH);
  }

  /**
   * Returns the body.
   *
   * @throws IllegalArgumentException if it is too large; the message is one sentence
   */
  byte[] body() throws IOException {
    byte[] body = exchange.getRequestBody().readNBytes(MOST_BYTES + 1);
    if (body.length > MOST_BYTES) {
      throw new IllegalArgumentException("The request is longer than 1 MB.");
    }
    return body;
  }

  /**
   * Returns the members of the body, which is a flat JSON object.
   *
   * @throws IllegalArgumentException if it is not; the message is one sentence
   */
  Map<String, Object> action() throws IOException {
    return Json.flatObject(new String(body(), StandardCharsets.UTF_8), "{\"do\": \"drones\"}");
  }

  void answer(int status, String sentence) throws IOException {
    answer(status, "text/plain", sentence.getBytes(StandardCharsets.UTF_8));
  }

  void answer(Object json) throws IOException {
    answer(OK, "application/json", Json.text(json).getBytes(StandardCharsets.UTF_8));
  }

  void answer(int status, String type, byte[] bytes) throws IOException {
    boolean text = type.startsWith("text/");
    header("Content-Type", text ? type + "; charset=utf-8" : type);
    exchange.sendResponseHeaders(status, bytes.length == 0 ? -1 : bytes.length);
    exchange.getResponseBody().write(bytes);
  }

  /** Begins an answer of unknown length. */
  OutputStream begin(String type) throws IOException {
    header("Content-Type", type);
    exchange.sendResponseHeaders(OK, 0);
    return exchange.getResponseBody();
  }

  /** Sets a header of the answer; without a value, removes it. */
  void header(String name, String... value) {
    exchange.getResponseHeaders().put(name, List.of(value));
  }

  /** Writes a server-sent event. */
  static void sendEvent(OutputStream out, String event, Object data) throws IOException {
    String text =
        String.format(Locale.ROOT, "retry: 100\nevent: %s\ndata: %s\n\n", event, Json.text(data));
    out.write(text.getBytes(StandardCharsets.UTF_8));
    out.flush();
  }

  /** What a stream writes at one tick. */
  interface Part {
    void write(OutputStream out) throws IOException;
  }

  /**
   * Sends a stream until the browser goes away, the stream has lasted {@link #LONGEST_STREAM}, or
   * it is no longer wanted. Blocks.
   *
   * @param period returns the time between two parts [ns]
   */
  void stream(String type, LongSupplier period, BooleanSupplier wanted, Part part)
      throws IOException {
    OutputStream out = begin(type);
    Ticker ticker = new Ticker();
    long end = ticker.nanos() + LONGEST_STREAM * 1_000_000_000L;
    while (wanted.getAsBoolean() && ticker.nanos() < end) {
      if (ticker.awaitTick(period.getAsLong())) {
        part.write(out);
      }
    }
  }
}
