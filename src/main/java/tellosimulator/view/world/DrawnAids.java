package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.scenery.Placed;
import tellosimulator.view.FxSimulation;

/**
 * What helps people to see where drones are, for the software camera: flown paths, lines down to
 * the floor, and numbers. For the JavaFX thread.
 */
final class DrawnAids {

  private final List<DrawnTrail> trails;
  private final List<DrawnPlumbLine> plumbLines;
  private final List<DrawnNumber> numbers;
  private boolean trailsShown = true;

  DrawnAids(FxSimulation simulation) {
    trails = simulation.drones().stream().map(DrawnTrail::new).toList();
    plumbLines = simulation.drones().stream().map(DrawnPlumbLine::new).toList();
    boolean several = simulation.drones().size() > 1;
    numbers = several ? simulation.drones().stream().map(DrawnNumber::new).toList() : List.of();
  }

  void showTrails(boolean shown) {
    trailsShown = shown;
  }

  /**
   * Moves on with the drones.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos) {
    trails.forEach(trail -> trail.advance(nanos));
  }

  /** All of them; the same ones as long as nothing has changed. */
  List<Placed> parts(Pose camera) {
    List<Placed> parts = new ArrayList<>();
    if (trailsShown) {
      trails.forEach(trail -> parts.addAll(trail.parts()));
    }
    plumbLines.forEach(line -> line.part(camera.position()).ifPresent(parts::add));
    numbers.forEach(number -> parts.add(number.part(camera)));
    return List.copyOf(parts);
  }
}
