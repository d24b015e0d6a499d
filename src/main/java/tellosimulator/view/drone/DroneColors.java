package tellosimulator.view.drone;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import javafx.scene.paint.Color;
import tellosimulator.goal.Goal;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.view.model.FxDroneModel;

/** The colours that distinguish drones, as JavaFX colours. */
public final class DroneColors {

  /**
   * Relative luminance L above which black letters have more contrast than white ones. L solves the
   * equation 1.05 / (L + 0.05) = (L + 0.05) / 0.05. Documented: WCAG 2.1.
   */
  private static final double BRIGHT = Math.sqrt(1.05 * 0.05) - 0.05;

  private DroneColors() {}

  /**
   * Returns the colour of everything that belongs to a drone, such as its trail, its start, and its
   * rows in panels.
   */
  public static Color of(FxDroneModel drone) {
    return FxTextures.color(drone.livery().color());
  }

  /**
   * Returns the colour of everything that belongs to a goal: the colour of the drone to which the
   * goal is assigned. Empty if any drone may reach the goal.
   */
  public static Optional<Color> of(Goal goal, List<FxDroneModel> drones) {
    return drones.stream()
        .filter(drone -> goal.drone().equals(OptionalInt.of(drone.number())))
        .map(DroneColors::of)
        .findFirst();
  }

  /** Returns the CSS for a badge of the given colour, with readable text. */
  public static String badge(Color color) {
    return String.format(
        Locale.ROOT, "-fx-background-color: %s; -fx-text-fill: %s;", web(color), web(inkOn(color)));
  }

  private static String web(Color color) {
    return "#" + color.toString().substring(2, 8); // JavaFX writes 0xrrggbbaa
  }

  /** Returns black or white, whichever is more readable on the given colour. */
  public static Color inkOn(Color color) {
    double luminance =
        0.2126 * linear(color.getRed())
            + 0.7152 * linear(color.getGreen())
            + 0.0722 * linear(color.getBlue());
    return luminance > BRIGHT ? Color.BLACK : Color.WHITE;
  }

  /** Converts a component of sRGB to linear light. */
  private static double linear(double component) {
    return component <= 0.04045 ? component / 12.92 : Math.pow((component + 0.055) / 1.055, 2.4);
  }
}
