package tellosimulator.scenery.drone;

import java.util.List;
import java.util.OptionalInt;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * The colours that distinguish one drone from the others.
 *
 * <p>Decided: the colours of Okabe and Ito (Color Universal Design, 2008), which are
 * distinguishable with any kind of colour vision. Their order is chosen so that neighbours also
 * differ in lightness. After the last colour, the sequence starts again. The first drone has a
 * white cover, like a real Tello.
 *
 * @param cover colour of the drone's cover
 * @param color colour of everything else that belongs to the drone: its path, its start, its rows
 *     in panels
 */
public record Livery(Rgb cover, Rgb color) {

  /** The colour of the cover of a real Tello. Assumed: by eye, from pictures. */
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

  /** Returns the livery of a drone. */
  public static Livery of(DroneSnapshot drone) {
    return of(drone.state().drone(), drone.rgb());
  }

  /**
   * Returns the livery of a drone.
   *
   * @param number the drone's number, from 1
   * @param rgb the colour that was chosen for the drone; if empty, the number determines it
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
