package tellosimulator.view;

import java.nio.file.Path;
import java.util.Optional;
import tellosimulator.scenario.Scenario;

/**
 * A scenario, and how to open it again. Immutable.
 *
 * @param file from which it came
 * @param known its short name among those that come with the program
 */
public record OpenedScenario(Scenario scenario, Optional<Path> file, Optional<String> known) {

  /** The same with another scenario made of it. */
  public OpenedScenario with(Scenario changed) {
    return new OpenedScenario(changed, file, known);
  }

  /** One that cannot be opened again. */
  public static OpenedScenario once(Scenario scenario) {
    return new OpenedScenario(scenario, Optional.empty(), Optional.empty());
  }

  /** One of a file. */
  public static OpenedScenario of(Scenario scenario, Path file) {
    return new OpenedScenario(scenario, Optional.of(file), Optional.empty());
  }

  /** One that comes with the program. */
  public static OpenedScenario known(Scenario scenario, String name) {
    return new OpenedScenario(scenario, Optional.empty(), Optional.of(name));
  }
}
