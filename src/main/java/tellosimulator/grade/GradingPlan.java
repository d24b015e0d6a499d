package tellosimulator.grade;

import java.nio.file.Path;
import java.util.List;
import tellosimulator.launcher.Confinement;
import tellosimulator.scenario.Assignment;

/**
 * What is graded, and how. Immutable.
 *
 * @param file the file of the assignment
 * @param courses the courses with their seeds
 * @param simulator the command that starts a simulator, without options
 * @param into the folder of the results
 * @param scratch a temporary folder
 * @param hidden folders that programs must not see
 * @param confined whether this system can confine programs
 */
record GradingPlan(
    Assignment assignment,
    Path file,
    List<SeededCourse> courses,
    List<String> simulator,
    Path into,
    Path scratch,
    List<Path> hidden,
    boolean confined) {

  /**
   * Returns what a program may see and use.
   *
   * @param files the folder with its files, or a tar archive of it
   * @param stash an empty folder
   */
  Confinement confinement(Path files, Path stash) {
    Assignment.Limits limits = assignment.limits();
    return new Confinement(
        files,
        stash,
        hidden,
        new Confinement.Limits(
            limits.wallSeconds(),
            limits.outputBytes(),
            limits.memoryMb(),
            limits.processes(),
            limits.diskMb()));
  }
}
