package tellosimulator.view.app;

import java.util.Locale;
import java.util.Optional;
import javafx.stage.Stage;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.replay.ReplayFlight;
import tellosimulator.view.replay.ReplayWindow;
import tellosimulator.view.replay.ReplayWindow.Appearance;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.settings.WindowPlacement;
import tellosimulator.view.text.Language;

/** The program with a window on recorded flights. */
public final class ReplayApp {

  private final ReplayFlight flight;
  private final Optional<ReplayFlight> ghost;
  private final DroneOptics optics;

  /**
   * One that shows a flight.
   *
   * @param ghost that is shown with it
   * @param optics of the drones' cameras
   */
  public ReplayApp(ReplayFlight flight, Optional<ReplayFlight> ghost, DroneOptics optics) {
    this.flight = flight;
    this.ghost = ghost;
    this.optics = optics;
  }

  /**
   * Opens the window, and returns after it was closed. The {@link Toolkit} must run.
   *
   * @param settings what was remembered, and what is to be remembered
   * @param state what the window is switched to
   * @return whether there was a window; if not, the log says why
   * @throws InterruptedException if the program is to end
   */
  public boolean run(Settings settings, WindowState state) throws InterruptedException {
    return Toolkit.run(stage -> show(stage, settings, state));
  }

  /** Shows the window in a stage. For the JavaFX thread. */
  void show(Stage stage, Settings settings, WindowState state) {
    Language language = new Language(Locale.getDefault());
    settings.bind("language", language.localeProperty(), Language.codec());
    WindowPlacement.remember(stage, settings);
    Appearance appearance = new Appearance(language, state.themeProperty(), optics);
    ReplayWindow window = new ReplayWindow(stage, flight, appearance);
    window.camera().reducedMotionProperty().bind(state.reducedMotionProperty());
    settings.bind(
        WindowSettings.ENLARGED_DRONES, window.dronesEnlargedProperty(), SettingCodec.flag());
    window.compareWith(ghost);
    stage.setOnHidden(
        hidden -> {
          window.close();
          settings.save();
        });
    window.show();
    InitialStageSize.hold(stage);
  }
}
