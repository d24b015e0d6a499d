package tellosimulator.scenery.overlay;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.world.Room;

/** Tests the visual aids that people see in the room, and drones do not. */
class OverlayTest {

  private static final Eye CAMERA = new Eye(new Pose(new Vec3(-2, 0, 1), Attitude.LEVEL), 0.1);

  private static final Peer OPERATOR =
      new Peer(SteppedDrone.address("127.0.0.1", 50_000), SteppedDrone.DRONE);

  private final Simulation simulation = simulation(SimConfig.DEFAULT);
  private final Overlay overlay = new Overlay(snapshot());
  private long nanos;

  @Test
  void nothingIsAddedToADroneOnTheGround() {
    assertThat(overlay.instances(snapshot(), CAMERA)).isEmpty();
  }

  @Test
  void aDroneInTheAirHasAPlumbLineAndATrail() {
    fly();

    int withTrail = overlay.instances(snapshot(), CAMERA).size();
    overlay.showTrails(false);

    assertThat(overlay.instances(snapshot(), CAMERA))
        .as("the plumb line and its target")
        .hasSize(2);
    assertThat(withTrail).isGreaterThan(2);
  }

  @Test
  void whatWasFlownWhileTrailsWereHiddenIsShownAfterwards() {
    overlay.showTrails(false);
    fly();

    overlay.showTrails(true);

    List<Instance> instances = overlay.instances(snapshot(), CAMERA);
    assertThat(instances).hasSizeGreaterThan(2);
    double highest =
        instances.stream()
            .map(instance -> instance.part().mesh())
            .flatMap(mesh -> IntStream.range(0, mesh.positions()).mapToObj(mesh::position))
            .mapToDouble(Vec3::z)
            .max()
            .orElseThrow();
    assertThat(highest).isGreaterThan(1.5); // takeoff and 150 cm up; the plumb line is a unit mesh
  }

  @Test
  void aTrailThatDidNotChangeIsTheSameMesh() {
    fly();

    List<Instance> before = overlay.instances(snapshot(), CAMERA);
    nanos += 1_000_000_000;
    overlay.advance(snapshot(), nanos);

    assertThat(overlay.instances(snapshot(), CAMERA)).isEqualTo(before);
  }

  @Test
  void aTrailIsFinerInTheRoomWhenItIsSeenFromNear() {
    fly();

    double afar = thickness(overlay.instances(snapshot(), from(-8, 1)));
    List<Instance> near = overlay.instances(snapshot(), from(-2, 1));

    assertThat(thickness(near)).isLessThan(0.5 * afar);
    assertThat(overlay.instances(snapshot(), from(-2.05, 1)).get(0).part())
        .as("no other mesh for each step")
        .isSameAs(near.get(0).part());
  }

  /** Returns the thickness of a trail straight up, the first of all instances [m]. */
  private static double thickness(List<Instance> instances) {
    Mesh trail = instances.get(0).part().mesh();
    DoubleSummaryStatistics across =
        IntStream.range(0, trail.positions())
            .mapToDouble(i -> trail.position(i).y())
            .summaryStatistics();
    return across.getMax() - across.getMin();
  }

  @Test
  void pathAndPlumbLineOfADroneBesideTheChosenOneAreFaint() {
    SimConfig two =
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT));
    Simulation pair = simulation(two);
    Overlay several = new Overlay(pair.snapshot());
    fly(pair, several);

    // dashes have 0.75 * 255 = 191
    assertThat(opacities(several, pair)).containsExactly(255, 255, 255, 191);
    several.choose(1);
    assertThat(opacities(several, pair)).containsExactly(255, 255, 255, 191);
    several.choose(2); // 0.35 * 255 = 89, and 0.35 * 191 = 67
    assertThat(opacities(several, pair)).containsExactly(89, 89, 89, 67);
  }

  /**
   * Returns the alpha, 0 to 255, of both parts of the path of the only flying drone, of its target
   * and of its plumb line.
   */
  private static List<Integer> opacities(Overlay overlay, Simulation simulation) {
    return overlay.instances(simulation.snapshot(), CAMERA).stream()
        .limit(4)
        .map(one -> one.part().material().texture().argbArray())
        .map(texels -> Arrays.stream(texels).map(argb -> argb >>> 24).max().orElseThrow())
        .toList();
  }

  @Test
  void ringAndTagOfTheChosenDroneOfSeveralStandOut() {
    SimConfig three =
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(3, Vec3.ZERO, Room.DEFAULT));
    SimSnapshot snapshot = simulation(three).snapshot();
    Eye afar = new Eye(new Pose(new Vec3(-5, 0, 1), Attitude.LEVEL), 0.1);
    Overlay several = new Overlay(snapshot);
    List<Instance> before = several.instances(snapshot, afar);

    several.choose(2);
    List<Instance> after = several.instances(snapshot, afar);

    assertThat(after).hasSameSizeAs(before);
    assertThat(before.stream().filter(one -> !after.contains(one)))
        .as("its ring and its tag")
        .hasSize(2);
    assertThat(before).as("the tag is in front").doesNotContain(after.get(after.size() - 1));
    List<Instance> alone = overlay.instances(snapshot(), afar);
    overlay.choose(1);
    assertThat(overlay.instances(snapshot(), afar)).isEqualTo(alone);
  }

  @Test
  void onlyDronesThatCouldBeTakenForEachOtherHaveNumbers() {
    SimConfig three =
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(3, Vec3.ZERO, Room.DEFAULT));
    SimSnapshot snapshot = simulation(three).snapshot();

    assertThat(new Overlay(snapshot).instances(snapshot, CAMERA)).hasSize(3);
  }

  @Test
  void aDroneThatIsSmallHasARing() {
    assertThat(overlay.instances(snapshot(), from(-4, 1))).hasSize(1);
    assertThat(overlay.instances(snapshot(), from(-2, 1))).isEmpty();
  }

  private static Eye from(double x, double z) {
    return new Eye(new Pose(new Vec3(x, 0, z), Attitude.LEVEL), 0.1);
  }

  private void fly() {
    fly(simulation, overlay);
  }

  /** Takes off with the first drone, and moves up by 150 cm. */
  private void fly(Simulation simulation, Overlay overlay) {
    simulation.control(new Control.Power(1, true));
    for (String command : List.of("command", "takeoff", "up 150")) {
      simulation.submit(1, OPERATOR, WireText.encode(command));
      for (int i = 0; i < 2000; i++) { // ten seconds
        simulation.drain();
        simulation.step();
        nanos += 5_000_000;
        overlay.advance(simulation.snapshot(), nanos);
      }
    }
  }

  private SimSnapshot snapshot() {
    return simulation.snapshot();
  }

  private static Simulation simulation(SimConfig config) {
    return new Simulation(config, drone -> datagram -> {}, List.of());
  }
}
