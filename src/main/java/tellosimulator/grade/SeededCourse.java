package tellosimulator.grade;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.recording.FlightResult;
import tellosimulator.scenario.Assignment;
import tellosimulator.scenario.Assignment.AssignedCourse;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;

/**
 * A course of an assignment with one of its seeds. Immutable.
 *
 * @param name the name of the scenario's file without its ending; unique together with the seed
 * @param title the name of the scenario; if it has none, {@code name}
 * @param scenario the scenario's file, or its name in the gallery
 * @param seed the seed with which it is flown
 * @param drones the number of drones
 * @param lasting whether a goal lasts for a time, during which programs may sleep
 * @param unflown the result of a program that was never started
 * @param fingerprint what the scenario was read from
 */
record SeededCourse(
    String name,
    String title,
    String scenario,
    long seed,
    int drones,
    boolean lasting,
    FlightResult unflown,
    String fingerprint) {

  /**
   * Opens the courses of an assignment.
   *
   * @param errors receives a sentence for each error in a scenario
   * @return the courses without errors
   */
  static List<SeededCourse> of(Assignment assignment, List<String> errors) {
    List<SeededCourse> courses = new ArrayList<>();
    List<String> names = new ArrayList<>();
    for (AssignedCourse assigned : assignment.courses()) {
      String base = name(assigned.scenario());
      long before = names.stream().filter(base::equals).count();
      names.add(base);
      try {
        OpenedScenario opened = OpenedScenario.named(assigned.scenario());
        if (opened.scenario().challenge().goals().isEmpty()) {
          errors.add(assigned.scenario() + ": a course needs goals, but this scenario has none.");
          continue;
        }
        add(courses, before == 0 ? base : base + "-" + (before + 1), assigned, opened);
      } catch (ScenarioException e) {
        errors.add(e.getMessage());
      } catch (IllegalArgumentException | IOException e) {
        errors.add(assigned.scenario() + ": " + e.getMessage());
      }
    }
    return courses;
  }

  private static void add(
      List<SeededCourse> courses, String name, AssignedCourse assigned, OpenedScenario opened)
      throws ScenarioException, IOException {
    Path file = Path.of(assigned.scenario());
    String fingerprint = Files.isRegularFile(file) ? Files.readString(file) : assigned.scenario();
    String title = opened.scenario().description().name().english();
    long usual = opened.scenario().config().seed();
    for (long seed : assigned.seeds().isEmpty() ? List.of(usual) : assigned.seeds()) {
      Scenario scenario = opened.drawnFrom(seed).scenario();
      courses.add(
          new SeededCourse(
              name,
              title.isEmpty() ? name : title,
              assigned.scenario(),
              seed,
              scenario.config().drones().size(),
              scenario.challenge().goals().stream().anyMatch(goal -> goal.lasting() > 0),
              FlightResult.none(scenario.challenge()),
              fingerprint));
    }
  }

  /** Returns the name of a course without its number. */
  static String name(String scenario) {
    return Path.of(scenario)
        .getFileName()
        .toString()
        .replaceFirst("\\.ya?ml$", "")
        .replaceAll("[^\\p{L}\\p{N}_-]+", "-");
  }
}
