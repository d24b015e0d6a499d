package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.SimConfig;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;

class EditedScenarioTest {

  private static final Goal LAND = new Goal.Land(Terms.ANY, new GoalRegion(Vec3.ZERO, 0.3));
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

    assertThat(EditedScenario.of(opened).unsaved()).isFalse();
    assertThat(EditedScenario.of(opened).toSave()).isEqualTo(SLALOM.scenario());

    Arena larger = applied.config().arena().withRoom(new Room(5, 7, 3));
    Scenario edited = applied.withConfig(applied.config().withArena(larger));
    assertThat(edited(opened, edited).unsaved()).isTrue();
    assertThat(edited(opened, edited).toSave())
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

    Scenario larger = empty.withConfig(SimConfig.DEFAULT.withArena(arena));
    assertThat(edited(opened, larger).unsaved()).isFalse();

    Arena furnished = arena.withPads(List.of(MissionPad.onFloor(1, Vec3.ZERO, 0)));
    Scenario withPad = empty.withConfig(SimConfig.DEFAULT.withArena(furnished));
    assertThat(edited(opened, withPad).unsaved()).isTrue();
    Scenario withGoal = empty.withChallenge(Challenge.NONE.withGoals(List.of(LAND)));
    assertThat(edited(opened, withGoal).unsaved()).isTrue();

    EditedScenario plain = EditedScenario.of(opened);
    DroneOrigin origin = plain.origins().get(0);
    PlannedDrone drone = new PlannedDrone(origin, empty.config().drones().get(0).start());
    assertThat(planned(plain, drone).unsaved()).isFalse();
    assertThat(planned(plain, drone, drone).unsaved()).isTrue();
    PlannedDrone red = new PlannedDrone(origin.painted(0xff0000), drone.start());
    assertThat(planned(plain, red).unsaved()).isTrue();
  }

  private static EditedScenario planned(EditedScenario edited, PlannedDrone... drones) {
    return edited.planned(
        edited.present().config().arena(), List.of(drones), edited.present().challenge());
  }

  private static EditedScenario edited(OpenedScenario opened, Scenario present) {
    return new EditedScenario(opened, present, EditedScenario.of(opened).origins());
  }

  /** Removes the second drone and adds a copy of the first: the values of options are not saved. */
  @Test
  void plannedDronesTakeNoOptionsIntoAFile() throws Exception {
    ScenarioDocument document =
        ScenarioFile.open(
            "two.yaml",
            new ByteArrayInputStream(
                """
                drones:
                  - {start: [0, 0], command-port: 9000}
                  - {start: [100, 0], profile: tt, colour: "#ff0000"}
                """
                    .getBytes(StandardCharsets.UTF_8)));
    Scenario written = document.scenario();
    Scenario applied =
        written.withConfig(written.config().withProduct(Profile.TELLO, Behavior.MEASURED));
    EditedScenario opened =
        EditedScenario.of(OpenedScenario.of(document, Path.of("two.yaml")).with(applied));
    DroneOrigin first = opened.origins().get(0);
    Pose beside = new Pose(new Vec3(0, 1, 0), Attitude.LEVEL);

    EditedScenario planned =
        opened.planned(
            applied.config().arena(),
            List.of(
                new PlannedDrone(first, applied.config().drones().get(0).start()),
                new PlannedDrone(first.another(), beside)),
            applied.challenge());

    assertThat(planned.present().config().drones())
        .extracting(drone -> drone.product().behavior())
        .containsOnly(Behavior.MEASURED);
    Scenario saved = planned.toSave();
    assertThat(saved.config().drones().get(0)).isEqualTo(written.config().drones().get(0));
    assertThat(saved.config().drones().get(1))
        .isEqualTo(written.config().drones().get(0).withStart(beside));
    assertThat(saved.stations().get(1)).isEqualTo(written.stations().get(0));
    assertThat(planned.unsaved()).isTrue();

    EditedScenario back =
        planned.planned(
            applied.config().arena(),
            List.of(
                new PlannedDrone(first, applied.config().drones().get(0).start()),
                new PlannedDrone(
                    opened.origins().get(1), applied.config().drones().get(1).start())),
            applied.challenge());
    assertThat(back.toSave()).isEqualTo(written);
    assertThat(back.unsaved()).isFalse();
  }

  @Test
  void whatIsSavedIsWhatFurtherChangesAreComparedWith() {
    EditedScenario edited =
        edited(
            OpenedScenario.of(SLALOM, Path.of("slalom.yaml")),
            SLALOM.scenario().withChallenge(Challenge.NONE));
    Path file = Path.of("other.yaml");
    ScenarioDocument document = SLALOM.changedTo(edited.toSave(), Path.of(""));

    EditedScenario saved = edited.savedAs(document, file);

    assertThat(saved.unsaved()).isFalse();
    assertThat(saved.opened().file()).contains(file);
    assertThat(saved.toSave().challenge().goals()).isEmpty();
  }
}
