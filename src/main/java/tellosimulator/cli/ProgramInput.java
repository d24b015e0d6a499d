package tellosimulator.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.Charset;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;

/**
 * The standard input of the program, and the registration of shutdown tasks. Not thread-safe.
 *
 * @param in the standard input
 * @param atEnd registers a task that runs on its own thread when the program is asked to end
 */
public record ProgramInput(InputStream in, Consumer<Runnable> atEnd) {

  /** Waits until {@code quit} is typed. If the input ends without it, waits forever. */
  void awaitQuit() throws InterruptedException {
    CountDownLatch quit = new CountDownLatch(1);
    BufferedReader typed = new BufferedReader(new InputStreamReader(in, Charset.defaultCharset()));
    Worker.start(
        "console",
        new Agent() {
          private final ErrorPolicy unreadable =
              ErrorPolicy.finish("Standard input cannot be read any more");

          @Override
          public Outcome doWork() throws IOException {
            String line = typed.readLine();
            if (line != null && line.strip().equals("quit")) {
              quit.countDown();
            }
            return line == null ? Outcome.FINISHED : Outcome.WORKED;
          }

          @Override
          public ErrorPolicy onError(Throwable failure) {
            return unreadable;
          }
        });
    quit.await();
  }
}
