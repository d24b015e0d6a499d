package tellosimulator.view.settings;

import java.util.List;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.geometry.Rectangle2D;
import javafx.stage.Screen;
import javafx.stage.Stage;

/**
 * The size, position and maximised state of a window. Size and position are not saved while the
 * window is maximised, minimised or in full screen.
 */
public final class WindowPlacement {

  /**
   * Default width of a window [pixels]. Documented: nothing is cut off in a window of 1280 by 800.
   */
  private static final double WIDTH = 1280;

  /** Default height of a window [pixels]. Documented as for {@link #WIDTH}. */
  private static final double HEIGHT = 800;

  /** Minimum plausible width and height [pixels]. */
  private static final double SMALLEST = 300;

  /**
   * Maximum plausible size, and maximum distance from the origin [pixels]. Assumed: larger than any
   * wall of screens.
   */
  private static final double LARGEST = 30_000;

  /** Width of the part of a window's upper edge by which the user can grab the window [pixels]. */
  private static final double HOLD_WIDTH = 100;

  /** Height of the part of a window's upper edge by which the user can grab the window [pixels]. */
  private static final double HOLD_HEIGHT = 30;

  private final DoubleProperty x = new SimpleDoubleProperty(Double.NaN);
  private final DoubleProperty y = new SimpleDoubleProperty(Double.NaN);
  private final DoubleProperty width = new SimpleDoubleProperty(WIDTH);
  private final DoubleProperty height = new SimpleDoubleProperty(HEIGHT);
  private final BooleanProperty maximized = new SimpleBooleanProperty();

  private WindowPlacement(Settings settings) {
    settings.bind("window.x", x, SettingCodec.decimal(-LARGEST, LARGEST));
    settings.bind("window.y", y, SettingCodec.decimal(-LARGEST, LARGEST));
    settings.bind("window.width", width, SettingCodec.decimal(SMALLEST, LARGEST));
    settings.bind("window.height", height, SettingCodec.decimal(SMALLEST, LARGEST));
    settings.bind("window.maximised", maximized, SettingCodec.flag());
  }

  /** Restores a window's size and position before it is shown, and saves their changes. */
  public static void remember(Stage stage, Settings settings) {
    WindowPlacement placement = new WindowPlacement(settings);
    List<Rectangle2D> screens = Screen.getScreens().stream().map(Screen::getVisualBounds).toList();
    placement.place(stage, screens);
    placement.follow(stage);
  }

  private void place(Stage stage, List<Rectangle2D> screens) {
    Optional<Rectangle2D> place = visible(x.get(), y.get(), screens);
    Rectangle2D screen = place.orElse(screens.get(0));
    stage.setWidth(Math.min(width.get(), screen.getWidth()));
    stage.setHeight(Math.min(height.get(), screen.getHeight()));
    if (place.isPresent()) {
      stage.setX(x.get());
      stage.setY(y.get());
    } else {
      stage.centerOnScreen();
    }
    stage.setMaximized(maximized.get());
  }

  /**
   * Returns the screen on which the user can grab the upper left of a window; empty if there is
   * none, for example because a monitor was removed.
   */
  static Optional<Rectangle2D> visible(double x, double y, List<Rectangle2D> screens) {
    return screens.stream()
        .filter(
            screen ->
                x + HOLD_WIDTH <= screen.getMaxX()
                    && x >= screen.getMinX() - HOLD_WIDTH
                    && y >= screen.getMinY() - 1
                    && y + HOLD_HEIGHT <= screen.getMaxY())
        .findFirst();
  }

  private void follow(Stage stage) {
    stage.xProperty().addListener((observed, before, now) -> note(stage, x, now));
    stage.yProperty().addListener((observed, before, now) -> note(stage, y, now));
    stage.widthProperty().addListener((observed, before, now) -> noteSize(stage, width, now));
    stage.heightProperty().addListener((observed, before, now) -> noteSize(stage, height, now));
    stage.maximizedProperty().addListener((observed, before, now) -> maximized.set(now));
  }

  /**
   * Saves a size, unless it is too small. Windows may be too small while they are being opened or
   * closed.
   */
  private static void noteSize(Stage stage, DoubleProperty property, Number value) {
    if (value.doubleValue() >= SMALLEST) {
      note(stage, property, value);
    }
  }

  private static void note(Stage stage, DoubleProperty property, Number value) {
    boolean free = !stage.isMaximized() && !stage.isFullScreen() && !stage.isIconified();
    if (free && stage.isShowing() && !Double.isNaN(value.doubleValue())) {
      property.set(value.doubleValue());
    }
  }
}
