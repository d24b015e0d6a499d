package tellosimulator.testing;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Starts Java processes for tests, which need the tag {@code process}. */
public final class Jvm {

  private static final Path HOME = Path.of(System.getProperty("java.home"));

  private Jvm() {}

  /** Returns the running {@code java}. */
  public static String java() {
    return java(HOME);
  }

  /** Returns the {@code java} of a JDK. */
  public static String java(Path home) {
    return home.resolve("bin").resolve("java").toString();
  }

  /**
   * Returns a command that runs a class of the tests or of the program, with this Java and class
   * path.
   */
  public static List<String> commandOf(Class<?> main, String... arguments) {
    List<String> command =
        new ArrayList<>(List.of(java(), "-cp", System.getProperty("java.class.path")));
    command.add(main.getName());
    command.addAll(List.of(arguments));
    return command;
  }

  /**
   * Returns a command that runs a class of the program with this Java. Libraries that only tests
   * need are left out, because their directories would take a tenth of a heap of 32 MB.
   */
  public static List<String> commandOfProgram(Class<?> main, String... arguments) {
    List<String> command = commandOf(main, arguments);
    command.set(2, System.getProperty("program.class-path", command.get(2)));
    return command;
  }

  /**
   * Returns a process builder for a command.
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
