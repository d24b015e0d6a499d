package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.view.testing.ClosableProgram;
import tellosimulator.view.testing.NeedsDisplay;

/** Tests the program with its window, from start to end. */
@NeedsDisplay
@Tag("process")
class WindowProgramDisplayTest {

  @Test
  @Timeout(3 * ProgramProcess.PATIENCE_SECONDS)
  void closingTheWindowInFlightEndsEverythingCleanly() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(ClosableProgram.class, "--on --log-level warn", "")) {
      int port = program.port();
      assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");
      assertThat(ProgramProcess.ask("takeoff", port)).isEqualTo("ok");

      program.type("close");

      assertThat(program.exitCode()).isZero();
      assertThat(ProgramProcess.isFree(port)).isTrue();
      assertThat(program.errors()).isEmpty();
    }
  }

  @Test
  @Timeout(3 * ProgramProcess.PATIENCE_SECONDS)
  void aTerminationFreesThePort() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(ClosableProgram.class, "--on --log-level warn", "")) {
      int port = program.port();
      assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");

      program.terminate();

      assertThat(program.exitCode()).isEqualTo(143);
      assertThat(ProgramProcess.isFree(port)).isTrue();
      assertThat(program.errors()).isEmpty();
    }
  }

  /** A display that vanishes ends the process as abruptly as this. */
  @Test
  @Timeout(3 * ProgramProcess.PATIENCE_SECONDS)
  void anAbruptEndIsReported() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(ClosableProgram.class, "--on --log-level warn", "")) {
      assertThat(ProgramProcess.ask("command", program.port())).isEqualTo("ok");
      List<ProcessHandle> started = program.descendants().toList();

      program.kill();

      for (ProcessHandle shell : started) {
        shell.onExit().get();
      }
      assertThat(program.errors()).startsWith("The simulator ended unexpectedly: its display ");
    }
  }
}
