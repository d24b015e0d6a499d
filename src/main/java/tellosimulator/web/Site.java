package tellosimulator.web;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.util.stream.Stream;

/** The pages of a {@link WebServer}. Thread-safe: each request has a thread of its own. */
interface Site extends AutoCloseable {

  /** Whether a request may be answered although it lacks the token of the pages. */
  default boolean admits(HttpExchange request) {
    return false;
  }

  /** Returns lines with more links, for which people and scripts wait. */
  default Stream<String> lines(String link) {
    return Stream.of();
  }

  /** Returns the name of the resource with the first page. */
  String page();

  /** Answers a GET request for anything but a file. */
  void get(WebRequest request) throws IOException;

  /**
   * Answers a POST request.
   *
   * @throws IllegalArgumentException if the request is invalid; the message is one sentence
   * @throws IllegalStateException if it cannot be carried out now; the message is one sentence
   */
  void post(WebRequest request) throws IOException;

  @Override
  void close();
}
