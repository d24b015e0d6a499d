package tellosimulator.view.model;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.scenario.DroneOrigin;
import tellosimulator.scenario.EditedScenario;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;

/**
 * The running scenario as the views see it: its challenge, and the drones' progress. Confined to
 * the JavaFX thread.
 */
public final class FxScenario {

  private final EditedScenario scenario;
  private final ReadOnlyObjectWrapper<Challenge> challenge;
  private final Consumer<Challenge> asking;
  private final ReadOnlyObjectWrapper<Optional<Path>> file;
  private final ReadOnlyBooleanWrapper unsaved = new ReadOnlyBooleanWrapper(this, "unsaved");
  private final ScenarioActions actions;
  private final Supplier<Progress> newest;
  private final ReadOnlyObjectWrapper<Progress> progress;

  /**
   * @param scenario the scenario as it is when the window opens
   * @param goals observes the drones' progress
   * @param asking sets another challenge
   * @param actions opens and saves scenarios
   */
  public FxScenario(
      EditedScenario scenario,
      GoalWatch goals,
      Consumer<Challenge> asking,
      ScenarioActions actions) {
    this.scenario = scenario;
    this.challenge = new ReadOnlyObjectWrapper<>(this, "challenge", scenario.present().challenge());
    this.file = new ReadOnlyObjectWrapper<>(this, "file", scenario.opened().file());
    this.asking = asking;
    this.actions = actions;
    this.newest = goals::progress;
    this.progress = new ReadOnlyObjectWrapper<>(goals.progress());
  }

  /** Updates the progress. Must be called at each UI tick. */
  void update() {
    Progress now = newest.get();
    // Until the simulation adopts a new challenge, it reports the progress of the old one.
    if (now.challenge().equals(challenge())) {
      progress.set(now);
    }
  }

  /** Returns the scenario as it was when the window opened. Later changes are not included. */
  public Scenario scenario() {
    return scenario.present();
  }

  /** Returns the origins of the scenario's drones, in the order of the drones' numbers. */
  public List<DroneOrigin> origins() {
    return scenario.origins();
  }

  /** The current challenge. */
  public ReadOnlyObjectProperty<Challenge> challengeProperty() {
    return challenge.getReadOnlyProperty();
  }

  /** See {@link #challengeProperty}. */
  public Challenge challenge() {
    return challenge.get();
  }

  /**
   * Sets another challenge and starts it from the beginning. Must not be called while a drone is
   * flying.
   */
  public void ask(Challenge newChallenge) {
    asking.accept(newChallenge);
    progress.set(Progress.start(newChallenge));
    challenge.set(newChallenge);
  }

  /**
   * The file from which the scenario was loaded or to which it was saved; empty if there is none.
   */
  public ReadOnlyObjectProperty<Optional<Path>> fileProperty() {
    return file.getReadOnlyProperty();
  }

  /** See {@link #fileProperty}. */
  public Optional<Path> file() {
    return file.get();
  }

  /** Sets the file to which the scenario was written. */
  public void savedAs(Path newFile) {
    file.set(Optional.of(newFile));
  }

  /** Whether there are changes that have not been saved to a file. */
  public ReadOnlyBooleanProperty unsavedProperty() {
    return unsaved.getReadOnlyProperty();
  }

  public void setUnsaved(boolean newUnsaved) {
    unsaved.set(newUnsaved);
  }

  /**
   * Returns the short name of the next scenario of the gallery; empty after the last one, or if
   * this scenario is not in the gallery.
   */
  public Optional<String> next() {
    return scenario.opened().known().flatMap(Gallery::next);
  }

  /** Returns the seed from which the course was drawn; empty if the scenario has no ranges. */
  public OptionalLong course() {
    return scenario.opened().varies()
        ? OptionalLong.of(scenario().config().seed())
        : OptionalLong.empty();
  }

  /** Returns the actions that open and save scenarios. */
  public ScenarioActions actions() {
    return actions;
  }

  /**
   * Returns whether this is the empty default room rather than a scenario that the user has chosen.
   */
  public boolean plain() {
    return file().isEmpty()
        && scenario().description().name().isEmpty()
        && challenge().goals().isEmpty();
  }

  /** The drones' progress. */
  public ReadOnlyObjectProperty<Progress> progressProperty() {
    return progress.getReadOnlyProperty();
  }
}
