package tellosimulator.view.world;

import javafx.scene.Group;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import tellosimulator.math.Vec3;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.drone.DroneColors;

/**
 * The path that a drone has flown as a thin band in the air. Its last few points are a mesh of
 * their own, which changes some times a second and is small; the long one behind it changes only
 * when these have become many. Measured: with one mesh a path, twenty drones that circle took half
 * of a processor for nothing else. For the JavaFX thread.
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
  private final TrailPath path = new TrailPath(CAPACITY);
  private final TrailBand past;
  private final TrailBand recent;
  private boolean changed;
  private long lastUpdate;

  /** The last point of the long part, the first of the other; what is behind it may still move. */
  private int settled;

  private int sizeBefore;

  Trail(FxDroneModel drone) {
    this.drone = drone;
    Color color = DroneColors.of(drone).deriveColor(0, 1, 1, 0.85);
    PhongMaterial material = new PhongMaterial(color);
    past = new TrailBand(material);
    recent = new TrailBand(material);
    setId("trail-" + drone.number());
    getChildren().addAll(past, recent);
  }

  /** Forgets the path; it begins anew where the drone is. */
  void clear() {
    path.clear();
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
    changed |= path.add(position.plusScaled(Vec3.UP, MIDDLE));
    if (changed && isVisible() && nanos - lastUpdate >= UPDATE_PERIOD) {
      lastUpdate = nanos;
      changed = false;
      update();
    }
  }

  /** Points of the path at present. */
  int size() {
    return path.size();
  }

  private void update() {
    int last = path.size() - 1;
    boolean anew = path.size() < sizeBefore; // cleared, or thinned out
    if (anew || last - settled >= RECENT) {
      settled = Math.max(0, last - 1);
      past.show(path, 0, settled);
    }
    recent.show(path, settled, last);
    sizeBefore = path.size();
  }
}
