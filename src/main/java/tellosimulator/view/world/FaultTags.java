package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javafx.geometry.Point2D;
import javafx.scene.control.Label;
import javafx.scene.layout.Pane;
import tellosimulator.fault.Fault;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * The names of the faults that act on each drone, below it in the picture of the room. For the
 * JavaFX thread.
 */
final class FaultTags extends Pane {

  /** From the drone's middle to the text [px]. Decided: clear of the body from most distances. */
  private static final double BELOW = 18;

  private final List<Label> tags = new ArrayList<>();

  FaultTags(int drones) {
    for (int i = 0; i < drones; i++) {
      Label tag = new Label();
      tag.getStyleClass().add("fault-tag");
      tag.setVisible(false);
      tags.add(tag);
    }
    getChildren().setAll(tags);
    setMouseTransparent(true);
    setManaged(false);
  }

  /**
   * Follows the drones.
   *
   * @param viewpoint from where they are seen; empty for no tags
   */
  void advance(SimSnapshot snapshot, Optional<Viewpoint> viewpoint) {
    for (int i = 0; i < tags.size(); i++) {
      DroneSnapshot drone = snapshot.drones().get(i);
      show(tags.get(i), drone, viewpoint.filter(seen -> !drone.faults().faults().isEmpty()));
    }
  }

  private void show(Label tag, DroneSnapshot drone, Optional<Viewpoint> viewpoint) {
    Optional<Point2D> place =
        viewpoint.flatMap(
            seen -> seen.project(drone.state().motion().position(), getWidth(), getHeight()));
    tag.setVisible(place.isPresent());
    if (place.isPresent()) {
      tag.setText(words(drone.faults().faults()));
      tag.autosize();
      tag.relocate(
          Math.rint(place.get().getX() - tag.getWidth() / 2),
          Math.rint(place.get().getY() + BELOW));
    }
  }

  private static String words(List<Fault> faults) {
    return faults.stream()
        .map(fault -> fault.kind().word())
        .distinct()
        .collect(Collectors.joining(", "));
  }
}
