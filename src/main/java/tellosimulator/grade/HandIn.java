package tellosimulator.grade;

import java.nio.file.Path;
import java.util.Optional;
import tellosimulator.words.Phrase;

/**
 * What a student handed in. Immutable.
 *
 * @param name the name of the student, or of the file
 * @param id the number of the student; may be empty
 * @param group may be empty
 * @param folder the name of its folders in the results; unique
 * @param original the name of what was handed in: a file, or a folder such as Moodle's; empty if
 *     nothing was
 * @param files the folder with its files; a copy
 * @param file the file to start, relative to {@code files}; empty if there is none
 * @param problem why it was not accepted, as a sentence; empty if it was, or there is none
 */
public record HandIn(
    String name,
    String id,
    String group,
    String folder,
    String original,
    Path files,
    String file,
    Optional<Phrase> problem) {

  /** Returns why there is no file to start, in the words of {@link GradedFlight#program}. */
  public String obstacle() {
    if (original.isEmpty()) {
      return "nothing handed in";
    }
    return problem.isPresent() ? "not accepted" : "no entry file";
  }
}
