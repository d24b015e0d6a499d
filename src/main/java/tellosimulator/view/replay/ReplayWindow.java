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
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.model.UiTicker;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;
import tellosimulator.view.world.SimulatorCamera;

/** The player's window. Confined to the JavaFX thread. */
public final class ReplayWindow implements AutoCloseable {

  /** Initial width of the scene [px]. */
  private static final double FIRST_WIDTH = 1280;

  /** Initial height of the scene [px]. */
  private static final double FIRST_HEIGHT = 800;

  private final Stage stage;
  private final FxReplay replay;
  private final GhostLoader ghosts;
  private final UiTicker ticker;
  private final WindowVideo video;
  private final ReplayPane pane;

  /**
   * The appearance of the window.
   *
   * @param optics the optics of the drones' cameras
   */
  public record Appearance(Language language, Property<Theme> theme, DroneOptics optics) {}

  /** Builds the window without showing it. */
  public ReplayWindow(Stage stage, ReplayFlight flight, Appearance appearance) {
    this.stage = stage;
    Language language = appearance.language();
    Property<Theme> theme = appearance.theme();
    theme.subscribe(now -> Application.setUserAgentStylesheet(now.stylesheet()));
    replay = new FxReplay(flight);
    ticker = new UiTicker(() -> {}, () -> !replay.playback().playingProperty().get());
    video = new WindowVideo(replay::snapshot, appearance.optics(), MediaFolder.ofUser());
    ghosts = new GhostLoader(replay, language, ticker::wake, ReplayFlight::read);
    BooleanProperty fullScreen = new SimpleBooleanProperty();
    stage.fullScreenProperty().subscribe(fullScreen::set);
    fullScreen.subscribe(stage::setFullScreen);
    SceneContext context =
        new SceneContext(replay.simulation(), language, ticker, video, ReplayOverlay.of(replay));
    pane =
        new ReplayPane(replay, ghosts, context, new ReplayPane.DisplaySettings(theme, fullScreen));
    ticker.onTick(nanos -> video.advance());
    video.onReport(
        report ->
            Platform.runLater(() -> replay.newsProperty().set(language.say(report.phrase()))));
    Scene scene = new Scene(pane, FIRST_WIDTH, FIRST_HEIGHT);
    pane.keys().on(KeyCode.F11, () -> ReplayPane.toggle(fullScreen)).install(scene);
    scene
        .getAccelerators()
        .put(new KeyCodeCombination(KeyCode.Q, KeyCombination.SHORTCUT_DOWN), this::quit);
    FileDrop.install(pane, ghosts::read);
    EventHandler<InputEvent> waking = input -> ticker.wake();
    scene.addEventFilter(InputEvent.ANY, waking);
    scene.widthProperty().subscribe(ticker::wake);
    scene.heightProperty().subscribe(ticker::wake);
    replay.playback().timeProperty().subscribe(ticker::wake);
    replay.playback().playingProperty().subscribe(ticker::wake);
    stage.setScene(scene);
    stage.setTitle(flight.name() + " \u2013 Tello Simulator");
    stage.setFullScreenExitHint("");
    stage.setFullScreenExitKeyCombination(KeyCombination.NO_MATCH);
  }

  /** Shows another flight as the ghost, if there is one. */
  public void compareWith(Optional<ReplayFlight> other) {
    other.ifPresent(ghosts::show);
  }

  /** Returns the camera that shows the room from outside. */
  public SimulatorCamera camera() {
    return pane.world().camera();
  }

  /** Whether drones that would look small are drawn enlarged. */
  public BooleanProperty dronesEnlargedProperty() {
    return pane.world().dronesEnlargedProperty();
  }

  /** Shows the window. */
  public void show() {
    ticker.start();
    stage.show();
    pane.world().requestFocus(); // otherwise Space would press the first button
  }

  /** Closes the window, as the close button of its frame does. */
  private void quit() {
    stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST));
  }

  /** Stops playback and video. */
  @Override
  public void close() {
    ticker.stop();
    pane.world().rest();
    video.close();
  }
}
