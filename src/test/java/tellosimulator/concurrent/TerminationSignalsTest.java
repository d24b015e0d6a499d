package tellosimulator.concurrent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Signals itself: a signal that is not taken ends the tests. */
@NeedsTool(Tool.SH)
@Timeout(60)
class TerminationSignalsTest {

  @Test
  @SuppressWarnings("try") // the signals come by themselves
  void eachSignalIsTakenAsOftenAsItComes() throws Exception {
    BlockingQueue<Integer> taken = new LinkedBlockingQueue<>();
    try (TerminationSignals signals = TerminationSignals.take(taken::add)) {
      for (String name : new String[] {"TERM", "TERM", "HUP"}) {
        signal(name);
        assertThat(taken.take()).isEqualTo(name.equals("HUP") ? 1 : 15);
      }
    }
    assertThat(taken).isEmpty();
  }

  private static void signal(String name) throws IOException, InterruptedException {
    String self = Long.toString(ProcessHandle.current().pid());
    assertThat(Tool.SH.command("-c", "kill -s " + name + " " + self).start().waitFor()).isZero();
  }
}
