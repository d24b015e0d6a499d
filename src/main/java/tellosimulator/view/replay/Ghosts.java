package tellosimulator.view.replay;

import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import javafx.application.Platform;
import javafx.stage.DirectoryChooser;
import javafx.stage.Window;
import tellosimulator.concurrent.Verdict;
import tellosimulator.concurrent.Worker;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Where a ghost comes from: another recording, read by a thread of its own. For the JavaFX thread.
 */
final class Ghosts {

  private static final Verdict FAILED = Verdict.finish("A recording could not be read");

  private final FxReplay replay;
  private final Messages messages;
  private final Runnable changed;

  /**
   * @param changed is told when there is something new to show
   */
  Ghosts(FxReplay replay, Language language, Runnable changed) {
    this.replay = replay;
    this.changed = changed;
    messages = language.messages(Ghosts.class);
  }

  /** Lets somebody choose the folder of a recording. */
  void choose(Window owner) {
    DirectoryChooser chooser = new DirectoryChooser();
    chooser.setTitle(messages.now("choose-recording"));
    File chosen = chooser.showDialog(owner);
    if (chosen != null) {
      read(chosen.toPath());
    }
  }

  /** Shows a recording as the ghost, as soon as it is read. */
  void read(Path folder) {
    tell(messages.now("reading"));
    Worker.once("replay-reader", FAILED, () -> load(folder));
  }

  /** On the thread that reads. */
  private void load(Path folder) {
    try {
      ReplayFlight other = ReplayFlight.read(folder);
      Platform.runLater(() -> show(other));
    } catch (UnreadableRecordingException e) {
      Platform.runLater(() -> tell(e.getMessage()));
    }
  }

  /** Shows another flight as the ghost. */
  void show(ReplayFlight other) {
    ReplayFlight painted =
        new ReplayFlight(
            other.name(), other.flight(), other.snapshots().withColor(FxReplay.GHOST_RGB));
    replay.ghostProperty().set(Optional.of(painted));
    tell("");
  }

  /** Shows no ghost any more. */
  void remove() {
    replay.ghostProperty().set(Optional.empty());
    tell("");
  }

  private void tell(String sentence) {
    replay.newsProperty().set(sentence);
    changed.run();
  }
}
