package tellosimulator.testing;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Java processes for tests, which need the tag {@code process}. */
public final class Jvm {

  private static final Path HOME = Path.of(System.getProperty("java.home"));

  private Jvm() {}

  /** The {@code java} that runs this. */
  public static String java() {
    return java(HOME);
  }

  /** The {@code java} of a JDK. */
  public static String java(Path home) {
    return home.resolve("bin").resolve("java").toString();
  }

  /** Runs a class of the tests or of the program, on this Java and with this class path. */
  public static List<String> commandOf(Class<?> main, String... arguments) {
    List<String> command =
        new ArrayList<>(List.of(java(), "-cp", System.getProperty("java.class.path")));
    command.add(main.getName());
    command.addAll(List.of(arguments));
    return command;
  }

  /**
   * A process that is ready to be started.
   *
   * @param command whose first word is a {@code java}
   * @throws AssertionError if the running test is not tagged with {@code process}
   */
  public static ProcessBuilder process(List<String> command) {
    if (!RunningTest.isTagged("process")) {
      throw new AssertionError("a test starts a process without @Tag(\"process\")");
    }
    if (!Path.of(command.get(0)).endsWith(Path.of("bin", "java"))) {
      throw new AssertionError(command.get(0) + " is no java; see Tool");
    }
    return new ProcessBuilder(command);
  }
}
