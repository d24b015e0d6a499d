package tellosimulator.view.layout;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.property.SimpleObjectProperty;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;

/**
 * What the window itself can be switched to: which parts are there, whether they lie over the 3D
 * scene, and how it looks. Buttons, keys and settings are bound to it. For the JavaFX thread.
 */
public final class WindowState {

  /** Height of the log at first [px]. Decided: six lines. */
  static final double LOG_HEIGHT = 163;

  /** Limits of the height of the log [px]. Decided: a line, and any screen. */
  static final double LEAST_LOG_HEIGHT = 90;

  private static final double MOST_LOG_HEIGHT = 10_000;

  private final BooleanProperty simulatorControlsShown = new SimpleBooleanProperty(true);
  private final BooleanProperty networkControlsShown = new SimpleBooleanProperty();
  private final BooleanProperty logOpen = new SimpleBooleanProperty();
  private final BooleanProperty dronesShown = new SimpleBooleanProperty(true);
  private final BooleanProperty flightsRecorded = new SimpleBooleanProperty(true);
  private final BooleanProperty planShown = new SimpleBooleanProperty();
  private final BooleanProperty projector = new SimpleBooleanProperty();
  private final BooleanProperty reducedMotion = new SimpleBooleanProperty();
  private final DoubleProperty logHeight = new SimpleDoubleProperty(LOG_HEIGHT);
  private final BooleanProperty fullScreen = new SimpleBooleanProperty();
  private final ObjectProperty<Theme> theme = new SimpleObjectProperty<>(Theme.LIGHT);
  private final ObjectProperty<UiScale> uiScale = new SimpleObjectProperty<>(UiScale.SYSTEM);

  /** Is at first as it was left, and remembers how it is left. */
  public static WindowState remembered(Settings settings) {
    WindowState state = new WindowState();
    settings.bind("show.simulator-controls", state.simulatorControlsShown, SettingCodec.flag());
    settings.bind("show.network-controls", state.networkControlsShown, SettingCodec.flag());
    settings.bind("show.log", state.logOpen, SettingCodec.flag());
    settings.bind("show.drones", state.dronesShown, SettingCodec.flag());
    settings.bind(
        "log.height", state.logHeight, SettingCodec.decimal(LEAST_LOG_HEIGHT, MOST_LOG_HEIGHT));
    settings.bind("record-flights", state.flightsRecorded, SettingCodec.flag());
    settings.bind("reduced-motion", state.reducedMotion, SettingCodec.flag());
    settings.bind("theme", state.theme, SettingCodec.constant(Theme.class));
    settings.bind("ui-scale", state.uiScale, SettingCodec.constant(UiScale.class));
    return state;
  }

  /** The same state for a window that comes and goes; each of them follows the other. */
  public WindowState linked() {
    WindowState other = new WindowState();
    other.simulatorControlsShown.bindBidirectional(simulatorControlsShown);
    other.networkControlsShown.bindBidirectional(networkControlsShown);
    other.logOpen.bindBidirectional(logOpen);
    other.dronesShown.bindBidirectional(dronesShown);
    other.flightsRecorded.bindBidirectional(flightsRecorded);
    other.planShown.bindBidirectional(planShown);
    other.projector.bindBidirectional(projector);
    other.reducedMotion.bindBidirectional(reducedMotion);
    other.logHeight.bindBidirectional(logHeight);
    other.fullScreen.bindBidirectional(fullScreen);
    other.theme.bindBidirectional(theme);
    other.uiScale.bindBidirectional(uiScale);
    return other;
  }

  public BooleanProperty simulatorControlsShownProperty() {
    return simulatorControlsShown;
  }

  public BooleanProperty networkControlsShownProperty() {
    return networkControlsShown;
  }

  /** Whether all of the log is there, rather than its newest row alone. */
  public BooleanProperty logOpenProperty() {
    return logOpen;
  }

  /** Whether the list of drones is there, if there are several. */
  public BooleanProperty dronesShownProperty() {
    return dronesShown;
  }

  /** Whether flights are recorded, unless the command line says so anyway. */
  public BooleanProperty flightsRecordedProperty() {
    return flightsRecorded;
  }

  /** Whether the plan in which one places things lies over the scene. */
  public BooleanProperty planShownProperty() {
    return planShown;
  }

  /** Whether there is nothing but the 3D scene and what a class must read from afar. */
  public BooleanProperty projectorProperty() {
    return projector;
  }

  /** Whether nothing glides or grows that can as well jump. */
  public BooleanProperty reducedMotionProperty() {
    return reducedMotion;
  }

  /** Height of the log [px]. */
  public DoubleProperty logHeightProperty() {
    return logHeight;
  }

  /** Whether the 3D scene fills the screen, with the other parts over it. */
  public BooleanProperty fullScreenProperty() {
    return fullScreen;
  }

  public ObjectProperty<Theme> themeProperty() {
    return theme;
  }

  /** Lets JavaFX start with the chosen scale; to be called before it starts. */
  public void applyUiScale() {
    uiScale.get().apply();
  }

  /** How large everything is drawn, from the next start on. */
  ObjectProperty<UiScale> uiScaleProperty() {
    return uiScale;
  }
}
