package tellosimulator.view.model;

import java.nio.file.Path;
import java.util.List;
import tellosimulator.goal.Challenge;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.world.Arena;

/**
 * What a person can do with scenarios and recordings: choose, open, reload, save. What goes wrong
 * is told in the window, which then goes on as before. For the JavaFX thread.
 */
public interface ScenarioActions {

  /** One that has no scenarios. */
  ScenarioActions CLOSED =
      new ScenarioActions() {
        @Override
        public void choose() {}

        @Override
        public void open(Path file) {}

        @Override
        public void openEmpty() {}

        @Override
        public void openRecording(Path place) {}

        @Override
        public void openKnown(String name) {}

        @Override
        public void beginAnew(StartSettings settings) {}

        @Override
        public boolean replan(Arena arena, List<PlannedDrone> drones, Challenge challenge) {
          return false;
        }

        @Override
        public void reload() {}

        @Override
        public void save(Path file) {}
      };

  /** Shows what there is, or closes that page. */
  void choose();

  /** Opens a file in place of what is flown; asks before edits are lost, as those below do. */
  void open(Path file);

  /**
   * Opens a scenario that comes with the program.
   *
   * @param name its short name
   */
  void openKnown(String name);

  /** Opens the default room, with one drone and nothing to do. */
  void openEmpty();

  /**
   * Opens a recording in a player of its own, beside what is flown.
   *
   * @param place its folder, or a file in it
   */
  void openRecording(Path place);

  /** Begins what is flown anew, with other settings, after a question. */
  void beginAnew(StartSettings settings);

  /**
   * Begins what is flown anew with other drones, as somebody has planned them, and with what was
   * planned until now still there to be undone.
   *
   * @return whether it did; if not, the window says why
   */
  boolean replan(Arena arena, List<PlannedDrone> drones, Challenge challenge);

  /** Opens again what is flown. */
  void reload();

  /**
   * Writes room, drones and goals, as they are now, to a file, which from then on is the opened.
   * Asks before it loses what another program has written into that file.
   */
  void save(Path file);
}
