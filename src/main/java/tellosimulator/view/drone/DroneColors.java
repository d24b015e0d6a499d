package tellosimulator.view.drone;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import javafx.scene.paint.Color;
import tellosimulator.goal.Goal;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.view.model.FxDroneModel;

/** The colours that tell drones apart, as JavaFX has them. */
public final class DroneColors {

  /**
   * Relative luminance above which black letters have more contrast than white ones: where 1.05 /
   * (L + 0.05) is (L + 0.05) / 0.05. Documented: WCAG 2.1.
   */
  private static final double BRIGHT = Math.sqrt(1.05 * 0.05) - 0.05;

  private DroneColors() {}

  /** The colour of all that belongs to a drone: its path, its start, its rows in panels. */
  public static Color of(FxDroneModel drone) {
    return FxTextures.color(drone.livery().color());
  }

  /** That of the one drone that shall reach a goal, which all that belongs to the goal has. */
  public static Optional<Color> of(Goal goal, List<FxDroneModel> drones) {
    return drones.stream()
        .filter(drone -> goal.drone().equals(OptionalInt.of(drone.number())))
        .map(DroneColors::of)
        .findFirst();
  }

  /** The CSS of a badge of a colour, with a text that is read on it. */
  public static String badge(Color color) {
    return String.format(
        Locale.ROOT, "-fx-background-color: %s; -fx-text-fill: %s;", web(color), web(inkOn(color)));
  }

  private static String web(Color color) {
    return "#" + color.toString().substring(2, 8); // as the toolkit writes it: 0xrrggbbaa
  }

  /** Black or white, whichever is read better on a colour. */
  public static Color inkOn(Color color) {
    double luminance =
        0.2126 * linear(color.getRed())
            + 0.7152 * linear(color.getGreen())
            + 0.0722 * linear(color.getBlue());
    return luminance > BRIGHT ? Color.BLACK : Color.WHITE;
  }

  /** A component of sRGB as light. */
  private static double linear(double component) {
    return component <= 0.04045 ? component / 12.92 : Math.pow((component + 0.055) / 1.055, 2.4);
  }
}
