package tellosimulator.web;

import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Asks a server as the script of a page does, or as an attacker. */
final class WebClient {

  private static final Pattern LENGTH = Pattern.compile("Content-Length: ([0-9]+)");

  private final HttpClient client = HttpClient.newHttpClient();
  private final int port;
  private final String query;

  /**
   * @param query the parameters that each address has
   */
  WebClient(int port, String query) {
    this.port = port;
    this.query = query;
  }

  private HttpRequest.Builder request(String path) {
    String sign = path.contains("?") ? "&" : "?";
    return HttpRequest.newBuilder(
        URI.create("http://127.0.0.1:" + port + "/" + path + sign + query));
  }

  HttpResponse<String> get(String path) {
    return sent(request(path).build(), HttpResponse.BodyHandlers.ofString());
  }

  HttpResponse<byte[]> bytes(String path) {
    return sent(request(path).build(), HttpResponse.BodyHandlers.ofByteArray());
  }

  HttpResponse<String> post(String path, String body) {
    return post(path, body.getBytes(StandardCharsets.UTF_8));
  }

  HttpResponse<String> post(String path, byte[] body) {
    return sent(
        request(path).POST(HttpRequest.BodyPublishers.ofByteArray(body)).build(),
        HttpResponse.BodyHandlers.ofString());
  }

  /** Opens a stream, which the caller closes. */
  InputStream stream(String path) {
    return sent(request(path).build(), HttpResponse.BodyHandlers.ofInputStream()).body();
  }

  private <T> HttpResponse<T> sent(HttpRequest request, HttpResponse.BodyHandler<T> handler) {
    try {
      return client.send(request, handler);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  /** Returns the first data of an event that fits. */
  String awaitEvent(String name, Predicate<String> fits) throws IOException {
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(stream("state"), StandardCharsets.UTF_8))) {
      String event = "";
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        if (line.startsWith("event: ")) {
          event = line.substring("event: ".length());
        }
        if (line.startsWith("data: ") && event.equals(name) && fits.test(dense(line))) {
          return dense(line.substring("data: ".length()));
        }
      }
      throw new IOException("the stream ended");
    }
  }

  /** Returns JSON without spaces between its parts. */
  static String dense(String json) {
    return json.replace("\": ", "\":").replace(", \"", ",\"").replace("}, {", "},{");
  }

  /** Reads the next picture of a stream. */
  static byte[] picture(InputStream stream) throws IOException {
    DataInputStream in = new DataInputStream(stream);
    StringBuilder head = new StringBuilder();
    while (head.indexOf("\r\n\r\n") < 0) {
      head.append((char) in.readUnsignedByte());
    }
    Matcher length = LENGTH.matcher(head);
    if (!length.find()) {
      throw new IOException("a part without its length: " + head);
    }
    byte[] picture = new byte[Integer.parseInt(length.group(1))];
    in.readFully(picture);
    in.skipNBytes(2);
    return picture;
  }

  /** Sends the text of a request as it is, and returns the status line of the answer. */
  static String status(int port, String... lines) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      String text = String.join("\r\n", lines) + "\r\n\r\n";
      socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
      BufferedReader answer =
          new BufferedReader(
              new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
      return String.valueOf(answer.readLine());
    }
  }
}
