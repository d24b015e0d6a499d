package tellosimulator.scenery.drone;

import java.util.List;
import java.util.OptionalInt;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * The colours that tell a drone from others.
 *
 * <p>Decided: the colours of Okabe and Ito (Color Universal Design, 2008), which people with any
 * kind of colour vision can tell apart, in an order in which neighbours differ in lightness too.
 * After the last one they begin anew. The first drone is white, as the real one.
 *
 * @param cover of the drone's cover
 * @param color of all else that belongs to it: its path, its start, its rows in panels
 */
public record Livery(Rgb cover, Rgb color) {

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

  /** That of a drone. */
  public static Livery of(DroneSnapshot drone) {
    return of(drone.state().drone(), drone.rgb());
  }

  /**
   * That of a drone.
   *
   * @param number from 1
   * @param rgb the colour that was chosen for it; empty for that of its number
   */
  static Livery of(int number, OptionalInt rgb) {
    if (rgb.isPresent()) {
      Rgb chosen = Rgb.of(rgb.getAsInt());
      return new Livery(chosen, chosen);
    }
    Rgb color = COLORS.get(Math.floorMod(number - 1, COLORS.size()));
    return new Livery(number == 1 ? WHITE_COVER : color, color);
  }
}
