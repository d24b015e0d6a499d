package tellosimulator.scenario;

import java.util.List;
import java.util.Optional;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;

/**
 * An exercise that a class hands in: the courses to fly, how the programs are started and limited,
 * and how points become a grade. Immutable.
 *
 * @param name its title
 * @param attempts the number of flights on each course with each seed
 * @param take which of the attempts counts
 * @param entry names or patterns of the file to start; the first that matches counts
 * @param command the command that starts the file, which it names {@code {file}}; empty if it
 *     follows from the ending of the file
 * @param build the command that is run once before the first flight; empty if there is none
 */
public record Assignment(
    String name,
    List<AssignedCourse> courses,
    int attempts,
    Take take,
    List<String> entry,
    Optional<String> command,
    Optional<String> build,
    Setup setup,
    Limits limits,
    Scale scale) {

  /** Maximum number of flights of a hand-in. Decided: a day on one processor. */
  public static final int MOST_FLIGHTS = 1000;

  public Assignment {
    courses = List.copyOf(courses);
    entry = List.copyOf(entry);
  }

  /**
   * A course of an assignment.
   *
   * @param scenario the scenario's file, or its name in the gallery
   * @param seeds the seeds with which it is flown; empty for the one of the scenario
   */
  public record AssignedCourse(String scenario, List<Long> seeds) {

    public AssignedCourse {
      seeds = List.copyOf(seeds);
    }
  }

  /** The attempt that counts, or the mean of all. */
  public enum Take {
    BEST,
    MEAN,
    LAST
  }

  /**
   * How simulated time passes: by the wall clock, as fast as possible, or as the program allows.
   */
  public enum Pace {
    AUTO,
    MAX,
    REAL
  }

  /**
   * Properties of all drones that replace those of the scenario.
   *
   * @param link the quality of all radio links
   */
  public record Setup(
      Optional<Profile> profile,
      Optional<Behavior> behavior,
      Optional<LinkPreset> link,
      List<Fault> faults,
      Pace pace) {

    public static final Setup DEFAULT =
        new Setup(Optional.empty(), Optional.empty(), Optional.empty(), List.of(), Pace.AUTO);

    public Setup {
      faults = List.copyOf(faults);
    }
  }

  /**
   * The limits of each flight.
   *
   * @param wallSeconds maximum duration of the program [s of real time]
   * @param simulatedSeconds maximum duration of the flight
   * @param outputBytes maximum size of the output that is kept
   * @param memoryMb maximum memory of all processes of the program
   * @param processes maximum number of processes of the program
   * @param diskMb maximum size of the program's files
   */
  public record Limits(
      double wallSeconds,
      double simulatedSeconds,
      int outputBytes,
      int memoryMb,
      int processes,
      int diskMb) {

    /** Decided: for flights of a minute or two, on machines that fly several at once. */
    public static final Limits DEFAULT = new Limits(120, 300, 1_000_000, 1024, 64, 100);
  }

  /**
   * How points become a grade.
   *
   * @param range whether the grade lies between {@code from} and {@code to}; otherwise it is a
   *     percentage
   * @param passedFrom the least percentage of the points with which one passes
   */
  public record Scale(boolean range, double from, double to, double passedFrom) {

    public static final Scale DEFAULT = new Scale(false, 0, 100, 50);

    /** Returns the grade for a percentage of the points, rounded to two decimals. */
    public double grade(double percent) {
      double share = Math.min(100, Math.max(0, percent)) / 100;
      return Math.round((from + share * (to - from)) * 100) / 100.0;
    }
  }
}
