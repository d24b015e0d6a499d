package tellosimulator.launcher;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.launcher.ProgramRun.NetworkChoice;
import tellosimulator.launcher.ProgramRun.Plan;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Uses plain scripts as simulator and program. */
@NeedsTool({Tool.NAMESPACES, Tool.SH, Tool.MKFIFO})
@Timeout(120)
class ProgramRunTest {

  /** Reports that it is ready, and waits for input; the address options become {@code $@}. */
  private static final List<String> SIMULATOR =
      List.of("sh", "-c", "echo ready; read typed; exit 3", "simulator");

  /** A unique number of seconds that identifies the processes of this test. */
  private static final String NAP = "1" + System.nanoTime();

  @TempDir private Path folder;

  private final ByteArrayOutputStream printed = new ByteArrayOutputStream();

  @Test
  void aProgramThatIgnoresSignalsIsEnded() throws Exception {
    Path told = pipe();
    String stubborn = "trap '' TERM INT; echo ready > " + told + "; exec sleep " + NAP;
    ProgramRun run = new ProgramRun(plan(SIMULATOR, stubborn), out());
    CompletableFuture<?> ended = CompletableFuture.runAsync(() -> flyOrAbort(run));

    Files.readString(told);
    run.close();
    ended.handle((result, failure) -> failure).get(60, TimeUnit.SECONDS);

    assertNothingIsLeft();
  }

  @Test
  void aRunThatIsClosedBeforeItsSimulatorStartsEndsAtOnce() throws Exception {
    ProgramRun run = new ProgramRun(plan(SIMULATOR, "exec sleep " + NAP), out());

    run.close();
    CompletableFuture.runAsync(() -> flyOrAbort(run)).get(60, TimeUnit.SECONDS);

    assertNothingIsLeft();
  }

  /** A process does not survive by starting its own session or ignoring signals. */
  @Test
  void whatTheProgramLeavesBehindIsEndedWithIt() throws Exception {
    String forking =
        "(setsid sh -c \"trap '' TERM INT HUP; sleep " + NAP + "; :\" &); sleep " + NAP + " &";

    assertThat(new ProgramRun(plan(SIMULATOR, forking), out()).run()).isPresent();

    assertNothingIsLeft();
  }

  @Test
  void theSimulatorEndsWithTheProgram() throws Exception {
    assertThat(new ProgramRun(plan(SIMULATOR, "exit 5"), out()).run())
        .contains(new ProgramRun.ExitCodes(OptionalInt.of(5), 3));
    assertThat(printed()).isEqualTo("ready\nprogram: exit code 5\n");
  }

  @Test
  void aProgramThatGoesOnEndsWithTheSimulator() throws Exception {
    List<String> verdict = List.of("sh", "-c", "echo ready; echo verdict; exit 3", "simulator");

    assertThat(new ProgramRun(plan(verdict, "exec sleep " + NAP), out()).run())
        .contains(new ProgramRun.ExitCodes(OptionalInt.empty(), 3));
    assertThat(printed().lines())
        .containsExactlyInAnyOrder("ready", "verdict", "program: ended by run");
    assertNothingIsLeft();
  }

  /** As with Ctrl-C, the program cleans up while the simulator is still running. */
  @Test
  void anInterruptedProgramMayCleanUp() throws Exception {
    Path told = pipe();
    String careful =
        "trap 'test -d /proc/1 && exit 9' INT; echo ready > " + told + "; read forever < " + told;
    ProgramRun run = new ProgramRun(plan(SIMULATOR, careful), out());
    CompletableFuture<?> ended = CompletableFuture.runAsync(() -> flyOrAbort(run));

    Files.readString(told);
    run.interrupt();
    ended.get(60, TimeUnit.SECONDS);

    assertThat(printed()).isEqualTo("ready\nprogram: exit code 9\n");
  }

  @Test
  void theSecondInterruptEndsBothAtOnce() throws Exception {
    Path told = pipe();
    String deaf = "trap '' TERM INT; echo ready > " + told + "; exec sleep " + NAP;
    ProgramRun run = new ProgramRun(plan(SIMULATOR, deaf), out());
    CompletableFuture<?> ended = CompletableFuture.runAsync(() -> flyOrAbort(run));
    Files.readString(told);
    CompletableFuture<?> first = CompletableFuture.runAsync(() -> interruptOrAbort(run));

    while (!run.interrupted()) {
      Thread.onSpinWait();
    }
    run.interrupt();

    CompletableFuture.allOf(ended, first).get(10, TimeUnit.SECONDS);
    assertThat(printed()).isEqualTo("ready\nprogram: ended by run\n");
    assertNothingIsLeft();
  }

  @Test
  void aProgramWithAShimIsOutOfReachOfTheTerminalAndIsInterruptedOnce() throws Exception {
    Path told = pipe();
    String careful =
        "trap 'test $(ps -o sid= -p $$) -eq $$ && exit 9' INT; echo ready > "
            + told
            + "; read forever < "
            + told;
    List<String> simulator =
        List.of(
            "sh", "-c", "echo 'ready: drone 1 at 127.0.0.1:8879'; read typed; exit 3", "simulator");
    Plan plan =
        new Plan(
            simulator,
            List.of("sh", "-c", careful),
            1,
            NetworkChoice.SHIM,
            false,
            Optional.empty(),
            Optional.empty());
    ProgramRun run = new ProgramRun(plan, out());
    CompletableFuture<?> ended = CompletableFuture.runAsync(() -> flyOrAbort(run));

    Files.readString(told);
    run.interrupt();
    ended.get(60, TimeUnit.SECONDS);

    assertThat(printed()).endsWith("program: exit code 9\n");
  }

  @Test
  void whatTheProgramPrintsGoesToItsFile() throws Exception {
    Path file = folder.resolve("program.log");
    Plan plan =
        new Plan(
            SIMULATOR,
            List.of("sh", "-c", "echo goals; echo sighs >&2"),
            1,
            NetworkChoice.PRIVATE,
            false,
            Optional.of(file),
            Optional.empty());

    assertThat(new ProgramRun(plan, out()).run()).isPresent();

    assertThat(printed()).as(Files.readString(file)).isEqualTo("ready\nprogram: exit code 0\n");
    assertThat(file).hasContent("goals\nsighs");
  }

  private static Plan plan(List<String> simulator, String script) {
    return new Plan(
        simulator,
        List.of("sh", "-c", script),
        1,
        NetworkChoice.PRIVATE,
        false,
        Optional.empty(),
        Optional.empty());
  }

  /** Waits, because the kernel takes a moment to remove killed processes. */
  private static void assertNothingIsLeft() {
    while (ProcessHandle.allProcesses().anyMatch(ProgramRunTest::naps)) {
      Thread.onSpinWait();
    }
  }

  private static boolean naps(ProcessHandle process) {
    return List.of(process.info().arguments().orElse(new String[0])).contains(NAP);
  }

  /**
   * Creates a pipe through which the program reports that it runs, however long its start takes.
   */
  private Path pipe() throws IOException, InterruptedException {
    Path pipe = folder.resolve("pipe");
    assertThat(Tool.MKFIFO.command(pipe.toString()).start().waitFor()).isZero();
    return pipe;
  }

  private String printed() {
    return printed.toString(StandardCharsets.UTF_8);
  }

  private static void interruptOrAbort(ProgramRun run) {
    try {
      run.interrupt();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
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

  private PrintStream out() {
    return new PrintStream(printed, true, StandardCharsets.UTF_8);
  }
}
