package tellosimulator.concurrent;

import java.io.IOException;
import java.io.OutputStream;
import java.lang.ProcessBuilder.Redirect;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reports that the process ended without running any more code: it was killed, or a native library
 * called {@code exit}, as the X client library does when its display vanishes. This class starts a
 * shell that waits for the end of its input and then prints a message. The operating system closes
 * that input no matter how the process ends.
 */
public final class LastWords {

  private static final Logger LOG = LoggerFactory.getLogger(LastWords.class);

  /**
   * The script that the shell runs. At the end of its input, it prints its argument, unless it has
   * read a line. This process sends a line when it exits normally.
   */
  private static final String SCRIPT = "trap '' INT HUP TERM; read line || echo \"$1\" >&2";

  private LastWords() {}

  /**
   * Starts the shell; does nothing on systems without one.
   *
   * @param sentence printed to standard error if the process ends abruptly
   */
  public static void prepare(String sentence) {
    OutputStream input;
    try {
      input =
          new ProcessBuilder("sh", "-c", SCRIPT, "sh", sentence)
              .redirectOutput(Redirect.DISCARD)
              .redirectError(Redirect.INHERIT)
              .start()
              .getOutputStream();
    } catch (IOException e) {
      LOG.debug("An abrupt end will not be reported: {}", e.toString());
      return;
    }
    try {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> dismiss(input), "last-words"));
    } catch (IllegalStateException e) { // the process is already ending
      dismiss(input);
    }
  }

  private static void dismiss(OutputStream input) {
    try (input) {
      input.write('\n');
    } catch (IOException e) {
      LOG.debug("The shell has ended already: {}", e.toString());
    }
  }
}
