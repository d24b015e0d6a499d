package tellosimulator.replay;

import java.nio.file.Path;
import java.util.List;
import tellosimulator.words.Phrase;

/**
 * What became of a flight that was flown again. Immutable; for any thread.
 *
 * @param recording the folder of the second recording
 * @param differences the first one of each file; none if both are identical
 * @param remarks why they may differ, in one clause each
 */
public record Repetition(Path recording, List<Difference> differences, List<Phrase> remarks) {

  public Repetition {
    differences = List.copyOf(differences);
    remarks = List.copyOf(remarks);
  }

  /** Whether both recordings are the same to the byte, but for what the wall clock decides. */
  public boolean identical() {
    return differences.isEmpty();
  }
}
