package tellosimulator.view.replay;

import java.util.Optional;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.Property;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.input.InputEvent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.fx.FileDrop;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.model.Pulse;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;
import tellosimulator.view.world.SimulatorCamera;

/** The player in a stage. For the JavaFX thread. */
public final class ReplayWindow implements AutoCloseable {

  /** Size of the scene before the window has its own [px]. */
  private static final double FIRST_WIDTH = 1280;

  private static final double FIRST_HEIGHT = 800;

  private final Stage stage;
  private final FxReplay replay;
  private final GhostLoader ghosts;
  private final Pulse pulse;
  private final WindowVideo video;
  private final ReplayPane pane;

  /**
   * How everything looks.
   *
   * @param optics of the drones' cameras
   */
  public record Appearance(Language language, Property<Theme> theme, DroneOptics optics) {}

  /** Builds the window, and does not show it yet. */
  public ReplayWindow(Stage stage, ReplayFlight flight, Appearance appearance) {
    this.stage = stage;
    Language language = appearance.language();
    Property<Theme> theme = appearance.theme();
    theme.subscribe(now -> Application.setUserAgentStylesheet(now.stylesheet()));
    replay = new FxReplay(flight);
    pulse = new Pulse(() -> {}, () -> !replay.playback().playingProperty().get());
    video = new WindowVideo(replay::snapshot, appearance.optics(), MediaFolder.ofUser());
    ghosts = new GhostLoader(replay, language, pulse::wake, ReplayFlight::read);
    BooleanProperty fullScreen = new SimpleBooleanProperty();
    stage.fullScreenProperty().subscribe(fullScreen::set);
    fullScreen.subscribe(stage::setFullScreen);
    SceneContext context =
        new SceneContext(replay.simulation(), language, pulse, video, ReplayMarks.of(replay));
    pane =
        new ReplayPane(replay, ghosts, context, new ReplayPane.DisplaySettings(theme, fullScreen));
    pulse.onBeat(nanos -> video.advance());
    video.onReport(
        report ->
            Platform.runLater(() -> replay.newsProperty().set(language.say(report.phrase()))));
    Scene scene = new Scene(pane, FIRST_WIDTH, FIRST_HEIGHT);
    pane.keys().on(KeyCode.F11, () -> ReplayPane.toggle(fullScreen)).install(scene);
    scene
        .getAccelerators()
        .put(new KeyCodeCombination(KeyCode.Q, KeyCombination.SHORTCUT_DOWN), this::quit);
    FileDrop.install(pane, ghosts::read);
    EventHandler<InputEvent> waking = input -> pulse.wake();
    scene.addEventFilter(InputEvent.ANY, waking);
    scene.widthProperty().subscribe(pulse::wake);
    scene.heightProperty().subscribe(pulse::wake);
    replay.playback().timeProperty().subscribe(pulse::wake);
    replay.playback().playingProperty().subscribe(pulse::wake);
    stage.setScene(scene);
    stage.setTitle(flight.name() + " \u2013 Tello Simulator");
    stage.setFullScreenExitHint("");
    stage.setFullScreenExitKeyCombination(KeyCombination.NO_MATCH);
  }

  /** Shows another flight as the ghost. */
  public void compareWith(Optional<ReplayFlight> other) {
    other.ifPresent(ghosts::show);
  }

  /** The camera that looks into the room from outside. */
  public SimulatorCamera camera() {
    return pane.world().camera();
  }

  /** Whether drones that would be small in the picture are drawn larger than life. */
  public BooleanProperty dronesEnlargedProperty() {
    return pane.world().dronesEnlargedProperty();
  }

  /** Opens it. */
  public void show() {
    pulse.start();
    stage.show();
    pane.world().requestFocus(); // or the first button would have it, and Space would press that
  }

  /** As the button of the frame does. */
  private void quit() {
    stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST));
  }

  /** Ends what it does beside showing. */
  @Override
  public void close() {
    pulse.stop();
    pane.world().rest();
    video.close();
  }
}
