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

/** Size and place of a window, remembered while it is neither maximised nor full-screen. */
public final class WindowPlacement {

  /** Size of a first window [pixels]. Documented: nothing is cut off at 1280 by 800. */
  private static final double WIDTH = 1280;

  private static final double HEIGHT = 800;

  /** Limits of what is believed [pixels]. Assumed: beyond any wall of screens. */
  private static final double SMALLEST = 300;

  private static final double LARGEST = 30_000;

  /** What must be seen of a window's upper edge, so that one can take hold of it [pixels]. */
  private static final double HOLD_WIDTH = 100;

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

  /** Puts a window, before it is shown, where it was last time, and remembers where it goes. */
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
   * The screen on which one can take hold of the upper left of a window; empty if there is none, as
   * when a monitor is gone.
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

  /** A window that is just being opened, or closed, may be smaller than anybody wants it. */
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
