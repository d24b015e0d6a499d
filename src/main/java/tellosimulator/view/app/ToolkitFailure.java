package tellosimulator.view.app;

import java.util.List;
import java.util.stream.Stream;

/**
 * The reasons why JavaFX cannot open a window, each with a message for users who expect a window.
 */
public enum ToolkitFailure {
  /**
   * There is no display. Measured with OpenJFX 21 on Linux, with {@code DISPLAY} unset and with a
   * wrong value.
   */
  NO_DISPLAY(
      "There is no display",
      "so the simulator runs without a window. With --headless it does so without this sentence.",
      ""),

  /**
   * Libraries of the system are missing. Measured with OpenJFX 21 on Debian 12 by hiding each
   * library in turn. Without GTK or its dependencies, the message is "Unable to load glass GTK
   * library". Without libX11 or libXtst, an {@link UnsatisfiedLinkError} is thrown. Without any
   * rendering pipeline, the message is "No toolkit found".
   */
  MISSING_LIBRARIES(
      "The window needs system libraries that are missing",
      "so the simulator runs without it.",
      " On Debian and Ubuntu: sudo apt install libgtk-3-0 libgl1 libgl1-mesa-dri libxtst6"
          + " libxxf86vm1; on Fedora: sudo dnf install gtk3 libglvnd-glx mesa-dri-drivers libXtst"
          + " libXxf86vm."),

  /**
   * There is no folder with space for the libraries that JavaFX unpacks before it opens a window;
   * see {@link NativeCache}.
   */
  NO_ROOM(
      "The window needs some megabytes for its libraries, but neither your home folder nor the folder"
          + " for temporary files has them or may be written to",
      "so the simulator runs without a window.",
      " Make room and start it again."),

  /**
   * The program was built on another kind of system. The jar contains only the native libraries of
   * that system.
   */
  OTHER_SYSTEM(
      "This program was built on another kind of computer",
      "so the simulator runs without a window.",
      " Build it again on this one: mvn -DskipTests package."),

  /** Any other reason. */
  UNKNOWN("The window cannot be opened", "so the simulator runs without it.", "");

  private static final List<String> DISPLAY_WORDS = List.of("DISPLAY", "display");
  private static final List<String> LIBRARY_WORDS =
      List.of("GTK", "no suitable pipeline", "No toolkit found", "java.library.path");

  private final String cause;
  private final String consequence;
  private final String remedy;

  /**
   * @param consequence the effect on a program that can also run without a window
   * @param remedy how to solve the problem; may be empty
   */
  ToolkitFailure(String cause, String consequence, String remedy) {
    this.cause = cause;
    this.consequence = consequence;
    this.remedy = remedy;
  }

  /**
   * Determines the reason from the toolkit's exception.
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

  /**
   * Returns the message for a program that runs without a window: one sentence, followed by the
   * remedy.
   */
  public String sentence() {
    return cause + ", " + consequence + remedy;
  }

  /**
   * Returns the message for a program that needs a window: one sentence, followed by the remedy.
   */
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
