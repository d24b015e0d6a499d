package tellosimulator.cli;

import java.io.PrintStream;
import tellosimulator.words.Printable;

/**
 * Prints text without the control characters in it, as {@link Printable} has it: what is printed
 * may repeat names, files and datagrams from outside. For any thread.
 */
public final class EscapingPrintStream extends PrintStream {

  private final PrintStream to;

  /** Prints to a stream, and flushes when that does. */
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
