package tellosimulator.testing;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/**
 * A headless browser in a separate process for each page, for tests that need {@link
 * Tool#CHROMIUM}.
 */
public final class Chromium {

  private static final long MOST_SECONDS = 120;

  private Chromium() {}

  /**
   * Returns the markup of a page after its scripts have run.
   *
   * @param page a file
   * @param anchor the fragment after its name: {@code #t=3}
   * @param work a folder for the browser's own files
   */
  public static String dom(Path page, String anchor, Path work) {
    try {
      Path out = Files.createTempFile(work, "dom", ".html");
      Process process =
          Tool.CHROMIUM
              .command(
                  "--headless=new",
                  "--no-sandbox",
                  "--disable-gpu",
                  "--user-data-dir=" + Files.createTempDirectory(work, "profile"),
                  "--dump-dom",
                  page.toUri() + anchor)
              .redirectOutput(out.toFile())
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      if (!process.waitFor(MOST_SECONDS, TimeUnit.SECONDS)) {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        throw new AssertionError("the browser did not end within " + MOST_SECONDS + " s");
      }
      return Files.readString(out, StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }
}
