package tellosimulator.view.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxToolkit;
import org.testfx.util.WaitForAsyncUtils;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.testing.CapturedLog;
import tellosimulator.view.text.Language;

/** Loading of recordings, whose reading is completed by the test. */
class GhostLoaderFxTest {

  private static final Path SLOW = Path.of("slow");
  private static final Path FAST = Path.of("fast");

  private final Map<Path, BlockingQueue<Supplier<ReplayFlight>>> results =
      Map.of(SLOW, new LinkedBlockingQueue<>(), FAST, new LinkedBlockingQueue<>());
  private final Map<Path, Thread> readers = new ConcurrentHashMap<>();
  @TempDir private Path folder;
  private ReplayFlight flight;
  private FxReplay replay;
  private GhostLoader ghosts;

  @BeforeEach
  void prepare() throws Exception {
    FxToolkit.registerPrimaryStage();
    flight = ReplayFlight.read(RecordingFixture.in(folder.resolve("flight")));
    onFxThread(
        () -> {
          replay = new FxReplay(flight);
          ghosts = new GhostLoader(replay, new Language(Locale.ENGLISH), () -> {}, this::read);
          return ghosts;
        });
  }

  private ReplayFlight read(Path wanted) throws UnreadableRecordingException {
    readers.put(wanted, Thread.currentThread());
    try {
      return results.get(wanted).poll(60, TimeUnit.SECONDS).get();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void ofTwoChoicesTheLaterOneIsShownThoughItIsReadSooner() throws InterruptedException {
    run(() -> ghosts.read(SLOW));
    run(() -> ghosts.read(FAST));
    finish(FAST, () -> named("fast"));
    finish(SLOW, () -> named("slow"));

    assertThat(ghost()).contains("fast");
    assertThat(news()).isEmpty();
  }

  @Test
  void aGhostThatIsTakenAwayDoesNotComeBackWhenItIsRead() throws InterruptedException {
    run(() -> ghosts.read(SLOW));
    run(ghosts::remove);
    finish(SLOW, () -> named("slow"));

    assertThat(ghost()).isEmpty();
    assertThat(news()).isEmpty();
  }

  @Test
  void theSameCommandsFlownAgainAreAGhost() throws IOException {
    Files.delete(flight.folder().resolve("events.jsonl"));
    Files.writeString(
        flight.folder().resolve("wire.jsonl"),
        """
        {"t":4,"drone":1,"kind":"command","from":"127.0.0.1:9001","to":"127.0.0.1:8889","text":"takeoff"}
        {"t":8,"drone":1,"kind":"command","from":"127.0.0.1:9001","to":"127.0.0.1:8889","text":"cw 90"}
        """);
    run(ghosts::flyAgain);

    waitUntil(() -> replay.ghostProperty().get().isPresent());
    assertThat(ghost()).contains("flight, flown again");
    assertThat(onFxThread(() -> replay.ghostProperty().get().orElseThrow().flight().commands()))
        .extracting(RecordedCommand::text)
        .containsExactly("command", "takeoff", "cw 90");
    assertThat(news()).isEmpty();
  }

  @Test
  void whatCannotBeFlownAgainIsASentence() throws IOException {
    Files.delete(flight.folder().resolve("events.jsonl"));
    run(ghosts::flyAgain);

    waitUntil(() -> news().contains("not flown again"));
    assertThat(news())
        .isEqualTo("The flight of " + flight.folder() + " was not flown again: no drone took off.");
  }

  @Test
  void aFailureThatNobodyExpectedIsToldAndLeavesTheGhost() throws InterruptedException {
    run(() -> ghosts.show(named("before")));
    try (CapturedLog log = CapturedLog.of(ErrorPolicy.class)) {
      run(() -> ghosts.read(FAST));
      assertThat(news()).isEqualTo("The recording is being read.");
      finish(
          FAST,
          () -> {
            throw new IllegalStateException("broken on purpose");
          });

      waitUntil(() -> news().startsWith("The recording fast could not be read"));
      assertThat(log.next()).startsWith("A recording could not be read; please report this");
    }
    assertThat(ghost()).contains("before");
  }

  @Test
  void aFailureThatComesTooLateSaysNothing() throws InterruptedException {
    try (CapturedLog log = CapturedLog.of(ErrorPolicy.class)) {
      run(() -> ghosts.read(SLOW));
      run(ghosts::remove);
      finish(
          SLOW,
          () -> {
            throw new IllegalStateException("broken on purpose");
          });

      assertThat(log.next()).startsWith("A recording could not be read; please report this");
      assertThat(news()).isEmpty();
    }
  }

  private ReplayFlight named(String name) {
    return new ReplayFlight(name, folder, flight.flight(), flight.snapshots());
  }

  private static void run(Runnable what) {
    WaitForAsyncUtils.waitForAsyncFx(60_000, what);
  }

  /** Completes a reading, and waits until the window has received the result. */
  private void finish(Path wanted, Supplier<ReplayFlight> result) throws InterruptedException {
    results.get(wanted).add(result);
    waitUntil(() -> readers.containsKey(wanted));
    readers.get(wanted).join(60_000);
    run(() -> {});
  }

  private Optional<String> ghost() {
    return onFxThread(() -> replay.ghostProperty().get().map(ReplayFlight::name));
  }

  private String news() {
    return onFxThread(() -> replay.newsProperty().get());
  }
}
