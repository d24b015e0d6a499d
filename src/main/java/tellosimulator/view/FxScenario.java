package tellosimulator.view;

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
import tellosimulator.sim.SimEvent;

/**
 * The scenario that is flown, for views: what it asks for, and how far the drones have come. For
 * the JavaFX thread.
 */
public final class FxScenario {

  private final Scenario scenario;
  private final ReadOnlyObjectWrapper<Optional<Path>> file;
  private final ReadOnlyBooleanWrapper unsaved = new ReadOnlyBooleanWrapper(this, "unsaved");
  private final ScenarioDesk desk;
  private final Supplier<Progress> newest;
  private final ReadOnlyObjectWrapper<Progress> progress;

  /**
   * @param file from which it came; empty for what came with the program, or from nowhere
   * @param goals which watches the simulation
   * @param desk where other scenarios are had
   */
  public FxScenario(Scenario scenario, Optional<Path> file, GoalWatch goals, ScenarioDesk desk) {
    this.scenario = scenario;
    this.file = new ReadOnlyObjectWrapper<>(this, "file", file);
    this.desk = desk;
    this.newest = goals::progress;
    this.progress = new ReadOnlyObjectWrapper<>(goals.progress());
  }

  /** A scenario that asks for nothing. */
  static FxScenario none(Scenario scenario) {
    GoalWatch idle = new GoalWatch(scenario.challenge(), (SimEvent news) -> {});
    return new FxScenario(scenario, Optional.empty(), idle, ScenarioDesk.CLOSED);
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
  void savedAs(Path newFile) {
    file.set(Optional.of(newFile));
  }

  /** Whether there is something that no file has. */
  public ReadOnlyBooleanProperty unsavedProperty() {
    return unsaved.getReadOnlyProperty();
  }

  void setUnsaved(boolean newUnsaved) {
    unsaved.set(newUnsaved);
  }

  /** Where other scenarios are had. */
  public ScenarioDesk desk() {
    return desk;
  }

  /** Whether nobody chose it: an empty room. */
  public boolean plain() {
    return file().isEmpty() && scenario.name().isEmpty() && scenario.challenge().goals().isEmpty();
  }

  /** How far the drones have come. */
  public ReadOnlyObjectProperty<Progress> progressProperty() {
    return progress.getReadOnlyProperty();
  }
}
