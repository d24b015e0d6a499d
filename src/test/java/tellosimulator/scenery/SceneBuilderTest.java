package tellosimulator.scenery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.world.Room;

class SceneBuilderTest {

  /** Body, lamp and four propellers. */
  private static final int PARTS_OF_DRONE = 6;

  private final SceneBuilder scenes = new SceneBuilder();

  @Test
  void aDroneDoesNotSeeItselfButTheOthersAndAllShadows() {
    SimSnapshot two = drones(2);

    Scene everything = scenes.scene(two);
    Scene fromFirst = scenes.scene(two, 1);

    assertThat(fromFirst.drones()).hasSize(everything.drones().size() - PARTS_OF_DRONE);
    assertThat(lit(everything)).hasSize(2 + 2 * 4);
    assertThat(lit(fromFirst)).hasSize(1 + 4).allMatch(part -> isNear(part, start(two, 2)));
    assertThat(fromFirst.ground()).isEqualTo(everything.ground());
  }

  @Test
  void peopleSeeACalmRoomAndDronesATexturedOne() {
    SimSnapshot one = drones(1);

    List<Instance> seen = scenes.scene(one).room();
    List<Instance> filmed = scenes.scene(one, 1).room();

    assertThat(seen.get(0).part().material()).isNotEqualTo(filmed.get(0).part().material());
    assertThat(scenes.scene(one).room()).isSameAs(seen);
    assertThat(scenes.scene(one, 1).room()).isSameAs(filmed);
  }

  @Test
  void onlyPeopleSeeALitLampGlow() {
    SimSnapshot one = flying(new Pose(new Vec3(0, 0, 1), Attitude.LEVEL));
    int another = 2;

    assertThat(translucent(scenes.scene(one))).as("four propellers and the glow").hasSize(5);
    assertThat(translucent(scenes.scene(one, another))).as("four propellers").hasSize(4);
  }

  private static List<Instance> translucent(Scene scene) {
    return scene.drones().stream()
        .filter(part -> part.part().material().shading() == Shading.TRANSLUCENT)
        .toList();
  }

  @Test
  void theBodyIsWhereTheDroneIs() {
    Pose pose = new Pose(new Vec3(1, -0.5, 1.2), Attitude.ofHeading(1));

    Scene scene = scenes.scene(flying(pose));

    Instance body = lit(scene).get(0);
    assertThat(body.pose()).isEqualTo(pose);
    assertThat(body.scale()).isEqualTo(new Vec3(1, 1, 1));
  }

  @Test
  void fromAfarADroneIsDrawnLargerAboutItsFeet() {
    SimSnapshot flying = flying(new Pose(new Vec3(1, 0, 1), Attitude.ofHeading(1)));
    List<Instance> lifeSize = scenes.scene(flying).drones();

    List<Instance> near = scenes.scene(flying, new Vec3(0, 0, 1)).drones();
    List<Instance> far = scenes.scene(flying, new Vec3(-5, 0, 1)).drones();

    assertThat(near).as("from 1 m").isEqualTo(lifeSize);
    double factor = 0.06 * 6 / (0.0925 + 2 * 0.0405); // 60 thousandths of 6 m, for 173.5 mm
    assertThat(far).hasSameSizeAs(lifeSize);
    for (int i = 0; i < far.size(); i++) {
      Vec3 feet = new Vec3(1, 0, 1);
      Vec3 offset = lifeSize.get(i).pose().position().minus(feet).times(factor);
      assertThat(far.get(i).pose().position().distanceTo(feet.plus(offset))).isLessThan(1e-9);
      assertThat(far.get(i).pose().attitude()).isEqualTo(lifeSize.get(i).pose().attitude());
      assertThat(far.get(i).largestScale()).isCloseTo(factor, within(1e-9));
      assertThat(far.get(i).part()).isSameAs(lifeSize.get(i).part());
    }
  }

  @Test
  void itIsNeverDrawnSoLargeThatItFillsAGate() {
    SimSnapshot flying = flying(new Pose(Vec3.ZERO, Attitude.LEVEL));

    assertThat(scenes.scene(flying, new Vec3(-100, 0, 1)).drones())
        .allMatch(part -> part.largestScale() == 3);
  }

  @Test
  void amongManyItIsDrawnLessLarge() {
    Vec3 eye = new Vec3(-6, 0, 2);
    double alone = scenes.scene(drones(1), eye).drones().get(0).largestScale();
    double amongMany = scenes.scene(drones(20), eye).drones().get(0).largestScale();

    assertThat(amongMany).isLessThan(alone);
  }

  @Test
  void aDroneHasTheColorThatWasChosenForIt() {
    SimSnapshot one = drones(1);
    DroneSnapshot was = one.drones().get(0);
    DroneSnapshot green =
        new DroneSnapshot(
            was.state(),
            was.link(),
            was.product(),
            was.start(),
            OptionalInt.of(0x10c020),
            was.faults());

    Scene scene = scenes.scene(one.withDrones(List.of(green)));

    Texture white = lit(scenes.scene(one)).get(0).part().material().texture();
    Texture texture = lit(scene).get(0).part().material().texture();
    assertThat(texture.argbArray()).contains(0xff10c020);
    assertThat(white.argbArray()).doesNotContain(0xff10c020);
  }

  @Test
  void aFlyingDroneHasTranslucentDiscsAtTheEnd() {
    Pose pose = new Pose(new Vec3(0, 0, 1), Attitude.LEVEL);

    List<Instance> instances = scenes.scene(flying(pose)).drones();

    List<Instance> last = instances.subList(instances.size() - 4, instances.size());
    assertThat(last).allMatch(part -> part.part().material().shading() == Shading.TRANSLUCENT);
    // front left: half of 98 mm ahead, half of 92.5 mm to the left, 38.5 mm up
    assertThat(last.get(0).pose().position().distanceTo(new Vec3(0.049, 0.04625, 1.0385)))
        .isCloseTo(0, within(1e-9));
    assertThat(instances.subList(0, instances.size() - 5)) // preceded by the lamp's glow
        .noneMatch(part -> part.part().material().shading() == Shading.TRANSLUCENT);
  }

  @Test
  void theRoomIsMadeOnce() {
    Scene first = scenes.scene(drones(1));
    Scene second = scenes.scene(flying(new Pose(new Vec3(0, 0, 1), Attitude.LEVEL)));

    assertThat(second.instances().get(0)).isSameAs(first.instances().get(0));
  }

  @Test
  void anotherRoomIsShown() {
    SimSnapshot before = drones(1);
    scenes.scene(before);

    SimSnapshot after =
        new SimSnapshot(
            before.time(),
            before.clock(),
            before.seed(),
            before.arena().withRoom(new Room(9, 9, 3)),
            before.drones());

    Mesh floor = scenes.scene(after, 1).instances().get(0).part().mesh();
    assertThat(floor.position(0)).isEqualTo(new Vec3(-4.5, 4.5, 0));
    assertThat(scenes.scene(after).room())
        .anyMatch(one -> one.part().mesh().position(0).equals(new Vec3(-4.5, 4.5, 0)));
  }

  @Test
  void theRoomComesFirstThenDecalsThenTheRest() {
    List<Shading> order =
        scenes.scene(drones(2)).instances().stream()
            .map(part -> part.part().material().shading())
            .toList();

    assertThat(order.lastIndexOf(Shading.DECAL)).isLessThan(order.indexOf(Shading.GLOSSY));
    assertThat(order.get(0)).as("the shadow on the ground outside").isEqualTo(Shading.DECAL);
    assertThat(order.get(1)).isEqualTo(Shading.UNLIT);
  }

  private static List<Instance> lit(Scene scene) {
    return scene.instances().stream()
        .filter(part -> part.part().material().shading() == Shading.GLOSSY)
        .toList();
  }

  private static boolean isNear(Instance part, Vec3 place) {
    return part.pose().position().distanceTo(place) < 0.1;
  }

  private static Vec3 start(SimSnapshot snapshot, int drone) {
    return snapshot.drones().get(drone - 1).start().position();
  }

  private static SimSnapshot drones(int count) {
    SimConfig config =
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(count, Vec3.ZERO, Room.DEFAULT));
    return new Simulation(config, drone -> datagram -> {}, List.of()).snapshot();
  }

  private static SimSnapshot flying(Pose pose) {
    SimSnapshot one = drones(1);
    DroneSnapshot drone = one.drones().get(0);
    DroneState was = drone.state();
    DroneState now =
        new DroneState(
            was.drone(),
            was.time(),
            Motion.restingAt(pose),
            FlightPhase.FLYING,
            was.energy(),
            was.reference(),
            was.perception(),
            was.video());
    return new SimSnapshot(
        one.time(),
        one.clock(),
        one.seed(),
        one.arena(),
        List.of(new DroneSnapshot(now, drone.link(), drone.product(), drone.start())));
  }
}
