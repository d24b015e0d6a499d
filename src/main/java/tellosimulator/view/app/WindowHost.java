package tellosimulator.view.app;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import javafx.application.Platform;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.web.ScenarioHost;
import tellosimulator.web.WebSubject;

/** The window's scenarios, as the teacher's board sees them. Thread-safe. */
final class WindowHost implements ScenarioHost {

  private final Supplier<ScenarioSession> running;
  private final BiConsumer<OpenedScenario, OptionalLong> opener;
  private ScenarioSession known;
  private WebSubject subject;

  /**
   * @param running returns the present session, on any thread
   * @param opener opens a scenario with a seed, on the JavaFX thread
   */
  WindowHost(Supplier<ScenarioSession> running, BiConsumer<OpenedScenario, OptionalLong> opener) {
    this.running = running;
    this.opener = opener;
  }

  @Override
  public synchronized WebSubject current() {
    ScenarioSession now = running.get();
    if (now != known) {
      subject = now.webSubject(subject == null ? 1 : subject.number() + 1);
      known = now;
    }
    return subject;
  }

  @Override
  public Optional<RecordingFolder> recordings() {
    return Optional.empty(); // the window shows reports itself
  }

  @Override
  public void open(OpenedScenario chosen, OptionalLong seed) {
    Platform.runLater(() -> opener.accept(chosen, seed));
  }
}
