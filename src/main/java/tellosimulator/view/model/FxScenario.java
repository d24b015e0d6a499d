package tellosimulator.view.model;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.scenario.Scenario;

/**
 * The scenario that is flown, for views: what it asks for, and how far the drones have come. For
 * the JavaFX thread.
 */
public final class FxScenario {

  private final Scenario scenario;
  private final ReadOnlyObjectWrapper<Optional<Path>> file;
  private final ReadOnlyBooleanWrapper unsaved = new ReadOnlyBooleanWrapper(this, "unsaved");
  private final ScenarioActions actions;
  private final Supplier<Progress> newest;
  private final ReadOnlyObjectWrapper<Progress> progress;

  /**
   * @param file from which it came; empty for what came with the program, or from nowhere
   * @param goals which watches the simulation
   * @param actions where other scenarios are had
   */
  public FxScenario(
      Scenario scenario, Optional<Path> file, GoalWatch goals, ScenarioActions actions) {
    this.scenario = scenario;
    this.file = new ReadOnlyObjectWrapper<>(this, "file", file);
    this.actions = actions;
    this.newest = goals::progress;
    this.progress = new ReadOnlyObjectWrapper<>(goals.progress());
  }

  /** A scenario that asks for nothing. */
  static FxScenario none(Scenario scenario) {
    GoalWatch idle = new GoalWatch(scenario.challenge(), news -> {});
    return new FxScenario(scenario, Optional.empty(), idle, ScenarioActions.CLOSED);
  }

  /** Takes over how far the drones have come; called once a pulse. */
  void update() {
    progress.set(newest.get());
  }

  /** As it was opened. */
  public Scenario scenario() {
    return scenario;
  }

  /** From which it came or to which it was saved; empty for none. */
  public ReadOnlyObjectProperty<Optional<Path>> fileProperty() {
    return file.getReadOnlyProperty();
  }

  /** See {@link #fileProperty}. */
  public Optional<Path> file() {
    return file.get();
  }

  /** It has been written to a file. */
  public void savedAs(Path newFile) {
    file.set(Optional.of(newFile));
  }

  /** Whether there is something that no file has. */
  public ReadOnlyBooleanProperty unsavedProperty() {
    return unsaved.getReadOnlyProperty();
  }

  public void setUnsaved(boolean newUnsaved) {
    unsaved.set(newUnsaved);
  }

  /** Where other scenarios are had. */
  public ScenarioActions actions() {
    return actions;
  }

  /** Whether nobody chose it: an empty room. */
  public boolean plain() {
    return file().isEmpty()
        && scenario.description().name().isEmpty()
        && scenario.challenge().goals().isEmpty();
  }

  /** How far the drones have come. */
  public ReadOnlyObjectProperty<Progress> progressProperty() {
    return progress.getReadOnlyProperty();
  }
}
