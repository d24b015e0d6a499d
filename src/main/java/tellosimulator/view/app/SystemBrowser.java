package tellosimulator.view.app;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Opens files in the browser of the system. For any thread but JavaFX's, as it waits. */
final class SystemBrowser {

  private static final Logger LOG = LoggerFactory.getLogger(SystemBrowser.class);

  /**
   * How long it may take to fail [s]. Decided: a program that still runs by then has opened the
   * file; some stay until the browser is closed.
   */
  private static final int PATIENCE_SECONDS = 3;

  private SystemBrowser() {}

  /**
   * Opens a file.
   *
   * @return whether that worked, as far as the system tells
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
   * What opens a file. Documented: freedesktop.org xdg-utils; macOS, open(1); Windows, the handler
   * that its shell uses for addresses.
   *
   * @param system as {@code os.name} has it
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
