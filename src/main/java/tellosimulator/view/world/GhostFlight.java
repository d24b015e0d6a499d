package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import javafx.scene.layout.Pane;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.overlay.GhostDrones;
import tellosimulator.scenery.overlay.Overlay;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * Another flight in the same room, shown together with the window's own flight. Its drones are
 * translucent, and each has its own trail and a label. No drone's camera sees them. Confined to the
 * JavaFX thread.
 */
public final class GhostFlight {

  private final GhostDrones ghosts;
  private final Overlay overlay;
  private final Supplier<String> label;
  private final List<PlacedLabel> tags = new ArrayList<>();
  private final Pane labels = new Pane();
  private SimSnapshot snapshot;

  /**
   * Creates a flight that initially shows a snapshot.
   *
   * @param rgb the colour of the ghosts as 0xRRGGBB; all drones in the snapshots must have this
   *     colour
   * @param label supplies the text below each ghost, in the current language
   */
  public GhostFlight(SimSnapshot first, int rgb, Supplier<String> label) {
    this.label = label;
    snapshot = first;
    ghosts = new GhostDrones(Rgb.of(rgb));
    overlay = new Overlay(first);
    labels.setMouseTransparent(true);
    labels.setManaged(false);
    first.drones().forEach(drone -> tags.add(new PlacedLabel("ghost-tag")));
    labels.getChildren().setAll(tags);
  }

  /** Sets the moment to show at the next UI tick. */
  public void show(SimSnapshot moment) {
    snapshot = moment;
  }

  /** Redraws the trails from earlier snapshots. */
  public void retrace(Iterable<SimSnapshot> past) {
    overlay.clearTrails();
    past.forEach(each -> overlay.advance(each, 0));
  }

  /** Returns the pane that contains the labels. The pane must be placed over the scene. */
  Pane labels() {
    return labels;
  }

  /** Shows or hides the trails. */
  void showTrails(boolean shown) {
    overlay.showTrails(shown);
  }

  /** Returns the moment that is shown. */
  SimSnapshot snapshot() {
    return snapshot;
  }

  /**
   * Returns the instances to add to a scene.
   *
   * @param own the scene of this flight's snapshot
   * @param nanos the time of the frame [ns]
   */
  List<Instance> instances(Scene own, Viewpoint viewpoint, long nanos) {
    overlay.advance(snapshot, nanos);
    List<Instance> instances = new ArrayList<>(ghosts.of(own.drones()));
    instances.addAll(overlay.instances(snapshot, viewpoint.eye()));
    return instances;
  }

  /** Moves the labels to the ghosts. */
  void label(Viewpoint viewpoint) {
    List<DroneSnapshot> drones = snapshot.drones();
    for (int i = 0; i < tags.size(); i++) {
      tags.get(i).show(label.get(), drones.get(i).state().motion().position(), viewpoint, labels);
    }
  }

  /** Hides the labels, for example in the view of a drone's camera, which does not show ghosts. */
  void hideLabels() {
    tags.forEach(tag -> tag.setVisible(false));
  }
}
