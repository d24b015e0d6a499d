package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * The overlay of a scene in one window. It shows the trails, plumb lines, rings and tags of the
 * drones; the goals and the lines to the next goals; and the contacts. It follows the drones from
 * snapshot to snapshot. Not thread-safe.
 */
public final class Overlay {

  /**
   * Height above a drone's feet at which the line to its goal begins [m]: the middle of the drone.
   */
  private static final double MIDDLE = 0.02;

  private final List<Trail> trails = new ArrayList<>();
  private final List<PlumbLine> plumbLines = new ArrayList<>();
  private final List<HeadingRing> rings = new ArrayList<>();

  /** The tags of the drones; empty for a lone drone. */
  private final List<DroneTag> tags = new ArrayList<>();

  private final Map<Integer, Rgb> colors = new HashMap<>();
  private final GoalShapes goalMarkers = new GoalShapes();
  private final GoalTags goalTags = new GoalTags();
  private final GoalLine goalLine = new GoalLine();
  private final ContactDecals contactMarkers = new ContactDecals();
  private List<PlacedGoal> goals = List.of();
  private List<ContactDecal> contacts = List.of();
  private OptionalInt chosen = OptionalInt.empty();
  private boolean trailsShown = true;
  private boolean goalLineShown = true;

  /**
   * Creates an overlay without goals and contacts.
   *
   * @param first the first snapshot; all later snapshots must have the same number of drones
   */
  public Overlay(SimSnapshot first) {
    for (DroneSnapshot drone : first.drones()) {
      Livery livery = Livery.of(drone);
      colors.put(drone.state().drone(), livery.color());
      trails.add(new Trail(drone));
      plumbLines.add(new PlumbLine(livery));
      rings.add(new HeadingRing(livery, first.drones().size()));
      if (first.drones().size() > 1) {
        tags.add(new DroneTag(drone.state().drone(), livery, first.drones().size()));
      }
    }
  }

  /** Shows or hides the trails. */
  public void showTrails(boolean shown) {
    trailsShown = shown;
  }

  /** Shows or hides the line from each drone to its next goal. */
  public void showGoalLine(boolean shown) {
    goalLineShown = shown;
  }

  /**
   * Selects a drone by its number. If there are several drones, the selected one stands out and the
   * others become fainter.
   */
  public void choose(int drone) {
    chosen = colors.size() > 1 ? OptionalInt.of(drone) : OptionalInt.empty();
  }

  /** Sets the goals and contacts to show. */
  public void show(List<PlacedGoal> newGoals, List<ContactDecal> newContacts) {
    goals = newGoals;
    contacts = newContacts;
  }

  /** Clears all trails. */
  public void clearTrails() {
    trails.forEach(Trail::clear);
  }

  /**
   * Extends the trails to the positions of the drones in a snapshot.
   *
   * @param nanos time on any monotonic clock [ns]
   */
  public void advance(SimSnapshot snapshot, long nanos) {
    for (int i = 0; i < trails.size(); i++) {
      trails.get(i).advance(snapshot.drones().get(i), nanos);
    }
  }

  /**
   * Returns the overlay of a snapshot in drawing order: first the lines, then the translucent items
   * from the farthest to the nearest, because nearer items are blended over the items behind them.
   */
  public List<Instance> instances(SimSnapshot snapshot, Eye eye) {
    List<Instance> instances = new ArrayList<>();
    List<DroneSnapshot> drones = snapshot.drones();
    Vec3 camera = eye.pose().position();
    List<Integer> order = inDrawingOrder(drones);
    if (trailsShown) {
      for (int i : order) {
        instances.addAll(trails.get(i).instances(camera, emphasis(drones.get(i))));
      }
    }
    addGoalPlumbLines(instances, camera);
    for (int i : order) {
      DroneSnapshot drone = drones.get(i);
      Vec3 place = drone.state().motion().position();
      instances.addAll(plumbLines.get(i).from(place, camera, emphasis(drone)));
      if (goalLineShown) {
        addGoalLine(instances, drone, camera);
      }
    }
    markers(drones, eye).stream()
        .sorted(Comparator.comparingDouble(OverlayItem::distance).reversed())
        .map(OverlayItem::instance)
        .forEach(instances::add);
    return instances;
  }

  /** Adds plumb lines below the balls that are in the air and have not been reached yet. */
  private void addGoalPlumbLines(List<Instance> instances, Vec3 camera) {
    for (PlacedGoal goal : goals) {
      if (goal.state() != GoalState.DONE
          && goal.place() instanceof PlacedGoal.Ball ball
          && ball.middle().z() > ball.radius()) {
        Vec3 bottom = ball.middle().plusScaled(Vec3.UP, -ball.radius());
        boolean active = goal.state() == GoalState.ACTIVE;
        Emphasis emphasis = active ? Emphasis.NORMAL : Emphasis.FAINT;
        instances.add(PlumbLine.line(bottom, camera, emphasis));
      }
    }
  }

  /**
   * Returns the indices of the drones. The selected drone comes first, so its path is visible
   * through the paths of the others.
   */
  private List<Integer> inDrawingOrder(List<DroneSnapshot> drones) {
    return IntStream.range(0, drones.size())
        .boxed()
        .sorted(Comparator.comparing(i -> emphasis(drones.get(i)) != Emphasis.STRONG))
        .toList();
  }

  private Emphasis emphasis(DroneSnapshot drone) {
    if (chosen.isEmpty()) {
      return Emphasis.NORMAL;
    }
    return chosen.getAsInt() == drone.state().drone() ? Emphasis.STRONG : Emphasis.FAINT;
  }

  private void addGoalLine(List<Instance> instances, DroneSnapshot drone, Vec3 camera) {
    Vec3 from = drone.state().motion().position().plusScaled(Vec3.UP, MIDDLE);
    PlacedGoal.next(goals, drone.state().drone())
        .flatMap(mark -> goalLine.of(from, mark.place().middle(), color(mark), camera))
        .ifPresent(instances::add);
  }

  private List<OverlayItem> markers(List<DroneSnapshot> drones, Eye eye) {
    List<OverlayItem> markers = new ArrayList<>(goalMarkers.of(goals, this::color, eye));
    for (ContactDecal contact : contacts) {
      markers.add(contactMarkers.of(contact, eye));
    }
    for (int i = 0; i < rings.size(); i++) {
      Pose drone = drones.get(i).state().motion().pose();
      Emphasis emphasis = emphasis(drones.get(i));
      rings.get(i).around(drone, emphasis, eye).ifPresent(markers::add);
      if (!tags.isEmpty()) {
        double clear = rings.get(i).reach(drone, emphasis, eye);
        markers.add(tags.get(i).above(drone, clear, emphasis, eye));
      }
    }
    Map<Vec3, Integer> at = new HashMap<>();
    for (PlacedGoal mark : goals) {
      int aside = at.merge(mark.place().middle(), 1, Integer::sum) - 1;
      markers.add(goalTags.of(mark, color(mark), aside, eye));
    }
    return markers;
  }

  private Rgb color(PlacedGoal mark) {
    Rgb ofAny = OverlayColors.of(mark.state());
    return OverlayColors.of(mark, drone -> colors.getOrDefault(drone, ofAny));
  }
}
