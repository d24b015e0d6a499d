package tellosimulator.grade;

import java.nio.file.Path;
import java.util.List;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Take;

/**
 * A hand-in with its flights and its grade. Immutable.
 *
 * @param name the name of the student, or of the file
 * @param id the number of the student; may be empty
 * @param group may be empty
 * @param folder the name of its folders in the results; unique
 * @param original the name of what was handed in: a file, or a folder such as Moodle's; empty if
 *     nothing was
 * @param file the file that was started, relative to the hand-in; empty if there is none
 * @param points the points of all courses, each of the attempts that count
 * @param of the most points that one can get
 * @param percent {@code points} as a percentage of {@code of}, rounded to two decimals
 * @param grade the grade on the scale of the assignment
 */
public record GradedHandIn(
    String name,
    String id,
    String group,
    String folder,
    String original,
    String file,
    double points,
    double of,
    double percent,
    double grade,
    boolean passed,
    List<GradedFlight> flights) {

  public GradedHandIn {
    flights = List.copyOf(flights);
  }

  /**
   * Returns the folder with the files of a flight.
   *
   * @param results the folder of the results
   */
  public Path filesOf(GradedFlight flight, Path results) {
    return results.resolve(Grader.RECORDINGS).resolve(folder).resolve(flight.name());
  }

  /** Creates the grade of a hand-in from its flights. */
  static GradedHandIn of(HandIn handIn, List<GradedFlight> flights, Take take, Scale scale) {
    return new GradedHandIn(
            handIn.name(),
            handIn.id(),
            handIn.group(),
            handIn.folder(),
            handIn.original(),
            handIn.file(),
            0,
            0,
            0,
            0,
            false,
            List.of())
        .with(flights, take, scale);
  }

  /** Returns a copy with other flights, and the points and the grade that follow from them. */
  GradedHandIn with(List<GradedFlight> others, Take take, Scale scale) {
    List<CourseGrade> courses = CourseGrade.all(others, take);
    double sum = courses.stream().mapToDouble(CourseGrade::points).sum();
    double most = courses.stream().mapToDouble(CourseGrade::of).sum();
    double share = most == 0 ? 0 : Math.round(sum / most * 10_000) / 100.0;
    return new GradedHandIn(
        name,
        id,
        group,
        folder,
        original,
        file,
        Math.round(sum * 1000) / 1000.0,
        most,
        share,
        scale.grade(share),
        share >= scale.passedFrom(),
        others);
  }
}
