package tellosimulator.grade;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import tellosimulator.scenario.Assignment;

/** The commands that build and start hand-ins. */
final class Commands {

  private static final String FILE = "{file}";

  /** How files are started if the assignment does not say it, by their ending. */
  private static final Map<String, String> BY_ENDING =
      Map.of(
          ".py", "python3 {file}",
          ".java", "java {file}",
          ".jar", "java -jar {file}",
          ".js", "node {file}");

  private Commands() {}

  /** Returns the command that starts a file; empty if none is known for its ending. */
  static Optional<List<String>> start(Assignment assignment, String file) {
    String ending = file.replaceFirst(".*(?=\\.)", "");
    return assignment
        .command()
        .or(() -> Optional.ofNullable(BY_ENDING.get(ending)))
        .map(command -> words(command, file));
  }

  /** Returns the command that builds a hand-in, if it has to be built. */
  static Optional<List<String>> build(Assignment assignment, String file) {
    return assignment.build().map(command -> words(command, file));
  }

  private static List<String> words(String command, String file) {
    return Stream.of(command.strip().split("\\s+", -1))
        .map(word -> word.replace(FILE, file))
        .toList();
  }
}
