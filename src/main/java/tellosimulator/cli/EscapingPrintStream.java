package tellosimulator.cli;

import java.io.PrintStream;
import tellosimulator.words.Printable;

/**
 * Prints text with control characters replaced by {@link Printable}, because the text may contain
 * file names, file contents or datagrams from untrusted sources. Thread-safe.
 */
public final class EscapingPrintStream extends PrintStream {

  private final PrintStream to;

  /**
   * Creates a stream that prints to another one. The other stream determines when the output is
   * flushed.
   */
  public EscapingPrintStream(PrintStream to) {
    super(to);
    this.to = to;
  }

  @Override
  public void print(String text) {
    to.print(Printable.of(String.valueOf(text)));
  }

  @Override
  public void println(String text) {
    to.println(Printable.of(String.valueOf(text)));
  }
}
