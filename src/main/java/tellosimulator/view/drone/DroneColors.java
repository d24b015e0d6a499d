package tellosimulator.view.drone;

import javafx.scene.paint.Color;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxTextures;

/** The colours that tell drones apart, as JavaFX has them. */
public final class DroneColors {

  private DroneColors() {}

  /** The colour of all that belongs to a drone: its path, its start, its rows in panels. */
  public static Color of(FxDroneModel drone) {
    return FxTextures.color(drone.livery().color());
  }
}
