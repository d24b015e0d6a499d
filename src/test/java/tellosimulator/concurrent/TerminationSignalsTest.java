package tellosimulator.concurrent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Sends signals to its own process, where a signal that is not handled would end the tests. */
@NeedsTool(Tool.SH)
@Timeout(60)
class TerminationSignalsTest {

  @ParameterizedTest
  @CsvSource({"TERM, 15", "HUP, 1"})
  @SuppressWarnings("try") // the signal handler only needs to be open
  void eachSignalIsTakenAsOftenAsItComes(String name, int number) throws Exception {
    assumeFalse(exitCode("kill -s " + name + " $$") == 0, "ignored, as HUP is below nohup");
    BlockingQueue<Integer> taken = new LinkedBlockingQueue<>();

    try (TerminationSignals signals = TerminationSignals.take(taken::add)) {
      for (int i = 0; i < 2; i++) {
        assertThat(exitCode("kill -s " + name + " " + ProcessHandle.current().pid())).isZero();
        assertThat(taken.take()).isEqualTo(number);
      }
    }

    assertThat(taken).isEmpty();
  }

  private static int exitCode(String command) throws IOException, InterruptedException {
    return Tool.SH.command("-c", command).start().waitFor();
  }
}
