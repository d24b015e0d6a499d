package tellosimulator.view.model;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
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
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;

/**
 * The scenario that is flown, for views: what it asks for, and how far the drones have come. For
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
   * @param scenario as it begins
   * @param goals which watches the simulation
   * @param asking asks something else of the drones
   * @param actions where other scenarios are had
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

  /** A scenario that asks for nothing. */
  static FxScenario none(Scenario scenario) {
    GoalWatch idle = new GoalWatch(scenario.challenge(), news -> {});
    EditedScenario plain = EditedScenario.of(OpenedScenario.once(scenario));
    return new FxScenario(plain, idle, idle::ask, ScenarioActions.CLOSED);
  }

  /** Takes over how far the drones have come; called once a pulse. */
  void update() {
    Progress now = newest.get();
    if (now.challenge().equals(challenge())) { // otherwise the simulation has not heard of it yet
      progress.set(now);
    }
  }

  /** As it began. */
  public Scenario scenario() {
    return scenario.present();
  }

  /** Where its drones come from, in the order of their numbers. */
  public List<DroneOrigin> origins() {
    return scenario.origins();
  }

  /** What is asked of the drones now. */
  public ReadOnlyObjectProperty<Challenge> challengeProperty() {
    return challenge.getReadOnlyProperty();
  }

  /** See {@link #challengeProperty}. */
  public Challenge challenge() {
    return challenge.get();
  }

  /** Asks something else of the drones, which begin anew with it. While none of them flies. */
  public void ask(Challenge newChallenge) {
    asking.accept(newChallenge);
    progress.set(Progress.start(newChallenge));
    challenge.set(newChallenge);
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

  /** The short name of the scenario of the program that follows; empty if there is none. */
  public Optional<String> next() {
    return scenario.opened().known().flatMap(Gallery::next);
  }

  /** Where other scenarios are had. */
  public ScenarioActions actions() {
    return actions;
  }

  /** Whether nobody chose it: an empty room. */
  public boolean plain() {
    return file().isEmpty()
        && scenario().description().name().isEmpty()
        && challenge().goals().isEmpty();
  }

  /** How far the drones have come. */
  public ReadOnlyObjectProperty<Progress> progressProperty() {
    return progress.getReadOnlyProperty();
  }
}
