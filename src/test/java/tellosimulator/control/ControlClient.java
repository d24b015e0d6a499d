package tellosimulator.control;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;

/** A minimal client of the control channel. */
public final class ControlClient implements AutoCloseable {

  private static final int PATIENCE_MS = 30_000;

  private final Socket socket;
  private final BufferedReader answers;
  private final String token;

  public ControlClient(int port, String token) throws IOException {
    this.token = token;
    socket = new Socket(InetAddress.getLoopbackAddress(), port);
    socket.setSoTimeout(PATIENCE_MS);
    answers =
        new BufferedReader(
            new InputStreamReader(socket.getInputStream(), StandardCharsets.US_ASCII));
  }

  /** Sends a line and returns the next line received; null at the end of the stream. */
  String line(String line) throws IOException {
    send(line);
    return read();
  }

  void send(String line) throws IOException {
    socket.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
  }

  String read() throws IOException {
    return answers.readLine();
  }

  /**
   * Sends a request and returns the result.
   *
   * @param parameters members of a JSON object, without braces, such as {@code "drone": 1}
   */
  public Object ask(String name, String parameters) throws IOException {
    Map<String, Object> answer = answer(name, parameters);
    if (!Boolean.TRUE.equals(answer.get("ok"))) {
      throw new AssertionError(name + ": " + answer.get("error"));
    }
    return answer.get("result");
  }

  public Object ask(String name) throws IOException {
    return ask(name, "");
  }

  /** Sends a request whose result is an object. */
  @SuppressWarnings("unchecked")
  public Map<String, Object> object(String name, String parameters) throws IOException {
    return (Map<String, Object>) ask(name, parameters);
  }

  public Map<String, Object> object(String name) throws IOException {
    return object(name, "");
  }

  /** Sends a request whose result is a list of objects. */
  @SuppressWarnings("unchecked")
  public List<Map<String, Object>> objects(String name, String parameters) throws IOException {
    return (List<Map<String, Object>>) ask(name, parameters);
  }

  public List<Map<String, Object>> objects(String name) throws IOException {
    return objects(name, "");
  }

  /** Sends a request whose result is a list. */
  @SuppressWarnings("unchecked")
  public List<Object> list(String name, String parameters) throws IOException {
    return (List<Object>) ask(name, parameters);
  }

  public List<Object> list(String name) throws IOException {
    return list(name, "");
  }

  /** Sends a request that fails, and returns the error message. */
  String error(String name, String parameters) throws IOException {
    Map<String, Object> answer = answer(name, parameters);
    if (!Boolean.FALSE.equals(answer.get("ok"))) {
      throw new AssertionError(name + " is carried out: " + answer);
    }
    return (String) answer.get("error");
  }

  private Map<String, Object> answer(String name, String parameters) throws IOException {
    return parsed(line(request(name, parameters)));
  }

  String request(String name, String parameters) {
    String more = parameters.isEmpty() ? "" : ", " + parameters;
    return "{\"id\": 7, \"token\": \"" + token + "\", \"do\": \"" + name + "\"" + more + "}";
  }

  @SuppressWarnings("unchecked")
  static Map<String, Object> parsed(String line) {
    return (Map<String, Object>) new Load(LoadSettings.builder().build()).loadFromString(line);
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
