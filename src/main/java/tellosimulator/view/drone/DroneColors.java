package tellosimulator.view.drone;

import javafx.scene.paint.Color;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.view.FxTextures;

/** The colours that tell drones apart, as JavaFX has them. */
public final class DroneColors {

  private DroneColors() {}

  /**
   * The colour of all that belongs to a drone: its path, its start, its rows in panels.
   *
   * @param number from 1
   */
  public static Color of(int number) {
    return FxTextures.color(Livery.of(number));
  }
}
