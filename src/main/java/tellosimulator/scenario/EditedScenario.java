package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import tellosimulator.goal.Challenge;
import tellosimulator.scenario.Scenario.Station;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;

/**
 * An opened scenario with what somebody has changed in it since: room, drones and goals. Immutable;
 * for any thread.
 *
 * @param opened as it was opened or last saved
 * @param present as it is now
 * @param origins of its drones, in the order of their numbers
 */
public record EditedScenario(OpenedScenario opened, Scenario present, List<DroneOrigin> origins) {

  public EditedScenario {
    origins = List.copyOf(origins);
  }

  /** One in which nothing was changed. */
  public static EditedScenario of(OpenedScenario opened) {
    Scenario scenario = opened.scenario();
    return new EditedScenario(
        opened, scenario, DroneOrigin.of(opened.document().scenario(), scenario));
  }

  /**
   * The same as it is in a simulation of it now.
   *
   * @param snapshot with as many drones
   * @param challenge what is asked for now
   */
  public EditedScenario in(SimSnapshot snapshot, Challenge challenge) {
    return new EditedScenario(opened, present.asIn(snapshot).withChallenge(challenge), origins);
  }

  /** The same with what somebody has planned, which may be another number of drones. */
  public EditedScenario planned(Arena arena, List<PlannedDrone> drones, Challenge challenge) {
    SimConfig config = present.config();
    List<DroneOrigin> left = new ArrayList<>(origins);
    List<DroneSetup> setups = new ArrayList<>();
    for (PlannedDrone drone : drones) {
      int index = left.indexOf(drone.origin());
      DroneSetup setup = index < 0 ? drone.origin().opened() : config.drones().get(index);
      if (index >= 0) {
        left.set(index, null); // of two alike, each is taken once
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

  /** The same after it was written to a file. */
  public EditedScenario savedAs(ScenarioDocument document, Path file) {
    return new EditedScenario(OpenedScenario.of(document, file).with(present), present, origins);
  }

  /**
   * What is to be saved: what has changed since it was opened, and the rest as the document has it,
   * so that no option gets into a file.
   */
  public Scenario toSave() {
    Scenario written = opened.document().scenario();
    Scenario was = opened.scenario();
    List<DroneSetup> drones = new ArrayList<>();
    for (DroneOrigin origin : origins) {
      drones.add(origin.toSave(present.config().drones().get(drones.size())));
    }
    List<Station> stations = origins.stream().map(DroneOrigin::writtenStation).toList();
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

  /** What is there now, or what was written if that has not changed since it was opened. */
  static <T> T changed(T written, T opened, T now) {
    return now.equals(opened) ? written : now;
  }

  /**
   * Whether saving would change something. In a room that nobody opened only what was placed there
   * counts: nobody saves a room for its size.
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
