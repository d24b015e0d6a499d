package tellosimulator.replay;

import java.nio.file.Path;
import java.util.List;
import tellosimulator.words.Phrase;

/**
 * The result of replaying a flight. Immutable.
 *
 * @param recording the folder of the new recording
 * @param exact whether all inputs were known, so that the recordings can be compared byte by byte
 * @param differences the first difference in each file; empty if both recordings are identical or
 *     cannot be compared
 * @param remarks a clause for each possible reason why the recordings differ
 */
public record Repetition(
    Path recording, boolean exact, List<Difference> differences, List<Phrase> remarks) {

  public Repetition {
    differences = List.copyOf(differences);
    remarks = List.copyOf(remarks);
  }

  /**
   * Whether both recordings are identical byte for byte, except for the data that depend on the
   * wall clock.
   */
  public boolean identical() {
    return exact && differences.isEmpty();
  }
}
