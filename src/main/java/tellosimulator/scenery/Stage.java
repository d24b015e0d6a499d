package tellosimulator.scenery;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.ConcurrentHashMap;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.scenery.drone.DroneParts;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.drone.PropellerSpin;
import tellosimulator.scenery.drone.StatusLight;
import tellosimulator.scenery.furniture.Furniture;
import tellosimulator.scenery.pad.PadCards;
import tellosimulator.scenery.room.GroundMark;
import tellosimulator.scenery.room.Interior;
import tellosimulator.scenery.room.Underneath;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * Makes the scene of a moment. The same moment always gives the same scene. It keeps what does not
 * change from picture to picture, so that all cameras share one of them. For any thread.
 */
public final class Stage {

  private static final Pose ORIGIN = new Pose(Vec3.ZERO, Attitude.LEVEL);

  /** The latest room. */
  private record Furnished(Room room, Decor decor, List<Placed> parts) {}

  private final Underneath underneath = new Underneath();
  private final Interior interior = new Interior();
  private final PadCards pads = new PadCards();
  private final Furniture furniture = new Furniture();
  private final Map<Livery, DroneParts> figures = new ConcurrentHashMap<>();
  private final Map<Livery, GroundMark> marks = new ConcurrentHashMap<>();
  private volatile Furnished furnished;

  /** Everything that can be seen at a moment. */
  public Scene scene(SimSnapshot snapshot) {
    return scene(snapshot, OptionalInt.empty());
  }

  /**
   * What the camera on a drone sees: everything but this drone, whose shadow it does see.
   *
   * @param drone its number, from 1
   */
  public Scene scene(SimSnapshot snapshot, int drone) {
    return scene(snapshot, OptionalInt.of(drone));
  }

  private Scene scene(SimSnapshot snapshot, OptionalInt without) {
    Arena arena = snapshot.arena();
    List<Placed> parts = new ArrayList<>(room(snapshot));
    parts.addAll(pads.placed(arena.room(), arena.pads()));
    for (DroneSnapshot drone : snapshot.drones()) {
      addMarks(parts, arena, drone);
    }
    parts.addAll(furniture.placed(arena.obstacles()));
    List<DroneSnapshot> seen =
        snapshot.drones().stream()
            .filter(drone -> without.isEmpty() || without.getAsInt() != drone.state().drone())
            .toList();
    seen.forEach(drone -> addBody(parts, drone));
    seen.forEach(drone -> addPropellers(parts, drone)); // last, because they may be sheer
    return new Scene(parts);
  }

  private List<Placed> room(SimSnapshot snapshot) {
    Room room = snapshot.room();
    Decor decor = snapshot.decor();
    Furnished known = furnished;
    if (known == null || !known.room.equals(room) || !known.decor.equals(decor)) {
      List<Placed> parts =
          interior.parts(room, decor).stream().map(part -> new Placed(part, ORIGIN)).toList();
      known = new Furnished(room, decor, parts);
      furnished = known;
    }
    return known.parts;
  }

  private void addMarks(List<Placed> parts, Arena arena, DroneSnapshot drone) {
    GroundMark mark = marks.computeIfAbsent(Livery.of(drone), GroundMark::new);
    parts.add(mark.start(drone.start()));
    parts.add(GroundMark.shadow(underneath, arena, drone.state().motion().position()));
  }

  private void addBody(List<Placed> parts, DroneSnapshot drone) {
    DroneParts figure = figure(drone);
    DroneState state = drone.state();
    Pose pose = state.motion().pose();
    parts.add(new Placed(figure.body(), pose));
    parts.add(new Placed(figure.lamp(StatusLight.seen(drone)), pose));
  }

  private void addPropellers(List<Placed> parts, DroneSnapshot drone) {
    DroneParts figure = figure(drone);
    DroneState state = drone.state();
    Pose pose = state.motion().pose();
    double seconds = state.time().seconds();
    PropellerSpin spin = PropellerSpin.steady(state.phase(), state.motion(), seconds);
    for (int i = 0; i < figure.propellers().size(); i++) {
      Vec3 middle = pose.attitude().toRoom(figure.propellers().get(i));
      Attitude turned = Attitude.ofHeading(figure.heading(i, spin.angle()));
      parts.add(
          new Placed(
              figure.propeller(i, spin.blurred()),
              new Pose(pose.position().plus(middle), pose.attitude().after(turned))));
    }
  }

  /** Made when it is first seen, which the camera on the only drone never does. */
  private DroneParts figure(DroneSnapshot drone) {
    return figures.computeIfAbsent(Livery.of(drone), DroneParts::new);
  }
}
