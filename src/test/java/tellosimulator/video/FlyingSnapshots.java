package tellosimulator.video;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;

/** Snapshots of simulations in the default room, with drones in the air at any poses. */
final class FlyingSnapshots {

  private FlyingSnapshots() {}

  /** Returns a snapshot of drones that fly, at rest. */
  static SimSnapshot flying(Pose... poses) {
    return flying(Decor.DEFAULT, poses);
  }

  /** Returns a snapshot of drones that fly in a room with other decor. */
  static SimSnapshot flying(Decor decor, Pose... poses) {
    return flying(Arena.DEFAULT.withDecor(decor), poses);
  }

  /** Returns a snapshot of drones that fly in a room with other content. */
  static SimSnapshot flying(Arena arena, Pose... poses) {
    List<Pose> starts = Formation.row(poses.length, Vec3.ZERO, arena.room());
    SimConfig config = SimConfig.DEFAULT.withRoom(arena.room(), starts).withArena(arena);
    Simulation simulation = new Simulation(config, number -> datagram -> {}, List.of());
    SimSnapshot snapshot = simulation.snapshot();
    List<DroneSnapshot> drones = new ArrayList<>();
    for (int i = 0; i < poses.length; i++) {
      DroneSnapshot drone = snapshot.drones().get(i);
      drones.add(drone.withState(flying(drone.state(), poses[i])));
    }
    return snapshot.withDrones(drones);
  }

  private static DroneState flying(DroneState state, Pose pose) {
    return new DroneState(
        state.drone(),
        state.time(),
        Motion.restingAt(pose),
        FlightPhase.FLYING,
        state.energy(),
        state.reference(),
        state.perception(),
        state.video());
  }
}
