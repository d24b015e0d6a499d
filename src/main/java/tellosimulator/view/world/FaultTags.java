package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javafx.scene.layout.Pane;
import tellosimulator.fault.Fault;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * Shows a label below each drone in the 3D scene, with the drone's active faults. Confined to the
 * JavaFX thread.
 */
final class FaultTags extends Pane {

  private final List<PlacedLabel> tags = new ArrayList<>();

  FaultTags(int drones) {
    for (int i = 0; i < drones; i++) {
      tags.add(new PlacedLabel("fault-tag"));
    }
    getChildren().setAll(tags);
    setMouseTransparent(true);
    setManaged(false);
  }

  /**
   * Updates the labels' texts and positions.
   *
   * @param viewpoint the viewpoint from which the drones are seen; empty hides all labels
   */
  void advance(SimSnapshot snapshot, Optional<Viewpoint> viewpoint) {
    for (int i = 0; i < tags.size(); i++) {
      DroneSnapshot drone = snapshot.drones().get(i);
      List<Fault> acting = drone.faults().faults();
      if (viewpoint.isPresent() && !acting.isEmpty()) {
        Vec3 place = drone.state().motion().position();
        tags.get(i).show(words(acting), place, viewpoint.get(), this);
      } else {
        tags.get(i).setVisible(false);
      }
    }
  }

  private static String words(List<Fault> faults) {
    return faults.stream()
        .map(fault -> fault.kind().word())
        .distinct()
        .collect(Collectors.joining(", "));
  }
}
