package tellosimulator.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.operator.ProgramRun.Ends;
import tellosimulator.operator.ProgramRun.Plan;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Simulator and program are plain scripts here. */
@NeedsTool({Tool.NAMESPACES, Tool.SH, Tool.MKFIFO})
@Timeout(120)
class ProgramRunTest {

  /**
   * Says that it is ready, and waits for what is typed; its words of addresses go to {@code $@}.
   */
  private static final List<String> SIMULATOR =
      List.of("sh", "-c", "echo ready; read typed; exit 3", "simulator");

  @TempDir private Path folder;

  @Test
  void aProgramThatIgnoresSignalsIsEnded() throws Exception {
    Path told = pipe();
    List<String> stubborn =
        List.of("sh", "-c", "trap '' TERM INT; echo $$ > " + told + "; exec tail -f /dev/null");
    ProgramRun run = new ProgramRun(new Plan(SIMULATOR, stubborn, 1, Ends.AT_ONCE), silent());
    CompletableFuture<?> ended = CompletableFuture.runAsync(() -> flyOrAbort(run));

    ProcessHandle program = ProcessHandle.of(pid(told)).orElseThrow();
    run.close();
    program.onExit().get(60, TimeUnit.SECONDS);
    ended.handle((result, failure) -> failure).get(60, TimeUnit.SECONDS);

    assertThat(program.isAlive()).isFalse();
  }

  @Test
  void theSimulatorEndsWithTheProgram() throws Exception {
    ProgramRun run =
        new ProgramRun(
            new Plan(SIMULATOR, List.of("sh", "-c", "exit 5"), 1, Ends.AT_ONCE), silent());

    assertThat(run.run()).contains(new ProgramRun.ExitCodes(5, 3));
  }

  /** As where the program asked for nothing: the goals are neither reached nor missed. */
  @Test
  void aVerdictThatDoesNotComeIsAskedFor() throws Exception {
    Plan plan = new Plan(SIMULATOR, List.of("sh", "-c", "exit 9"), 1, Ends.WITH_VERDICT);

    assertThat(new ProgramRun(plan, silent(), 1).run()).contains(new ProgramRun.ExitCodes(9, 3));
  }

  /** Through which the program says that it runs, however long that takes. */
  private Path pipe() throws IOException, InterruptedException {
    Path pipe = folder.resolve("pid");
    assertThat(Tool.MKFIFO.command(pipe.toString()).start().waitFor()).isZero();
    return pipe;
  }

  private static long pid(Path pipe) throws IOException {
    try (BufferedReader lines = Files.newBufferedReader(pipe)) {
      return Long.parseLong(lines.readLine().trim());
    }
  }

  private static void flyOrAbort(ProgramRun run) {
    try {
      run.run();
    } catch (UnavailableException | IOException e) {
      throw new IllegalStateException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static PrintStream silent() {
    return new PrintStream(OutputStream.nullOutputStream());
  }
}
