package tellosimulator.log;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Redirects standard error to the log, level debug: JavaFX prints pages of stack traces there about
 * what a machine lacks, and the JDK warnings about JavaFX. Any thread may write.
 */
public final class StandardErrorLog extends OutputStream {

  private static final Logger LOG = LoggerFactory.getLogger(StandardErrorLog.class);

  private final ByteArrayOutputStream line = new ByteArrayOutputStream();

  private StandardErrorLog() {}

  /** Redirects it from now on. The log must have been set up: it keeps the real standard error. */
  public static void install() {
    System.setErr(new PrintStream(new StandardErrorLog(), true, StandardCharsets.UTF_8));
  }

  @Override
  public synchronized void write(int letter) {
    if (letter == '\n') {
      String text = line.toString(StandardCharsets.UTF_8).strip();
      line.reset();
      LOG.debug("{}", text);
    } else {
      line.write(letter);
    }
  }
}
