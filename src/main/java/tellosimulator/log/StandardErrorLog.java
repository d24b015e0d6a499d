package tellosimulator.log;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Redirects standard error to the log at level debug. Without it, JavaFX would fill standard error
 * with stack traces about features that the machine lacks, and the JDK would print warnings about
 * JavaFX. Thread-safe.
 */
public final class StandardErrorLog extends OutputStream {

  private static final Logger LOG = LoggerFactory.getLogger(StandardErrorLog.class);

  private final ByteArrayOutputStream line = new ByteArrayOutputStream();

  private StandardErrorLog() {}

  /**
   * Starts the redirection. The log must already have been set up, so that it uses the original
   * standard error.
   */
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
