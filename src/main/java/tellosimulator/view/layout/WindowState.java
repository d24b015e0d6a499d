package tellosimulator.view.layout;

import java.util.EnumMap;
import java.util.Map;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.property.SimpleObjectProperty;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;

/**
 * The state of the window itself: which parts it shows, whether they lie over the 3D scene, and its
 * appearance. Buttons, keys and settings are bound to it. Confined to the JavaFX thread.
 */
public final class WindowState {

  /** Default height of the log [px]. Decided: fits six lines. */
  static final double LOG_HEIGHT = 163;

  /** Minimum height of the log [px]. Decided: fits a line. */
  static final double LEAST_LOG_HEIGHT = 90;

  /** Maximum height of the log [px]. Decided: fits any screen. */
  private static final double MOST_LOG_HEIGHT = 10_000;

  /** The switches of the window. */
  public enum Flag {
    SIMULATOR_CONTROLS("show.simulator-controls", true),
    NETWORK_CONTROLS("show.network-controls", false),

    /** Whether the whole log is shown, rather than only its latest row. */
    LOG("show.log", false),

    /** Whether the list of drones is shown, if there are several. */
    DRONES("show.drones", true),

    /**
     * Whether flights are recorded. The command line can request this even if the switch is off.
     */
    RECORDED_FLIGHTS("record-flights", true),

    /** Whether animations are replaced by immediate changes. */
    REDUCED_MOTION("reduced-motion", false),

    /** Whether the plan editor covers the scene. */
    PLAN("", false),

    /** Whether the window shows only the scene and text that is large enough to read from afar. */
    PROJECTOR("", false),

    /** Whether the 3D scene fills the screen, with the other parts over it. */
    FULL_SCREEN("", false);

    private final String setting;
    private final boolean preset;

    /**
     * @param setting the key in the settings; empty if the flag is not stored
     */
    Flag(String setting, boolean preset) {
      this.setting = setting;
      this.preset = preset;
    }
  }

  private final Map<Flag, BooleanProperty> flags = new EnumMap<>(Flag.class);
  private final DoubleProperty logHeight = new SimpleDoubleProperty(LOG_HEIGHT);
  private final ObjectProperty<Theme> theme = new SimpleObjectProperty<>(Theme.LIGHT);
  private final ObjectProperty<UiScale> uiScale = new SimpleObjectProperty<>(UiScale.SYSTEM);

  /** Creates a state that is not restored from settings. */
  public WindowState() {
    for (Flag flag : Flag.values()) {
      flags.put(flag, new SimpleBooleanProperty(this, flag.name(), flag.preset));
    }
  }

  /** Restores the state from the settings, and saves its changes. */
  public static WindowState remembered(Settings settings) {
    WindowState state = new WindowState();
    state.flags.forEach(
        (flag, property) -> {
          if (!flag.setting.isEmpty()) {
            settings.bind(flag.setting, property, SettingCodec.flag());
          }
        });
    settings.bind(
        "log.height", state.logHeight, SettingCodec.decimal(LEAST_LOG_HEIGHT, MOST_LOG_HEIGHT));
    settings.bind("theme", state.theme, SettingCodec.constant(Theme.class));
    settings.bind("ui-scale", state.uiScale, SettingCodec.constant(UiScale.class));
    return state;
  }

  /** Returns a copy for a temporary window. Changes of either state apply to both. */
  public WindowState linked() {
    WindowState other = new WindowState();
    flags.forEach((flag, property) -> other.flag(flag).bindBidirectional(property));
    other.logHeight.bindBidirectional(logHeight);
    other.theme.bindBidirectional(theme);
    other.uiScale.bindBidirectional(uiScale);
    return other;
  }

  /** Whether a switch is on. */
  public BooleanProperty flag(Flag flag) {
    return flags.get(flag);
  }

  /** Turns a switch on if it is off, and off if it is on. */
  public void toggle(Flag flag) {
    flag(flag).set(!flag(flag).get());
  }

  /** Height of the log [px]. */
  public DoubleProperty logHeightProperty() {
    return logHeight;
  }

  public ObjectProperty<Theme> themeProperty() {
    return theme;
  }

  /** Sets the scale for JavaFX. Must be called before JavaFX starts. */
  public void applyUiScale() {
    uiScale.get().apply();
  }

  /** The scale of the window, effective from the next start. */
  ObjectProperty<UiScale> uiScaleProperty() {
    return uiScale;
  }
}
