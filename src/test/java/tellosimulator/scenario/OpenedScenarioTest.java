package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.SimConfig;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;

class OpenedScenarioTest {

  private static final ScenarioDocument SLALOM = Gallery.open("slalom").orElseThrow();

  @Test
  void optionsAreNoEditsAndDoNotGetIntoAFile() {
    SimConfig config = SLALOM.scenario().config();
    Scenario applied =
        SLALOM
            .scenario()
            .withConfig(
                config
                    .withTimeFactor(TimeFactor.MAX)
                    .withProduct(Profile.TT, Behavior.MEASURED)
                    .withDecor(config.arena().decor().withGrid(0.2)));
    OpenedScenario opened = OpenedScenario.of(SLALOM, Path.of("slalom.yaml")).with(applied);

    assertThat(opened.unsaved(applied)).isFalse();
    assertThat(opened.toSave(applied)).isEqualTo(SLALOM.scenario());

    Arena larger = applied.config().arena().withRoom(new Room(5, 7, 3));
    Scenario edited = applied.withConfig(applied.config().withArena(larger));
    assertThat(opened.unsaved(edited)).isTrue();
    assertThat(opened.toSave(edited))
        .isEqualTo(
            SLALOM
                .scenario()
                .withConfig(config.withArena(config.arena().withRoom(new Room(5, 7, 3)))));
  }

  @Test
  void aRoomThatNobodyOpenedIsWorthAQuestionOnlyWithThingsInIt() {
    Scenario empty = Scenario.of(SimConfig.DEFAULT);
    OpenedScenario opened = OpenedScenario.once(empty);
    Arena arena = Arena.DEFAULT.withRoom(new Room(5, 7, 3));

    assertThat(opened.unsaved(empty.withConfig(SimConfig.DEFAULT.withArena(arena)))).isFalse();

    Arena furnished = arena.withPads(List.of(MissionPad.onFloor(1, Vec3.ZERO, 0)));
    assertThat(opened.unsaved(empty.withConfig(SimConfig.DEFAULT.withArena(furnished)))).isTrue();
  }
}
