package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import tellosimulator.goal.Challenge;
import tellosimulator.scenario.Scenario.CommandAddress;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;

/**
 * An opened scenario, together with the changes that have since been made to its room, drones and
 * goals. Immutable.
 *
 * @param opened the scenario as it was opened or last saved
 * @param present the scenario as it is now
 * @param origins the origins of its drones, in the order of drone numbers
 */
public record EditedScenario(OpenedScenario opened, Scenario present, List<DroneOrigin> origins) {

  public EditedScenario {
    origins = List.copyOf(origins);
  }

  /** Creates an edited scenario without changes. */
  public static EditedScenario of(OpenedScenario opened) {
    Scenario scenario = opened.scenario();
    return new EditedScenario(
        opened, scenario, DroneOrigin.of(opened.document().scenario(), scenario));
  }

  /**
   * Returns a copy of this scenario, updated to the current state of its simulation.
   *
   * @param snapshot a snapshot with the same number of drones
   * @param challenge the current challenge
   */
  public EditedScenario in(SimSnapshot snapshot, Challenge challenge) {
    return new EditedScenario(opened, present.asIn(snapshot).withChallenge(challenge), origins);
  }

  /**
   * Returns a copy of this scenario with the room, drones and goals of a plan. The number of drones
   * may differ.
   */
  public EditedScenario planned(Arena arena, List<PlannedDrone> drones, Challenge challenge) {
    SimConfig config = present.config();
    List<DroneOrigin> left = new ArrayList<>(origins);
    List<DroneSetup> setups = new ArrayList<>();
    for (PlannedDrone drone : drones) {
      int index = left.indexOf(drone.origin());
      DroneSetup setup = index < 0 ? drone.origin().opened() : config.drones().get(index);
      if (index >= 0) {
        left.set(index, null); // so that drones with equal origins get different setups
      }
      setups.add(setup.withStart(drone.start()));
    }
    List<DroneOrigin> theirs = drones.stream().map(PlannedDrone::origin).toList();
    Scenario planned =
        new Scenario(
            present.description(),
            config.withArena(arena).withDrones(setups),
            theirs.stream().map(DroneOrigin::station).toList(),
            challenge);
    return new EditedScenario(opened, planned, theirs);
  }

  /** Returns a copy of this scenario whose source is the file to which it has just been saved. */
  public EditedScenario savedAs(ScenarioDocument document, Path file) {
    return new EditedScenario(OpenedScenario.of(document, file).with(present), present, origins);
  }

  /**
   * Returns the scenario to be saved. Values that have changed since the scenario was opened are
   * taken from the current scenario. All others are taken from the document, so that options are
   * not saved.
   */
  public Scenario toSave() {
    Scenario written = opened.document().scenario();
    Scenario was = opened.scenario();
    List<DroneSetup> drones = new ArrayList<>();
    for (DroneOrigin origin : origins) {
      drones.add(origin.toSave(present.config().drones().get(drones.size())));
    }
    List<CommandAddress> stations = origins.stream().map(DroneOrigin::writtenStation).toList();
    Arena arena = changed(written.config().arena(), was.config().arena(), present.config().arena());
    return new Scenario(
        written.description(),
        written.config().withArena(arena).withDrones(drones),
        stations,
        changed(written.challenge(), was.challenge(), present.challenge()));
  }

  private static Arena changed(Arena written, Arena opened, Arena now) {
    Decor decor = written.decor();
    Decor was = opened.decor();
    Decor is = now.decor();
    return new Arena(
        changed(written.room(), opened.room(), now.room()),
        new Decor(
            changed(decor.grid(), was.grid(), is.grid()),
            changed(decor.walls(), was.walls(), is.walls()),
            changed(decor.accent(), was.accent(), is.accent()),
            changed(decor.posters(), was.posters(), is.posters())),
        changed(written.obstacles(), opened.obstacles(), now.obstacles()),
        changed(written.pads(), opened.pads(), now.pads()),
        changed(written.wind(), opened.wind(), now.wind()));
  }

  /**
   * Returns the value to be saved: the current one, or the written one if the value has not changed
   * since the scenario was opened.
   */
  static <T> T changed(T written, T opened, T now) {
    return now.equals(opened) ? written : now;
  }

  /**
   * Returns whether there are changes to be saved. If the scenario comes from neither a file nor
   * the gallery, only obstacles, mission pads, goals and colours count, because the size of a room
   * alone is not worth saving.
   */
  public boolean unsaved() {
    Scenario written = opened.document().scenario();
    if (opened.file().isPresent() || opened.known().isPresent()) {
      return !toSave().equals(written);
    }
    Arena was = written.config().arena();
    Arena is = present.config().arena();
    return !is.obstacles().equals(was.obstacles())
        || !is.pads().equals(was.pads())
        || !present.challenge().equals(written.challenge())
        || !colors(present).equals(colors(written));
  }

  private static List<OptionalInt> colors(Scenario scenario) {
    return scenario.config().drones().stream().map(DroneSetup::rgb).toList();
  }
}
