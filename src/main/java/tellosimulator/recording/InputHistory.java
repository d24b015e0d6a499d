package tellosimulator.recording;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import tellosimulator.json.Json;
import tellosimulator.json.JsonRecords;
import tellosimulator.sim.SimInput;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * All inputs of a simulation since it began. They are needed to replay any of its flights, because
 * the position and battery level of a drone depend on everything that happened before. Must not be
 * used by two threads at the same time.
 */
final class InputHistory {

  /**
   * Maximum size of the history [bytes]. A longer history is dropped, and later flights of the run
   * cannot be replayed exactly. Decided: enough for more than an hour of stick commands at 20 Hz,
   * and negligible for any machine.
   */
  private static final int MOST = 12 << 20;

  /** The history takes at most 1/32 of the heap. */
  private static final long SHARE_OF_HEAP = 32;

  private final long most;
  private Optional<InitialConditions> start = Optional.empty();
  private final ByteArrayOutputStream lines = new ByteArrayOutputStream();
  private boolean begun;
  private boolean complete;

  InputHistory() {
    this(Math.min(MOST, Runtime.getRuntime().maxMemory() / SHARE_OF_HEAP));
  }

  /**
   * Creates an empty history.
   *
   * @param most maximum size of the history [bytes]
   */
  InputHistory(long most) {
    this.most = most;
  }

  /** Processes the next entry; returns its line if the entry is an input. */
  Optional<String> take(Entry entry) {
    if (entry instanceof Entry.NewRun newRun) {
      begin(newRun);
    } else if (entry instanceof Entry.Asked asked) {
      start = start.map(from -> from.withChallenge(asked.challenge()));
    } else if (entry instanceof Entry.Overrun || entry instanceof Entry.Missed) {
      forget();
    } else if (begun && entry instanceof Entry.Input input) {
      return Optional.of(kept(line(input)));
    }
    return Optional.empty();
  }

  /** Formats the initial conditions as the first line of the inputs. */
  static String line(InitialConditions start) {
    return Json.text(start.json()) + "\n";
  }

  private static String line(Entry.Input entry) {
    SimInput plain = entry.input();
    if (plain instanceof SimInput.Dropped dropped) { // the reason is kept as English text
      Phrase reason = Phrase.of("%s", dropped.reason().english());
      plain = new SimInput.Dropped(dropped.drone(), dropped.host(), dropped.count(), reason);
    }
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("step", entry.time().nanos() / SimTime.STEP_NANOS);
    members.put("input", JsonRecords.write(SimInput.class, plain));
    return Json.text(members) + "\n";
  }

  private void begin(Entry.NewRun newRun) {
    lines.reset();
    begun = newRun.start().isPresent();
    complete = begun;
    start = newRun.start();
  }

  private String kept(String line) {
    if (complete && lines.size() + line.length() > most) {
      forget();
    }
    if (complete) {
      lines.writeBytes(line.getBytes(StandardCharsets.US_ASCII));
    }
    return line;
  }

  private void forget() {
    complete = false;
    lines.reset();
  }

  /** Whether the initial conditions are known; for a real drone, they are not. */
  boolean begun() {
    return begun;
  }

  /** Whether the history contains every input. */
  boolean complete() {
    return complete;
  }

  /** The lines of all inputs until now; empty if some are missing. */
  String text() {
    String first = complete ? start.map(InputHistory::line).orElse("") : "";
    return first + lines.toString(StandardCharsets.US_ASCII);
  }
}
