package tellosimulator.view.app;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Opens files in the system's browser. The methods may block, so they must not be called on the
 * JavaFX thread.
 */
final class SystemBrowser {

  private static final Logger LOG = LoggerFactory.getLogger(SystemBrowser.class);

  /**
   * The time after which a command that is still running counts as successful [s]. Decided: some
   * browsers keep the command running until they are closed.
   */
  private static final int PATIENCE_SECONDS = 3;

  private SystemBrowser() {}

  /**
   * Opens a file.
   *
   * @return whether this succeeded, as far as the system reports errors
   */
  static boolean open(Path file) {
    List<String> command = command(System.getProperty("os.name"), file);
    try {
      Process process =
          new ProcessBuilder(command)
              .redirectOutput(Redirect.DISCARD)
              .redirectError(Redirect.DISCARD)
              .start();
      boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
      return !ended || process.exitValue() == 0;
    } catch (IOException e) {
      LOG.debug("{} does not run: {}", command.get(0), e.toString());
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /**
   * Returns the command that opens a file. Documented: on Linux, xdg-utils of freedesktop.org; on
   * macOS, open(1); on Windows, the shell's handler for URLs.
   *
   * @param system the value of {@code os.name}
   */
  static List<String> command(String system, Path file) {
    String name = system.toLowerCase(Locale.ROOT);
    String address = file.toUri().toString();
    if (name.contains("windows")) {
      return List.of("rundll32", "url.dll,FileProtocolHandler", address);
    }
    return List.of(name.contains("mac") ? "open" : "xdg-open", address);
  }
}
