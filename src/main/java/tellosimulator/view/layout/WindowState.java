package tellosimulator.view.layout;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.property.SimpleObjectProperty;

/**
 * What the window itself can be switched to: which parts are there, whether they lie over the 3D
 * scene, and how it looks. Buttons, keys and settings are bound to it. For the JavaFX thread.
 */
public final class WindowState {

  /** A page that lies over everything else. */
  public enum Page {
    NONE,
    HELP,
    ABOUT
  }

  /** Height of the log at first [px]. Decided: half a dozen lines. */
  public static final double LOG_HEIGHT = 190;

  private final BooleanProperty simulatorControlsShown = new SimpleBooleanProperty(true);
  private final BooleanProperty networkControlsShown = new SimpleBooleanProperty(true);
  private final BooleanProperty logShown = new SimpleBooleanProperty(true);
  private final DoubleProperty logHeight = new SimpleDoubleProperty(LOG_HEIGHT);
  private final BooleanProperty fullScreen = new SimpleBooleanProperty();
  private final ObjectProperty<Page> page = new SimpleObjectProperty<>(Page.NONE);
  private final ObjectProperty<Theme> theme = new SimpleObjectProperty<>(Theme.LIGHT);
  private final ObjectProperty<UiScale> uiScale = new SimpleObjectProperty<>(UiScale.SYSTEM);

  public BooleanProperty simulatorControlsShownProperty() {
    return simulatorControlsShown;
  }

  public BooleanProperty networkControlsShownProperty() {
    return networkControlsShown;
  }

  public BooleanProperty logShownProperty() {
    return logShown;
  }

  /** Height of the log [px]. */
  public DoubleProperty logHeightProperty() {
    return logHeight;
  }

  /** Whether the 3D scene fills the screen, with the other parts over it. */
  public BooleanProperty fullScreenProperty() {
    return fullScreen;
  }

  /** The page that lies over everything else. */
  public ObjectProperty<Page> pageProperty() {
    return page;
  }

  public ObjectProperty<Theme> themeProperty() {
    return theme;
  }

  /** How large everything is drawn, from the next start on. */
  public ObjectProperty<UiScale> uiScaleProperty() {
    return uiScale;
  }
}
