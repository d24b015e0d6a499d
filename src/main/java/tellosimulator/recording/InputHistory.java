package tellosimulator.recording;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/**
 * All inputs of a simulation since it began, so that each of its flights can be flown again: where
 * a drone is, and how full its battery, follows from all that came before. For one thread at a
 * time.
 */
final class InputHistory {

  /**
   * What is kept between flights [bytes]. Decided: more than an hour of sticks that are set 20
   * times a second, and nothing that a machine feels.
   */
  private static final int MOST = 8 << 20;

  /** Part of the heap that may be used for it, as long as that is less. */
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
   * @param most what is kept [bytes]
   */
  InputHistory(long most) {
    this.most = most;
  }

  /** Takes the next entry, and returns its line, if it is an input. */
  Optional<String> take(Entry entry) {
    if (entry instanceof Entry.Anew anew) {
      begin(anew);
    } else if (entry instanceof Entry.Asked asked) {
      start = start.map(from -> from.withChallenge(asked.challenge()));
    } else if (entry instanceof Entry.Overrun || entry instanceof Entry.Missed) {
      forget();
    } else if (begun && entry instanceof Entry.Received received) {
      return Optional.of(kept(InputLines.text(received)));
    } else if (begun && entry instanceof Entry.Taken taken) {
      return Optional.of(kept(InputLines.text(taken)));
    }
    return Optional.empty();
  }

  private void begin(Entry.Anew anew) {
    lines.reset();
    begun = anew.start().isPresent();
    complete = begun;
    start = anew.start();
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

  /** Whether there are inputs that can be told, unlike those of a real drone. */
  boolean begun() {
    return begun;
  }

  /** Whether nothing is missing. */
  boolean complete() {
    return complete;
  }

  /** The lines of all inputs until now; none if some are missing. */
  String text() {
    String first = complete ? start.map(InputLines::text).orElse("") : "";
    return first + lines.toString(StandardCharsets.US_ASCII);
  }
}
