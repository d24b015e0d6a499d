package tellosimulator.view.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.application.Platform;
import javafx.stage.Stage;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.view.replay.ReplayFlight;
import tellosimulator.view.replay.ReplayWindow;
import tellosimulator.view.replay.ReplayWindow.Appearance;
import tellosimulator.view.text.Language;

/**
 * Plays each recording in a window of its own. Recordings are read on a separate thread. Confined
 * to the JavaFX thread.
 */
final class RecordingPlayers {

  private static final ErrorPolicy FAILED = ErrorPolicy.finish("A recording could not be read");

  private final Appearance appearance;
  private final Consumer<Function<Language, String>> complain;
  private final List<Stage> stages = new ArrayList<>();

  /**
   * @param complain receives the reason, on the JavaFX thread, if a recording cannot be played
   */
  RecordingPlayers(Appearance appearance, Consumer<Function<Language, String>> complain) {
    this.appearance = appearance;
    this.complain = complain;
  }

  /**
   * Reads a recording and then opens a player for it.
   *
   * @param place the recording's folder, or a file in it
   */
  void open(Path place) {
    Worker.once(
        "replay-reader",
        FAILED,
        () -> {
          try {
            ReplayFlight flight = ReplayFlight.read(place);
            Platform.runLater(() -> show(flight));
          } catch (UnreadableRecordingException e) {
            Platform.runLater(() -> complain.accept(language -> e.getMessage()));
          }
        });
  }

  private void show(ReplayFlight flight) {
    Stage stage = new Stage();
    AppIcon.show(stage);
    Appearance own =
        new Appearance(appearance.language().linked(), appearance.theme(), appearance.optics());
    ReplayWindow window = new ReplayWindow(stage, flight, own);
    stages.add(stage);
    stage.setOnHidden(
        hidden -> {
          stages.remove(stage);
          window.close();
        });
    window.show();
    InitialStageSize.hold(stage);
  }

  /** Closes all players. */
  void closeAll() {
    List.copyOf(stages).forEach(Stage::hide);
  }
}
