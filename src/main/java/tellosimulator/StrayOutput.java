package tellosimulator;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lines that libraries print to standard error instead of logging them: JavaFX prints pages of
 * stack traces about what a machine lacks, the JDK warnings about JavaFX. They go into the log,
 * level debug. Any thread may write.
 */
final class StrayOutput extends OutputStream {

  private static final Logger LOG = LoggerFactory.getLogger(StrayOutput.class);

  private final ByteArrayOutputStream line = new ByteArrayOutputStream();

  private StrayOutput() {}

  /** From now on, and after the log has been set up, which keeps the real standard error. */
  static void intoTheLog() {
    System.setErr(new PrintStream(new StrayOutput(), true, StandardCharsets.UTF_8));
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
