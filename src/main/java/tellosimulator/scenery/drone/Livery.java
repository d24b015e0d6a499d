package tellosimulator.scenery.drone;

import java.util.List;
import tellosimulator.scenery.Rgb;

/**
 * The colours that tell drones apart.
 *
 * <p>Decided: the colours of Okabe and Ito (Color Universal Design, 2008), which people with any
 * kind of colour vision can tell apart, in an order in which neighbours differ in lightness too.
 * After the last one they begin anew.
 */
public final class Livery {

  /** Cover of a real Tello. Assumed: by eye, from pictures. */
  private static final Rgb WHITE_COVER = Rgb.of(0xeceded);

  private static final List<Rgb> COLORS =
      List.of(
          Rgb.of(0x0072b2),
          Rgb.of(0xe69f00),
          Rgb.of(0x009e73),
          Rgb.of(0xcc79a7),
          Rgb.of(0x56b4e9),
          Rgb.of(0xd55e00),
          Rgb.of(0xf0e442));

  private Livery() {}

  /**
   * The colour of all that belongs to a drone: its path, its start, its rows in panels.
   *
   * @param number from 1
   */
  public static Rgb of(int number) {
    return COLORS.get(Math.floorMod(number - 1, COLORS.size()));
  }

  /** The colour of a drone's cover: white for the first, as the real one, else its own colour. */
  public static Rgb cover(int number) {
    return number == 1 ? WHITE_COVER : of(number);
  }
}
