package tellosimulator.view.replay;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import javafx.application.Platform;
import javafx.stage.DirectoryChooser;
import javafx.stage.Window;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Loads a ghost on a separate thread: from another recording, or by flying the same commands again.
 * Only the latest request takes effect, even if an earlier one finishes later. Confined to the
 * JavaFX thread.
 */
final class GhostLoader {

  private static final ErrorPolicy FAILED = ErrorPolicy.finish("A recording could not be read");

  /** Reads the recording in a folder. Must be thread-safe. */
  @FunctionalInterface
  interface Reader {
    ReplayFlight read(Path folder) throws UnreadableRecordingException;
  }

  /** Provides a ghost. Called on the loading thread. */
  @FunctionalInterface
  private interface Source {
    ReplayFlight get() throws UnreadableRecordingException, IOException;
  }

  private final FxReplay replay;
  private final Language language;
  private final Messages messages;
  private final Runnable changed;
  private final Reader reader;

  /** Number of requests so far. Results of superseded requests are discarded. */
  private int requests;

  /**
   * Creates a loader.
   *
   * @param changed called when the ghost or the news has changed
   * @param reader reads recordings
   */
  GhostLoader(FxReplay replay, Language language, Runnable changed, Reader reader) {
    this.replay = replay;
    this.language = language;
    this.changed = changed;
    this.reader = reader;
    messages = language.messages(GhostLoader.class);
  }

  /** Opens a dialog for choosing the folder of a recording, and loads the recording. */
  void choose(Window owner) {
    DirectoryChooser chooser = new DirectoryChooser();
    chooser.setTitle(messages.now("choose-recording"));
    File chosen = chooser.showDialog(owner);
    if (chosen != null) {
      read(chosen.toPath());
    }
  }

  /** Reads a recording and then shows it as the ghost. */
  void read(Path folder) {
    tell(messages.now("reading"));
    load(folder, () -> reader.read(folder));
  }

  /** Flies the commands of the flight again, and shows the result as the ghost. */
  void flyAgain() {
    ReplayFlight flight = replay.flight();
    String name = messages.now("flown-again", flight.name());
    tell(messages.now("flying-again"));
    load(flight.folder(), () -> ReplayFlight.flyAgain(flight.folder(), name));
  }

  private void load(Path folder, Source source) {
    requests++;
    int mine = requests;
    Worker.once("replay-reader", FAILED, () -> load(folder, source, mine));
  }

  /** Loads a flight. Called on the loading thread. */
  private void load(Path folder, Source source, int mine) {
    try {
      ReplayFlight other = source.get();
      answer(mine, () -> show(other));
    } catch (UnreadableRecordingException e) {
      answer(mine, () -> tell(e.getMessage()));
    } catch (IOException e) {
      answer(mine, () -> tell(messages.now("not-flown", folder, language.reason(e))));
    } catch (RuntimeException | Error e) {
      answer(mine, () -> tell(messages.now("not-read", folder)));
      throw e;
    }
  }

  private void answer(int request, Runnable what) {
    Platform.runLater(
        () -> {
          if (request == requests) {
            what.run();
          }
        });
  }

  /** Shows another flight as the ghost. */
  void show(ReplayFlight other) {
    requests++;
    ReplayFlight painted =
        new ReplayFlight(
            other.name(),
            other.folder(),
            other.flight(),
            other.snapshots().withColor(FxReplay.GHOST_RGB));
    replay.ghostProperty().set(Optional.of(painted));
    tell("");
  }

  /** Removes the ghost. */
  void remove() {
    requests++;
    replay.ghostProperty().set(Optional.empty());
    tell("");
  }

  private void tell(String sentence) {
    replay.newsProperty().set(sentence);
    changed.run();
  }
}
