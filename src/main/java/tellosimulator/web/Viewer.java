package tellosimulator.web;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.video.camera.RenderCache;

/** One open page: its camera, its selected drone, and its streams. Thread-safe. */
final class Viewer implements AutoCloseable {

  /** Time between two pictures of the room [ns]. Decided: twenty a second. */
  private static final long ROOM_PERIOD = 50_000_000;

  /** Largest width of a picture of the room [pixels]. Decided: what a projector can show. */
  private static final int WIDEST = 1280;

  private static final int NARROWEST = 160;
  private static final int WIDTH = 960;
  private static final int HEIGHT = 540;

  private final WebSubject subject;
  private final RenderCache cache;
  private final WebPilot pilot;
  private final ViewerCamera camera = new ViewerCamera();
  private volatile int drone = 1;

  /** The connections of this page, which are closed with it. */
  private final Set<HttpExchange> open = new HashSet<>();

  private boolean closed;

  Viewer(WebSubject subject, RenderCache cache, WebPilot pilot) {
    this.subject = subject;
    this.cache = cache;
    this.pilot = pilot;
  }

  /** Whether no stream is open. */
  synchronized boolean idle() {
    return open.isEmpty();
  }

  private synchronized boolean isOpen() {
    return !closed;
  }

  private synchronized boolean begin(HttpExchange request) {
    return !closed && open.add(request);
  }

  private synchronized void end(HttpExchange request) {
    open.remove(request);
  }

  /** A stream that is written to a browser until the browser goes away. */
  private interface Stream {
    void send() throws IOException;
  }

  private void during(HttpExchange request, Stream stream) throws IOException {
    if (begin(request)) {
      try {
        stream.send();
      } finally {
        end(request);
      }
    }
  }

  /** Sends pictures of the room until the browser goes away. */
  void sendRoom(HttpExchange request) throws IOException {
    int width = size(request, "width", WIDTH);
    int height = size(request, "height", HEIGHT);
    during(
        request,
        () -> {
          try (RoomPictures pictures = new RoomPictures(subject, cache, width, height)) {
            PictureStream.send(
                request, ROOM_PERIOD, () -> pictures.next(camera, drone), this::isOpen);
          }
        });
  }

  private static int size(HttpExchange request, String name, int otherwise) {
    return Access.parameter(request.getRequestURI(), name)
        .filter(word -> word.matches("[0-9]{1,4}"))
        .map(Integer::valueOf)
        .map(pixels -> Math.max(NARROWEST, Math.min(WIDEST, pixels)) / 2 * 2)
        .orElse(otherwise);
  }

  /** Sends the film of the selected drone until the browser goes away. */
  void sendFilm(HttpExchange request) throws IOException {
    during(
        request,
        () -> {
          try (FilmPictures pictures = new FilmPictures(subject.video().stream(drone))) {
            PictureStream.send(request, ROOM_PERIOD, pictures::next, this::isOpen);
          }
        });
  }

  /** Sends the state until the browser goes away. */
  void sendState(HttpExchange request) throws IOException {
    during(request, () -> new StateStream(subject).send(request, this::isOpen));
  }

  /**
   * Carries out an action of the page.
   *
   * @throws IllegalArgumentException if the action is invalid; the message is one sentence
   */
  Object carryOut(Map<String, Object> action) {
    switch (String.valueOf(action.get("do"))) {
      case "turn" -> camera.turn(number(action, "right"), number(action, "down"));
      case "zoom" -> camera.zoom(Math.max(0.1, Math.min(10, number(action, "factor"))));
      case "look" -> camera.look(view(String.valueOf(action.get("view"))));
      case "fly" -> pilot.send(drone, String.valueOf(action.get("command")));
      case "select" -> select(number(action, "drone"));
      default -> {
        return subject.requests().result(action);
      }
    }
    return Map.of();
  }

  private void select(double number) {
    int count = subject.simulation().snapshot().drones().size();
    if (!(number >= 1 && number <= count)) {
      throw new IllegalArgumentException("drone must be from 1 to " + count);
    }
    drone = (int) number;
  }

  private static RoomView view(String word) {
    return Arrays.stream(RoomView.values())
        .filter(each -> each.name().equalsIgnoreCase(word))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("there is no such view"));
  }

  private static double number(Map<String, Object> action, String name) {
    return Optional.ofNullable(action.get(name))
        .filter(Number.class::isInstance)
        .map(value -> ((Number) value).doubleValue())
        .filter(Double::isFinite)
        .orElseThrow(() -> new IllegalArgumentException(name + " must be a number"));
  }

  @Override
  public synchronized void close() {
    closed = true;
    open.forEach(HttpExchange::close);
  }
}
