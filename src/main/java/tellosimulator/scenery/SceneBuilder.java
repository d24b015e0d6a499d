package tellosimulator.scenery;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.ConcurrentHashMap;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.profile.Profile;
import tellosimulator.scenery.drone.DroneParts;
import tellosimulator.scenery.drone.Enlargement;
import tellosimulator.scenery.drone.ExtensionBoard;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.drone.PropellerSpin;
import tellosimulator.scenery.drone.StatusLight;
import tellosimulator.scenery.furniture.FloorShadows;
import tellosimulator.scenery.furniture.Furniture;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.pad.PadDecals;
import tellosimulator.scenery.room.BlobShadow;
import tellosimulator.scenery.room.Interior;
import tellosimulator.scenery.room.StartDecal;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.world.Arena;

/**
 * Builds the scene of a snapshot. Equal snapshots give equal scenes. Static meshes and textures are
 * cached, so all cameras should share one builder. People and drones see the same room; only people
 * see the slab on which it stands. Thread-safe.
 */
public final class SceneBuilder {

  private final Interior interior = new Interior();
  private final PadDecals pads = new PadDecals();
  private final BlobShadow shadows = new BlobShadow();
  private final Furniture furniture = new Furniture();
  private final ExtensionBoard boards = new ExtensionBoard();
  private final FloorShadows floorShadows = new FloorShadows();

  /**
   * The start decals by colour. The key is the ARGB value rather than the record, because hashing a
   * record uses slow reflection on first use.
   */
  private final Map<Integer, StartDecal> startMarks = new ConcurrentHashMap<>();

  private final Map<Integer, DroneParts> parts = new ConcurrentHashMap<>();

  /** Returns the scene for people, without an overlay. */
  public Scene scene(SimSnapshot snapshot) {
    return scene(snapshot, OptionalInt.empty(), Optional.empty());
  }

  /**
   * Returns the scene, without an overlay, for people who look from a given position. Drones that
   * would be hard to see from that position are enlarged.
   *
   * @param eye position of the viewer in the room frame
   */
  public Scene scene(SimSnapshot snapshot, Vec3 eye) {
    return scene(snapshot, OptionalInt.empty(), Optional.of(eye));
  }

  /**
   * Returns the scene for the camera of a drone: without the drone itself, but with its shadow.
   *
   * @param drone the drone's number, from 1
   */
  public Scene scene(SimSnapshot snapshot, int drone) {
    return scene(snapshot, OptionalInt.of(drone), Optional.empty());
  }

  private Scene scene(SimSnapshot snapshot, OptionalInt without, Optional<Vec3> eye) {
    Arena arena = snapshot.arena();
    List<Instance> obstacles = furniture.instances(arena.obstacles());
    int count = snapshot.drones().size();
    List<DrawnDrone> seen =
        snapshot.drones().stream()
            .filter(drone -> without.isEmpty() || without.getAsInt() != drone.state().drone())
            .map(
                drone ->
                    new DrawnDrone(
                        drone, eye.map(from -> Enlargement.of(drone, count, from)).orElse(1.0)))
            .toList();
    List<Instance> drones = new ArrayList<>();
    seen.forEach(drone -> addBody(drones, drone));
    if (without.isEmpty()) {
      seen.forEach(drone -> addGlow(drones, drone));
    }
    seen.forEach(drone -> addPropellers(drones, drone)); // last, because they may be translucent
    return new Scene(
        without.isEmpty()
            ? interior.onSlab(arena.room(), arena.decor())
            : interior.instances(arena.room(), arena.decor()),
        ground(snapshot, obstacles),
        obstacles,
        drones,
        List.of());
  }

  private List<Instance> ground(SimSnapshot snapshot, List<Instance> obstacles) {
    Arena arena = snapshot.arena();
    List<Instance> ground = new ArrayList<>(floorShadows.instances(arena.room(), obstacles));
    ground.addAll(pads.instances(arena.room(), arena.pads()));
    for (DroneSnapshot drone : snapshot.drones()) {
      Rgb color = Livery.of(drone).color();
      StartDecal mark = startMarks.computeIfAbsent(color.argb(), argb -> new StartDecal(color));
      ground.add(mark.at(drone.start()));
      ground.add(shadows.of(arena, drone.state().motion().position()));
    }
    return ground;
  }

  private void addBody(List<Instance> instances, DrawnDrone drawn) {
    DroneSnapshot drone = drawn.drone();
    DroneParts own = parts(drone);
    instances.add(drawn.instance(own.body()));
    instances.add(drawn.instance(own.lamp(StatusLight.seen(drone))));
    if (drone.product().profile() == Profile.TT) {
      boards.parts(drone.state()).forEach(part -> instances.add(drawn.instance(part)));
    }
  }

  private void addGlow(List<Instance> instances, DrawnDrone drawn) {
    StatusLight light = StatusLight.seen(drawn.drone());
    if (light != StatusLight.DARK) {
      instances.add(drawn.instance(parts(drawn.drone()).glow(light)));
    }
  }

  private void addPropellers(List<Instance> instances, DrawnDrone drawn) {
    DroneParts own = parts(drawn.drone());
    DroneState state = drawn.drone().state();
    PropellerSpin spin = PropellerSpin.of(state.phase(), state.time().seconds());
    for (int i = 0; i < own.propellers().size(); i++) {
      Attitude turned = Attitude.ofHeading(own.heading(i, spin.angle()));
      instances.add(
          drawn.instance(own.propeller(i, spin.blurred()), own.propellers().get(i), turned));
    }
  }

  /** Creates the parts on first use, because the camera of a lone drone never needs them. */
  private DroneParts parts(DroneSnapshot drone) {
    Rgb cover = Livery.of(drone).cover();
    return parts.computeIfAbsent(cover.argb(), argb -> new DroneParts(cover));
  }

  /**
   * A drone to be drawn.
   *
   * @param scale factor by which all of its parts are enlarged about its feet
   */
  private record DrawnDrone(DroneSnapshot drone, double scale) {

    /** Creates an instance of a part whose mesh is in the body frame. */
    Instance instance(Part part) {
      return new Instance(part, drone.state().motion().pose(), scale, 1);
    }

    /**
     * Creates an instance of a part that is rotated about its own origin.
     *
     * @param place position of the part's origin in the body frame [m]
     */
    Instance instance(Part part, Vec3 place, Attitude turned) {
      Pose pose = drone.state().motion().pose();
      Vec3 offset = pose.attitude().toRoom(place).times(scale);
      Pose own = new Pose(pose.position().plus(offset), pose.attitude().after(turned));
      return new Instance(part, own, scale, 1);
    }
  }
}
