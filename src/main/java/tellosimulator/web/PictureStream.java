package tellosimulator.web;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import tellosimulator.time.Ticker;

/** Sends JPEG files, each of which replaces the one before in the browser. */
final class PictureStream {

  private static final String BOUNDARY = "picture";

  private PictureStream() {}

  /**
   * Sends pictures until the browser goes away, or the stream ends. Blocks.
   *
   * @param period time between two pictures [ns]
   * @param pictures supplies the next picture; empty if nothing has changed
   * @param open whether the stream goes on
   */
  static void send(
      HttpExchange request, long period, Supplier<Optional<byte[]>> pictures, BooleanSupplier open)
      throws IOException {
    request.getResponseHeaders().remove("X-Content-Type-Options"); // browsers would show nothing
    request
        .getResponseHeaders()
        .set("Content-Type", "multipart/x-mixed-replace; boundary=" + BOUNDARY);
    request.sendResponseHeaders(200, 0);
    OutputStream out = request.getResponseBody();
    out.write(("--" + BOUNDARY + "\r\n").getBytes(StandardCharsets.US_ASCII));
    Ticker ticker = new Ticker();
    Optional<byte[]> last = Optional.empty();
    while (open.getAsBoolean()) {
      if (ticker.awaitTick(period)) {
        Optional<byte[]> picture = pictures.get();
        if (picture.isPresent()) {
          last = picture;
          write(out, picture.get());
        } else if (last.isPresent()) { // browsers show a picture when the next one begins
          write(out, last.get());
          last = Optional.empty();
        }
      }
    }
  }

  /** Writes a picture, and the boundary behind it, so that the browser shows it at once. */
  private static void write(OutputStream out, byte[] picture) throws IOException {
    String head = "Content-Type: image/jpeg\r\nContent-Length: " + picture.length + "\r\n\r\n";
    out.write(head.getBytes(StandardCharsets.US_ASCII));
    out.write(picture);
    out.write(("\r\n--" + BOUNDARY + "\r\n").getBytes(StandardCharsets.US_ASCII));
    out.flush();
  }
}
