package tellosimulator.web;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import tellosimulator.control.AccessToken;
import tellosimulator.json.Json;
import tellosimulator.time.Ticker;

/**
 * The teacher's board: one page that shows many simulators, which report to it. They need the token
 * of the class, which opens nothing else. Thread-safe.
 */
final class BoardSite implements Site {

  /** Maximum number of simulators. Decided: a class, with many to spare. */
  private static final int MOST_SEATS = 100;

  /** Time after which a silent simulator counts as gone [ns]. Decided: several reports. */
  private static final long SILENCE = 5_000_000_000L;

  /** Time after which a silent simulator leaves the board [ns]. Decided: a break in a lesson. */
  private static final long ABSENCE = 600_000_000_000L;

  /** Shortest time between two reports of a simulator [ns]. Decided: half their period. */
  private static final long SHORTEST = 500_000_000;

  private static final long EVENT_PERIOD = 500_000_000;

  /** What simulators accept from the board. */
  private static final Set<String> ORDERS = Set.of("power-all", "reset", "course", "pause");

  /** The orders after which results no longer count. */
  private static final Set<String> RESTARTS = Set.of("reset", "course");

  private final AccessToken token = AccessToken.create();
  private final Ticker clock = new Ticker();
  private final Map<String, Seat> seats = new LinkedHashMap<>();
  private Locale language = Locale.ENGLISH;
  private long newest;
  private volatile boolean closed;

  /** A simulator that reports. Guarded by the site. */
  private static final class Seat {
    final long number;
    final List<Map<String, Object>> orders = new ArrayList<>();
    SeatReport report = SeatReport.NONE;
    SeatReport best = SeatReport.NONE;
    byte[] picture = {};
    long pictures;
    long heard;

    Seat(long number, long now) {
      this.number = number;
      heard = now - SHORTEST;
    }
  }

  @Override
  public Stream<String> lines(String link) {
    return Stream.of("board: " + link + "/?class=" + token.text());
  }

  @Override
  public boolean admits(HttpExchange request) {
    return request.getRequestMethod().equals("POST")
        && request.getRequestURI().getPath().endsWith("/seat")
        && Access.isNeighbor(request)
        && token.matches(Access.parameter(request.getRequestURI(), "class").orElse(""));
  }

  @Override
  public String page() {
    return "board.html";
  }

  @Override
  public void get(WebRequest request) throws IOException {
    switch (request.path()) {
      case "state" -> sendState(request);
      case "picture" -> picture(request);
      default -> request.answer(WebRequest.NOT_FOUND, "There is no such page.");
    }
  }

  private void sendState(WebRequest request) throws IOException {
    synchronized (this) {
      language = request.locale();
    }
    request.stream(
        "text/event-stream",
        () -> EVENT_PERIOD,
        () -> !closed,
        out -> WebRequest.sendEvent(out, "state", state()));
  }

  private void picture(WebRequest request) throws IOException {
    byte[] picture;
    synchronized (this) {
      picture =
          seats.values().stream()
              .filter(
                  seat -> Long.toString(seat.number).equals(request.parameter("seat").orElse("")))
              .map(seat -> seat.picture)
              .findFirst()
              .orElse(new byte[0]);
    }
    request.answer(WebRequest.OK, "image/jpeg", picture);
  }

  private synchronized Map<String, Object> state() {
    long now = clock.nanos();
    seats.values().removeIf(seat -> now - seat.heard > ABSENCE);
    List<Seat> ranked = new ArrayList<>(seats.values());
    ranked.sort(Comparator.comparing(seat -> seat.best, SeatReport.BEST_FIRST));
    return Json.object(
        "seats", seats.values().stream().map(seat -> members(seat, now)).toList(),
        "ranking", ranked.stream().map(seat -> seat.best.members()).toList());
  }

  private static Map<String, Object> members(Seat seat, long now) {
    Map<String, Object> members = new HashMap<>(seat.report.members());
    members.put("seat", seat.number);
    members.put("picture", seat.pictures);
    members.put("gone", now - seat.heard > SILENCE);
    return members;
  }

  @Override
  public void post(WebRequest request) throws IOException {
    switch (request.path()) {
      case "seat" -> request.answer(take(request));
      case "do" -> {
        Map<String, Object> order = order(request.action());
        synchronized (this) {
          seats.values().forEach(seat -> order(seat, order));
        }
        request.answer(Map.of());
      }
      default -> request.answer(WebRequest.NOT_FOUND, "There is no such action.");
    }
  }

  private static void order(Seat seat, Map<String, Object> order) {
    seat.orders.removeIf(earlier -> earlier.get("do").equals(order.get("do")));
    seat.orders.add(order);
  }

  /**
   * Returns an order of the board to simulators.
   *
   * @throws IllegalArgumentException if it is none; the message is one sentence
   */
  static Map<String, Object> order(Object order) {
    if (!(order instanceof Map<?, ?> members && ORDERS.contains(members.get("do")))) {
      throw new IllegalArgumentException("the board can only ask for " + ORDERS);
    }
    Map<String, Object> known = new LinkedHashMap<>();
    List.of("do", "on", "seed").stream()
        .filter(members::containsKey)
        .forEach(name -> known.put(name, members.get(name)));
    return known;
  }

  /** Takes a report, and returns what the simulator is to do. */
  private Map<String, Object> take(WebRequest request) throws IOException {
    String id = request.parameter("id").orElse("");
    if (!id.matches("[0-9a-f]{32}")) {
      throw new IllegalArgumentException("a simulator needs an id of 32 hexadecimal digits");
    }
    byte[] body = request.body();
    SeatReport report = SeatReport.of(body);
    byte[] picture = SeatReport.picture(body);
    synchronized (this) {
      long now = clock.nanos();
      Seat known = seats.get(id);
      if (known == null && seats.size() >= MOST_SEATS) {
        seats.values().removeIf(seat -> now - seat.heard > SILENCE);
      }
      if (known == null && seats.size() >= MOST_SEATS) {
        throw new IllegalStateException("There are " + MOST_SEATS + " simulators already.");
      }
      Seat seat = known == null ? new Seat(++newest, now) : known;
      if (now - seat.heard < SHORTEST) {
        return Map.of(); // too soon: simulators report again in any case
      }
      seats.put(id, seat);
      seat.heard = now;
      seat.report = report;
      seat.best = SeatReport.better(seat.best, report);
      if (picture.length > 0) {
        seat.picture = picture;
        seat.pictures++;
      }
      List<Map<String, Object>> orders = List.copyOf(seat.orders); // each is sent once
      seat.orders.clear();
      if (orders.stream().anyMatch(order -> RESTARTS.contains(order.get("do")))) {
        seat.best = SeatReport.NONE.of(report);
      }
      return Json.object("language", language.getLanguage(), "orders", orders);
    }
  }

  @Override
  public void close() {
    closed = true;
  }
}
