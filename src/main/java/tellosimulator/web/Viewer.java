package tellosimulator.web;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntSupplier;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import tellosimulator.json.Json;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.scenery.overlay.Overlay;
import tellosimulator.time.Ticker;
import tellosimulator.video.camera.RenderCache;

/** One open page: its camera, its selected drone, and its streams. Thread-safe. */
final class Viewer {

  /** Shortest time between two pictures [ns]. Decided: twenty a second. */
  private static final long PICTURE_PERIOD = 50_000_000;

  /**
   * Number of viewers with the full rate; more of them share it. Decided: eight viewers get five
   * pictures a second each.
   */
  private static final int FULL_RATE = 2;

  /** Time between two events [ns]. Decided: as often as the drone's own state lines. */
  private static final long STATE_PERIOD = 100_000_000;

  /**
   * Number of unchanged states or pictures after which one is sent, so that proxies keep the stream
   * open, and a browser that has gone is noticed.
   */
  private static final int MOST_UNCHANGED = 50;

  /** Time after which a page without streams has gone [ns]. Decided: longer than it reconnects. */
  private static final long ABANDONED = 5_000_000_000L;

  private static final String BOUNDARY = "picture";

  /** Largest width of a picture of the room [pixels]. Decided: what a projector can show. */
  private static final int WIDEST = 1280;

  private static final int NARROWEST = 160;
  private static final int WIDTH = 960;
  private static final int HEIGHT = 540;

  private final Supplier<WebSubject> subject;
  private final RenderCache cache;
  private final IntSupplier readers;
  private final ViewerCamera camera = new ViewerCamera();

  /** The newest stream of each kind. */
  private final Map<String, WebRequest.Part> streams = new ConcurrentHashMap<>();

  private Aids aids;
  private final Ticker clock = new Ticker();
  private volatile long used = clock.nanos();
  private volatile boolean closed;

  private record Aids(int number, Overlay overlay) {}

  /**
   * Creates the viewer of a new page.
   *
   * @param cache the cache of all viewers
   * @param readers returns the number of viewers that read a stream
   */
  Viewer(Supplier<WebSubject> subject, RenderCache cache, IntSupplier readers) {
    this.readers = readers;
    this.subject = subject;
    this.cache = cache;
  }

  /** Whether a stream is open. */
  boolean reads() {
    return !streams.isEmpty();
  }

  /** Whether the page has gone: it has no stream, and has not asked for anything lately. */
  boolean abandoned() {
    return !reads() && clock.nanos() - used > ABANDONED;
  }

  /** Notes that the page has asked for something. */
  void use() {
    used = clock.nanos();
  }

  /** Ends all streams. */
  void close() {
    closed = true;
  }

  ViewerCamera camera() {
    return camera;
  }

  /** Returns the drone that a request is about; the first one unless it names another. */
  static int drone(WebRequest request, WebSubject subject) {
    int count = subject.simulation().snapshot().drones().size();
    return request
        .parameter("drone")
        .filter(word -> word.matches("[0-9]{1,2}"))
        .map(Integer::valueOf)
        .filter(number -> number >= 1 && number <= count)
        .orElse(1);
  }

  /** Looks from a view that a page names. */
  void look(String word) {
    camera.look(
        Arrays.stream(RoomView.values())
            .filter(each -> each.name().equalsIgnoreCase(word))
            .findFirst()
            .orElseThrow(() -> new IllegalArgumentException("there is no such view")));
  }

  /**
   * Sends pictures of the room, and of a drone's camera if the page wants them, until the browser
   * goes away. Both are in one stream, because browsers open few connections to a server.
   */
  void sendRoom(WebRequest request) throws IOException {
    int width = size(request, "width", WIDTH);
    int height = size(request, "height", HEIGHT);
    WebSubject shown = subject.get();
    int drone = drone(request, shown);
    boolean filmed = request.parameter("film").isPresent();
    try (ViewerPictures room = new ViewerPictures(shown, overlay(shown), cache, width, height);
        FilmPictures film = new FilmPictures(shown.video().stream(drone), filmed)) {
      stream(
          request,
          "room",
          "multipart/x-mixed-replace; boundary=" + BOUNDARY,
          () -> PICTURE_PERIOD * Math.max(FULL_RATE, readers.getAsInt()) / FULL_RATE,
          shown,
          new Pictures(() -> room.next(camera, drone), film));
    }
  }

  /** Returns the aids of a scenario, with the trails that earlier streams have begun. */
  private synchronized Overlay overlay(WebSubject shown) {
    if (aids == null || aids.number != shown.number()) {
      aids = new Aids(shown.number(), new Overlay(shown.simulation().snapshot()));
    }
    return aids.overlay;
  }

  private static int size(WebRequest request, String name, int otherwise) {
    return request
        .parameter(name)
        .filter(word -> word.matches("[0-9]{1,4}"))
        .map(Integer::valueOf)
        .map(pixels -> Math.max(NARROWEST, Math.min(WIDEST, pixels)) / 2 * 2)
        .orElse(otherwise);
  }

  /** The pictures that have changed, and now and then one that has not. */
  private static final class Pictures implements WebRequest.Part {

    private final Supplier<Optional<byte[]>> room;
    private final FilmPictures film;
    private Optional<byte[]> last = Optional.empty();
    private int unchanged;

    Pictures(Supplier<Optional<byte[]>> room, FilmPictures film) {
      this.room = room;
      this.film = film;
    }

    @Override
    public void write(OutputStream out) throws IOException {
      Optional<byte[]> picture = room.get();
      unchanged++;
      if (picture.isPresent() || unchanged >= MOST_UNCHANGED) {
        last = picture.or(() -> last);
        unchanged = 0;
        send(out, "room", last);
      }
      send(out, "film", film.next());
    }
  }

  private static void send(OutputStream out, String of, Optional<byte[]> picture)
      throws IOException {
    if (picture.isEmpty()) {
      return;
    }
    String head =
        String.format(
            Locale.ROOT,
            "--%s\r\nContent-Type: image/jpeg\r\nContent-Location: %s\r\nContent-Length: %d\r\n\r\n",
            BOUNDARY,
            of,
            picture.get().length);
    out.write(head.getBytes(StandardCharsets.US_ASCII));
    out.write(picture.get());
    out.write("\r\n".getBytes(StandardCharsets.US_ASCII));
    out.flush();
  }

  /** Sends a stream, which ends the viewer's earlier stream of that kind. */
  private void stream(
      WebRequest request,
      String kind,
      String type,
      LongSupplier period,
      WebSubject shown,
      WebRequest.Part part)
      throws IOException {
    streams.put(kind, part);
    try {
      request.stream(
          type,
          period,
          () -> !closed && streams.get(kind) == part && subject.get().number() == shown.number(),
          part);
    } finally {
      streams.remove(kind, part);
    }
  }

  /** Sends the state and the log as server-sent events until the browser goes away. */
  void sendState(WebRequest request, Supplier<Map<String, Object>> more) throws IOException {
    WebSubject shown = subject.get();
    stream(
        request,
        "state",
        "text/event-stream",
        () -> STATE_PERIOD,
        shown,
        new Events(shown, new WebTexts(request.locale()), more));
  }

  /** The state, if it has changed, and the events that have happened. */
  private static final class Events implements WebRequest.Part {

    private final WebSubject subject;
    private final WebTexts texts;
    private final Supplier<Map<String, Object>> more;
    private String before = "";
    private int unchanged;
    private long logged;

    Events(WebSubject subject, WebTexts texts, Supplier<Map<String, Object>> more) {
      this.subject = subject;
      this.texts = texts;
      this.more = more;
    }

    @Override
    public void write(OutputStream out) throws IOException {
      long count = subject.log().count();
      if (count > logged || before.isEmpty()) {
        WebRequest.sendEvent(
            out,
            before.isEmpty() ? "begin" : "log",
            subject.log().after(logged).stream()
                .map(event -> EventHistory.members(event, texts))
                .toList());
        logged = count;
      }
      Map<String, Object> members = FlightState.of(subject, texts);
      members.putAll(more.get());
      String state = Json.text(members);
      unchanged++;
      if (!state.equals(before) || unchanged >= MOST_UNCHANGED) {
        WebRequest.sendEvent(out, "state", members);
        before = state;
        unchanged = 0;
      }
    }
  }
}
