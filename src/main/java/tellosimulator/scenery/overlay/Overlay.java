package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * The overlay of a scene as one window shows it: trails, plumb lines, rings and drone tags; goals,
 * the way to the next one, and where drones touched something. It follows the drones from snapshot
 * to snapshot. For one thread at a time.
 */
public final class Overlay {

  /** Height above a drone's feet from which the line to its goal begins [m]: its middle. */
  private static final double MIDDLE = 0.02;

  private final List<Trail> trails = new ArrayList<>();
  private final List<PlumbLine> plumbLines = new ArrayList<>();
  private final List<HeadingRing> rings = new ArrayList<>();

  /** Empty where a drone is alone. */
  private final List<DroneTag> tags = new ArrayList<>();

  private final Map<Integer, Rgb> colors = new HashMap<>();
  private final GoalMarkers goalMarkers = new GoalMarkers();
  private final GoalTags goalTags = new GoalTags();
  private final GoalLine goalLine = new GoalLine();
  private final ContactMarkers contactMarkers = new ContactMarkers();
  private List<GoalMark> goals = List.of();
  private List<ContactMark> contacts = List.of();
  private OptionalInt chosen = OptionalInt.empty();
  private boolean trailsShown = true;
  private boolean goalLineShown = true;

  /**
   * @param first with as many drones as all that follow
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

  /** Shows the trails, or hides them. */
  public void showTrails(boolean shown) {
    trailsShown = shown;
  }

  /** Shows the line from each drone to its next goal, or hides it. */
  public void showGoalLine(boolean shown) {
    goalLineShown = shown;
  }

  /** Lets one of several drones stand out from now on, by its number; the others are fainter. */
  public void choose(int drone) {
    chosen = colors.size() > 1 ? OptionalInt.of(drone) : OptionalInt.empty();
  }

  /** Shows these goals and contacts from now on. */
  public void show(List<GoalMark> newGoals, List<ContactMark> newContacts) {
    goals = newGoals;
    contacts = newContacts;
  }

  /** Begins all trails anew. */
  public void clearTrails() {
    trails.forEach(Trail::clear);
  }

  /**
   * Moves on to a snapshot.
   *
   * @param nanos of any steady clock [ns]
   */
  public void advance(SimSnapshot snapshot, long nanos) {
    for (int i = 0; i < trails.size(); i++) {
      trails.get(i).advance(snapshot.drones().get(i), nanos);
    }
  }

  /**
   * The overlay of a snapshot, in drawing order: lines first, then what is translucent, the
   * farthest first, as the nearer is blended over it.
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
        .sorted(Comparator.comparingDouble(Marker::distance).reversed())
        .map(Marker::instance)
        .forEach(instances::add);
    return instances;
  }

  /** From balls in the air that are not done, so that one sees above what they hang. */
  private void addGoalPlumbLines(List<Instance> instances, Vec3 camera) {
    for (GoalMark goal : goals) {
      if (goal.state() != GoalState.DONE
          && goal.place() instanceof GoalMark.Ball ball
          && ball.middle().z() > ball.radius()) {
        Vec3 bottom = ball.middle().plusScaled(Vec3.UP, -ball.radius());
        boolean active = goal.state() == GoalState.ACTIVE;
        Emphasis emphasis = active ? Emphasis.NORMAL : Emphasis.FAINT;
        instances.add(PlumbLine.line(bottom, camera, emphasis));
      }
    }
  }

  /** Indices of the drones: first the chosen one, whose path is seen through those of others. */
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
    GoalMark.next(goals, drone.state().drone())
        .flatMap(mark -> goalLine.of(from, mark.place().middle(), color(mark), camera))
        .ifPresent(instances::add);
  }

  private List<Marker> markers(List<DroneSnapshot> drones, Eye eye) {
    List<Marker> markers = new ArrayList<>(goalMarkers.of(goals, this::color, eye));
    for (ContactMark contact : contacts) {
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
    for (GoalMark mark : goals) {
      int aside = at.merge(mark.place().middle(), 1, Integer::sum) - 1;
      markers.add(goalTags.of(mark, color(mark), aside, eye));
    }
    return markers;
  }

  private Rgb color(GoalMark mark) {
    Rgb ofAny = MarkColors.of(mark.state());
    return MarkColors.of(mark, drone -> colors.getOrDefault(drone, ofAny));
  }
}
