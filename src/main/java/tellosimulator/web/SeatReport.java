package tellosimulator.web;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import tellosimulator.json.Json;

/**
 * The state that a simulator reports to the teacher's board. Simulators belong to students, so
 * nothing that they send is trusted: each member has its type, and texts are short. Immutable.
 */
record SeatReport(Map<String, Object> members) {

  /** Maximum length of a text [characters]. Decided: what fits into a tile. */
  private static final int LONGEST = 120;

  /** Largest picture [bytes]. Decided: several times the size of a simulator's picture. */
  private static final int MOST_BYTES = 150_000;

  /** Largest width and height of a picture [pixels]. Decided: twice those of a simulator. */
  private static final int WIDEST = 960;

  private static final Map<String, Object> EMPTY =
      Json.object(
          "name", "",
          "team", "",
          "title", "",
          "course", 0.0,
          "status", "running",
          "reached", 0.0,
          "goals", 0.0,
          "clock", 0.0,
          "points", 0.0,
          "of", 0.0,
          "operator", "",
          "command", "",
          "failed", "");

  /** The report of a simulator that has not done anything. */
  static final SeatReport NONE = new SeatReport(EMPTY);

  /** The order of the leaderboard: points, then goals, then time. */
  static final Comparator<SeatReport> BEST_FIRST =
      Comparator.comparing(number("points"))
          .thenComparing(number("reached"))
          .reversed()
          .thenComparing(number("clock"));

  SeatReport {
    members = Map.copyOf(members);
  }

  private static Function<SeatReport, Double> number(String name) {
    return report -> (Double) report.members.get(name);
  }

  /**
   * Reads a report: a line with a flat JSON object.
   *
   * @throws IllegalArgumentException if it is none; the message is one sentence
   */
  static SeatReport of(byte[] body) {
    String line = new String(body, 0, end(body), StandardCharsets.UTF_8);
    Map<String, Object> said = Json.flatObject(line, "{\"name\": \"Ada\"}");
    Map<String, Object> members = new TreeMap<>();
    EMPTY.forEach((name, usual) -> members.put(name, checked(said.get(name), usual)));
    return new SeatReport(members);
  }

  private static Object checked(Object value, Object usual) {
    if (usual instanceof Double && value instanceof Number number) {
      return number.doubleValue();
    }
    if (usual instanceof String && value instanceof String text) {
      String printable = text.replaceAll("\\p{Cntrl}", " ");
      return printable.substring(0, Math.min(LONGEST, printable.length()));
    }
    return usual;
  }

  /**
   * Returns the picture, which is behind the line; may be empty.
   *
   * @throws IllegalArgumentException if it is not a small JPEG file; the message is one sentence
   */
  static byte[] picture(byte[] body) {
    byte[] picture = Arrays.copyOfRange(body, Math.min(body.length, end(body) + 1), body.length);
    if (picture.length > 0 && !isSmallJpeg(ByteBuffer.wrap(picture))) {
      throw new IllegalArgumentException("the picture is not a small JPEG file");
    }
    return picture;
  }

  /**
   * Returns whether a file is a JPEG file whose picture is so small that a browser can show a
   * hundred of them. Documented: segments and frame headers of ITU-T T.81, annex B.
   */
  private static boolean isSmallJpeg(ByteBuffer file) {
    if (file.limit() > MOST_BYTES || file.limit() < 4 || file.getShort(0) != (short) 0xffd8) {
      return false;
    }
    int at = 2;
    while (at + 9 <= file.limit() && (file.get(at) & 0xff) == 0xff) {
      int marker = file.get(at + 1) & 0xff;
      if (marker >= 0xc0 && marker <= 0xc2) { // a frame header: length, precision, height, width
        return (file.getShort(at + 5) & 0xffff) <= WIDEST
            && (file.getShort(at + 7) & 0xffff) <= WIDEST;
      }
      at += 2 + (file.getShort(at + 2) & 0xffff);
    }
    return false;
  }

  private static int end(byte[] body) {
    int end = 0;
    while (end < body.length && body[end] != '\n') {
      end++;
    }
    return end;
  }

  /** Returns a report like this one, under the name and team of another one. */
  SeatReport of(SeatReport named) {
    Map<String, Object> renamed = new TreeMap<>(members);
    renamed.put("name", named.members.get("name"));
    renamed.put("team", named.members.get("team"));
    return new SeatReport(renamed);
  }

  /** Returns the better one of two reports of a simulator; on another course, the new one. */
  static SeatReport better(SeatReport best, SeatReport now) {
    boolean sameCourse =
        best.members.get("title").equals(now.members.get("title"))
            && best.members.get("course").equals(now.members.get("course"));
    return sameCourse && BEST_FIRST.compare(best, now) < 0 ? best.of(now) : now;
  }
}
