package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SimulatedDrones;

/** Tests the visible effects of {@code EXT led} and {@code EXT mled}. */
class ExtensionBoardTest {

  private final SceneBuilder scenes = new SceneBuilder();

  @Test
  void onlyATtHasABoard() {
    SimulatedDrones tt = drones(Profile.TT);
    SimulatedDrones edu = drones(Profile.EDU);

    // case, lamp and matrix
    assertThat(scenes.scene(tt.snapshot()).drones())
        .hasSize(scenes.scene(edu.snapshot()).drones().size() + 3);
  }

  @Test
  void itsLampHasTheColorThatWasAskedFor() {
    SimulatedDrones tt = drones(Profile.TT);
    assertThat(tt.fly("command", "EXT led 255 0 255")).containsExactly("ok", "led ok");

    assertThat(texels(scenes.scene(tt.snapshot()))).anyMatch(argb -> argb == 0xffff00ff);
    assertThat(tt.fly("EXT led 0 255 0")).containsExactly("led ok");
    assertThat(texels(scenes.scene(tt.snapshot())))
        .noneMatch(argb -> argb == 0xffff00ff)
        .anyMatch(argb -> argb == 0xff00ff00);
  }

  @Test
  void itsMatrixHasThePatternThatWasAskedFor() {
    SimulatedDrones tt = drones(Profile.TT);
    tt.fly("command");
    long dark = red(tt);

    assertThat(tt.fly("EXT mled g rrrrrrrr")).containsExactly("matrix ok");
    long eight = red(tt);
    tt.fly("EXT mled g rrrr");

    assertThat(dark).isZero();
    // a dot of 64 texels is lit in about half of them
    assertThat(eight).isBetween(8 * 20L, 8 * 64L);
    assertThat(red(tt)).isEqualTo(eight / 2);
    tt.fly("EXT mled sl 0");
    assertThat(red(tt)).isZero();
  }

  @Test
  void equalMomentsHaveEqualPartsAndATextMoves() {
    SimulatedDrones tt = drones(Profile.TT);
    tt.fly("command", "EXT mled l b 2.5 TT");

    Scene before = scenes.scene(tt.snapshot());
    assertThat(scenes.scene(tt.snapshot()).drones()).isEqualTo(before.drones());
    tt.advance(0.5); // more than a dot
    assertThat(scenes.scene(tt.snapshot()).drones()).isNotEqualTo(before.drones());
  }

  @Test
  void itsOwnCameraDoesNotSeeIt() {
    SimulatedDrones tt = drones(Profile.TT);

    assertThat(scenes.scene(tt.snapshot(), 1).drones()).isEmpty();
  }

  @Test
  void whatAnotherDroneWasToldIsRefused() {
    SimulatedDrones edu = drones(Profile.EDU);

    assertThat(edu.fly("command", "EXT led 1 2 3").get(1)).startsWith("unknown command");
    assertThat(edu.snapshot().drones().get(0).state().lights().lampRgb(edu.snapshot().time()))
        .isZero();
  }

  private long red(SimulatedDrones drones) {
    return texels(scenes.scene(drones.snapshot())).stream()
        .filter(argb -> (argb & 0xffffff) == 0xff3020)
        .count();
  }

  private static List<Integer> texels(Scene scene) {
    return scene.drones().stream()
        .map(Instance::part)
        .flatMap(part -> Arrays.stream(part.material().texture().argbArray()).boxed())
        .toList();
  }

  private static SimulatedDrones drones(Profile profile) {
    return new SimulatedDrones(SimConfig.DEFAULT.withProduct(profile, Behavior.REPORT), List.of());
  }
}
