package tellosimulator.view.model;

import java.nio.file.Path;
import java.util.List;
import tellosimulator.goal.Challenge;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.world.Arena;

/**
 * The user's actions on scenarios and recordings: choose, open, reload, save. If unsaved changes
 * would be lost, the user is asked before a scenario is opened, reloaded or restarted. Errors are
 * shown in the window, which then continues as before. Confined to the JavaFX thread.
 */
public interface ScenarioActions {

  /** Opens the gallery, or closes it if it is open. */
  void choose();

  /** Opens a file in place of the current scenario. */
  void open(Path file);

  /**
   * Opens a scenario of the gallery.
   *
   * @param name its short name
   */
  void openKnown(String name);

  /** Opens the default room, with one drone and without goals. */
  void openEmpty();

  /**
   * Opens a recording in a separate player; the current scenario stays open.
   *
   * @param place the recording's folder, or a file in it
   */
  void openRecording(Path place);

  /**
   * Starts a new run of the current scenario with other settings, after the user has confirmed it.
   */
  void restart(StartSettings settings);

  /**
   * Starts a new run of the current scenario with the planned room, drones and challenge. The undo
   * history of the plan editor is kept.
   *
   * @return whether the run was started; if not, the window shows why
   */
  boolean replan(Arena arena, List<PlannedDrone> drones, Challenge challenge);

  /** Opens the current scenario again, with the course that is drawn from the next seed. */
  void openNextCourse();

  /** Opens a file chooser, and grades the last flight with the chosen assignment. */
  void gradeFlight();

  /** Reloads the current scenario. */
  void reload();

  /**
   * Saves the current room, drones and goals to a file, which then counts as the opened file. Asks
   * the user before overwriting changes that another program has made to the file.
   */
  void save(Path file);
}
