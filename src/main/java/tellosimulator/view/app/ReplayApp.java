package tellosimulator.view.app;

import java.util.Locale;
import java.util.Optional;
import javafx.stage.Stage;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.replay.ReplayFlight;
import tellosimulator.view.replay.ReplayWindow;
import tellosimulator.view.replay.ReplayWindow.Appearance;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.settings.WindowPlacement;
import tellosimulator.view.text.Language;

/** The replay program: a window that plays recorded flights. */
public final class ReplayApp {

  private final ReplayFlight flight;
  private final Optional<ReplayFlight> ghost;
  private final DroneOptics optics;

  /**
   * Creates the program for a flight.
   *
   * @param ghost another flight, shown for comparison; empty if there is none
   * @param optics the optics of the drones' cameras
   */
  public ReplayApp(ReplayFlight flight, Optional<ReplayFlight> ghost, DroneOptics optics) {
    this.flight = flight;
    this.ghost = ghost;
    this.optics = optics;
  }

  /**
   * Opens the window and waits until it is closed. The {@link Toolkit} must be running.
   *
   * @param settings the settings to restore and save
   * @param state the state of the window
   * @return whether the window was shown; if not, the reason is logged
   * @throws InterruptedException if the calling thread is interrupted while it waits
   */
  public boolean run(Settings settings, WindowState state) throws InterruptedException {
    return Toolkit.run(stage -> show(stage, settings, state));
  }

  /** Shows the window in a stage. Called on the JavaFX thread. */
  void show(Stage stage, Settings settings, WindowState state) {
    Language language = new Language(Locale.getDefault());
    settings.bind("language", language.localeProperty(), Language.codec());
    WindowPlacement.remember(stage, settings);
    Appearance appearance = new Appearance(language, state.themeProperty(), optics);
    ReplayWindow window = new ReplayWindow(stage, flight, appearance);
    window.camera().reducedMotionProperty().bind(state.flag(Flag.REDUCED_MOTION));
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
