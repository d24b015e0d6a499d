package tellosimulator.report;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.json.Json;

/**
 * A line of a report's list: a command, or something that happened. Immutable.
 *
 * @param time simulated seconds since the simulation began
 * @param drone empty if it concerns all
 * @param kind {@code answered}, {@code refused}, {@code crashed} and so on
 * @param event whether it is something that happened, not a command
 * @param wrong whether somebody wanted something else
 * @param words what is written
 */
public record ReportEntry(
    double time, OptionalInt drone, String kind, boolean event, boolean wrong, Words words) {

  /**
   * What is written of an entry; each text may be empty.
   *
   * @param text the command, or what happened
   * @param reply of the drone
   * @param why what it means, or why it went wrong
   * @param lasted how long the reply took [s]
   * @param count how many equal commands it stands for
   */
  public record Words(String text, String reply, String why, OptionalDouble lasted, int count) {}

  /** The same for one command more, and its reply. */
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

  /** As the page has it. */
  Map<String, Object> members() {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("t", Json.rounded(time));
    drone.ifPresent(number -> members.put("drone", number));
    members.put("kind", kind);
    members.put("text", words.text);
    members.put("reply", words.reply);
    members.put("why", words.why);
    words.lasted.ifPresent(seconds -> members.put("lasted", Json.rounded(seconds)));
    members.put("count", words.count);
    members.put("event", event);
    members.put("wrong", wrong);
    return members;
  }
}
