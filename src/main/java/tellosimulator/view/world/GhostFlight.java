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
 * Another flight in the same room, shown with what the window shows: translucent drones with trails
 * of their own, each with a label. No drone's camera sees it. For the JavaFX thread.
 */
public final class GhostFlight {

  private final GhostDrones ghosts;
  private final Overlay overlay;
  private final Supplier<String> label;
  private final List<PlacedLabel> tags = new ArrayList<>();
  private final Pane labels = new Pane();
  private SimSnapshot snapshot;

  /**
   * A flight that begins with a snapshot.
   *
   * @param rgb colour of the ghosts, as one writes #rrggbb; that of all drones in its snapshots
   * @param label what is written below each of them, in the present language
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

  /** Shows another moment with the next beat. */
  public void show(SimSnapshot moment) {
    snapshot = moment;
  }

  /** Draws the trails anew, along what was to be seen until now. */
  public void retrace(Iterable<SimSnapshot> past) {
    overlay.clearTrails();
    past.forEach(each -> overlay.advance(each, 0));
  }

  /** The labels, which lie over the picture. */
  Pane labels() {
    return labels;
  }

  /** Shows the trails, or hides them. */
  void showTrails(boolean shown) {
    overlay.showTrails(shown);
  }

  /** The moment that is shown. */
  SimSnapshot snapshot() {
    return snapshot;
  }

  /**
   * What is added to a scene.
   *
   * @param own the scene of its snapshot
   * @param nanos the time of the frame [ns]
   */
  List<Instance> instances(Scene own, Viewpoint viewpoint, long nanos) {
    overlay.advance(snapshot, nanos);
    List<Instance> instances = new ArrayList<>(ghosts.of(own.drones()));
    instances.addAll(overlay.instances(snapshot, viewpoint.eye()));
    return instances;
  }

  /** Moves the labels to where the ghosts are seen. */
  void label(Viewpoint viewpoint) {
    List<DroneSnapshot> drones = snapshot.drones();
    for (int i = 0; i < tags.size(); i++) {
      tags.get(i).show(label.get(), drones.get(i).state().motion().position(), viewpoint, labels);
    }
  }

  /** Hides the labels, as no drone's camera sees ghosts. */
  void hideLabels() {
    tags.forEach(tag -> tag.setVisible(false));
  }
}
