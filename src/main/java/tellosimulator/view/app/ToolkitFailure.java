package tellosimulator.view.app;

import java.util.List;
import java.util.stream.Stream;

/** Why JavaFX cannot open a window, each with what to say to somebody who expects one. */
public enum ToolkitFailure {
  /** Measured: OpenJFX 21 on Linux, without and with a wrong {@code DISPLAY}. */
  NO_DISPLAY(
      "There is no display",
      "so the simulator runs without a window. With --headless it does so without this sentence.",
      ""),

  /**
   * Measured: OpenJFX 21 on Debian 12, each library hidden in turn. Without GTK or what it stands
   * on, "Unable to load glass GTK library"; without libX11 or libXtst, an {@link
   * UnsatisfiedLinkError}; without any pipeline, "No toolkit found".
   */
  MISSING_LIBRARIES(
      "The window needs system libraries that are missing",
      "so the simulator runs without it.",
      " On Debian and Ubuntu: sudo apt install libgtk-3-0 libgl1 libgl1-mesa-dri libxtst6"
          + " libxxf86vm1; on Fedora: sudo dnf install gtk3 libglvnd-glx mesa-dri-drivers libXtst"
          + " libXxf86vm."),

  /** JavaFX unpacks libraries before it opens a window; see {@link NativeCache}. */
  NO_ROOM(
      "The window needs some megabytes for its libraries, but neither your home folder nor the folder"
          + " for temporary files has them or may be written to",
      "so the simulator runs without a window.",
      " Make room and start it again."),

  /** The jar holds the native libraries of the system on which it was built, and no others. */
  OTHER_SYSTEM(
      "This program was built on another kind of computer",
      "so the simulator runs without a window.",
      " Build it anew on this one: mvn -DskipTests package."),

  /** Something that nobody has seen yet. */
  UNKNOWN("The window cannot be opened", "so the simulator runs without it.", "");

  private static final List<String> DISPLAY_WORDS = List.of("DISPLAY", "display");
  private static final List<String> LIBRARY_WORDS =
      List.of("GTK", "no suitable pipeline", "No toolkit found", "java.library.path");

  private final String cause;
  private final String consequence;
  private final String remedy;

  /**
   * @param consequence of a simulator that could have a window
   * @param remedy what helps; may be empty
   */
  ToolkitFailure(String cause, String consequence, String remedy) {
    this.cause = cause;
    this.consequence = consequence;
    this.remedy = remedy;
  }

  /**
   * Judges by what the toolkit threw.
   *
   * @param nativesAreThere whether the class path has JavaFX's libraries for this system
   */
  static ToolkitFailure because(Throwable failure, boolean nativesAreThere) {
    if (!nativesAreThere) {
      return OTHER_SYSTEM;
    }
    if (chain(failure).anyMatch(cause -> says(cause, DISPLAY_WORDS))) {
      return NO_DISPLAY;
    }
    return chain(failure)
            .anyMatch(cause -> cause instanceof UnsatisfiedLinkError || says(cause, LIBRARY_WORDS))
        ? MISSING_LIBRARIES
        : UNKNOWN;
  }

  /** What to say when the simulator runs all the same: one sentence, and what helps. */
  public String sentence() {
    return cause + ", " + consequence + remedy;
  }

  /** What to say of something that needs a window: one sentence, and what helps. */
  public String cause() {
    return cause + "." + remedy;
  }

  private static Stream<Throwable> chain(Throwable failure) {
    return Stream.iterate(failure, cause -> cause != null, Throwable::getCause);
  }

  private static boolean says(Throwable cause, List<String> words) {
    String message = String.valueOf(cause.getMessage());
    return words.stream().anyMatch(message::contains);
  }
}
