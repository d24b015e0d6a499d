package tellosimulator.view.drone;

import javafx.scene.paint.Color;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.view.model.FxDroneModel;

/** The colours that tell drones apart, as JavaFX has them. */
public final class DroneColors {

  /** Brightness above which a colour bears black letters. Decided: by eye. */
  private static final double BRIGHT = 0.62;

  private DroneColors() {}

  /** The colour of all that belongs to a drone: its path, its start, its rows in panels. */
  public static Color of(FxDroneModel drone) {
    return FxTextures.color(drone.livery().color());
  }

  /** Black or white, whichever is read better on a colour. */
  public static Color inkOn(Color color) {
    return color.grayscale().getRed() > BRIGHT ? Color.BLACK : Color.WHITE;
  }
}
