package tellosimulator.testing;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.json.Json;

/**
 * One page of a headless browser, which is driven through its DevTools protocol: real clicks, keys
 * and drags. Not thread-safe.
 */
public final class ChromiumPage implements AutoCloseable {

  private static final long PATIENCE_SECONDS = 30;
  private static final Pattern DEVTOOLS = Pattern.compile(".*ws://127.0.0.1:([0-9]+)/.*");
  private static final Pattern SOCKET =
      Pattern.compile("\"webSocketDebuggerUrl\": \"(ws://[^\"]*/devtools/page/[^\"]*)\"");

  private final Process process;
  private final WebSocket socket;
  private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
  private int sent;

  /**
   * Starts a browser with an empty page.
   *
   * @param work a folder for the browser's own files
   */
  public ChromiumPage(Path work, int width, int height) throws Exception {
    Path profile = Files.createTempDirectory(work, "profile");
    process =
        Tool.CHROMIUM
            .command(
                "--headless=new",
                "--no-sandbox",
                "--disable-gpu",
                "--remote-debugging-port=0",
                "--user-data-dir=" + profile,
                "--window-size=" + width + "," + height,
                "about:blank")
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    String port = port(process);
    HttpResponse<String> pages =
        HttpClient.newHttpClient()
            .send(
                HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + "/json")).build(),
                HttpResponse.BodyHandlers.ofString());
    Matcher found = SOCKET.matcher(pages.body());
    if (!found.find()) {
      throw new IOException("the browser has no page: " + pages.body());
    }
    socket =
        HttpClient.newHttpClient()
            .newWebSocketBuilder()
            .buildAsync(URI.create(found.group(1)), new Listener())
            .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    call("Page.enable", Map.of());
    call("DOM.enable", Map.of());
    call(
        "Emulation.setDeviceMetricsOverride",
        Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", false));
  }

  private static String port(Process process) throws IOException {
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(process.getErrorStream(), StandardCharsets.UTF_8));
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      Matcher found = DEVTOOLS.matcher(line);
      if (found.matches()) {
        return found.group(1);
      }
    }
    throw new IOException("the browser has ended");
  }

  /** Collects the parts of each message. */
  private final class Listener implements WebSocket.Listener {

    private final StringBuilder message = new StringBuilder();

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence part, boolean last) {
      message.append(part);
      if (last) {
        answers.add(message.toString());
        message.setLength(0);
      }
      from.request(1);
      return null;
    }
  }

  /** Calls a method of the DevTools protocol, and returns its result. */
  public Map<?, ?> call(String method, Map<String, Object> parameters) throws Exception {
    sent++;
    String message = Json.text(Json.object("id", sent, "method", method, "params", parameters));
    socket.sendText(message, true).get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    while (true) {
      String text = answers.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
      if (text == null) {
        throw new AssertionError("the browser does not answer " + method);
      }
      Map<?, ?> answer = (Map<?, ?>) Json.value(text);
      if (answer.get("id") instanceof Number id && id.intValue() == sent) {
        if (answer.get("error") != null) {
          throw new AssertionError(method + ": " + answer.get("error"));
        }
        return (Map<?, ?>) answer.get("result");
      }
    }
  }

  public void open(String link) throws Exception {
    call("Page.navigate", Map.of("url", link));
  }

  /** Returns the value of a JavaScript expression. */
  public Object value(String expression) throws Exception {
    Map<?, ?> answer =
        call("Runtime.evaluate", Map.of("expression", expression, "returnByValue", true));
    if (answer.get("exceptionDetails") != null) {
      throw new AssertionError(expression + ": " + answer.get("exceptionDetails"));
    }
    return ((Map<?, ?>) answer.get("result")).get("value");
  }

  /** Waits until a JavaScript expression is true; one that fails is not. */
  public void await(String expression) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    String safe =
        "(() => { try { return Boolean(" + expression + "); } catch { return false; } })()";
    while (!Boolean.TRUE.equals(value(safe))) {
      if (System.nanoTime() > end) {
        throw new AssertionError(
            "never true: " + expression + "; the page says " + value("document.body.innerText"));
      }
    }
  }

  /** Clicks into the middle of an element. */
  public void click(String selector) throws Exception {
    double[] middle = middle(selector);
    mouse("mousePressed", middle[0], middle[1], 1);
    mouse("mouseReleased", middle[0], middle[1], 0);
  }

  /** Drags from the middle of an element. */
  public void drag(String selector, double right, double down) throws Exception {
    double[] from = middle(selector);
    mouse("mousePressed", from[0], from[1], 1);
    mouse("mouseMoved", from[0] + right / 2, from[1] + down / 2, 1);
    mouse("mouseMoved", from[0] + right, from[1] + down, 1);
    mouse("mouseReleased", from[0] + right, from[1] + down, 0);
  }

  private double[] middle(String selector) throws Exception {
    List<?> place =
        (List<?>)
            value(
                "(() => { const e = document.querySelector('"
                    + selector
                    + "'); e.scrollIntoView({ block: 'nearest' });"
                    + " const r = e.getBoundingClientRect();"
                    + " return [r.x + r.width / 2, r.y + r.height / 2]; })()");
    return place.stream().mapToDouble(number -> ((Number) number).doubleValue()).toArray();
  }

  private void mouse(String type, double x, double y, int buttons) throws Exception {
    call(
        "Input.dispatchMouseEvent",
        Map.of(
            "type", type, "x", x, "y", y, "button", "left", "buttons", buttons, "clickCount", 1));
  }

  /** Presses a key, such as {@code KeyW}, and keeps it down. */
  public void press(String code) throws Exception {
    call("Input.dispatchKeyEvent", Map.of("type", "keyDown", "code", code));
  }

  public void release(String code) throws Exception {
    call("Input.dispatchKeyEvent", Map.of("type", "keyUp", "code", code));
  }

  /** Chooses a file for an input element. */
  public void choose(String selector, Path file) throws Exception {
    Object root = ((Map<?, ?>) call("DOM.getDocument", Map.of()).get("root")).get("nodeId");
    Object input =
        call("DOM.querySelector", Map.of("nodeId", root, "selector", selector)).get("nodeId");
    call("DOM.setFileInputFiles", Map.of("nodeId", input, "files", List.of(file.toString())));
  }

  @Override
  public void close() {
    socket.abort();
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly();
    try {
      process.waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
