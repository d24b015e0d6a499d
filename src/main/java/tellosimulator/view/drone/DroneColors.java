package tellosimulator.view.drone;

import java.util.List;
import javafx.scene.paint.Color;

/**
 * The colours that tell drones apart.
 *
 * <p>Decided: the colours of Okabe and Ito (Color Universal Design, 2008), which people with any
 * kind of colour vision can tell apart, in an order in which neighbours differ in lightness too.
 * After the last one they begin anew.
 */
public final class DroneColors {

  /** Cover of a real Tello. Assumed: by eye, from pictures. */
  private static final Color WHITE_COVER = Color.web("#eceded");

  private static final List<Color> COLORS =
      List.of(
          Color.web("#0072b2"),
          Color.web("#e69f00"),
          Color.web("#009e73"),
          Color.web("#cc79a7"),
          Color.web("#56b4e9"),
          Color.web("#d55e00"),
          Color.web("#f0e442"));

  private DroneColors() {}

  /**
   * The colour of all that belongs to a drone: its path, its start, its rows in panels.
   *
   * @param number from 1
   */
  public static Color of(int number) {
    return COLORS.get(Math.floorMod(number - 1, COLORS.size()));
  }

  /** The colour of a drone's cover: white for the first, as the real one, else its own colour. */
  static Color cover(int number) {
    return number == 1 ? WHITE_COVER : of(number);
  }
}
