package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.Group;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.drone.DroneColors;

/**
 * The path that a drone has flown as a thin band in the air. Its last few points are a mesh of
 * their own, which changes some times a second and is small; the long one behind it changes only
 * when these have become many. Measured: with one mesh a path, twenty drones that circle took half
 * of a processor for nothing else. Paths of earlier flights are fainter. For the JavaFX thread.
 */
final class Trail extends Group {

  /** Most points. Decided: enough for minutes, cheap enough to draw. */
  static final int CAPACITY = 384;

  /** Most points of the part that changes often. Decided. */
  private static final int RECENT = 24;

  /** Shortest time from update to update [ns]. Decided. */
  static final long UPDATE_PERIOD = 120_000_000;

  /** Height of the band above the drone's feet [m]. Documented: half of 41 mm. */
  static final double MIDDLE = 0.02;

  private final FxDroneModel drone;
  private final FlightPaths paths = new FlightPaths(CAPACITY);
  private final List<TrailBand> earlier = new ArrayList<>();
  private final TrailBand past;
  private final TrailBand recent;
  private boolean changed;
  private long lastUpdate;

  /** The last point of the long part, the first of the other; what is behind it may still move. */
  private int settled;

  private int sizeBefore;
  private int shownChanges;

  Trail(FxDroneModel drone) {
    this.drone = drone;
    Color color = DroneColors.of(drone);
    PhongMaterial material = new PhongMaterial(color.deriveColor(0, 1, 1, 0.85));
    past = new TrailBand(material);
    recent = new TrailBand(material);
    setId("trail-" + drone.number());
    for (int age = 1; age <= FlightPaths.EARLIER; age++) {
      earlier.add(new TrailBand(faint(color, FlightPaths.opacity(age))));
    }
    getChildren().addAll(earlier);
    getChildren().addAll(past, recent);
  }

  /** Measured: the toolkit adds a material's color to what is behind it, so it is premultiplied. */
  private static PhongMaterial faint(Color color, double opacity) {
    return new PhongMaterial(
        new Color(
            color.getRed() * opacity,
            color.getGreen() * opacity,
            color.getBlue() * opacity,
            opacity));
  }

  /** Forgets all paths; the present one begins anew where the drone is. */
  void clear() {
    paths.clear();
    changed = true;
    lastUpdate = 0;
  }

  /**
   * Goes on to where the drone is.
   *
   * @param nanos the time of the picture [ns]
   */
  void advance(long nanos) {
    Vec3 position = drone.poseProperty().get().position();
    boolean takingOff = drone.phaseProperty().get() == FlightPhase.TAKING_OFF;
    changed |= paths.advance(takingOff, position.plusScaled(Vec3.UP, MIDDLE));
    if (changed && isVisible() && nanos - lastUpdate >= UPDATE_PERIOD) {
      lastUpdate = nanos;
      changed = false;
      update();
    }
  }

  /** Points of the present flight's path. */
  int size() {
    return paths.present().size();
  }

  private void update() {
    boolean anotherFlight = paths.changes() != shownChanges;
    if (anotherFlight) {
      showEarlier();
    }
    TrailPath path = paths.present();
    int last = path.size() - 1;
    boolean anew = anotherFlight || path.size() < sizeBefore; // cleared, or thinned out
    if (anew || last - settled >= RECENT) {
      settled = Math.max(0, last - 1);
      past.show(path, 0, settled);
    }
    recent.show(path, settled, last);
    sizeBefore = path.size();
  }

  private void showEarlier() {
    shownChanges = paths.changes();
    List<TrailPath> shown = paths.earlier();
    for (int i = 0; i < earlier.size(); i++) {
      if (i < shown.size()) {
        earlier.get(i).show(shown.get(i), 0, shown.get(i).size() - 1);
      } else {
        earlier.get(i).setVisible(false);
      }
    }
  }
}
