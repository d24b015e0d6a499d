package tellosimulator.report;

import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.json.Json;

/**
 * A line of a report's list: a command or an event. Immutable.
 *
 * @param time simulated seconds since the simulation began
 * @param drone the drone's number; empty if the entry concerns all drones
 * @param kind {@code answered}, {@code refused}, {@code crashed} and so on
 * @param event whether the entry is an event rather than a command
 * @param wrong whether the operator probably did not intend the outcome
 * @param words the texts of the entry
 */
public record ReportEntry(
    double time, OptionalInt drone, String kind, boolean event, boolean wrong, Words words) {

  /**
   * The texts of an entry; each may be empty.
   *
   * @param text the command, or the description of the event
   * @param reply the drone's reply
   * @param why the meaning of the command, or the reason for its failure
   * @param lasted the time from command to reply [s]
   * @param count the number of commands that the entry represents
   */
  public record Words(String text, String reply, String why, OptionalDouble lasted, int count) {}

  /** Returns a copy of this entry that represents one more command, with the given reply. */
  ReportEntry andOneMore(String reply) {
    Words more =
        new Words(
            words.text,
            reply.isEmpty() ? words.reply : reply,
            words.why,
            words.lasted,
            words.count + 1);
    return new ReportEntry(time, drone, kind, event, wrong, more);
  }

  /** Returns the members for the page's data. */
  Map<String, Object> members() {
    return Json.object(
        "t",
        time,
        "drone",
        drone,
        "kind",
        kind,
        "text",
        words.text,
        "reply",
        words.reply,
        "why",
        words.why,
        "lasted",
        words.lasted,
        "count",
        words.count,
        "event",
        event,
        "wrong",
        wrong);
  }
}
