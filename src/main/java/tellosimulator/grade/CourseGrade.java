package tellosimulator.grade;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.scenario.Assignment.Take;

/**
 * The points of a hand-in on a course with one of its seeds. Immutable.
 *
 * @param course the name of the course
 * @param points the points of the attempts that count
 * @param of the most points that one can get
 * @param flights the attempts, in order
 */
public record CourseGrade(
    String course, long seed, double points, double of, List<GradedFlight> flights) {

  public CourseGrade {
    flights = List.copyOf(flights);
  }

  /** Returns the courses of flights, in the order in which they first occur. */
  public static List<CourseGrade> all(List<GradedFlight> flights, Take take) {
    Map<String, List<GradedFlight>> courses = new LinkedHashMap<>();
    for (GradedFlight flight : flights) {
      courses
          .computeIfAbsent(flight.course() + " " + flight.seed(), key -> new ArrayList<>())
          .add(flight);
    }
    return courses.values().stream().map(attempts -> of(attempts, take)).toList();
  }

  private static CourseGrade of(List<GradedFlight> attempts, Take take) {
    GradedFlight first = attempts.get(0);
    double of = attempts.stream().mapToDouble(each -> each.result().of()).max().orElse(0);
    return new CourseGrade(first.course(), first.seed(), taken(attempts, take), of, attempts);
  }

  private static double taken(List<GradedFlight> attempts, Take take) {
    return switch (take) {
      case BEST -> attempts.stream().mapToDouble(each -> each.result().points()).max().orElse(0);
      case MEAN ->
          attempts.stream().mapToDouble(each -> each.result().points()).average().orElse(0);
      case LAST ->
          attempts.stream()
              .max(Comparator.comparingInt(GradedFlight::attempt))
              .map(each -> each.result().points())
              .orElse(0.0);
    };
  }

  /** Returns the attempt with the most points; of several, the first. */
  public GradedFlight best() {
    return flights.stream()
        .max(
            Comparator.comparingDouble((GradedFlight each) -> each.result().points())
                .thenComparingInt(each -> -each.attempt()))
        .orElseThrow();
  }
}
